# SPDX-License-Identifier: BSD-3-Clause
# Debian packages, by `cpack` in a build folder; they run on any processor where it was configured with BERM_VECTOR_UNITS=all, as by `make packages`:
#   berm           the program with its engine
#   berm-mpi       runs on several processes of an MPI launcher
#   libberm-dev    the library, its headers and the file for find_package
#   python3-berm   the Python package, with the engine as a module
#   berm-doc       examples and documentation
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME berm)
set(CPACK_PACKAGE_VENDOR "berm developers")
set(BERM_MAINTAINER "berm developers <developers@berm.invalid>" CACHE STRING "who answers for the Debian packages: name <address>")
set(CPACK_PACKAGE_CONTACT ${BERM_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "pipe-soil interaction at large deformation by the material point method")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_SOURCE_DIR}/build/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR}/lib)
set(CPACK_DEBIAN_DEBUGINFO_PACKAGE OFF)

# berm_package(COMPONENT NAME SUMMARY [field value]...)    fields as CPACK_DEBIAN_<COMPONENT>_PACKAGE_<field>
set(CPACK_COMPONENTS_ALL)
macro(berm_package component name summary)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}")
  set(fields ${ARGN})
  while(fields)
    list(POP_FRONT fields field value)
    set(CPACK_DEBIAN_${upper}_PACKAGE_${field} "${value}")
  endwhile()
  install(FILES ${CMAKE_BINARY_DIR}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
  install(FILES ${CMAKE_BINARY_DIR}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
endmacro()

file(READ ${CMAKE_SOURCE_DIR}/LICENSE licence)
file(WRITE ${CMAKE_BINARY_DIR}/copyright "${licence}\nThe licences of other packages whose code berm holds are in /usr/share/doc/berm/licences.gz.\n")
# What Debian's tools read; what is new is in CHANGELOG.md of berm-doc. Dated as the last commit, so that the same sources give the same bytes.
execute_process(COMMAND git -C ${CMAKE_SOURCE_DIR} log -1 --format=%cD OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT date)
  execute_process(COMMAND date --rfc-email --reference ${CMAKE_SOURCE_DIR}/CHANGELOG.md OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
file(WRITE ${CMAKE_BINARY_DIR}/changelog "berm (${PROJECT_VERSION}) bookworm; urgency=medium\n\n  * /usr/share/doc/berm-doc/CHANGELOG.md says what is new.\n\n -- ${BERM_MAINTAINER}  ${date}\n")
execute_process(COMMAND gzip -9 -n -c ${CMAKE_BINARY_DIR}/changelog OUTPUT_FILE ${CMAKE_BINARY_DIR}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
set(same "(= ${PROJECT_VERSION})")
berm_package(berm berm "pushes pipes and cables into the seabed, drags them, tells how soil responds"
  DEPENDS "gmsh, gnuplot-nox | gnuplot, librsvg2-bin" SUGGESTS "berm-doc, python3-berm, berm-mpi, chromium, xdg-utils")
if(TARGET berm_mpi)
  berm_package(berm_mpi berm-mpi "one run of berm on several processes of an MPI launcher" DEPENDS "berm ${same}, openmpi-bin")
endif()
berm_package(libberm libberm-dev "the library of berm, to step cases inside other programs" DEPENDS "berm ${same}" SECTION libdevel SUGGESTS cmake CONTROL_EXTRA ${CMAKE_BINARY_DIR}/triggers)
file(WRITE ${CMAKE_BINARY_DIR}/triggers "activate-noawait ldconfig\n")
berm_package(python python3-berm "berm in Python: runs, results, and the engine as a module" DEPENDS "berm ${same}, libberm-dev ${same}, python3, python3-numpy"
  SECTION python SUGGESTS "python3-matplotlib, python3-pandas, python3-xarray")
berm_package(doc berm-doc "examples and documentation of berm" SHLIBDEPS OFF SECTION doc ARCHITECTURE all)

# Once all is built: the build tells what it has read, and Debian which package that is of.
find_program(BERM_DPKG_QUERY dpkg-query)
if(BERM_DPKG_QUERY AND CMAKE_GENERATOR STREQUAL "Ninja")
  install(CODE "execute_process(COMMAND ${CMAKE_SOURCE_DIR}/scripts/materials ${CMAKE_BINARY_DIR} licences COMMAND gzip -9 -n OUTPUT_FILE ${CMAKE_BINARY_DIR}/licences.gz COMMAND_ERROR_IS_FATAL ANY)" COMPONENT berm)
  install(FILES ${CMAKE_BINARY_DIR}/licences.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/berm COMPONENT berm)
endif()

install(DIRECTORY ${CMAKE_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/berm COMPONENT doc PATTERN "*.so" EXCLUDE) # laws that were built where they lie
install(DIRECTORY ${CMAKE_SOURCE_DIR}/build/site/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/berm/html COMPONENT doc OPTIONAL) # where `make site` has made it
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/berm COMPONENT doc)
install(FILES ${CMAKE_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/berm COMPONENT doc)
install(FILES ${CMAKE_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/berm-doc COMPONENT doc)
# The library is for programs that are built with its headers; one package holds both.
file(WRITE ${CMAKE_BINARY_DIR}/libberm-dev.overrides "libberm-dev: link-to-shared-library-in-wrong-package *\nlibberm-dev: package-name-doesnt-match-sonames *\n")
install(FILES ${CMAKE_BINARY_DIR}/libberm-dev.overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME libberm-dev COMPONENT libberm)
include(CPack)
