// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tables of the work of a scene with this core and with variants of it: objects that overlap
// (thesis 4.3), slots of the mailbox (4.3.2, 6.1.2), clipping nodes (4.2). The tracer of
// host/analysis/counts/counts.h counts in doubles, without a board.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/app/prepare.h"

namespace dynrt::host {

struct WorkReport {
  std::string text;
  nlohmann::ordered_json json;
};

/// Four ways to treat overlapping objects, and Table 4.1, whose figures are for single rays.
WorkReport overlap_report(const Prepared& prepared);
/// From no slots to 32, and the repeated transformations that more slots would avoid.
WorkReport mailbox_report(const Prepared& prepared);
/// With and without the six clipping nodes of the scene and of objects.
WorkReport clipping_report(const Prepared& prepared);

}  // namespace dynrt::host
