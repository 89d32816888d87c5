# Every library comes from a Debian package; scripts/setup installs them.

# The program.
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(glm REQUIRED)
find_package(OpenImageIO REQUIRED)
# Debian's target names the headers of OpenCV, which nothing here uses and CMake insists on finding.
get_target_property(dynrt_oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
list(FILTER dynrt_oiio_includes EXCLUDE REGEX opencv)
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
                      INTERFACE_INCLUDE_DIRECTORIES "${dynrt_oiio_includes}")
find_package(assimp REQUIRED)
find_package(TBB REQUIRED)
# Its package brings no CMake files.
find_library(DYNRT_HTTPLIB cpp-httplib REQUIRED)
find_path(DYNRT_HTTPLIB_INCLUDE httplib.h REQUIRED)
add_library(dynrt_httplib INTERFACE)
target_include_directories(dynrt_httplib SYSTEM INTERFACE ${DYNRT_HTTPLIB_INCLUDE})
find_package(Threads REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(cereal REQUIRED)
find_package(ZLIB REQUIRED)
target_link_libraries(dynrt_httplib INTERFACE ${DYNRT_HTTPLIB} Threads::Threads)
# Verilator's package tries 20 compiler flags aloud.
set(CMAKE_REQUIRED_QUIET ON)
find_package(verilator HINTS $ENV{VERILATOR_ROOT} /usr/share/verilator REQUIRED)
unset(CMAKE_REQUIRED_QUIET)
if(DYNRT_PROGRAM_ONLY)
  return()
endif()

# hlsc, the analyses and the tests.
find_package(GTest REQUIRED)
find_package(LLVM 19.1 REQUIRED CONFIG)
find_program(DYNRT_YOSYS yosys REQUIRED)
find_package(benchmark REQUIRED)
find_package(embree REQUIRED)  # 3 or 4: host/analysis/truth/embree.h
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE ON)
find_package(CGAL REQUIRED QUIET)
find_package(PkgConfig REQUIRED)
# Not MPFR: CGAL would take the variables of that name for its own.
pkg_check_modules(DYNRT_MPFR REQUIRED IMPORTED_TARGET mpfr)
