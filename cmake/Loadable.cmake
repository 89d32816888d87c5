# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# One configuration as a shared library that the program dynrt loads (host/board/loadable.h), or its
# Verilog alone. scripts/configuration runs this and keeps what it gives; it passes
#   DYNRT_LOADABLE        ON: this, not the project
#   DYNRT_CONFIGS_FILE    a file as hls/configs/configs.json with one configuration, `loadable`
#   DYNRT_FINGERPRINT     of what it is built of (scripts/fingerprint)
#   DYNRT_RTL             with its Verilog, which DYNRT_HLSC, of a build that is there, lowers
# and what that build found out: compiler, flags, clock, delay model, Verilator.
# Targets: loadable, the library; dynrt_loadable_core, the Verilog.
include(Warnings)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
include(HlsLower)
include(HlsUnit)
if(DYNRT_RTL)
  include(Verilate)
  add_executable(hlsc IMPORTED GLOBAL)
  set_target_properties(hlsc PROPERTIES IMPORTED_LOCATION ${DYNRT_HLSC})
endif()
add_subdirectory(hls)
add_subdirectory(rtl/board)
add_subdirectory(host/format)
add_subdirectory(host/board)
