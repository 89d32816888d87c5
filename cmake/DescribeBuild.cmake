# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# dynrt_describe_build(FILE.json): what a later build of one configuration (cmake/Loadable.cmake) has
# to know of this one, so that both can be one program: compiler, flags, tools.
#   source      the project's folder
#   folder      that of the build
#   identity    decides whether code of two builds fits together
#   variables   CMake's, passed on as they are
#   hlsc        the tool; not there without RTL, for which it is not built by itself
#   program_only  whether it is the program alone, without hlsc, CGAL and Embree
function(dynrt_describe_build file)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  set(identity CMAKE_CXX_COMPILER CMAKE_CXX_COMPILER_VERSION CMAKE_BUILD_TYPE CMAKE_CXX_FLAGS
      CMAKE_CXX_FLAGS_${type})
  set(variables CMAKE_C_COMPILER CMAKE_CXX_COMPILER CMAKE_CXX_COMPILER_LAUNCHER
      CMAKE_BUILD_TYPE CMAKE_CXX_FLAGS CMAKE_CXX_FLAGS_${type} DYNRT_CLOCK_NS DYNRT_DELAY_MODEL
      VERILATOR_ROOT VERILATOR_BIN VERILATOR_CFLAGS)
  set(json "{}")
  foreach(part identity variables)
    string(JSON json SET "${json}" ${part} "{}")
    foreach(name IN LISTS ${part})
      string(REPLACE "\\" "\\\\" value "${${name}}")
      string(REPLACE "\"" "\\\"" value "${value}")
      string(JSON json SET "${json}" ${part} ${name} "\"${value}\"")
    endforeach()
  endforeach()
  string(JSON json SET "${json}" source "\"${PROJECT_SOURCE_DIR}\"")
  string(JSON json SET "${json}" folder "\"${PROJECT_BINARY_DIR}\"")
  string(JSON json SET "${json}" hlsc "\"${PROJECT_BINARY_DIR}/hls/compiler/hlsc\"")
  set(program_only false)
  if(DYNRT_PROGRAM_ONLY)
    set(program_only true)
  endif()
  string(JSON json SET "${json}" program_only ${program_only})
  file(CONFIGURE OUTPUT ${file} CONTENT "@json@\n" @ONLY)
endfunction()
