# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# add_hls_unit(NAME mailbox SOURCE units/mailbox.h TYPE "dynrt::Mailbox<dynrt::config::thesis>"
#              CONFIG thesis [CLOCK_NS n] [DELAY file] [ROOM n] [UNCERTAINTY ns]
#              [FAST] [TRACE] [SHARDS n])
#
# Everything that belongs to one unit. SOURCE is its header as it is included, DELAY is relative to
# the project's folder; the configuration comes from configs/<CONFIG>.h, which a custom command of
# the calling folder writes to build/<preset>/generated/include:
#   <NAME>_model   interface library: what a program needs to include the C++ (header only)
#   <NAME>.v       build/<preset>/generated/<CONFIG>/<NAME>.v, made by hlsc, module <NAME>, with its
#                  schedule report <NAME>.txt, the same as data <NAME>.json and the header
#                  <NAME>_ports.h for the test bench
#   <NAME>_rtl     library with the Verilated class V<NAME> (FAST, TRACE, SHARDS: Verilate.cmake),
#                  whose name is the same for every configuration, so link only one of them
#   test           generated.<NAME>, label lint, for a CONFIG that is checked in: fails when
#                  rtl/generated/<CONFIG>/<NAME>.v is not what hlsc writes now (the target
#                  update-generated renews it); generated.<NAME>.json the same of its schedule
# CLOCK_NS and DELAY default to the cache variables DYNRT_CLOCK_NS and DYNRT_DELAY_MODEL, ROOM and
# UNCERTAINTY to the defaults of hlsc --room and --uncertainty.
# For a CONFIG other than thesis the names of targets and tests begin with "<CONFIG>_".
# With DYNRT_RTL off (preset asan) only the model is made.

option(DYNRT_RTL "lower the units to Verilog and Verilate them" ON)
set(DYNRT_CLOCK_NS 8.33 CACHE STRING "clock period that hlsc schedules for, in ns")
set(DYNRT_DELAY_MODEL hls/compiler/delay/ecp5.json CACHE STRING
    "delay model that hlsc schedules with, relative to the project's folder")
set(HLS_COMPILER hlsc)
set(HLS_LANGUAGE ${PROJECT_SOURCE_DIR}/hls/lowered ${PROJECT_SOURCE_DIR}/hls/include)
if(DYNRT_RTL AND NOT DYNRT_PROGRAM_ONLY)
  set(DYNRT_LANGUAGE ${PROJECT_BINARY_DIR}/generated/language.pch)  # for units with the usual delays
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/generated)
  hls_precompile(TARGET hls_language FILE ${DYNRT_LANGUAGE}
                 DELAY ${PROJECT_SOURCE_DIR}/${DYNRT_DELAY_MODEL} ROOT ${PROJECT_SOURCE_DIR})
endif()
add_custom_target(verilog ALL)
add_custom_target(update-generated)

# The configurations whose Verilog is checked in, for readers and builds without LLVM: the thesis's
# and the one that programs take.
set(DYNRT_CHECKED_IN thesis fast)
# What boards have besides: the cores with a port to their memory, the link to the host, the encoder of
# the display, the controller of the SDRAM. The scripts that need these make them by this target.
add_custom_target(board_verilog)

# dynrt_checked_in(CONFIG FILE TARGET): FILE, which TARGET makes, is also checked in under
# rtl/generated/<CONFIG>, if such a configuration is. The target update-generated renews it, the test
# generated.<stem> (label lint; with its extension if that is not .v) fails when it is stale.
function(dynrt_checked_in config file target)
  if(NOT DYNRT_RTL OR NOT config IN_LIST DYNRT_CHECKED_IN)
    return()
  endif()
  add_dependencies(verilog ${target})
  get_filename_component(name ${file} NAME)
  string(REGEX REPLACE "[.]v$" "" stem ${name})
  if(NOT config STREQUAL "thesis")
    set(stem ${config}_${stem})
  endif()
  set(folder ${PROJECT_SOURCE_DIR}/rtl/generated/${config})
  add_custom_target(update_${stem}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${file} ${folder})
  add_dependencies(update_${stem} ${target})
  add_dependencies(update-generated update_${stem})
  add_test(NAME generated.${stem}
    COMMAND ${CMAKE_COMMAND} -DNEW=${file} -DOLD=${folder}/${name}
            -P ${PROJECT_SOURCE_DIR}/cmake/CompareGenerated.cmake)
  set_tests_properties(generated.${stem} PROPERTIES LABELS lint)
endfunction()

function(add_hls_unit)
  cmake_parse_arguments(PARSE_ARGV 0 arg "FAST;TRACE"
                        "NAME;SOURCE;TYPE;CONFIG;CLOCK_NS;DELAY;ROOM;UNCERTAINTY;SHARDS" "")
  foreach(needed NAME SOURCE TYPE CONFIG)
    if(NOT arg_${needed})
      message(FATAL_ERROR "add_hls_unit(${arg_NAME}): ${needed} is missing")
    endif()
  endforeach()
  set(id ${arg_NAME})
  if(NOT arg_CONFIG STREQUAL "thesis")
    set(id ${arg_CONFIG}_${arg_NAME})
  endif()

  add_library(${id}_model INTERFACE)
  target_include_directories(${id}_model INTERFACE ${PROJECT_SOURCE_DIR}/hls
                             ${PROJECT_BINARY_DIR}/generated/include)
  target_link_libraries(${id}_model INTERFACE hls)
  if(NOT DYNRT_RTL)
    return()
  endif()

  set(clock ${DYNRT_CLOCK_NS})
  if(arg_CLOCK_NS)
    set(clock ${arg_CLOCK_NS})
  endif()
  set(delay ${DYNRT_DELAY_MODEL})
  set(language PRECOMPILED ${DYNRT_LANGUAGE})
  if(arg_DELAY)
    set(delay ${arg_DELAY})
    set(language)
  endif()
  # hlsc takes one header: the unit's after the configuration's.
  set(config_header ${PROJECT_BINARY_DIR}/generated/include/configs/${arg_CONFIG}.h)
  set(header ${PROJECT_BINARY_DIR}/generated/include/${arg_CONFIG}/${arg_NAME}.h)
  file(CONFIGURE OUTPUT ${header}
       CONTENT "#include \"configs/@arg_CONFIG@.h\"\n#include \"@arg_SOURCE@\"\n" @ONLY)
  set(dir ${PROJECT_BINARY_DIR}/generated/${arg_CONFIG})
  set(stem ${dir}/${arg_NAME})
  hls_lower(MODULE ${arg_NAME} HEADER ${arg_CONFIG}/${arg_NAME}.h TYPE ${arg_TYPE} FOLDER ${dir}
            INCLUDES ${PROJECT_SOURCE_DIR}/hls ${PROJECT_BINARY_DIR}/generated/include
            CLOCK_NS ${clock} DELAY ${PROJECT_SOURCE_DIR}/${delay} ROOM ${arg_ROOM}
            UNCERTAINTY ${arg_UNCERTAINTY}
            DEPENDS ${config_header}
            ROOT ${PROJECT_SOURCE_DIR} ${language})
  add_custom_target(${id}_verilog DEPENDS ${stem}.v)
  add_dependencies(verilog ${id}_verilog)

  set(speed)
  foreach(flag FAST TRACE)
    if(arg_${flag})
      list(APPEND speed ${flag})
    endif()
  endforeach()
  if(arg_SHARDS)
    list(APPEND speed SHARDS ${arg_SHARDS})
  endif()
  dynrt_verilate(${id}_rtl TOP ${arg_NAME} PREFIX V${arg_NAME} SOURCES ${stem}.v ${speed})
  target_include_directories(${id}_rtl PUBLIC ${dir})
  add_dependencies(${id}_rtl ${id}_verilog)
  target_link_libraries(${id}_rtl PUBLIC ${id}_model)

  dynrt_checked_in(${arg_CONFIG} ${stem}.v ${id}_verilog)
  dynrt_checked_in(${arg_CONFIG} ${stem}.json ${id}_verilog)
endfunction()
