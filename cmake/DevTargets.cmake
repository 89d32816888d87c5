# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
# Targets for whoever edits the code: format, format-check, tidy, and compile_commands.json at the
# top, where editors look for it (it belongs to the preset that was configured last).
file(CREATE_LINK ${CMAKE_BINARY_DIR}/compile_commands.json
     ${CMAKE_SOURCE_DIR}/compile_commands.json SYMBOLIC)

find_program(DYNRT_CLANG_FORMAT clang-format-19)
find_program(DYNRT_RUN_CLANG_TIDY run-clang-tidy-19)
find_package(Python3 REQUIRED COMPONENTS Interpreter)

set(dynrt_format ${CMAKE_SOURCE_DIR}/scripts/format --clang-format ${DYNRT_CLANG_FORMAT})
add_custom_target(format COMMAND ${dynrt_format} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} VERBATIM)
add_custom_target(format-check COMMAND ${dynrt_format} --check
                  WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} VERBATIM)
add_custom_target(tidy
  COMMAND ${DYNRT_RUN_CLANG_TIDY} -quiet -p ${CMAKE_BINARY_DIR}
          "^${CMAKE_SOURCE_DIR}/(hls|host|verif)/.*\\.cpp$"
  WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} VERBATIM)
