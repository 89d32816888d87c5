# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# dynrt_configuration_sources(TARGET CONFIG): adds to a library what makes the boards of a
# configuration: its native core and, where its Verilog is made, the Verilated board. Appends to the
# caller's variables
#   DECLARATIONS   of the functions that do so
#   ROWS           their row in a table of host/board/configurations.h
function(dynrt_configuration_sources target CONFIG)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated)
  configure_file(${PROJECT_SOURCE_DIR}/host/board/native_core.cpp.in
                 ${generated}/${CONFIG}_core.cpp @ONLY)
  target_sources(${target} PRIVATE ${generated}/${CONFIG}_core.cpp)
  set_source_files_properties(${generated}/${CONFIG}_core.cpp PROPERTIES COMPILE_OPTIONS -O3)
  string(APPEND DECLARATIONS "CoreInfo ${CONFIG}_info();\n"
         "std::unique_ptr<NativeCore> make_${CONFIG}_core();\n")
  set(row ".name = \"${CONFIG}\", .core = ${CONFIG}_info, .native = make_${CONFIG}_core")

  get_property(rtl_configs GLOBAL PROPERTY DYNRT_RTL_CONFIGS)
  # A float of more than 24 bits needs wider words than the board's SRAM has: no board.
  dynrt_config_key(exponent_bits ${CONFIG} exponent_bits)
  dynrt_config_key(mantissa_bits ${CONFIG} mantissa_bits)
  math(EXPR float_bits "1 + ${exponent_bits} + ${mantissa_bits}")
  if(CONFIG IN_LIST rtl_configs AND float_bits LESS_EQUAL 24)
    foreach(key packets lines sram_latency scan_out)
      dynrt_config_key(${key} ${CONFIG} ${key})
    endforeach()
    get_property(core GLOBAL PROPERTY DYNRT_${CONFIG}_VERILOG)
    get_property(header GLOBAL PROPERTY DYNRT_${CONFIG}_HEADER)
    dynrt_add_board(${CONFIG}_board CONFIG ${CONFIG} PACKETS ${packets} CACHE_LINES ${lines}
                    SRAM_LATENCY ${sram_latency} SCAN_OUT ${scan_out} CORE ${core} HEADER ${header} SHARDS 4)
    target_link_libraries(${target} PUBLIC ${CONFIG}_board)
    set(json ${PROJECT_BINARY_DIR}/generated/${CONFIG}/dynrt_core.json)
    add_custom_command(
      OUTPUT ${generated}/${CONFIG}_json.cpp
      COMMAND ${CMAKE_COMMAND} -DSOURCE=${json} -DOUTPUT=${generated}/${CONFIG}_json.cpp
              -DNAME=dynrt::host::${CONFIG}_json -P ${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake
      DEPENDS ${json} ${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake
      VERBATIM)
    target_sources(${target} PRIVATE ${generated}/${CONFIG}_json.cpp)
    string(APPEND DECLARATIONS "std::unique_ptr<ClockedBoard> make_${CONFIG}_board();\n"
           "std::unique_ptr<ClockedBoard> make_${CONFIG}_board_traced(const std::string&, int);\n"
           "std::string_view ${CONFIG}_json();\n")
    string(APPEND row ", .rtl = make_${CONFIG}_board, .traced = make_${CONFIG}_board_traced, "
           ".core_json = ${CONFIG}_json")
  endif()
  set(DECLARATIONS "${DECLARATIONS}" PARENT_SCOPE)
  set(ROWS "${ROWS}      {${row}},\n" PARENT_SCOPE)
endfunction()
