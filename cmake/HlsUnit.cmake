# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# add_hls_unit(NAME mailbox SOURCE hls/units/mailbox.h TYPE "Mailbox<thesis>" CONFIG thesis
#              [CLOCK_NS n] [DELAY file] [FAST] [TRACE] [SHARDS n])
#
# Everything that belongs to one unit:
#   <NAME>_model   interface library: what a program needs to include the C++ (header only)
#   <NAME>.v       build/<preset>/generated/<CONFIG>/<NAME>.v, made by hlsc, module <NAME>, with its
#                  schedule report <NAME>.txt and the header <NAME>_binding.h for the test bench
#   <NAME>_rtl     library with the Verilated class V<NAME> (FAST, TRACE, SHARDS: Verilate.cmake)
#   test           generated.<CONFIG>.<NAME>, label lint: fails when rtl/generated/<CONFIG>/<NAME>.v
#                  is not what hlsc writes now (the target update-generated renews it)
# CLOCK_NS and DELAY default to the cache variables DYNRT_CLOCK_NS and DYNRT_DELAY_MODEL.
# For a CONFIG other than thesis the target names begin with "<CONFIG>_".
# With DYNRT_RTL off (preset asan) only the model is made.

option(DYNRT_RTL "lower the units to Verilog and Verilate them" ON)
set(DYNRT_CLOCK_NS 10 CACHE STRING "clock period that hlsc schedules for, in ns")
set(DYNRT_DELAY_MODEL ${PROJECT_SOURCE_DIR}/hls/compiler/delay/lut4.json CACHE FILEPATH
    "delay model that hlsc schedules with")
add_custom_target(verilog ALL)
add_custom_target(update-generated)

function(add_hls_unit)
  cmake_parse_arguments(PARSE_ARGV 0 arg "FAST;TRACE"
                        "NAME;SOURCE;TYPE;CONFIG;CLOCK_NS;DELAY;SHARDS" "")
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
  target_include_directories(${id}_model INTERFACE ${PROJECT_SOURCE_DIR}/hls)
  target_link_libraries(${id}_model INTERFACE hls)
  if(NOT DYNRT_RTL)
    return()
  endif()

  set(clock ${DYNRT_CLOCK_NS})
  if(arg_CLOCK_NS)
    set(clock ${arg_CLOCK_NS})
  endif()
  set(delay ${DYNRT_DELAY_MODEL})
  if(arg_DELAY)
    get_filename_component(delay ${arg_DELAY} ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
  endif()
  get_filename_component(header ${arg_SOURCE} ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
  set(dir ${PROJECT_BINARY_DIR}/generated/${arg_CONFIG})
  set(stem ${dir}/${arg_NAME})
  set(fresh ${dir}/fresh/${arg_NAME})
  file(MAKE_DIRECTORY ${dir}/fresh)
  set(include_flags)
  foreach(folder hls/include hls/lowered hls)
    list(APPEND include_flags -I ${PROJECT_SOURCE_DIR}/${folder})
  endforeach()

  # The compiler lists the headers that the unit includes; hlsc runs again when one of them changes,
  # and what follows only when hlsc then writes something else.
  add_custom_command(
    OUTPUT ${stem}.v
    BYPRODUCTS ${stem}.txt ${stem}_binding.h
    COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -x c++ ${include_flags} -MM -MT ${stem}.v
            -MF ${stem}.d ${header}
    COMMAND hlsc --unit ${arg_TYPE} --name ${arg_NAME} --header ${header} ${include_flags}
            --clock-ns ${clock} --delay ${delay} -o ${fresh}.v --report ${fresh}.txt
            --binding ${fresh}_binding.h
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${fresh}.v ${fresh}.txt ${fresh}_binding.h ${dir}
    DEPENDS hlsc ${header} ${delay}
    DEPFILE ${stem}.d
    COMMENT "Lowering ${arg_TYPE} to ${arg_CONFIG}/${arg_NAME}.v"
    VERBATIM)
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
  dynrt_verilate(${id}_rtl TOP ${arg_NAME} PREFIX V${id} SOURCES ${stem}.v ${speed})
  target_include_directories(${id}_rtl PUBLIC ${dir})
  add_dependencies(${id}_rtl ${id}_verilog)
  target_link_libraries(${id}_rtl PUBLIC ${id}_model)

  set(checked_in ${PROJECT_SOURCE_DIR}/rtl/generated/${arg_CONFIG}/${arg_NAME}.v)
  add_custom_target(${id}_update
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_SOURCE_DIR}/rtl/generated/${arg_CONFIG}
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${stem}.v ${checked_in}
    DEPENDS ${stem}.v)
  add_dependencies(${id}_update ${id}_verilog)
  add_dependencies(update-generated ${id}_update)
  # Only the configuration thesis is checked in.
  if(arg_CONFIG STREQUAL "thesis")
    add_test(NAME generated.${arg_CONFIG}.${arg_NAME}
      COMMAND ${CMAKE_COMMAND} -DNEW=${stem}.v -DOLD=${checked_in}
              -P ${PROJECT_SOURCE_DIR}/cmake/CompareGenerated.cmake)
    set_tests_properties(generated.${arg_CONFIG}.${arg_NAME} PROPERTIES LABELS lint)
  endif()
endfunction()
