// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The symbols of a shared library with one configuration. A program may use its C++ classes only if
// the same compiler made both from the same sources. Each carries a fingerprint of sources and
// compiler, and the program compares the two as text before it uses anything else.
#pragma once

#include "host/board/configurations.h"

#define DYNRT_VISIBLE [[gnu::visibility("default")]]

extern "C" {
DYNRT_VISIBLE extern const char dynrt_configuration_fingerprint[];
DYNRT_VISIBLE const dynrt::host::Configuration* dynrt_configuration();
}

#undef DYNRT_VISIBLE
