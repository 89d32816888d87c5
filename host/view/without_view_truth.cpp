// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The program alone is built without the libraries that find the truth.
#include "host/view/view_truth.h"

namespace dynrt::host {

std::unique_ptr<ViewTruth> ViewTruth::of(const Scene& /*scene*/) { return nullptr; }

}  // namespace dynrt::host
