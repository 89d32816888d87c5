# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# find_package(dynrt) gives
#   dynrt::hls      the language's headers, for the native model
#   dynrt::join     the library of joins of units (hls/join.h)
#   dynrt::cosim    the bench that runs a unit's Verilog against its C++ (cosim/bench.h)
#   dynrt::hlsc     the compiler
#   dynrt_add_unit(NAME HEADER scale.h TYPE "example::Scale" [CLOCK_NS n] [DELAY ecp5|file.json])
#     HEADER lies in the calling folder. Makes the libraries <NAME>_model, the C++, and <NAME>_rtl,
#     the Verilated class V<NAME> with <NAME>_ports.h for the bench; NAME.v and the schedule's report
#     NAME.txt in the build folder, for CLOCK_NS nanoseconds (10).
#   DYNRT_RTL_FOLDER, DYNRT_CORE_LIST, DYNRT_BOARD_LIST  the core's Verilog and lists of its files
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang" OR CMAKE_CXX_COMPILER_VERSION VERSION_LESS 16)
  set(dynrt_FOUND FALSE)
  set(dynrt_NOT_FOUND_MESSAGE "units are written with _BitInt, which ${CMAKE_CXX_COMPILER_ID} \
${CMAKE_CXX_COMPILER_VERSION} lacks; configure with -DCMAKE_CXX_COMPILER=clang++-19")
  return()
endif()
include(CMakeFindDependencyMacro)
find_dependency(fmt)
set(CMAKE_REQUIRED_QUIET ON)
find_package(verilator HINTS $ENV{VERILATOR_ROOT} /usr/share/verilator REQUIRED)
unset(CMAKE_REQUIRED_QUIET)
include(${CMAKE_CURRENT_LIST_DIR}/dynrtTargets.cmake)

get_filename_component(dynrt_share ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
get_filename_component(DYNRT_INCLUDE_FOLDER ${dynrt_share}/../../include/dynrt ABSOLUTE)
set(DYNRT_RTL_FOLDER ${dynrt_share}/rtl)
set(DYNRT_DELAY_FOLDER ${dynrt_share}/delay)
set(DYNRT_CORE_LIST ${DYNRT_RTL_FOLDER}/dynrt_core.f)
set(DYNRT_BOARD_LIST ${DYNRT_RTL_FOLDER}/dynrt_board.f)
set(HLS_RTL_LIB ${DYNRT_RTL_FOLDER}/lib)
set(HLS_COMPILER dynrt::hlsc)
set(HLS_LANGUAGE ${DYNRT_INCLUDE_FOLDER}/lowered ${DYNRT_INCLUDE_FOLDER}/include)

add_library(dynrt::hls INTERFACE IMPORTED)
target_include_directories(dynrt::hls INTERFACE ${DYNRT_INCLUDE_FOLDER}/include
                           ${DYNRT_INCLUDE_FOLDER}/native)
target_compile_features(dynrt::hls INTERFACE cxx_std_20)
target_link_libraries(dynrt::hls INTERFACE fmt::fmt)
add_library(dynrt::join STATIC IMPORTED)
set_target_properties(dynrt::join PROPERTIES IMPORTED_LOCATION
                      ${dynrt_share}/../../lib/dynrt/libhls_join.a)
target_link_libraries(dynrt::join INTERFACE dynrt::hls)
add_library(dynrt::cosim STATIC IMPORTED)
set_target_properties(dynrt::cosim PROPERTIES IMPORTED_LOCATION
                      ${dynrt_share}/../../lib/dynrt/libcosim_bench.a)
target_include_directories(dynrt::cosim INTERFACE ${DYNRT_INCLUDE_FOLDER})
target_link_libraries(dynrt::cosim INTERFACE dynrt::hls)

include(${CMAKE_CURRENT_LIST_DIR}/HlsLower.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/Verilate.cmake)

function(dynrt_add_unit name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADER;TYPE;CLOCK_NS;DELAY" "")
  if(NOT arg_CLOCK_NS)
    set(arg_CLOCK_NS 10)
  endif()
  if(NOT arg_DELAY)
    set(arg_DELAY ecp5)
  endif()
  if(EXISTS ${DYNRT_DELAY_FOLDER}/${arg_DELAY}.json)
    set(arg_DELAY ${DYNRT_DELAY_FOLDER}/${arg_DELAY}.json)
  endif()
  add_library(${name}_model INTERFACE)
  target_include_directories(${name}_model INTERFACE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${name}_model INTERFACE dynrt::hls)
  hls_lower(MODULE ${name} HEADER ${arg_HEADER} TYPE ${arg_TYPE} FOLDER ${CMAKE_CURRENT_BINARY_DIR}
            INCLUDES ${CMAKE_CURRENT_SOURCE_DIR} CLOCK_NS ${arg_CLOCK_NS} DELAY ${arg_DELAY})
  dynrt_verilate(${name}_rtl TOP ${name} PREFIX V${name} SOURCES ${CMAKE_CURRENT_BINARY_DIR}/${name}.v)
  target_include_directories(${name}_rtl PUBLIC ${CMAKE_CURRENT_BINARY_DIR})
  target_link_libraries(${name}_rtl PUBLIC ${name}_model)
endfunction()
