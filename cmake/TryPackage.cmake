# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
# cmake -DBUILD=.. -DEXAMPLE=.. -DCOMPILER=.. -P TryPackage.cmake
# Installs a build into a fresh folder, renders with the installed program, builds a copy of the
# example project with what is installed alone and runs it; Verilator lints the installed board and the
# core on a serial line by the lists of their files; boards have their lists and constraints.
set(work ${BUILD}/package_test)
file(REMOVE_RECURSE ${work})
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/prefix)
# Nothing that only tests have.
file(GLOB_RECURSE tests_own ${work}/prefix/include/*/float_judge.h ${work}/prefix/include/*/lean.h
     ${work}/prefix/include/*/boards.h)
if(tests_own)
  message(FATAL_ERROR "the package has headers that are only for tests: ${tests_own}")
endif()
run(${work}/prefix/bin/dynrt compare blocks --size 32x32 --out ${work}/blocks.png)
file(COPY ${EXAMPLE}/ DESTINATION ${work}/example)
run(${CMAKE_COMMAND} -G Ninja -S ${work}/example -B ${work}/build -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_PREFIX_PATH=${work}/prefix -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
run(${CMAKE_COMMAND} --build ${work}/build)
run(${work}/build/example)
set(rtl ${work}/prefix/share/dynrt/rtl)
foreach(list dynrt_lint dynrt_serial)
  run(verilator --lint-only -F ${rtl}/${list}.f)
endforeach()
foreach(file dynrt.core dynrt_arty.f arty_a7.xdc dynrt_ulx3s.f ulx3s.lpf dynrt_board.sdc memory_port.sdc)
  if(NOT EXISTS ${rtl}/${file})
    message(FATAL_ERROR "the package lacks ${file}")
  endif()
endforeach()
file(GLOB measured ${rtl}/place_*)
if(measured)
  message(FATAL_ERROR "the package has constraints that are for no board: ${measured}")
endif()
file(REMOVE_RECURSE ${work})
