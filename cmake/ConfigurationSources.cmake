# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# dynrt_configuration_sources(TARGET CONFIG): adds to a library what makes the boards of a
# configuration: its native core and, where its Verilog is made, the Verilated board. Appends to the
# caller's variables
#   DECLARATIONS   of the functions that do so
#   ROWS           their row in a table of host/board/configurations.h
#
# dynrt_list_configuration(CONFIG): appends to the same variables the row of a configuration that is
# not built in: its limits alone.
include_guard(GLOBAL)
include(Embed)

# dynrt_has_board(RESULT CONFIG): whether builds make a board of its Verilog. A float of more than 24
# bits needs wider words than the board's SRAM has: no board.
function(dynrt_has_board result config)
  dynrt_config_key(rtl ${config} rtl)
  dynrt_config_key(exponent_bits ${config} exponent_bits)
  dynrt_config_key(mantissa_bits ${config} mantissa_bits)
  math(EXPR float_bits "1 + ${exponent_bits} + ${mantissa_bits}")
  set(${result} OFF PARENT_SCOPE)
  if(DYNRT_RTL AND rtl AND float_bits LESS_EQUAL 24)
    set(${result} ON PARENT_SCOPE)
  endif()
endfunction()

macro(dynrt_list_configuration config)
  dynrt_has_board(lowered ${config})
  string(APPEND DECLARATIONS "CoreInfo ${config}_info();\n")
  string(APPEND ROWS "      {.name = \"${config}\", .core = ${config}_info")
  if(lowered)
    string(APPEND ROWS ", .lowered = true")
  endif()
  string(APPEND ROWS "},\n")
endmacro()

# dynrt_loadable_library(TARGET CONFIG SOURCE WRITTEN): a shared library with one configuration as
# host/board/loadable.h describes it, compiled from SOURCE. WRITTEN is what is written for it now: the
# same file, or one that a command turns into it. It has DYNRT_FINGERPRINT of the caller.
function(dynrt_loadable_library target CONFIG source written)
  set(DECLARATIONS)
  set(ROWS)
  # The program's own table has no keys of a configuration that a file states, so each library has its
  # table.
  add_library(${target} MODULE EXCLUDE_FROM_ALL ${source}
              ${DYNRT_CONFIG_FOLDER}/core_configuration.cpp)
  # Its names are its own: many such libraries have a class of the same name.
  set_target_properties(${target} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden
                        VISIBILITY_INLINES_HIDDEN ON)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${target} PRIVATE dynrt_units dynrt_warnings fmt::fmt)
  target_link_options(${target} PRIVATE -Wl,-Bsymbolic)
  dynrt_configuration_sources(${target} ${CONFIG})
  configure_file(${PROJECT_SOURCE_DIR}/host/board/loadable.cpp.in ${written} @ONLY)
endfunction()

# dynrt_configuration_library(CONFIG FOLDER): the target configuration_<CONFIG>, such a library
# FOLDER/<CONFIG>.so with the fingerprint of this build.
function(dynrt_configuration_library CONFIG folder)
  set(target configuration_${CONFIG})
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated)
  set(source ${generated}/${CONFIG}_loadable.cpp)
  set(DYNRT_FINGERPRINT "@fingerprint@")  # which the build fills in
  dynrt_loadable_library(${target} ${CONFIG} ${source} ${source}.in)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${CONFIG}
                        LIBRARY_OUTPUT_DIRECTORY ${folder})
  set(script ${PROJECT_SOURCE_DIR}/cmake/AddFingerprint.cmake)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DTHIS_BUILD=${generated}/this_build.cpp -DSOURCE=${source}.in
            -DOUTPUT=${source} -P ${script}
    DEPENDS ${generated}/this_build.cpp ${source}.in ${script} VERBATIM)
endfunction()

function(dynrt_configuration_sources target CONFIG)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated)
  configure_file(${PROJECT_SOURCE_DIR}/host/board/native_core.cpp.in
                 ${generated}/${CONFIG}_core.cpp @ONLY)
  target_sources(${target} PRIVATE ${generated}/${CONFIG}_core.cpp)
  set_source_files_properties(${generated}/${CONFIG}_core.cpp PROPERTIES COMPILE_OPTIONS -O3)
  string(APPEND DECLARATIONS "CoreInfo ${CONFIG}_info();\n"
         "std::unique_ptr<NativeCore> make_${CONFIG}_core();\n")
  dynrt_has_board(lowered ${CONFIG})
  set(row ".name = \"${CONFIG}\", .core = ${CONFIG}_info")
  if(lowered)
    string(APPEND row ", .lowered = true")
  endif()
  string(APPEND row ", .native = make_${CONFIG}_core")
  if(lowered)
    foreach(key packets lines scan_out)
      dynrt_config_key(${key} ${CONFIG} ${key})
    endforeach()
    get_property(core GLOBAL PROPERTY DYNRT_${CONFIG}_VERILOG)
    get_property(header GLOBAL PROPERTY DYNRT_${CONFIG}_HEADER)
    dynrt_add_board(${CONFIG}_board CONFIG ${CONFIG} PACKETS ${packets} CACHE_LINES ${lines}
                    SCAN_OUT ${scan_out} CORE ${core} HEADER ${header} SHARDS 4)
    target_link_libraries(${target} PUBLIC ${CONFIG}_board)
    dynrt_embed_text(${target} ${CONFIG}_json
                     ${PROJECT_BINARY_DIR}/generated/${CONFIG}/dynrt_core.json)
    string(APPEND DECLARATIONS "std::unique_ptr<ClockedBoard> make_${CONFIG}_board();\n"
           "std::unique_ptr<ClockedBoard> make_${CONFIG}_board_traced(const std::string&, int);\n"
           "std::string_view ${CONFIG}_json();\n")
    string(APPEND row ", .rtl = make_${CONFIG}_board, .traced = make_${CONFIG}_board_traced, "
           ".core_json = ${CONFIG}_json")
  endif()
  set(DECLARATIONS "${DECLARATIONS}" PARENT_SCOPE)
  set(ROWS "${ROWS}      {${row}},\n" PARENT_SCOPE)
endfunction()
