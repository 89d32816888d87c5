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
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string_view>

#include "host/scene/assimp_scene.h"
#include "host/scene/check_file.h"
#include "host/scene/text_lines.h"
#include "host/scene/wording.h"

#if __has_feature(address_sanitizer)
// Assimp leaks its open file when it rejects one; LeakSanitizer asks for this by name.
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }
#endif

namespace dynrt::host {

namespace {

constexpr double kSingular = 1e-12;  // the volume that three unit axes must exceed

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
  Scene result = convert_assimp(*scene, label, flat);
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
