// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt report truth: what the primary rays of a scene really hit (host/analysis/truth), how often
// doubles did not suffice to tell, and where and why Embree says otherwise.
#pragma once

#include "host/app/work_report.h"

namespace dynrt::host {

WorkReport truth_report(const Prepared& prepared, unsigned width, unsigned height);

}  // namespace dynrt::host
