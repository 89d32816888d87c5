// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages about mistakes in a scene, and notes about a scene. Each names the file
// (and the line, mesh or node), says what is wrong and what would be right.
#pragma once

#include <fmt/format.h>

#include "host/error.h"

namespace dynrt::host::wording {

// Which file
inline constexpr char kUnknownScene[] =
    "there is no scene '{}': give a built-in name ({}) or the path of a file";
inline constexpr char kUnreadable[] = "{}: cannot read this file ({})";
inline constexpr char kNotAFile[] = "{}: this path is not a file; give the path of a file";
inline constexpr char kSceneFolder[] =
    "{}: this is a folder, but a scene is a file; give the path of a file in it, such as {}";
inline constexpr char kEmptyFile[] = "{}: the file is empty";
inline constexpr char kExtension[] =
    "{}: dynrt does not read files with the extension '{}'; it reads .json, .bsp and .pk3, and "
    "through Assimp {}";
inline constexpr char kRejected[] = "{}: not a valid {} file: {}";
inline constexpr char kNotOfFormat[] =
    "{}: not a valid {} file: it has another format or is cut off";
inline constexpr char kCrash[] =
    "{}: is damaged: Assimp crashed while it read this {} file; export it again, or in another "
    "format";

// What an import gives
inline constexpr char kVertexNotFinite[] =
    "{}: mesh '{}', vertex {}: the position ({}, {}, {}) is not finite";
inline constexpr char kFacesDropped[] = "{}: some faces use vertices that their mesh does not have";
inline constexpr char kFaceRange[] =
    "{}: mesh '{}', face {}: the face uses vertex {}, but the mesh has {} vertices";
inline constexpr char kFaceEmpty[] =
    "{}: mesh '{}', face {}: the face has no vertices; it needs three";
inline constexpr char kNoInverse[] =
    "{}: node '{}': its transform has no inverse; its three axes must not be zero and must not lie "
    "in one plane";
inline constexpr char kTransformNotAffine[] =
    "{}: node '{}': its transform is not affine; the last row must be 0 0 0 1, and all numbers "
    "must be finite";
inline constexpr char kCameraNode[] = "{}: node '{}': {}";
inline constexpr char kNoTriangles[] =
    "{}: the scene has no triangles ({} of zero area, {} points and lines left out)";

inline constexpr char kChannelEmpty[] =
    "{}: node '{}': its animation has no keyframes; add a keyframe or remove the animation";
inline constexpr char kKeyframe[] =
    "{}: node '{}': keyframe {} of its animation, at {} seconds, cannot be used; times must not be "
    "negative and must rise, values must be finite, rotations must not be zero";
inline constexpr char kLight[] =
    "{}: light '{}': its position and its colour must be finite, and the colour must not be "
    "negative";

inline constexpr char kLightDistant[] =
    "scene '{}': light '{}' is infinitely far away, and dynrt has only point lights; make it a "
    "point light that is far away, or remove it";
inline constexpr char kLightOnSurface[] =
    "scene '{}': light '{}' at ({:g}, {:g}, {:g}) lies on {} {} of '{}': the core's numbers cannot "
    "tell the two apart; move the light away from the surface";
inline constexpr char kLightInside[] =
    "scene '{}': light '{}' at ({:g}, {:g}, {:g}) lies inside '{}', a closed object that no light "
    "leaves; move the light";
inline constexpr char kNoMaterialNamed[] = "scene '{}' has no material '{}'; its materials are {}";

// Notes, which are no errors
inline constexpr char kAnimations[] = "{}: the file has {} animations; dynrt uses only '{}'";
inline constexpr char kNothingMoves[] =
    "{}: the animation '{}' moves no node, only {}, so dynrt renders the scene at rest";
inline constexpr char kSkins[] =
    "{}: {} mesh{} with {} cannot follow the animation of bones, so dynrt renders them at rest";
inline constexpr char kBareSkins[] =
    "{}: dynrt leaves out {} skin{} without 'inverseBindMatrices' and renders {} meshes at rest";
inline constexpr char kLightNotPoint[] =
    "{}: light '{}' is not a point light, so dynrt leaves it out";
inline constexpr char kCameraNotPerspective[] =
    "{}: camera '{}' is not a perspective camera, so dynrt leaves it out";
inline constexpr char kTextures[] =
    "{}: the file has {} base colour texture{}; each material gets the mean colour of its texture";
inline constexpr char kTexturesUnread[] =
    "{}: {} of its textures cannot be read, so their materials keep the colours of the file: {}{}";
inline constexpr char kCameraAngle[] =
    "{}: camera '{}' has no name, so dynrt cannot read its angle and takes {} degrees";
inline constexpr char kNoMaterialFile[] =
    "{}: there is no material file '{}', so its materials are grey";

// OBJ, by line
inline constexpr char kObjVertex[] = "{}:{}: a vertex needs three numbers, not '{}'";
inline constexpr char kObjFaceShort[] =
    "{}:{}: a face needs at least three vertices, but this one has {}";

// PLY
inline constexpr char kPlyHeader[] = "{}:{}: '{}' is not a line of a PLY header";
inline constexpr char kPlyHeaderEnds[] =
    "{}: the PLY header has no 'end_header'; the file seems cut off";
inline constexpr char kPlyCutOff[] =
    "{}: the PLY header announces {} of element '{}', but the file ends after {}; it seems cut off";
inline constexpr char kPlyShort[] =
    "{}:{}: the line has fewer numbers than element '{}' has properties";

// glTF
inline constexpr char kNodesDeep[] =
    "{}: node '{}' lies more than {} levels deep or inside itself; flatten the node graph";

// Scene descriptions
inline constexpr char kJsonDeep[] =
    "{}: not a valid file: its JSON is nested deeper than {} levels";
inline constexpr char kJson[] = "{}:{}: not valid JSON: {}";
inline constexpr char kDescription[] = "{}: {}: {}";
inline constexpr char kNoColour[] = "'{}' is not a colour of this file";
inline constexpr char kColourRange[] = "'{}' must be three numbers from 0 to 1";
inline constexpr char kTwice[] = "there are two objects named '{}'";
inline constexpr char kNoParts[] = "the object '{}' has no parts";
inline constexpr char kSize[] = "'size' must be three numbers above zero";
inline constexpr char kNoMaterial[] = "the model has no material '{}'; its materials are {}";
inline constexpr char kNoTexture[] = "the map has no texture '{}'; its textures are {}";
inline constexpr char kPartKind[] =
    "a part needs one of the keys 'model', 'map', 'generate' and 'primitive'";
inline constexpr char kPrimitive[] =
    "'{}' is not a primitive; the primitives are sphere and rectangle";
inline constexpr char kRadius[] = "a sphere has either a 'radius' or three 'radii'";
inline constexpr char kRadii[] = "'radii' must be three numbers above zero";
inline constexpr char kSphereMirror[] =
    "a sphere that is a primitive cannot be a 'mirror', as each of its points would reflect in "
    "another direction; generate a sphere of triangles";
inline constexpr char kRectangle[] =
    "'across' and 'along' must not be zero and must not lie on one line";
inline constexpr char kBoxCorners[] = "'from' must be below 'to' on every axis";
inline constexpr char kShape[] =
    "dynrt cannot generate '{}'; it generates sphere, box, torus and hills";
inline constexpr char kNoObject[] = "there is no object '{}'";
inline constexpr char kAxis[] = "'axis' must not be zero";
inline constexpr char kScatterCorners[] = "'from' must be below 'to' on both axes";
inline constexpr char kScatterScale[] =
    "'scale' must be two numbers above zero, the lower one first";
inline constexpr char kScatterFull[] =
    "there is room for only {} of {} instances of '{}'; scatter fewer, closer together or over a "
    "larger area";
inline constexpr char kUnusedObject[] = "no instance uses the object '{}'";
inline constexpr char kKeyMissing[] = "{}: {}: the key '{}' is missing";
inline constexpr char kKeyUnknown[] = "{}: {}: there is no key '{}' here; the keys are {}";
inline constexpr char kKeyType[] = "{}: {}: '{}' must be {}";

// The furniture package
inline constexpr char kNoPackage[] =
    "the models of this scene come from the Debian package sweethome3d-furniture, which is not "
    "installed ({} has no .sh3f file); install it with: apt-get install sweethome3d-furniture";
inline constexpr char kNoModel[] =
    "{}: {}: the package sweethome3d-furniture has no model with the catalogue id '{}'";
inline constexpr char kCatalogueKey[] =
    "{}: the catalogue's entry '{}' has no usable '{}'; reinstall the package "
    "sweethome3d-furniture";
inline constexpr char kBadLibrary[] = "{}: cannot read this zip library ({}); {}";

// Maps
inline constexpr char kBspMagic[] =
    "{}: not a Quake 3 map: the file must begin with 'IBSP' and the version 46";
inline constexpr char kBspVersion[] =
    "{}: the map has version {}; dynrt reads only version {}, that of Quake 3";
inline constexpr char kBspHeader[] =
    "{}: the map has {} bytes, fewer than the {} of its header; it seems cut off";
inline constexpr char kBspLump[] =
    "{}: the map's {} lie in bytes {} to {}, but it has {} bytes; it seems cut off";
inline constexpr char kBspLumpSize[] =
    "{}: the map's {} take {} bytes, which is not a multiple of {}; the file is damaged";
inline constexpr char kBspVertex[] = "{}: vertex {} is not finite; the file is damaged";
inline constexpr char kBspFaceRange[] =
    "{}: face {} uses {} {} to {}, but there are {}; the file is damaged";
inline constexpr char kBspFaceType[] =
    "{}: face {} is of type {}; types are 1 (polygon), 2 (patch), 3 (mesh) and 4 (billboard)";
inline constexpr char kBspPatch[] =
    "{}: face {} is a patch of {} by {} control points and has {}; both sides must be odd and at "
    "least 3, and their product must be that number";
inline constexpr char kBspCorners[] =
    "{}: face {} has {} corners, which is not a multiple of 3; the file is damaged";
inline constexpr char kBspModel[] =
    "{}: model {} uses faces {} to {}, but there are {}; the file is damaged";
inline constexpr char kBspEntities[] =
    "{}: the list of entities ends inside an entity; the file is damaged";
inline constexpr char kBspEntity[] =
    "{}: an entity places the model '{}' at '{}'; the model must be one of the map's {}, written "
    "as '*' and its number, and the place must be three numbers";
inline constexpr char kNoMaps[] = "{}: the file holds no map (maps/NAME.bsp)";
inline constexpr char kWhichMap[] =
    "{}: the file holds {} maps; name one of them, such as {}:{} (the maps are {})";
inline constexpr char kNoMap[] = "{}: the file has no map '{}'; its maps are {}";
inline constexpr char kNoMapPackage[] =
    "the map of this scene comes from the Debian package openarena-081-maps, which is not "
    "installed ({} is missing); install it with: apt-get install openarena-081-maps";

// Motion
inline constexpr char kNoKeys[] = "'{}' has no keys; it needs at least one";
inline constexpr char kKeyTime[] =
    "'time' must be at least 0 and above the time of the previous key";
inline constexpr char kKeyScale[] =
    "'scale' must not be zero, and on each axis it must have the sign of the instance's scale";
inline constexpr char kKeyTurn[] = "'turn' may change by at most {} degrees from the previous key";
inline constexpr char kRepeat[] = "'repeat' needs a key later than at time 0";
inline constexpr char kMatrixMotion[] =
    "an instance with a 'motion' cannot have a 'matrix'; give position, turn, rotate and scale";
inline constexpr char kPathCamera[] =
    "a 'path' needs a 'camera', which gives its field of view and its up direction";
inline constexpr char kCameraTime[] = "{}, after {} seconds: {}";
inline constexpr char kAtTime[] = "{}, after {} seconds";

// Cameras
inline constexpr char kFieldOfView[] =
    "the camera's field of view is {} degrees; it must lie between 0 and 180";
inline constexpr char kCameraNotFinite[] = "the camera's {} ({}, {}, {}) is not finite";
inline constexpr char kCameraPoint[] =
    "the camera's position and the point that it looks at are the same ({}, {}, {}); move one of "
    "the two";
inline constexpr char kCameraUp[] =
    "the camera's up direction ({}, {}, {}) is parallel to its view; give another one";
inline constexpr char kImageSize[] = "the image is {}x{} pixels; both sides must be at least 1";

template <typename... Args>
[[noreturn]] void fail(fmt::format_string<const Args&...> text, const Args&... args) {
  throw UserError(fmt::format(text, args...));
}

}  // namespace dynrt::host::wording
