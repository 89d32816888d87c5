// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Every sentence that a user can get from a scene that is not as it should be: each names the file
// (and the line, mesh or node), says what is wrong and what would be right.
#pragma once

#include <fmt/format.h>

#include "host/error.h"

namespace dynrt::host::wording {

using Text = const char[];

// Which file
inline constexpr Text kUnknownScene =
    "there is no scene '{}': give a built-in name ({}) or the path of a file";
inline constexpr Text kUnreadable = "{}: cannot be read ({})";
inline constexpr Text kNotAFile = "{}: is not a file; give the path of one";
inline constexpr Text kEmptyFile = "{}: the file is empty";
inline constexpr Text kExtension =
    "{}: the extension '{}' is not known; scenes are .json, .bsp and .pk3 files and those that "
    "Assimp reads: {}";
inline constexpr Text kRejected = "{}: is not a valid {} file: {}";
inline constexpr Text kNotOfFormat =
    "{}: is not a valid {} file: its content is of another format, or cut off";

// What an import gives
inline constexpr Text kVertexNotFinite =
    "{}: mesh '{}', vertex {}: the position ({}, {}, {}) is not finite";
inline constexpr Text kFacesDropped =
    "{}: has faces that use vertices which their mesh does not have";
inline constexpr Text kFaceRange =
    "{}: mesh '{}', face {}: uses vertex {}, but the mesh has {} vertices";
inline constexpr Text kFaceEmpty = "{}: mesh '{}', face {}: has no vertices; it needs three";
inline constexpr Text kNoInverse =
    "{}: node '{}': its transform has no inverse; no axis may be scaled to zero and the three must "
    "not lie in one plane";
inline constexpr Text kTransformNotAffine =
    "{}: node '{}': its transform is not affine; the last row must be 0 0 0 1 and all numbers "
    "finite";
inline constexpr Text kCameraNode = "{}: node '{}': {}";
inline constexpr Text kNoTriangles =
    "{}: the scene has no triangles ({} of zero area, {} points and lines left out)";

inline constexpr Text kChannelEmpty =
    "{}: node '{}': its animation has no keyframes; give it at least one or take it out";
inline constexpr Text kKeyframe =
    "{}: node '{}': keyframe {} of its animation, at {} seconds, cannot be used; times must rise "
    "from at least 0, values be finite, rotations not zero";
inline constexpr Text kLight =
    "{}: light '{}': its position and its colour must be finite and the colour not negative";

inline constexpr Text kLightDistant =
    "scene '{}': light '{}' is infinitely far away; only point lights shine here: make it one, far "
    "away if need be, or take it out";
inline constexpr Text kLightOnSurface =
    "scene '{}': light '{}' at ({:g}, {:g}, {:g}) lies on {} {} of '{}', nearer than the "
    "core's numbers tell apart; move it away from the surface";
inline constexpr Text kLightInside =
    "scene '{}': light '{}' at ({:g}, {:g}, {:g}) lies inside '{}', which is closed and lets none "
    "of it out; move the light";
inline constexpr Text kNoMaterialNamed = "scene '{}' has no material '{}'; it has {}";

// Notes, which stop nothing
inline constexpr Text kAnimations = "{}: has {} animations, of which only '{}' is used";
inline constexpr Text kNothingMoves =
    "{}: the animation '{}' moves {} and no node, so the scene is rendered at rest";
inline constexpr Text kSkins =
    "{}: {} mesh{} with {} cannot follow the animation of bones, so dynrt renders them at rest";
inline constexpr Text kLightNotPoint = "{}: light '{}' is not a point light and was left out";
inline constexpr Text kCameraNotPerspective =
    "{}: camera '{}' is not a perspective camera and was left out";
inline constexpr Text kTextures =
    "{}: has {} base colour texture{}; a material gets the mean colour of its texture";
inline constexpr Text kTexturesUnread =
    "{}: {} of its textures cannot be read, so their materials keep their own colours: {}{}";
inline constexpr Text kCameraAngle =
    "{}: the angle of camera '{}' is not read, as the camera has no name; it is taken as {} "
    "degrees";
inline constexpr Text kNoMaterialFile =
    "{}: the material file '{}' is not there, so its materials are grey";

// OBJ, by line
inline constexpr Text kObjVertex = "{}:{}: a vertex needs three numbers, not '{}'";
inline constexpr Text kObjFaceShort =
    "{}:{}: a face needs at least three vertices, this one has {}";

// PLY
inline constexpr Text kPlyHeader = "{}:{}: '{}' is not a line of a PLY header";
inline constexpr Text kPlyHeaderEnds =
    "{}: the PLY header has no 'end_header'; the file seems cut off";
inline constexpr Text kPlyCutOff =
    "{}: the PLY header announces {} of element '{}', but the file ends after {}; it seems cut off";
inline constexpr Text kPlyShort =
    "{}:{}: the line has fewer numbers than element '{}' has properties";

// glTF
inline constexpr Text kSkinWithoutMatrices =
    "{}: skin {} has no 'inverseBindMatrices', which it needs here; export the file with them or "
    "without the skin";
inline constexpr Text kNodesDeep =
    "{}: node '{}' lies more than {} levels deep or inside itself; flatten the node graph";

// Scene descriptions
inline constexpr Text kJsonDeep =
    "{}: is not a valid file: its JSON is nested deeper than {} levels";
inline constexpr Text kJson = "{}:{}: is not valid JSON: {}";
inline constexpr Text kDescription = "{}: {}: {}";
inline constexpr Text kNoColour = "'{}' is not one of the file's colours";
inline constexpr Text kColourRange = "'{}' must be three numbers from 0 to 1";
inline constexpr Text kTwice = "there are two objects named '{}'";
inline constexpr Text kNoParts = "the object '{}' has no parts";
inline constexpr Text kSize = "'size' must be three numbers above zero";
inline constexpr Text kNoMaterial = "the model has no material '{}'; it has {}";
inline constexpr Text kNoTexture = "the map has no texture '{}'; it has {}";
inline constexpr Text kPartKind =
    "a part needs one of the keys 'model', 'map', 'generate' and 'primitive'";
inline constexpr Text kPrimitive = "'{}' is not a primitive; sphere and rectangle are";
inline constexpr Text kRadius = "a sphere has either a 'radius' or three 'radii'";
inline constexpr Text kRadii = "'radii' must be three numbers above zero";
inline constexpr Text kSphereMirror =
    "a sphere that is a primitive cannot be a 'mirror', as every point of it would need a "
    "reflection of its own; generate a sphere of triangles";
inline constexpr Text kRectangle = "'across' and 'along' must not be zero nor lie on one line";
inline constexpr Text kBoxCorners = "'from' must be below 'to' on every axis";
inline constexpr Text kShape = "'{}' cannot be generated; sphere, box, torus and hills can";
inline constexpr Text kNoObject = "there is no object '{}'";
inline constexpr Text kAxis = "'axis' must not be zero";
inline constexpr Text kScatterCorners = "'from' must be below 'to' on both axes";
inline constexpr Text kScatterScale = "'scale' must be two numbers above zero, the lower one first";
inline constexpr Text kScatterFull =
    "only {} of {} instances of '{}' find room; scatter fewer, less far apart or more widely";
inline constexpr Text kUnusedObject = "no instance uses the object '{}'";
inline constexpr Text kKeyMissing = "{}: {}: the key '{}' is missing";
inline constexpr Text kKeyUnknown = "{}: {}: the key '{}' is not known; it takes {}";
inline constexpr Text kKeyType = "{}: {}: '{}' must be {}";

// The furniture package
inline constexpr Text kNoPackage =
    "the models of this scene come from the Debian package sweethome3d-furniture, which is not "
    "installed ({} has no .sh3f file); install it with: apt-get install sweethome3d-furniture";
inline constexpr Text kNoModel =
    "{}: {}: the package sweethome3d-furniture has no model with the catalogue id '{}'";
inline constexpr Text kCatalogueKey =
    "{}: the catalogue's entry '{}' has no usable '{}'; reinstall the package "
    "sweethome3d-furniture";
inline constexpr Text kBadLibrary = "{}: is not a readable zip library ({}); {}";

// Maps
inline constexpr Text kBspMagic =
    "{}: is not a Quake 3 map: it must begin with 'IBSP' and the version 46";
inline constexpr Text kBspVersion =
    "{}: is a map of version {}; only version {}, Quake 3's, is read";
inline constexpr Text kBspHeader =
    "{}: the map has {} bytes, but its header alone has {}; it seems cut off";
inline constexpr Text kBspLump =
    "{}: the map's {} lie in bytes {} to {}, but it has {} bytes; it seems cut off";
inline constexpr Text kBspLumpSize =
    "{}: the map's {} take {} bytes, which is not a multiple of {}; the file is damaged";
inline constexpr Text kBspVertex = "{}: vertex {} is not finite; the file is damaged";
inline constexpr Text kBspFaceRange =
    "{}: face {} uses {} {} to {}, but there are {}; the file is damaged";
inline constexpr Text kBspFaceType =
    "{}: face {} is of type {}; types are 1 (polygon), 2 (patch), 3 (mesh) and 4 (billboard)";
inline constexpr Text kBspPatch =
    "{}: face {} is a patch of {} by {} control points and has {}; both sides must be odd and at "
    "least 3 and their product be that number";
inline constexpr Text kBspCorners =
    "{}: face {} has {} corners, which is not a multiple of 3; the file is damaged";
inline constexpr Text kBspModel =
    "{}: model {} uses faces {} to {}, but there are {}; the file is damaged";
inline constexpr Text kBspEntities =
    "{}: the list of entities ends within one; the file is damaged";
inline constexpr Text kBspEntity =
    "{}: an entity places the model '{}' at '{}'; it must be one of {} models, '*' and its number, "
    "at three numbers";
inline constexpr Text kNoMaps = "{}: holds no map (maps/NAME.bsp)";
inline constexpr Text kWhichMap = "{}: holds {} maps; name one, such as {}:{} (there are {})";
inline constexpr Text kNoMap = "{}: has no map '{}'; it has {}";
inline constexpr Text kNoMapPackage =
    "the map of this scene comes from the Debian package openarena-081-maps, which is not "
    "installed ({} is missing); install it with: apt-get install openarena-081-maps";

// Motion
inline constexpr Text kNoKeys = "'{}' has no keys; it needs at least one";
inline constexpr Text kKeyTime = "'time' must be at least 0 and above that of the key before";
inline constexpr Text kKeyScale =
    "'scale' must not be zero and on no axis change its sign from the instance's";
inline constexpr Text kKeyTurn = "'turn' may change by at most {} degrees from the key before";
inline constexpr Text kRepeat = "'repeat' needs a key later than at time 0";
inline constexpr Text kMatrixMotion =
    "an instance with a 'motion' cannot be placed by a 'matrix'; give position, turn, rotate, "
    "scale";
inline constexpr Text kPathCamera =
    "a 'path' needs a 'camera', which has its field of view and what is up";
inline constexpr Text kCameraTime = "{}, after {} seconds: {}";
inline constexpr Text kAtTime = "{}, after {} seconds";

// Cameras
inline constexpr Text kFieldOfView =
    "the camera's field of view is {} degrees; it must lie between 0 and 180";
inline constexpr Text kCameraNotFinite = "the camera's {} ({}, {}, {}) is not finite";
inline constexpr Text kCameraPoint =
    "the camera stands at the point that it looks at ({}, {}, {}); move one of the two";
inline constexpr Text kCameraUp =
    "the camera's up ({}, {}, {}) is parallel to its view; give another one";
inline constexpr Text kImageSize = "the image is {}x{} pixels; both sides must be at least 1";

template <typename... Args>
[[noreturn]] void fail(fmt::format_string<const Args&...> text, const Args&... args) {
  throw UserError(fmt::format(text, args...));
}

}  // namespace dynrt::host::wording
