// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the scheduler; fmt fills in the {}. Tests assert the texts.
#pragma once

namespace hlsc::messages {

inline constexpr char kTooSlow[] =
    "{} needs {:.2f} ns in one stage, but the clock leaves only {:.2f}; ask for a clock of at "
    "least {:.2f} ns or use a narrower operation";
inline constexpr char kRegisterFeedback[] =
    "register {} needs {:.2f} ns from its value to its next value, which must be in one stage, but "
    "the clock leaves only {:.2f}; ask for a clock of at least {:.2f} ns or compute less between "
    "the two";
inline constexpr char kFileFeedback[] =
    "register file {} needs {:.2f} ns from the row that it reads to the row that it writes, which "
    "must be in one stage, but the clock leaves only {:.2f}; ask for a clock of at least {:.2f} "
    "ns, compute less between the two or use a Ram1R1W";
inline constexpr char kNoWrite[] =
    "the unit writes no token, row or register; a unit without effect cannot be lowered";

}  // namespace hlsc::messages
