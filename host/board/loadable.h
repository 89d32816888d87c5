// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a shared library with one configuration shows. Its classes are C++'s and laid out as its
// compiler saw them, so a program may use them only if both were made of the same sources by the
// same compiler: each carries a fingerprint of these, which is compared as text before anything
// else is touched.
#pragma once

#include "host/board/configurations.h"

#define DYNRT_VISIBLE [[gnu::visibility("default")]]

extern "C" {
DYNRT_VISIBLE extern const char dynrt_configuration_fingerprint[];
DYNRT_VISIBLE const dynrt::host::Configuration* dynrt_configuration();
}

#undef DYNRT_VISIBLE
