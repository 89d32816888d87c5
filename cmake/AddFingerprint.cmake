# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
# cmake -DTHIS_BUILD=this_build.cpp -DSOURCE=file.in -DOUTPUT=file -P AddFingerprint.cmake
# Replaces @fingerprint@ by what scripts/fingerprint wrote to THIS_BUILD.
file(READ ${THIS_BUILD} text)
if(NOT text MATCHES "[.]fingerprint = \"([0-9a-f]+)\"")
  message(FATAL_ERROR "${THIS_BUILD} holds no fingerprint; scripts/fingerprint should write one")
endif()
set(fingerprint ${CMAKE_MATCH_1})
configure_file(${SOURCE} ${OUTPUT} @ONLY)
