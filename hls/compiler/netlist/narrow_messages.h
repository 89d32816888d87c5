// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The wordings of what narrowing refuses; {} are filled in by fmt. Tests assert the texts.
#pragma once

namespace hlsc::messages {

inline constexpr char kRowAddress[] =
    "RAM {} is read at an address that depends on the row that is read; read it once, with an "
    "address that is known before";

}  // namespace hlsc::messages
