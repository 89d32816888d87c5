// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/import.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <string_view>

#include "host/scene/camera.h"
#include "host/scene/check_file.h"
#include "host/scene/mesh_builder.h"
#include "host/scene/text_lines.h"
#include "host/scene/wording.h"

#if __has_feature(address_sanitizer)
// Assimp leaks its open file when it rejects one; LeakSanitizer asks for this by name.
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }
#endif

namespace dynrt::host {

namespace {

constexpr double kSingular = 1e-12;  // the volume that three unit axes must exceed

glm::dvec3 to_glm(const aiVector3D& v) { return {v.x, v.y, v.z}; }

glm::dmat4 to_glm(const aiMatrix4x4& m) {  // Assimp's rows to GLM's columns
  return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2,
          m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

std::string one_sentence(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  text = trim(text);
  while (text.ends_with('.')) text.pop_back();
  return text.empty() ? "no reason given" : text;
}

// Assimp leaves out glTF faces whose vertices do not exist and only says so in its log. Its logger
// is one for the whole process; this listens to it for one import.
class DroppedFaces {
 public:
  DroppedFaces() {
    Assimp::DefaultLogger::create(nullptr, Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(&listener_, Assimp::Logger::Warn);
  }
  DroppedFaces(const DroppedFaces&) = delete;
  DroppedFaces& operator=(const DroppedFaces&) = delete;
  ~DroppedFaces() {
    Assimp::DefaultLogger::get()->detachStream(&listener_, Assimp::Logger::Warn);
    Assimp::DefaultLogger::kill();
  }

  bool any() const { return listener_.heard; }

 private:
  struct Listener : Assimp::LogStream {
    void write(const char* message) override {
      heard |= std::string_view(message).find("out-of-range indices") != std::string_view::npos;
    }
    bool heard = false;
  };

  Listener listener_;
};

// Before Assimp cuts up the faces: its triangulation ends the program on what it does not expect.
void check_mesh(const aiMesh& mesh, const std::string& label) {
  const std::string name = mesh.mName.C_Str();
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& v = mesh.mVertices[i];
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
      wording::fail(wording::kVertexNotFinite, label, name, i, v.x, v.y, v.z);
    }
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices == 0) wording::fail(wording::kFaceEmpty, label, name, f);
  }
}

class Conversion {
 public:
  Conversion(const aiScene& from, const std::string& label, bool flat)
      : from_(from), label_(label), flat_(flat) {}

  Scene run() {
    scene_.name = std::filesystem::path(label_).stem().string();
    for (unsigned i = 0; i < from_.mNumMaterials; ++i) material(*from_.mMaterials[i]);
    if (flat_) {
      MeshBuilder builder(scene_.name);
      flatten(*from_.mRootNode, builder);
      keep(std::move(builder), {scene_.name, 0, glm::dmat4(1.0)});
    } else {
      instances(*from_.mRootNode, glm::dmat4(1.0));
    }
    return std::move(scene_);
  }

 private:
  void material(const aiMaterial& from) {
    Material material;
    aiColor3D diffuse;
    if (from.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse) == aiReturn_SUCCESS) {
      const glm::dvec3 colour(diffuse.r, diffuse.g, diffuse.b);
      if (std::isfinite(colour.x + colour.y + colour.z)) {
        material.diffuse = glm::clamp(colour, 0.0, 1.0);
      }
    }
    material.name = from.GetName().C_Str();
    scene_.materials.push_back(std::move(material));
  }

  void add(const aiMesh& mesh, MeshBuilder& builder) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) {
        ++scene_.dropped.points_and_lines;
        continue;
      }
      const unsigned* i = face.mIndices;
      builder.add(to_glm(mesh.mVertices[i[0]]), to_glm(mesh.mVertices[i[1]]),
                  to_glm(mesh.mVertices[i[2]]), mesh.mMaterialIndex);
    }
  }

  void flatten(const aiNode& node, MeshBuilder& builder) {
    for (unsigned m = 0; m < node.mNumMeshes; ++m) add(*from_.mMeshes[node.mMeshes[m]], builder);
    for (unsigned c = 0; c < node.mNumChildren; ++c) flatten(*node.mChildren[c], builder);
  }

  // Takes over what was built, unless nothing is left of it.
  bool keep(MeshBuilder&& builder, Instance instance) {
    scene_.dropped.zero_area_triangles += builder.zero_area_triangles();
    Mesh mesh = builder.take();
    if (mesh.triangles.empty()) return false;
    instance.object = static_cast<uint32_t>(scene_.objects.size());
    scene_.objects.push_back(std::move(mesh));
    scene_.instances.push_back(std::move(instance));
    return true;
  }

  void instances(const aiNode& node, const glm::dmat4& parent) {
    const glm::dmat4 transform = parent * to_glm(node.mTransformation);
    const std::string name = node.mName.C_Str();
    if (node.mNumMeshes > 0) {
      const std::vector<unsigned> meshes(node.mMeshes, node.mMeshes + node.mNumMeshes);
      Instance instance{name, 0, transform};
      require_inverse(instance, label_);
      const auto known = object_of_.find(meshes);
      if (known == object_of_.end()) {
        MeshBuilder builder(object_name(meshes));
        for (const unsigned m : meshes) add(*from_.mMeshes[m], builder);
        const bool kept = keep(std::move(builder), std::move(instance));
        object_of_[meshes] = kept ? static_cast<int>(scene_.objects.size()) - 1 : kNothingLeft;
      } else if (known->second != kNothingLeft) {
        instance.object = static_cast<uint32_t>(known->second);
        scene_.instances.push_back(std::move(instance));
      }
    }
    for (unsigned c = 0; !scene_.camera && c < from_.mNumCameras; ++c) {
      if (from_.mCameras[c]->mName == node.mName) camera(*from_.mCameras[c], transform);
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c) instances(*node.mChildren[c], transform);
  }

  // Assimp makes meshes NAME-0, NAME-1, ... of the primitives of one glTF mesh.
  std::string object_name(const std::vector<unsigned>& meshes) const {
    std::string name = from_.mMeshes[meshes[0]]->mName.C_Str();
    if (meshes.size() > 1 && name.ends_with("-0")) name.resize(name.size() - 2);
    return name;
  }

  void camera(const aiCamera& from, const glm::dmat4& transform) {
    // A glTF camera looks along -z of its node, y up; Assimp 5.2 repeats the node's translation in
    // mPosition, and its "horizontal" angle is the file's vertical one times the aspect.
    const double aspect = from.mAspect > 0.0f ? from.mAspect : 1.0;
    const double field_of_view = glm::degrees(from.mHorizontalFOV / aspect);
    if (!(field_of_view > 0.0)) {
      scene_.notes.push_back(
          fmt::format(wording::kCameraNotPerspective, label_, from.mName.C_Str()));
      return;
    }
    const glm::dvec3 position(transform[3]), back(transform[2]), up(transform[1]);
    try {
      scene_.camera = look_at(position, position - back, up, field_of_view, 1.0);
    } catch (const UserError& error) {
      wording::fail(wording::kCameraNode, label_, from.mName.C_Str(), error.what());
    }
  }

  static constexpr int kNothingLeft = -1;

  const aiScene& from_;
  const std::string& label_;
  const bool flat_;
  Scene scene_;
  std::map<std::vector<unsigned>, int> object_of_;
};

Scene convert(Assimp::Importer& importer, const std::string& path, const std::string& label,
              bool flat, const char* format) {
  const aiScene* scene = nullptr;
  std::string reason;
  const DroppedFaces dropped_faces;
  try {
    scene = importer.ReadFile(path, 0);
    reason = importer.GetErrorString();
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (scene == nullptr) wording::fail(wording::kRejected, label, format, one_sentence(reason));
  if (dropped_faces.any()) wording::fail(wording::kFacesDropped, label);
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) check_mesh(*scene->mMeshes[m], label);
  // Pre-transforming, joining and splitting are left out on purpose: see import.h.
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    wording::fail(wording::kRejected, label, format, one_sentence(importer.GetErrorString()));
  }
  Scene result = Conversion(*scene, label, flat).run();
  if (result.instances.empty()) {
    wording::fail(wording::kNoTriangles, label, result.dropped.zero_area_triangles,
                  result.dropped.points_and_lines);
  }
  return result;
}

// An importer deletes its file system at its end, unless it has got another one by then.
class Lend {
 public:
  Lend(Assimp::Importer& importer, Assimp::IOSystem& files) : importer_(importer) {
    importer_.SetIOHandler(&files);
  }
  Lend(const Lend&) = delete;
  Lend& operator=(const Lend&) = delete;
  ~Lend() { importer_.SetIOHandler(nullptr); }

 private:
  Assimp::Importer& importer_;
};

// A material file that is not there costs colours, not the picture.
void note_missing(const std::vector<std::string>& material_files, Assimp::IOSystem& files,
                  const std::string& path, const std::string& label, Scene& scene) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (const std::string& name : material_files) {
    if (!files.Exists((folder / name).string().c_str())) {
      scene.notes.push_back(fmt::format(wording::kNoMaterialFile, label, name));
    }
  }
}

}  // namespace

void require_inverse(const Instance& instance, const std::string& label) {
  const glm::dmat4& m = instance.transform;
  bool affine = true;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) affine &= std::isfinite(m[column][row]);
    affine &= m[column][3] == (column == 3 ? 1.0 : 0.0);
  }
  if (!affine) wording::fail(wording::kTransformNotAffine, label, instance.name);
  const glm::dmat3 linear(m);
  const double lengths = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
  if (!(std::abs(glm::determinant(linear)) > kSingular * lengths)) {
    wording::fail(wording::kNoInverse, label, instance.name);
  }
}

Scene import_obj(Assimp::IOSystem& files, const std::string& path, const std::string& text,
                 const std::string& label) {
  const std::vector<std::string> material_files = check_obj(text, label);
  Assimp::Importer importer;
  const Lend lend(importer, files);
  Scene scene = convert(importer, path, label, true, "OBJ");
  note_missing(material_files, files, path, label, scene);
  return scene;
}

Scene import_file(const std::string& path) {
  const std::string text = read_file(path);
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".obj") {
    Assimp::DefaultIOSystem disk;
    return import_obj(disk, path, text, path);
  }
  Assimp::Importer importer;
  if (extension == ".ply") {
    check_ply(text, path);
    return convert(importer, path, path, true, "PLY");
  }
  if (extension == ".gltf" || extension == ".glb") {
    check_gltf(text, path);
    return convert(importer, path, path, false, "glTF");
  }
  wording::fail(wording::kExtension, path, extension);
}

}  // namespace dynrt::host
