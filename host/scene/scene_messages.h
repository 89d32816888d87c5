// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages that several readers of scenes share.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kNoTriangles[] =
    "{}: the scene has no triangles ({} of zero area, {} points and lines left out)";
inline constexpr char kBadLibrary[] = "{}: cannot read this zip library ({}); {}";

}  // namespace dynrt::host::messages
