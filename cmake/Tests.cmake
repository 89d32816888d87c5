# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
include(GoogleTest)

# dynrt_discover_tests(TARGET ...): as gtest_discover_tests, but patient: on a cold machine the first
# start of a program takes long, with all the libraries that OpenImageIO brings.
function(dynrt_discover_tests target)
  gtest_discover_tests(${target} ${ARGN} DISCOVERY_TIMEOUT 300)
endfunction()
