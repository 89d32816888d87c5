# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# The back end: passes, schedule, Verilog. It knows nothing of the front end.
find_package(lemon REQUIRED)

add_library(hlsc_backend STATIC
  pipeline.cpp
  emit/binding.cpp
  emit/expression.cpp
  emit/names.cpp
  emit/pipeline_bits.cpp
  emit/report.cpp
  emit/schedule_json.cpp
  emit/stages.cpp
  emit/state.cpp
  emit/timing_json.cpp
  emit/verilog.cpp
  passes/balance_chains.cpp
  passes/expand_divisions.cpp
  passes/expand_shifts.cpp
  passes/merge_add_sub.cpp
  passes/rewrite.cpp
  passes/split_products.cpp
  schedule/asap.cpp
  schedule/checker.cpp
  schedule/circuit.cpp
  schedule/delay_model.cpp
  schedule/registers.cpp
  schedule/timing.cpp
  schedule/timing_operations.cpp)
target_include_directories(hlsc_backend SYSTEM PRIVATE ${LEMON_INCLUDE_DIRS})
target_link_libraries(hlsc_backend PUBLIC hlsc_netlist
                      PRIVATE ${LEMON_LIBRARIES} fmt::fmt nlohmann_json::nlohmann_json
                              dynrt_warnings)
hlsc_headers(hlsc_backend)

add_subdirectory(cosim)

add_executable(hlsc_passes_test passes/passes_test.cpp)
target_compile_definitions(hlsc_passes_test
                           PRIVATE DELAY_FOLDER="${CMAKE_CURRENT_SOURCE_DIR}/delay")
target_link_libraries(hlsc_passes_test PRIVATE hlsc_random dynrt_warnings GTest::gtest_main)
dynrt_quick_tests(hlsc_passes_test)
dynrt_discover_tests(hlsc_passes_test PROPERTIES LABELS lower)

add_executable(hlsc_schedule_test schedule/checker_test.cpp schedule/schedule_test.cpp
                                  schedule/timing_test.cpp)
target_compile_definitions(hlsc_schedule_test
                           PRIVATE DELAY_FOLDER="${CMAKE_CURRENT_SOURCE_DIR}/delay")
target_link_libraries(hlsc_schedule_test PRIVATE hlsc_random dynrt_warnings GTest::gmock
                                                 GTest::gtest_main)
dynrt_quick_tests(hlsc_schedule_test)
dynrt_discover_tests(hlsc_schedule_test PROPERTIES LABELS lower)

add_executable(hlsc_emit_test emit/emit_test.cpp emit/timing_json_test.cpp)
target_compile_definitions(hlsc_emit_test
                           PRIVATE DELAY_FOLDER="${CMAKE_CURRENT_SOURCE_DIR}/delay"
                                   GOLDEN_FOLDER="${CMAKE_CURRENT_SOURCE_DIR}/emit/golden")
target_link_libraries(hlsc_emit_test PRIVATE hlsc_random nlohmann_json::nlohmann_json dynrt_warnings
                                             GTest::gmock GTest::gtest_main)
dynrt_quick_tests(hlsc_emit_test)
dynrt_discover_tests(hlsc_emit_test PROPERTIES LABELS lower)
