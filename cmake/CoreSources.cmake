# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# dynrt_core_sources(RESULT PART): the files that a core is made of, as core_sources.json lists their
# patterns for a part (code, build, verilog, board). scripts/configuration reads the same list. CMake
# configures again when a file comes or goes.
include_guard(GLOBAL)
set(DYNRT_CORE_SOURCES ${CMAKE_CURRENT_LIST_DIR}/core_sources.json)

function(dynrt_core_sources result part)
  set(depends CONFIGURE_DEPENDS)
  if(CMAKE_SCRIPT_MODE_FILE)
    set(depends)
  endif()
  cmake_path(GET DYNRT_CORE_SOURCES PARENT_PATH folder)
  cmake_path(GET folder PARENT_PATH root)
  file(READ ${DYNRT_CORE_SOURCES} json)
  string(JSON count LENGTH "${json}" ${part})
  math(EXPR last "${count} - 1")
  set(all)
  foreach(number RANGE ${last})
    string(JSON pattern GET "${json}" ${part} ${number})
    set(glob GLOB)
    if(pattern MATCHES "/[*][*]/")
      set(glob GLOB_RECURSE)
      string(REPLACE "/**/" "/" pattern "${pattern}")
    endif()
    file(${glob} found LIST_DIRECTORIES false ${depends} "${root}/${pattern}")
    list(APPEND all ${found})
  endforeach()
  if(NOT CMAKE_SCRIPT_MODE_FILE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${DYNRT_CORE_SOURCES})
  endif()
  set(${result} ${all} PARENT_SCOPE)
endfunction()
