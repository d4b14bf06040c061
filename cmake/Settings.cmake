# SPDX-License-Identifier: BSD-3-Clause
# How everything is compiled, and the libraries that are used.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_BUILD_RPATH_USE_ORIGIN ON) # a build folder may be moved
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

option(BERM_TESTS "build the tests" ON)
set(BERM_VECTOR_UNITS native CACHE STRING "what the engine is compiled for: native (the vector unit that the loader takes on this machine), all (baseline, x86-64-v3 and x86-64-v4) or baseline")
set_property(CACHE BERM_VECTOR_UNITS PROPERTY STRINGS native all baseline)
set(BERM_SANITIZE "" CACHE STRING "sanitizers, as for -fsanitize=")
option(BERM_REPRODUCIBLE "nothing that is built names the folder it was built in" OFF)
option(BERM_FUZZ "make the targets of tests/fuzz programs of clang's libFuzzer" OFF)

# What Debian hardens its programs with (dpkg-buildflags, hardening=+all); tests/installed looks for it. Sanitizers look at more themselves.
add_library(berm_hardening INTERFACE)
if(NOT BERM_SANITIZE AND NOT BERM_FUZZ)
  target_compile_options(berm_hardening INTERFACE -fstack-protector-strong -fstack-clash-protection)
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
    target_compile_options(berm_hardening INTERFACE -fcf-protection)
  endif()
  target_compile_definitions(berm_hardening INTERFACE $<$<CONFIG:Release>:_FORTIFY_SOURCE=2>)
  target_link_options(berm_hardening INTERFACE -Wl,-z,relro -Wl,-z,now)
endif()

add_library(berm_flags INTERFACE)
target_link_libraries(berm_flags INTERFACE berm_hardening)
# -Wno-psabi: vectors wider than a register are passed by reference inside berm; no such type crosses a library's boundary by value.
target_compile_options(berm_flags INTERFACE -Wall -Wextra -Wconversion -Wno-sign-conversion -Werror -Wno-psabi)
# Files that are compiled together see each other's constants, which their local names may shadow, and are no main file, whose types in anonymous namespaces may be anywhere.
if(CMAKE_UNITY_BUILD)
  target_compile_options(berm_flags INTERFACE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wshadow=local;-Wno-subobject-linkage>)
else()
  target_compile_options(berm_flags INTERFACE -Wshadow)
endif()
# One law serves vectors of lanes, whose masks are joined by & and |, and single numbers, whose masks are bool.
target_compile_options(berm_flags INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical;-Wno-bitwise-conditional-parentheses>)
# gcc collects its garbage from half a gigabyte on, which it rarely reaches: a tenth of its time. It writes the same code.
target_compile_options(berm_flags INTERFACE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=524288>)
# Square roots need no errno and no comparison may trap: with this the compiler can vectorize them. NaN keeps its meaning.
target_compile_options(berm_flags INTERFACE -fno-math-errno -fno-trapping-math)
target_compile_definitions(berm_flags INTERFACE $<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>)
target_include_directories(berm_flags INTERFACE ${CMAKE_SOURCE_DIR}/include) # what users include is also what the program means
target_compile_definitions(berm_flags INTERFACE BERM_VERSION="${PROJECT_VERSION}")
target_link_options(berm_flags INTERFACE -Wl,--build-id) # by which results are known to be of this program; gcc of Debian does so anyway
if(BERM_REPRODUCIBLE)
  target_compile_options(berm_flags INTERFACE -ffile-prefix-map=${CMAKE_SOURCE_DIR}=.)
endif()
# Eigen's alignment follows the vector unit by default; fixed here, so that all versions of the engine share one layout.
target_compile_definitions(berm_flags INTERFACE EIGEN_MAX_STATIC_ALIGN_BYTES=0)
if(BERM_SANITIZE)
  target_compile_options(berm_flags INTERFACE -fsanitize=${BERM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(berm_flags INTERFACE -fsanitize=${BERM_SANITIZE})
  target_compile_definitions(berm_flags INTERFACE _GLIBCXX_ASSERTIONS)
endif()

find_package(OpenMP REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(tomlplusplus REQUIRED) # its headers; input/document.cpp compiles them
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(DEFLATE REQUIRED IMPORTED_TARGET libdeflate) # zlib streams of frames, in a third of the time of zlib
pkg_check_modules(MICROHTTPD REQUIRED IMPORTED_TARGET libmicrohttpd) # the server of `berm desk`
pkg_check_modules(XLSXWRITER REQUIRED IMPORTED_TARGET xlsxwriter) # tables as .xlsx
find_package(OpenSSL REQUIRED COMPONENTS Crypto) # SHA-256 of what a run is made from
# HDF5 without MPI.
find_path(HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial REQUIRED)
find_library(HDF5_LIBRARY NAMES hdf5_serial hdf5 REQUIRED)
add_library(hdf5 INTERFACE)
target_include_directories(hdf5 SYSTEM INTERFACE ${HDF5_INCLUDE})
target_link_libraries(hdf5 INTERFACE ${HDF5_LIBRARY})
find_library(SECCOMP_LIBRARY seccomp REQUIRED)
add_library(seccomp INTERFACE)
target_link_libraries(seccomp INTERFACE ${SECCOMP_LIBRARY})
find_library(UDUNITS_LIBRARY udunits2 REQUIRED)
add_library(udunits2 INTERFACE)
target_link_libraries(udunits2 INTERFACE ${UDUNITS_LIBRARY})
find_package(MPI COMPONENTS CXX) # of the machine, for runs on several of them; without it there are none
# MUMPS without MPI; PETSc's package would bring MPI and ninety others (docs/decisions/0008).
find_path(MUMPS_INCLUDE dmumps_c.h REQUIRED)
find_library(MUMPS_LIBRARY dmumps_seq REQUIRED)
add_library(mumps INTERFACE)
target_include_directories(mumps SYSTEM INTERFACE ${MUMPS_INCLUDE})
target_link_libraries(mumps INTERFACE ${MUMPS_LIBRARY})
find_library(CMARK_GFM_LIBRARY cmark-gfm REQUIRED)
find_library(CMARK_GFM_EXTENSIONS_LIBRARY cmark-gfm-extensions REQUIRED)
add_library(cmark_gfm INTERFACE)
target_link_libraries(cmark_gfm INTERFACE ${CMARK_GFM_EXTENSIONS_LIBRARY} ${CMARK_GFM_LIBRARY})
set(openmp OpenMP::OpenMP_CXX)
if(BERM_FUZZ) # a target has one thread; there OpenMP would only take memory at every loop
  set(openmp ${OpenMP_omp_LIBRARY})
  target_compile_options(berm_flags INTERFACE -Wno-unused-variable -Wno-unused-parameter)
endif()
target_link_libraries(berm_flags INTERFACE ${openmp} Eigen3::Eigen fmt::fmt spdlog::spdlog)
