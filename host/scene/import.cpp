// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/import.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string_view>

#include "host/error.h"
#include "host/scene/assimp_scene.h"
#include "host/scene/check_file.h"
#include "host/scene/crash_guard.h"
#include "host/scene/memory_files.h"
#include "host/scene/scene_messages.h"
#include "host/scene/text_encoding.h"
#include "host/scene/text_lines.h"
#include "host/scene/textures.h"

#if __has_feature(address_sanitizer)
// Assimp leaks its open file when it rejects one; LeakSanitizer asks for this by name.
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }
#endif

namespace dynrt::host {

namespace {

constexpr char kRejected[] = "{}: not a valid {} file: {}";

constexpr double kSingular = 1e-12;  // the volume that three unit axes must exceed

std::string one_sentence(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  text = trim(text);
  while (text.ends_with('.')) text.pop_back();
  return text.empty() ? "no reason given" : text;
}

/// Assimp leaves out glTF faces whose vertices do not exist and only says so in its log. Its logger
/// is one for the whole process; this listens to it for one import.
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

/// Checks faces before Assimp triangulates them, as an unexpected face would end the program there.
void check_mesh(const aiMesh& mesh, const std::string& label) {
  const std::string name = mesh.mName.C_Str();
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& v = mesh.mVertices[i];
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
      refuse("{}: mesh '{}', vertex {}: the position ({}, {}, {}) is not finite", label, name, i,
             v.x, v.y, v.z);
    }
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices == 0) {
      refuse("{}: mesh '{}', face {}: the face has no vertices; it needs three", label, name, f);
    }
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      if (face.mIndices[k] < mesh.mNumVertices) continue;
      refuse("{}: mesh '{}', face {}: the face uses vertex {}, but the mesh has {} vertices", label,
             name, f, face.mIndices[k], mesh.mNumVertices);
    }
  }
}

/// Assimp's scene of a file's content. `format` is the format's name in messages.
const aiScene& read(Assimp::Importer& importer, const std::string& path, const std::string& label,
                    const std::string& format) {
  // Else Assimp puts nodes of its own between those of an FBX file, and draws skeletons.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene = nullptr;
  std::string reason;
  const DroppedFaces dropped_faces;
  try {
    scene = importer.ReadFile(path, 0);
    reason = importer.GetErrorString();
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (scene == nullptr && reason.starts_with("No suitable reader")) {
    refuse("{}: not a valid {} file: it has another format or is cut off", label, format);
  }
  if (scene == nullptr) refuse(kRejected, label, format, one_sentence(reason));
  if (dropped_faces.any()) {
    refuse("{}: some faces use vertices that their mesh does not have", label);
  }
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) check_mesh(*scene->mMeshes[m], label);
  // Pre-transforming, joining and splitting are left out on purpose: see import.h.
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    refuse(kRejected, label, format, one_sentence(importer.GetErrorString()));
  }
  return *scene;
}

/// A path's extension in small letters, with its point.
std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

bool is_gltf(std::string_view extension) { return extension == ".gltf" || extension == ".glb"; }

/// The usual name of the format: OBJ, 3DS, glTF.
std::string format_of(std::string_view extension) {
  if (is_gltf(extension)) return "glTF";
  std::string name(extension.substr(1));
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

std::string crash_of(const std::string& label, std::string_view extension) {
  return fmt::format(
      "{}: is damaged: Assimp crashed while it read this {} file; export it again, or in another "
      "format",
      label, format_of(extension));
}

AssimpForm form_of(std::string_view extension) {
  constexpr std::array<std::string_view, 4> kOfOneMesh = {".obj", ".ply", ".stl", ".off"};
  if (is_gltf(extension)) return AssimpForm::kGltf;
  return std::ranges::find(kOfOneMesh, extension) == kOfOneMesh.end() ? AssimpForm::kNodes
                                                                      : AssimpForm::kOneMesh;
}

Scene convert(Assimp::Importer& importer, const std::string& path, const std::string& label,
              Textures textures = Textures::kMixed) {
  const std::string extension = extension_of(path);
  const aiScene& scene = read(importer, path, label, format_of(extension));
  Scene result = convert_assimp(scene, label, form_of(extension));
  if (textures == Textures::kMixed) {
    mix_textures(scene, *importer.GetIOHandler(), path, label, result);
  }
  if (result.instances.empty()) {
    refuse(messages::kNoTriangles, label, result.dropped.zero_area_triangles,
           result.dropped.points_and_lines);
  }
  return result;
}

/// An importer deletes its file system at its end, unless it has got another one by then.
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

/// A material file that is not there costs colours, not the picture.
void note_missing(const std::vector<std::string>& material_files, Assimp::IOSystem& files,
                  const std::string& path, const std::string& label, Scene& scene) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (const std::string& name : material_files) {
    if (!files.Exists((folder / name).string().c_str())) {
      scene.notes.push_back(fmt::format(
          "{}: there is no material file '{}', so its materials are grey", label, name));
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
  if (!affine) {
    refuse(
        "{}: node '{}': its transform is not affine; the last row must be 0 0 0 1, and all numbers "
        "must be finite",
        label, instance.name);
  }
  const glm::dmat3 linear(m);
  const double lengths = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
  if (!(std::abs(glm::determinant(linear)) > kSingular * lengths)) {
    refuse(
        "{}: node '{}': its transform has no inverse; its three axes must not be zero and must not "
        "lie in one plane",
        label, instance.name);
  }
}

std::vector<std::string> assimp_extensions() {
  aiString list;  // "*.3ds;*.obj;..."
  Assimp::Importer().GetExtensionList(list);
  std::vector<std::string> extensions;
  std::string_view rest = list.C_Str();
  while (!rest.empty()) extensions.emplace_back(take_until(rest, ';').substr(1));
  // Of a file that is cut off Assimp's importer of OpenGEX reads for ever.
  std::erase(extensions, ".ogex");
  std::ranges::sort(extensions);
  return extensions;
}

Scene import_obj(Assimp::IOSystem& files, const std::string& path, const std::string& text,
                 const std::string& label, Textures textures) {
  const std::string utf8 = to_utf8(text);
  const std::vector<std::string> material_files = check_obj(utf8, label);
  OneFileReplaced decoded(files, path, utf8);
  const CrashGuard guard(crash_of(label, ".obj"));
  Assimp::Importer importer;
  const Lend lend(importer, decoded);
  Scene scene = convert(importer, path, label, textures);
  note_missing(material_files, files, path, label, scene);
  return scene;
}

namespace {

Scene import_gltf(Assimp::IOSystem& disk, const std::string& path) {
  const MendedGltf gltf = mended_gltf(read_file(path), path);
  OneFileReplaced mended(disk, path, gltf.text);
  Assimp::Importer importer;
  const Lend lend(importer, mended);
  Scene scene = convert(importer, path, path);
  if (gltf.bare_skins > 0) {
    rest_if_nothing_moves(scene);
    const bool one = gltf.bare_skins == 1;
    scene.notes.push_back(
        fmt::format("{}: dynrt leaves out {} skin{} without 'inverseBindMatrices' and renders {} "
                    "meshes at rest",
                    path, gltf.bare_skins, one ? "" : "s", one ? "its" : "their"));
  }
  return scene;
}

}  // namespace

Scene import_file(const std::string& path) {
  const std::string extension = extension_of(path);
  const std::vector<std::string> known = assimp_extensions();
  if (std::ranges::find(known, extension) == known.end()) {
    refuse(
        "{}: dynrt does not read files with the extension '{}'; it reads .json, .bsp and .pk3, and "
        "through Assimp {}",
        path, extension, fmt::format("{}", fmt::join(known, ", ")));
  }
  Assimp::DefaultIOSystem disk;
  const CrashGuard guard(crash_of(path, extension));  // until the importer has tidied up
  Assimp::Importer importer;
  if (extension == ".obj") {
    return import_obj(disk, path, read_file(path), path, Textures::kMixed);
  }
  if (extension == ".ply") {
    const std::string text = mended_ply(read_file(path), path);
    OneFileReplaced mended(disk, path, text);
    const Lend lend(importer, mended);
    return convert(importer, path, path);
  }
  if (is_gltf(extension)) return import_gltf(disk, path);
  require_file(path);
  return convert(importer, path, path);
}

}  // namespace dynrt::host
