// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the window.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kPortsInUse[] =
    "the ports {} to {} of this computer are all in use; name another port";
inline constexpr char kNoPageFile[] = "{}: the page of the window needs this file; {}";
inline constexpr char kNoTruth[] =
    "this program was built without the libraries that find the truth; scripts/test builds one "
    "with "
    "them";
inline constexpr char kNotWatched[] = "the frame was not watched yet";
inline constexpr char kNoClocks[] =
    "the clocks of configuration {} are not known, as its schedules are not there; lower it, or "
    "take "
    "a configuration whose Verilog was built";
inline constexpr char kRecordedSize[] =
    "the recorded frame of {}x{} pixels would take more than {} MB, the most that a file may have; "
    "record a smaller picture";
inline constexpr char kJobRunning[] = "{} is under way; wait until it is done";
inline constexpr char kNoPicture[] = "no whole frame stands in the window yet";
inline constexpr char kOtherPicture[] =
    "another page of this window has drawn another picture since; a step draws this one again";
inline constexpr char kNoPixel[] = "there is no pixel {}, {} in a picture of {}x{}";
inline constexpr char kNotOurMessage[] = "this is no message of the window: {}";

}  // namespace dynrt::host::messages
