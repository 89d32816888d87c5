// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the scheduler; fmt fills in the {}. Tests assert the texts.
#pragma once

namespace hlsc::messages {

inline constexpr char kTooSlow[] =
    "{} needs {:.2f} ns in one stage, but --clock-ns {} leaves {:.2f}; give --clock-ns {:.2f}, the "
    "least that this unit reaches, or use a narrower operation";
inline constexpr char kRegisterFeedback[] =
    "register {} needs {:.2f} ns from its value to its next value, which must be in one stage, but "
    "--clock-ns {} leaves {:.2f}; give --clock-ns {:.2f}, the least that this unit reaches, or "
    "compute less between the two";
inline constexpr char kFileFeedback[] =
    "register file {} needs {:.2f} ns from the row that it reads to the row that it writes, which "
    "must be in one stage, but --clock-ns {} leaves {:.2f}; give --clock-ns {:.2f}, the least that "
    "this unit reaches, compute less between the two or use a Ram1R1W";
inline constexpr char kNoClock[] =
    "no clock is long enough for {}: its next value must be in the stage of its value, and what "
    "lies "
    "between the two, such as a multiplication, takes a stage of its own; compute that before or "
    "after";
inline constexpr char kNoWrite[] =
    "the unit writes no token, row or register; a unit without effect cannot be lowered";

}  // namespace hlsc::messages
