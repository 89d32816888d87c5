# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# hls_lower(MODULE m HEADER scale.h TYPE "example::Scale" FOLDER dir INCLUDES dir...
#           CLOCK_NS n DELAY model.json [ROOM n] [UNCERTAINTY ns] [DEPENDS file...] [ROOT dir]
#           [PRECOMPILED file])
#
# A command that lowers the unit TYPE, which HEADER defines, to FOLDER/m.v with its schedule report
# m.txt, the same as data m.json and the test bench's header m_ports.h, whenever one of the headers that it includes changes;
# what follows from these files is made again only when they change. HEADER is named as it is
# included. No absolute path gets into the Verilog of headers within ROOT.
#
# The including project says where things are:
#   HLS_COMPILER    the target of hlsc
#   HLS_LANGUAGE    the folders of the headers that hlsc reads in place of the native ones
#
# hls_precompile(TARGET t FILE language.pch DELAY model.json ROOT dir)
#
# A command that precompiles the language's headers, which then need not be parsed for each unit that is
# lowered with PRECOMPILED language.pch and the same DELAY and ROOT.

# hls_includes(RESULT ROOT dir...): -I and each folder, relative to ROOT if that is not empty.
function(hls_includes result root)
  set(words)
  foreach(folder IN LISTS ARGN)
    if(root)
      file(RELATIVE_PATH folder ${root} ${folder})
    endif()
    list(APPEND words -I ${folder})
  endforeach()
  set(${result} ${words} PARENT_SCOPE)
endfunction()

function(hls_precompile)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;FILE;DELAY;ROOT" "")
  hls_includes(includes ${arg_ROOT} ${HLS_LANGUAGE})
  set(headers)
  foreach(folder IN LISTS HLS_LANGUAGE)
    file(GLOB found CONFIGURE_DEPENDS ${folder}/hls/*.h)
    list(APPEND headers ${found})
  endforeach()
  add_custom_command(OUTPUT ${arg_FILE}
    COMMAND ${HLS_COMPILER} --precompile ${arg_FILE} --header hls/language.h ${includes}
            --delay ${arg_DELAY}
    DEPENDS ${HLS_COMPILER} ${headers} ${arg_DELAY}
    WORKING_DIRECTORY ${arg_ROOT}
    COMMENT "Precompiling the headers that units include"
    VERBATIM)
  add_custom_target(${arg_TARGET} DEPENDS ${arg_FILE})
endfunction()

function(hls_lower)
  cmake_parse_arguments(PARSE_ARGV 0 arg ""
                        "MODULE;HEADER;TYPE;FOLDER;CLOCK_NS;DELAY;ROOM;UNCERTAINTY;ROOT;PRECOMPILED"
                        "INCLUDES;DEPENDS")
  foreach(needed MODULE HEADER TYPE FOLDER CLOCK_NS DELAY)
    if(NOT arg_${needed})
      message(FATAL_ERROR "hls_lower(${arg_MODULE}): ${needed} is missing")
    endif()
  endforeach()
  hls_includes(compiler_includes "" ${HLS_LANGUAGE} ${arg_INCLUDES})
  hls_includes(hlsc_includes "${arg_ROOT}" ${HLS_LANGUAGE} ${arg_INCLUDES})
  set(precompiled)
  if(arg_PRECOMPILED)
    set(precompiled --precompiled ${arg_PRECOMPILED})
  endif()
  set(room)
  if(arg_ROOM)
    set(room --room ${arg_ROOM})
  endif()
  set(uncertainty)
  if(arg_UNCERTAINTY)
    set(uncertainty --uncertainty ${arg_UNCERTAINTY})
  endif()
  set(in_root)
  if(arg_ROOT)
    set(in_root WORKING_DIRECTORY ${arg_ROOT})
  endif()
  unset(hls_header)
  find_file(hls_header ${arg_HEADER} PATHS ${arg_INCLUDES} NO_CACHE NO_DEFAULT_PATH REQUIRED)
  set(stem ${arg_FOLDER}/${arg_MODULE})
  set(fresh ${arg_FOLDER}/fresh/${arg_MODULE})
  file(MAKE_DIRECTORY ${arg_FOLDER}/fresh)
  add_custom_command(
    OUTPUT ${stem}.v
    BYPRODUCTS ${stem}.txt ${stem}.json ${stem}_ports.h
    COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -x c++ ${compiler_includes} -MM -MT ${stem}.v
            -MF ${stem}.d ${hls_header}
    COMMAND ${HLS_COMPILER} --unit ${arg_TYPE} --module ${arg_MODULE} --header ${arg_HEADER}
            ${hlsc_includes} ${precompiled} --clock-ns ${arg_CLOCK_NS} --delay ${arg_DELAY}
            ${room} ${uncertainty}
            -o ${fresh}.v --report ${fresh}.txt --schedule ${fresh}.json
            --binding ${fresh}_ports.h
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${fresh}.v ${fresh}.txt ${fresh}.json
            ${fresh}_ports.h ${arg_FOLDER}
    DEPENDS ${HLS_COMPILER} ${hls_header} ${arg_DELAY} ${arg_PRECOMPILED} ${arg_DEPENDS}
    DEPFILE ${stem}.d
    ${in_root}
    COMMENT "Lowering ${arg_TYPE} to ${arg_MODULE}.v"
    VERBATIM)
endfunction()
