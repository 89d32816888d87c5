// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of narrowing; fmt fills in the {}. Tests assert the texts.
#pragma once

namespace hlsc::messages {

inline constexpr char kRowAddress[] =
    "the address at which RAM {} is read depends on the row that is read; read the row once, at an "
    "address that does not depend on it";

}  // namespace hlsc::messages
