# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# dynrt_embed_text(TARGET FUNCTION FILE): the target has `std::string_view dynrt::host::FUNCTION()`,
# which gives the text of the file.
function(dynrt_embed_text target function file)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/generated/${function}.cpp)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${file} -DOUTPUT=${source} -DNAME=dynrt::host::${function}
            -P ${script}
    DEPENDS ${file} ${script}
    VERBATIM)
  target_sources(${target} PRIVATE ${source})
endfunction()
