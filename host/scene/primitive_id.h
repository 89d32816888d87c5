// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The name of a primitive in the world.
#pragma once

#include <compare>
#include <cstdint>

namespace dynrt::host {

/// A primitive where an instance has put it. The numbers are those of Scene::instances and of the
/// object's primitives (Mesh).
struct PrimitiveId {
  std::uint32_t instance = 0;
  std::uint32_t primitive = 0;
  friend auto operator<=>(const PrimitiveId&, const PrimitiveId&) = default;
};

}  // namespace dynrt::host
