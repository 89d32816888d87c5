# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# Parsing the headers of libraries takes about half of the time of a build from nothing. So each group
# of targets that compile with the same flags shares one precompiled header, made of libraries'
# headers alone: our own change too often. The bench is an exception, as all that share it need it. The presets dev and asan use none, so that a file which
# forgets an #include is found out.
#
# dynrt_quick_tests(TARGET...): targets that GoogleTest runs, not optimised: what takes time when they
# run stands in the libraries that they link. Those that hold units or whole cores, which are
# templates, run three times as long for it, but compile in a quarter of the time, which is more.
#
# dynrt_long_tests(TARGET...): the same for those of which it is not: a little optimised.
#
# dynrt_cosimulations(TARGET...): not optimised, with the headers of Verilator's classes and of the bench.
#
# dynrt_host_headers(TARGET...), hlsc_headers(TARGET...): static libraries of the host, of hlsc.

# dynrt_headers(NAME KIND HEADER...): a target whose only purpose is a precompiled header; KIND is
# LIBRARY for the flags of libraries, PROGRAM for those of programs, whose code is placed otherwise.
function(dynrt_headers name kind)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// The owner of a precompiled header needs a source.\n")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${source})
  if(kind STREQUAL "PROGRAM")
    dynrt_flags_of_programs(${name})
  endif()
  # Without it the header's date is part of it, and no compiler cache finds it again.
  target_compile_options(${name} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  target_link_libraries(${name} PRIVATE dynrt_warnings)
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

# Objects of a library that compile as those of a program do.
function(dynrt_flags_of_programs target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  target_compile_options(${target} PRIVATE -fPIE)
endfunction()

set(dynrt_standard_headers
    <algorithm> <array> <cmath> <cstdint> <filesystem> <fstream> <functional> <iostream> <map>
    <memory> <optional> <random> <set> <span> <sstream> <string> <string_view> <tuple> <utility>
    <variant> <vector>)

dynrt_headers(dynrt_headers_of_host LIBRARY ${dynrt_standard_headers} <fmt/format.h> <fmt/ranges.h>
              <glm/glm.hpp> <glm/gtc/matrix_transform.hpp> <nlohmann/json.hpp> <CLI/CLI.hpp>)
target_link_libraries(dynrt_headers_of_host PRIVATE fmt::fmt glm::glm nlohmann_json::nlohmann_json
                      CLI11::CLI11)
function(dynrt_host_headers)
  foreach(target IN LISTS ARGN)
    target_precompile_headers(${target} REUSE_FROM dynrt_headers_of_host)
  endforeach()
endfunction()
if(DYNRT_PROGRAM_ONLY)
  return()
endif()

dynrt_headers(dynrt_headers_of_hlsc LIBRARY ${dynrt_standard_headers} <fmt/format.h>
              <llvm/ADT/APInt.h> <llvm/IR/IRBuilder.h> <llvm/IR/InstIterator.h>
              <llvm/IR/IntrinsicInst.h> <llvm/IR/Module.h>)
target_include_directories(dynrt_headers_of_hlsc SYSTEM PRIVATE ${LLVM_INCLUDE_DIRS})
target_link_libraries(dynrt_headers_of_hlsc PRIVATE fmt::fmt)
function(hlsc_headers)
  foreach(target IN LISTS ARGN)
    target_precompile_headers(${target} REUSE_FROM dynrt_headers_of_hlsc)
  endforeach()
endfunction()

# dynrt_headers_of_tests(NAME LEVEL HEADER...): those of tests at a level of optimisation.
function(dynrt_headers_of_tests name level)
  dynrt_headers(${name} PROGRAM ${dynrt_standard_headers} <fmt/format.h> <glm/glm.hpp>
                <glm/gtc/matrix_transform.hpp> <nlohmann/json.hpp> <gmock/gmock.h> <gtest/gtest.h>
                ${ARGN})
  target_compile_options(${name} PRIVATE -O${level} -g0)
  target_link_libraries(${name} PRIVATE fmt::fmt glm::glm nlohmann_json::nlohmann_json GTest::gmock
                        GTest::gtest)
endfunction()
# dynrt_tests_with(HEADERS LEVEL TARGET...): targets that compile with them.
function(dynrt_tests_with headers level)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE -O${level} -g0)
    target_precompile_headers(${target} REUSE_FROM ${headers})
  endforeach()
endfunction()

dynrt_headers_of_tests(dynrt_headers_of_quick_tests 0)
function(dynrt_quick_tests)
  dynrt_tests_with(dynrt_headers_of_quick_tests 0 ${ARGN})
endfunction()
dynrt_headers_of_tests(dynrt_headers_of_long_tests 1)
function(dynrt_long_tests)
  dynrt_tests_with(dynrt_headers_of_long_tests 1 ${ARGN})
endfunction()
dynrt_headers_of_tests(dynrt_headers_of_cosimulations 0 <verilated.h> <cosim/bench.h>)
target_link_libraries(dynrt_headers_of_cosimulations PRIVATE verilated_runtime cosim_bench)
function(dynrt_cosimulations)
  dynrt_tests_with(dynrt_headers_of_cosimulations 0 ${ARGN})
endfunction()
