# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# dynrt_lower_link(BYTES): the units of the link (link.h) lowered for a memory whose beats have so many
# bytes, and their top dynrt_link.v with its header dynrt_link.vh.
#   dynrt_link<BYTES>                        custom target that makes build/<preset>/generated/link<BYTES>
#   global property DYNRT_link<BYTES>_VERILOG  its files; _HEADER the header
#   global property DYNRT_link<BYTES>_UNITS    the units
function(dynrt_lower_link bytes)
  set(name link${bytes})
  set(dir ${PROJECT_BINARY_DIR}/generated/${name})
  set(top ${dir}/dynrt_link)
  file(MAKE_DIRECTORY ${dir})
  # These units take a number for a configuration.
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/include/configs/${name}.h
       CONTENT "// The units of the link have no configuration.\n")
  add_executable(elaborate_${name} EXCLUDE_FROM_ALL elaborate_link.cpp)
  target_compile_definitions(elaborate_${name} PRIVATE DYNRT_LINK_BYTES=${bytes})
  target_link_libraries(elaborate_${name} PRIVATE dynrt_units hlsc_join dynrt_warnings fmt::fmt)
  target_compile_options(elaborate_${name} PRIVATE -O0)  # it runs once, for a moment
  add_custom_command(OUTPUT ${top}.v ${top}.vh COMMAND elaborate_${name} ${top}
                     DEPENDS elaborate_${name} COMMENT "Joining the units of the link" VERBATIM)
  set(files ${top}.v)
  set(units)
  foreach(entry "uart_receive:UartReceive" "uart_send:UartSend" "link_receive:LinkReceive"
          "link_stuff:LinkStuff" "link_order:LinkOrder<${bytes}>"
          "link_execute:LinkExecute<${bytes}>" "link_beats:LinkBeats<${bytes}>"
          "link_registers:LinkRegisters<${bytes}>" "link_answer:LinkAnswer<${bytes}>"
          "link_serialise:LinkSerialise<${bytes}>")
    string(REPLACE ":" ";" parts "${entry}")
    list(POP_FRONT parts unit type)
    set(header ${unit})
    if(unit MATCHES "^link_(beats|registers)$")
      set(header link_data)
    endif()
    add_hls_unit(NAME ${unit} SOURCE units/${header}.h TYPE "dynrt::${type}" CONFIG ${name})
    list(APPEND files ${dir}/${unit}.v)
    list(APPEND units ${unit})
  endforeach()
  add_custom_target(dynrt_${name} DEPENDS ${files})
  add_dependencies(verilog dynrt_${name})
  add_dependencies(board_verilog dynrt_${name})
  set_property(GLOBAL PROPERTY DYNRT_${name}_VERILOG ${files})
  set_property(GLOBAL PROPERTY DYNRT_${name}_HEADER ${top}.vh)
  set_property(GLOBAL PROPERTY DYNRT_${name}_UNITS ${units})
endfunction()
