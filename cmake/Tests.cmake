# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
include(GoogleTest)

# dynrt_discover_tests(TARGET [TEST_PREFIX p] [TEST_FILTER f] ... PROPERTIES LABELS label): the tests of
# a GoogleTest program. Those of the label unit are short, starting their program with all the libraries
# that OpenImageIO brings is not: the program is one test with the target's name. Of other labels every
# case is a test, so that they run beside each other; the first start of a program on a cold machine
# takes long, hence the patience.
function(dynrt_discover_tests target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NO_PRETTY_VALUES" "TEST_PREFIX;TEST_FILTER;TEST_LIST"
                        "PROPERTIES")
  if("unit" IN_LIST arg_PROPERTIES AND NOT arg_TEST_FILTER)
    add_test(NAME ${arg_TEST_PREFIX}${target} COMMAND ${target})
    set_tests_properties(${arg_TEST_PREFIX}${target} PROPERTIES ${arg_PROPERTIES}
                         FAIL_REGULAR_EXPRESSION "Running 0 tests")
    return()
  endif()
  gtest_discover_tests(${target} ${ARGN} DISCOVERY_TIMEOUT 300)
endfunction()

# dynrt_python_test(NAME LABELS MODULE ARGUMENTS...): a test that is a module of scripts/dynrt_tools. It
# runs in Debian's Python, which has the packages of scripts/packages.txt.
function(dynrt_python_test name labels module)
  add_test(NAME ${name} COMMAND /usr/bin/python3 -m dynrt_tools.${module} ${ARGN}
           WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/scripts)
  set_tests_properties(${name} PROPERTIES LABELS "${labels}")
endfunction()

# dynrt_python_tests(NAME LABELS MODULE...): the tests of several such modules, in one process.
function(dynrt_python_tests name labels)
  list(TRANSFORM ARGN PREPEND dynrt_tools.)
  add_test(NAME ${name} COMMAND /usr/bin/python3 -m unittest ${ARGN}
           WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/scripts)
  set_tests_properties(${name} PROPERTIES LABELS "${labels}")
endfunction()
