// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/assimp_scene.h"

#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "host/error.h"
#include "host/scene/animation.h"
#include "host/scene/camera.h"
#include "host/scene/import.h"
#include "host/scene/mesh_builder.h"

namespace dynrt::host {

namespace {

constexpr ai_real kMetallic = 0.5f;  // at least this metallic
constexpr ai_real kPolished = 0.5f;  // and at most this rough is a mirror

// The angle that Assimp 5.2 gives a COLLADA camera without a name: it does not read such a camera,
// and turns its default into radians a second time.
constexpr ai_real kNotRead = AI_DEG_TO_RAD(0.25f * static_cast<float>(AI_MATH_PI));
constexpr double kFieldOfView = 45.0;  // of such a camera, in degrees

glm::dvec3 to_glm(const aiVector3D& v) { return {v.x, v.y, v.z}; }

glm::dmat4 to_glm(const aiMatrix4x4& m) {  // Assimp's rows to GLM's columns
  return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2,
          m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

bool finite(const glm::dvec3& v) { return std::isfinite(v.x + v.y + v.z); }

class Conversion {
 public:
  Conversion(const aiScene& from, const std::string& label, AssimpForm form)
      : from_(from), label_(label), form_(form) {}

  Scene run() {
    scene_.name = std::filesystem::path(label_).stem().string();
    for (unsigned i = 0; i < from_.mNumMaterials; ++i) material(*from_.mMaterials[i]);
    if (form_ == AssimpForm::kOneMesh) {
      MeshBuilder builder(scene_.name);
      flatten(*from_.mRootNode, builder);
      keep(std::move(builder), {scene_.name, 0, glm::dmat4(1.0)});
    } else {
      find_channels();
      nodes(*from_.mRootNode, glm::dmat4(1.0), std::nullopt);
      rest_skins();
      if (!scene_.motion.empty()) move_to(scene_, 0.0);
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
    // A glTF material is metallic unless it says otherwise, but as rough as can be.
    ai_real metallic = 0, roughness = 1;
    from.Get(AI_MATKEY_METALLIC_FACTOR, metallic);
    from.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness);
    if (metallic >= kMetallic && roughness <= kPolished) material.mirror = kMirrorShare;
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

  // Takes the object that was built, unless it is empty.
  bool keep(MeshBuilder&& builder, Instance instance) {
    scene_.dropped.zero_area_triangles += builder.zero_area_triangles();
    Mesh mesh = builder.take();
    if (mesh.triangles.empty()) return false;
    instance.object = static_cast<std::uint32_t>(scene_.objects.size());
    scene_.objects.push_back(std::move(mesh));
    scene_.instances.push_back(std::move(instance));
    return true;
  }

  /// Of the first animation that moves nodes.
  void find_channels() {
    const std::span<aiAnimation*> animations(from_.mAnimations, from_.mNumAnimations);
    if (animations.empty()) return;
    const auto moves_nodes = [](const aiAnimation* a) { return a->mNumChannels > 0; };
    const auto found = std::ranges::find_if(animations, moves_nodes);
    if (found == animations.end()) {
      note_rest(*animations[0]);
      return;
    }
    const aiAnimation& animation = **found;
    if (animations.size() > 1) {
      scene_.notes.push_back(fmt::format("{}: the file has {} animations; dynrt uses only '{}'",
                                         label_, animations.size(), animation.mName.C_Str()));
    }
    seconds_ = 1.0 / (animation.mTicksPerSecond > 0.0 ? animation.mTicksPerSecond : 1.0);
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
      channel_of_[animation.mChannels[c]->mNodeName.C_Str()] = animation.mChannels[c];
    }
  }

  void note_rest(const aiAnimation& animation) {
    const char* moved = animation.mNumMorphMeshChannels > 0 ? "morph targets"
                        : animation.mNumMeshChannels > 0    ? "vertices"
                                                            : "parts that dynrt does not know";
    scene_.notes.push_back(fmt::format(
        "{}: the animation '{}' moves no node, only {}, so dynrt renders the scene at rest", label_,
        animation.mName.C_Str(), moved));
  }

  /// Bones move no instance, so parts that only follow bones stand still.
  void rest_skins() {
    std::size_t skins = 0;
    for (unsigned m = 0; m < from_.mNumMeshes; ++m) skins += from_.mMeshes[m]->HasBones();
    if (skins == 0 || from_.mNumAnimations == 0) return;
    scene_.notes.push_back(fmt::format(
        "{}: {} mesh{} with {} cannot follow the animation of bones, so dynrt renders them at rest",
        label_, skins, skins == 1 ? "" : "es", skins == 1 ? "a skin" : "skins"));
    rest_if_nothing_moves(scene_);
  }

  // `moved_by`: index of the parent's motion in Scene::motion.
  void nodes(const aiNode& node, const glm::dmat4& parent, std::optional<std::uint32_t> moved_by) {
    const glm::dmat4 transform = parent * to_glm(node.mTransformation);
    const std::string name = node.mName.C_Str();
    const auto channel = channel_of_.find(name);
    if (moved_by || channel != channel_of_.end()) {
      if (!moved_by && parent != glm::dmat4(1.0))
        moved_by = add_motion("above " + name, parent, {});
      moved_by = add_motion(name, to_glm(node.mTransformation), moved_by);
      if (channel != channel_of_.end()) keyframes(*channel->second, scene_.motion.back());
    }
    if (node.mNumMeshes > 0) instance(node, {name, 0, transform, moved_by});
    for (unsigned c = 0; !scene_.camera && c < from_.mNumCameras; ++c) {
      if (from_.mCameras[c]->mName != node.mName) continue;
      camera(*from_.mCameras[c], transform);
      if (scene_.camera) scene_.camera_motion = moved_by;
    }
    for (unsigned l = 0; l < from_.mNumLights; ++l) {
      if (from_.mLights[l]->mName == node.mName) light(*from_.mLights[l], transform);
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c) nodes(*node.mChildren[c], transform, moved_by);
  }

  std::uint32_t add_motion(const std::string& name, const glm::dmat4& transform,
                           std::optional<std::uint32_t> parent) {
    MotionNode node;
    node.name = name;
    node.parent = parent;
    node.transform = transform;
    scene_.motion.push_back(std::move(node));
    return static_cast<std::uint32_t>(scene_.motion.size() - 1);
  }

  // Assimp gives a node that is animated in one way the keys of the two others as well: one each.
  void keyframes(const aiNodeAnim& from, MotionNode& to) const {
    for (unsigned k = 0; k < from.mNumPositionKeys; ++k) {
      to.position.push_back(
          {from.mPositionKeys[k].mTime * seconds_, to_glm(from.mPositionKeys[k].mValue)});
      require_key(to.position, finite(to.position.back().value), to.name);
    }
    for (unsigned k = 0; k < from.mNumRotationKeys; ++k) {
      const aiQuaternion& q = from.mRotationKeys[k].mValue;
      const glm::dquat rotation(q.w, q.x, q.y, q.z);
      const double length = glm::length(rotation);
      to.rotation.push_back({from.mRotationKeys[k].mTime * seconds_, rotation / length});
      require_key(to.rotation, std::isfinite(length) && length > 0.0, to.name);
    }
    for (unsigned k = 0; k < from.mNumScalingKeys; ++k) {
      to.scale.push_back(
          {from.mScalingKeys[k].mTime * seconds_, to_glm(from.mScalingKeys[k].mValue)});
      require_key(to.scale, finite(to.scale.back().value), to.name);
    }
  }

  // Of the last key.
  template <typename Keys>
  void require_key(const Keys& keys, bool is_finite, const std::string& node) const {
    const double time = keys.back().time;
    const bool rises = keys.size() == 1 || time > keys[keys.size() - 2].time;
    if (!is_finite || !(time >= 0.0) || !rises || !std::isfinite(time)) {
      refuse(
          "{}: node '{}': keyframe {} of its animation, at {} seconds, cannot be used; times must "
          "not be negative and must rise, values must be finite, rotations must not be zero",
          label_, node, keys.size() - 1, time);
    }
  }

  void instance(const aiNode& node, Instance instance) {
    const std::vector<unsigned> meshes(node.mMeshes, node.mMeshes + node.mNumMeshes);
    require_inverse(instance, label_);
    const auto known = object_of_.find(meshes);
    if (known == object_of_.end()) {
      MeshBuilder builder(object_name(meshes));
      for (const unsigned m : meshes) add(*from_.mMeshes[m], builder);
      const bool kept = keep(std::move(builder), std::move(instance));
      object_of_[meshes] = kept ? static_cast<int>(scene_.objects.size()) - 1 : kNothingLeft;
    } else if (known->second != kNothingLeft) {
      instance.object = static_cast<std::uint32_t>(known->second);
      scene_.instances.push_back(std::move(instance));
    }
  }

  // Assimp makes meshes NAME-0, NAME-1, ... of the primitives of one glTF mesh.
  std::string object_name(const std::vector<unsigned>& meshes) const {
    std::string name = from_.mMeshes[meshes[0]]->mName.C_Str();
    if (meshes.size() > 1 && name.ends_with("-0")) name.resize(name.size() - 2);
    return name;
  }

  void camera(const aiCamera& from, const glm::dmat4& transform) {
    const double field_of_view = vertical_angle(from);
    if (!(field_of_view > 0.0)) {
      scene_.notes.push_back(
          fmt::format("{}: camera '{}' is not a perspective camera, so dynrt leaves it out", label_,
                      from.mName.C_Str()));
      return;
    }
    // A glTF camera looks along -z of its node, y up; Assimp repeats the node's translation in its
    // position.
    const bool gltf = form_ == AssimpForm::kGltf;
    const glm::dvec3 at = gltf ? glm::dvec3(0.0) : to_glm(from.mPosition);
    const glm::dvec3 view = gltf ? glm::dvec3(0.0, 0.0, -1.0) : to_glm(from.mLookAt);
    const glm::dvec3 up = gltf ? glm::dvec3(0.0, 1.0, 0.0) : to_glm(from.mUp);
    const glm::dvec3 position(transform * glm::dvec4(at, 1.0));
    const glm::dmat3 linear(transform);
    try {
      scene_.camera = look_at(position, position + linear * view, linear * up, field_of_view, 1.0);
    } catch (const UserError& error) {
      refuse("{}: node '{}': {}", label_, from.mName.C_Str(), error.what());
    }
  }

  /// In degrees; not above 0 for a camera without perspective.
  double vertical_angle(const aiCamera& from) {
    const double aspect = from.mAspect > 0.0f ? from.mAspect : 1.0;
    if (from.mHorizontalFOV == kNotRead) {
      scene_.notes.push_back(fmt::format(
          "{}: camera '{}' has no name, so dynrt cannot read its angle and takes {} degrees",
          label_, from.mName.C_Str(), kFieldOfView));
      return kFieldOfView;
    }
    // Of a glTF camera, Assimp gives the vertical angle times the aspect as the horizontal one.
    if (form_ == AssimpForm::kGltf) return glm::degrees(from.mHorizontalFOV / aspect);
    return glm::degrees(2.0 * std::atan(std::tan(from.mHorizontalFOV / 2.0) / aspect));
  }

  void light(const aiLight& from, const glm::dmat4& transform) {
    const std::string name = from.mName.C_Str();
    if (from.mType != aiLightSource_POINT) {
      scene_.notes.push_back(
          fmt::format("{}: light '{}' is not a point light, so dynrt leaves it out", label_, name));
      if (from.mType == aiLightSource_DIRECTIONAL) scene_.distant_lights.push_back(name);
      return;
    }
    const aiColor3D& c = from.mColorDiffuse;
    const glm::dvec3 position(transform * glm::dvec4(to_glm(from.mPosition), 1.0));
    PointLight light{name, position, {c.r, c.g, c.b}};
    if (!finite(light.position) || !finite(light.colour) ||
        glm::any(glm::lessThan(light.colour, glm::dvec3(0.0)))) {
      refuse(
          "{}: light '{}': its position and its colour must be finite, and the colour must not be "
          "negative",
          label_, name);
    }
    scene_.lights.push_back(std::move(light));
  }

  static constexpr int kNothingLeft = -1;

  const aiScene& from_;
  const std::string& label_;
  const AssimpForm form_;
  Scene scene_;
  std::map<std::vector<unsigned>, int> object_of_;
  std::map<std::string, const aiNodeAnim*> channel_of_;  // by node
  double seconds_ = 1.0;                                 // of a tick of the animation's clock
};

}  // namespace

void rest_if_nothing_moves(Scene& scene) {
  const bool moves = scene.camera_motion.has_value() ||
                     std::ranges::any_of(scene.instances, [](const Instance& instance) {
                       return instance.motion.has_value();
                     });
  if (!moves) scene.motion.clear();
}

Scene convert_assimp(const aiScene& from, const std::string& label, AssimpForm form) {
  return Conversion(from, label, form).run();
}

}  // namespace dynrt::host
