# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# dynrt_verilate(TARGET TOP module PREFIX class SOURCES file.v...
#                [HEADERS file.vh...] [FAST] [TRACE] [TIMING] [SHARDS n]
#                [ARGS verilator-argument...])
#
# Makes the static library TARGET with the Verilated class PREFIX (header PREFIX.h) of a module.
# Verilator's own verilate() runs Verilator while CMake configures, when generated Verilog does not
# exist yet; this one runs it during the build. The names of the C++ files that Verilator writes are
# not known beforehand, so they are gathered into files whose names are: n (default 1) for what runs
# every clock, and one for what runs seldom, which is not optimised. A unit is one file: Verilator's
# headers take longer to parse than all of it to optimise.
#   FAST   for the whole core: -O3, unknown values are 0, no assertions. Without it: compiles quickly,
#          checks hlsc's assertions (HLS_ASSERT), and unknown values are random when the bench asks
#          for it (VerilatedContext::randReset(2)), so that a unit which relies on a value it never
#          wrote is found out.
#   TRACE  with FST waveforms; costs about a quarter of the speed even while none is written, so it is
#          a library of its own.
#   TIMING with modules that keep time, in ps (verif/vendor); the bench runs it by
#          host/board/timed_top.h
# Modules that SOURCES do not hold are looked for in HLS_RTL_LIB, where the primitives are that hlsc's
# Verilog is made of. HEADERS are what they include.

add_library(verilated_runtime STATIC EXCLUDE_FROM_ALL
  ${VERILATOR_ROOT}/include/verilated.cpp
  ${VERILATOR_ROOT}/include/verilated_fst_c.cpp
  ${VERILATOR_ROOT}/include/verilated_threads.cpp)
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)
target_include_directories(verilated_runtime SYSTEM PUBLIC
  ${VERILATOR_ROOT}/include ${VERILATOR_ROOT}/include/vltstd)
# Time belongs to a VerilatedContext; there is no global sc_time_stamp().
target_compile_definitions(verilated_runtime PUBLIC VL_TIME_CONTEXT)
target_compile_options(verilated_runtime PRIVATE -O2 -w)
target_link_libraries(verilated_runtime PUBLIC Threads::Threads ZLIB::ZLIB)

# The same for tops with TIMING.
add_library(verilated_timing STATIC EXCLUDE_FROM_ALL ${VERILATOR_ROOT}/include/verilated_timing.cpp)
target_compile_options(verilated_timing PRIVATE -O2 -w)
target_link_libraries(verilated_timing PUBLIC verilated_runtime)

# The flags of generated code: its own warnings are nobody's to mend, and RelWithDebInfo's -g would
# double its size. RUNTIME says what it runs on.
function(dynrt_flags_of_verilated target trace runtime)
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_compile_options(${target} PRIVATE -w -g0 ${VERILATOR_CFLAGS})
  target_compile_definitions(${target} PRIVATE VM_COVERAGE=0 VM_SC=0 VM_TRACE=$<BOOL:${trace}>
                             VM_TRACE_FST=$<BOOL:${trace}> VM_TRACE_VCD=0)
  target_link_libraries(${target} PUBLIC ${runtime})
endfunction()

# Units share Verilator's headers, precompiled: to parse them takes two thirds of a unit's time. The
# header's date is no part of it, as no compiler cache would find it again.
set(dynrt_verilated_source ${CMAKE_CURRENT_BINARY_DIR}/verilated_headers.cpp)
file(CONFIGURE OUTPUT ${dynrt_verilated_source}
     CONTENT "// The owner of a precompiled header needs a source.\n")
add_library(verilated_headers OBJECT EXCLUDE_FROM_ALL ${dynrt_verilated_source})
dynrt_flags_of_verilated(verilated_headers OFF verilated_runtime)
target_compile_options(verilated_headers PRIVATE -O1 "SHELL:-Xclang -fno-pch-timestamp")
target_precompile_headers(verilated_headers PRIVATE <verilated.h>)

function(dynrt_verilate target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "FAST;TRACE;TIMING" "TOP;PREFIX;SHARDS" "SOURCES;HEADERS;ARGS")
  foreach(needed TOP PREFIX SOURCES)
    if(NOT arg_${needed})
      message(FATAL_ERROR "dynrt_verilate(${target}): ${needed} is missing")
    endif()
  endforeach()
  if(NOT arg_SHARDS)
    set(arg_SHARDS 1)
  endif()

  set(dir ${CMAKE_CURRENT_BINARY_DIR}/${target}.verilated)
  set(flags --cc --compiler clang --make cmake --prefix ${arg_PREFIX} --top-module ${arg_TOP}
      --Mdir ${dir} -y ${HLS_RTL_LIB} -Wno-fatal -Wno-lint -Wno-style)
  foreach(header IN LISTS arg_HEADERS)
    get_filename_component(folder ${header} DIRECTORY)
    list(APPEND flags +incdir+${folder})
  endforeach()
  if(arg_FAST)
    list(APPEND flags -O3 --x-assign fast --x-initial fast)
    set(optimise -O3)
  else()
    list(APPEND flags -O3 --x-assign unique --x-initial unique +define+HLS_ASSERT)
    set(optimise -O1)
  endif()
  if(arg_SHARDS GREATER 1)
    list(APPEND flags --output-split 20000)
  else()
    list(APPEND flags --output-split 0)
  endif()
  if(arg_TRACE)
    list(APPEND flags --trace-fst)
  endif()
  set(runtime verilated_runtime)
  if(arg_TIMING)
    list(APPEND flags --timing --timescale 1ps/1ps)
    set(runtime verilated_timing)
  endif()

  set(fast_files)
  math(EXPR last "${arg_SHARDS} - 1")
  foreach(shard RANGE ${last})
    list(APPEND fast_files ${dir}/shard_fast_${shard}.cpp)
  endforeach()
  set(slow_file)
  set(of_a_core OFF)
  if(arg_FAST OR arg_SHARDS GREATER 1)
    set(of_a_core ON)
    set(slow_file ${dir}/shard_slow.cpp)
    set_source_files_properties(${slow_file} PROPERTIES COMPILE_OPTIONS -O0)
  endif()
  file(GLOB primitives CONFIGURE_DEPENDS ${HLS_RTL_LIB}/*.v)
  add_custom_command(
    OUTPUT ${fast_files} ${slow_file}
    BYPRODUCTS ${dir}/${arg_PREFIX}.h
    COMMAND ${CMAKE_COMMAND} -E env VERILATOR_ROOT=${VERILATOR_ROOT}
            ${VERILATOR_BIN} ${flags} ${arg_ARGS} ${arg_SOURCES}
    COMMAND ${CMAKE_COMMAND} -DDIR=${dir} -DPREFIX=${arg_PREFIX} -DSHARDS=${arg_SHARDS}
            -DSLOW_FILE=${of_a_core} -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/GatherVerilated.cmake
    DEPENDS ${arg_SOURCES} ${arg_HEADERS} ${primitives} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/GatherVerilated.cmake
    COMMENT "Verilating ${arg_TOP}"
    VERBATIM COMMAND_EXPAND_LISTS)

  add_library(${target} STATIC EXCLUDE_FROM_ALL ${fast_files} ${slow_file})
  dynrt_flags_of_verilated(${target} "${arg_TRACE}" ${runtime})
  target_include_directories(${target} SYSTEM PUBLIC ${dir})
  if(of_a_core)
    set_source_files_properties(${fast_files} PROPERTIES COMPILE_OPTIONS ${optimise})
  else()
    target_compile_options(${target} PRIVATE ${optimise})
    if(NOT arg_TRACE AND NOT arg_TIMING)
      target_precompile_headers(${target} REUSE_FROM verilated_headers)
    endif()
  endif()
endfunction()
