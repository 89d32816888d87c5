// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the language is compiled for. hls/native and hls/lowered have this header each; the include
// path decides.
#pragma once

namespace hls {

/// True where hlsc reads the source, false where it runs natively.
inline constexpr bool kLowered = true;

}  // namespace hls
