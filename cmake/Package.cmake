# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
#
# What `cmake --install` gives: the program dynrt, and for other projects hlsc, the language's headers,
# the core's units, the bench that co-simulates, the Verilog with lists of its files, and a CMake
# package that ties them together (dynrtConfig.cmake).
include(CMakePackageConfigHelpers)
set(share share/dynrt)
set(include include/dynrt)

# The program looks for the rest beside itself (host/program_part.h). It holds the configurations of
# DYNRT_BUILT_IN; of the others those go along that are built. For all else that it makes, such as a
# core for one scene, it needs the folder that it was built from.
install(TARGETS dynrt RUNTIME DESTINATION bin)
install(TARGETS dynrt_images LIBRARY DESTINATION lib/dynrt)
install(DIRECTORY ${PROJECT_BINARY_DIR}/configurations DESTINATION lib/dynrt)
install(DIRECTORY host/view/page/ DESTINATION ${share}/view)
install(DIRECTORY scenes DESTINATION ${share} FILES_MATCHING PATTERN *.json PATTERN CREDITS.md)

install(TARGETS hlsc EXPORT dynrtTargets RUNTIME DESTINATION bin)
install(EXPORT dynrtTargets NAMESPACE dynrt:: DESTINATION ${share}/cmake)
install(TARGETS hls_join cosim_bench ARCHIVE DESTINATION lib/dynrt)
foreach(folder include native lowered)
  install(DIRECTORY hls/${folder}/hls DESTINATION ${include}/${folder} FILES_MATCHING PATTERN *.h
          PATTERN float_judge.h EXCLUDE)  # of tests; it needs MPFR
endforeach()
install(DIRECTORY hls/units DESTINATION ${include} FILES_MATCHING PATTERN *.h
        PATTERN test_bench.h EXCLUDE)
# Tests write configurations of their own into the same folder.
get_property(configs GLOBAL PROPERTY DYNRT_CONFIGS)
list(TRANSFORM configs REPLACE "(.+)" "${DYNRT_CONFIG_FOLDER}/\\1.h" OUTPUT_VARIABLE config_headers)
install(FILES ${config_headers} ${DYNRT_CONFIG_FOLDER}/core_configuration.h
        DESTINATION ${include}/configs)
install(DIRECTORY hls/cosim DESTINATION ${include} FILES_MATCHING PATTERN *.h
        PATTERN example EXCLUDE)
install(DIRECTORY hls/compiler/delay/ DESTINATION ${share}/delay FILES_MATCHING PATTERN *.json)
install(FILES hls/compiler/README.md DESTINATION ${share} RENAME hlsc.md)
install(FILES cmake/HlsLower.cmake cmake/Verilate.cmake cmake/GatherVerilated.cmake
        DESTINATION ${share}/cmake)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/dynrtConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES cmake/dynrtConfig.cmake ${PROJECT_BINARY_DIR}/dynrtConfigVersion.cmake
        DESTINATION ${share}/cmake)

# The Verilog that is checked in, and that of boards. The prefix may be moved, so a list names its files
# relative to its own folder, as -F of Verilator and -f of others, run there, read it.
set(rtl ${share}/rtl)
install(DIRECTORY rtl/arty rtl/lib rtl/board rtl/bus rtl/display rtl/ecp5 rtl/link rtl/sdram rtl/ulx3s
        rtl/generated rtl/lint DESTINATION ${rtl}
        FILES_MATCHING PATTERN *.v PATTERN *.vh PATTERN *.vlt)
# Those of scripts/place are for no board.
install(DIRECTORY constraints/ DESTINATION ${rtl} PATTERN place_* EXCLUDE)
if(DYNRT_RTL)
  foreach(made fast_port fast_ulx3s link8 link16 sdram display)
    install(DIRECTORY ${PROJECT_BINARY_DIR}/generated/${made} DESTINATION ${rtl}/generated
            FILES_MATCHING PATTERN *.v PATTERN *.vh PATTERN fresh EXCLUDE)
  endforeach()
  set(lists dynrt_core.f dynrt_board.f dynrt_lint.f dynrt_axi.f dynrt_wishbone.f axi_system.f
      wishbone_system.f dynrt_serial.f dynrt_arty.f dynrt_ulx3s.f dynrt.core)
  list(TRANSFORM lists PREPEND ${PROJECT_BINARY_DIR}/)
  file(GLOB_RECURSE verilog CONFIGURE_DEPENDS rtl/*.v)
  add_custom_command(OUTPUT ${lists}
    COMMAND scripts/file_lists --relative --build ${PROJECT_BINARY_DIR} ${PROJECT_BINARY_DIR}
    DEPENDS scripts/dynrt_tools/hardware/file_lists.py board_verilog ${verilog}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
  add_custom_target(file_lists ALL DEPENDS ${lists})
  install(FILES ${lists} DESTINATION ${rtl})

  # hls/example is such a project: built out of the tree with what is installed, once a build.
  add_test(NAME package.example
    COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DEXAMPLE=${PROJECT_SOURCE_DIR}/hls/example
            -DCOMPILER=${CMAKE_CXX_COMPILER} -P ${PROJECT_SOURCE_DIR}/cmake/TryPackage.cmake)
  set_tests_properties(package.example PROPERTIES LABELS system PROCESSORS 2)
endif()
