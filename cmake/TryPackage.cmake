# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
# cmake -DBUILD=.. -DEXAMPLE=.. -DCOMPILER=.. -P TryPackage.cmake
# Installs a build into a fresh folder, renders with the installed program, builds a copy of the
# example project with what is installed alone and runs it; Verilator lints the installed board by the
# list of its files.
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
run(verilator --lint-only -F ${work}/prefix/share/dynrt/rtl/dynrt_lint.f)
file(REMOVE_RECURSE ${work})
