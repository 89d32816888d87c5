// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/not_a_unit.h: error: the type errors::Unit cannot be used as a unit; give --unit the full name of a complete type that errors/not_a_unit.h defines. clang says: no type named 'Unit' in namespace 'errors'
#include "hls/ports.h"
namespace errors {
struct Other {
  void step() {}
};
}  // namespace errors
