# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
include(GoogleTest)

# dynrt_discover_tests(TARGET ...): as gtest_discover_tests, but patient: on a cold machine the first
# start of a program takes long, with all the libraries that OpenImageIO brings.
function(dynrt_discover_tests target)
  gtest_discover_tests(${target} ${ARGN} DISCOVERY_TIMEOUT 300)
endfunction()

# dynrt_python_test(NAME LABELS MODULE ARGUMENTS...): a test that is a module of scripts/dynrt_tools. It
# runs in Debian's Python, which has the packages of scripts/packages.txt.
function(dynrt_python_test name labels module)
  add_test(NAME ${name} COMMAND /usr/bin/python3 -m dynrt_tools.${module} ${ARGN}
           WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/scripts)
  set_tests_properties(${name} PROPERTIES LABELS "${labels}")
endfunction()
