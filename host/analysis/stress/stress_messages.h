// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of dynrt stress.
#pragma once

namespace dynrt::host::stress::messages {

inline constexpr char kFormat[] =
    "--format {}: write the bits of exponent and mantissa, for example 7,12";
inline constexpr char kFormatOfFile[] =
    "--format: --config {} is a file, which has its own format; name a configuration";
inline constexpr char kNotListed[] = "--format: there is no configuration '{}'";
inline constexpr char kNotInTable[] = "this build's table of configurations lacks '{}'";
inline constexpr char kNoCase[] =
    "there is no stress case or group '{}'; give one of these, or the part before the slash: {}";

}  // namespace dynrt::host::stress::messages
