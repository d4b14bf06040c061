# SPDX-License-Identifier: BSD-3-Clause
# What `cmake --install` puts where. Libraries are found by where the program or libberm.so lies, so that the whole may be moved; the engine and what the program
# opens lie in a folder of their own, which the loader searches for no other program.
include(GNUInstallDirs)
set(BERM_PRIVATE_LIBRARIES ${CMAKE_INSTALL_LIBDIR}/berm)
file(RELATIVE_PATH from_program /${CMAKE_INSTALL_BINDIR} /${BERM_PRIVATE_LIBRARIES})

# Where the loader searches for the libraries of a target: `built` in the build folder, `installed` (not longer than that) in the file that is installed. CMake
# makes room for a change on installing with an empty entry in the one that is built, which the loader takes for the current folder; so the change is made here.
function(berm_search_path target component file built installed)
  set_target_properties(${target} PROPERTIES BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "${built}" INSTALL_RPATH_USE_LINK_PATH ON)
  install(CODE "file(RPATH_SET FILE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${file}\" NEW_RPATH [[${installed}]])" COMPONENT ${component})
endfunction()

install(TARGETS berm RUNTIME COMPONENT berm)
# In the build folder: the libraries beside the program, wherever the folder was moved; of a copy of the program alone those that it was built with.
set(beside "$ORIGIN/lib;${CMAKE_BINARY_DIR}/lib")
if(BERM_REPRODUCIBLE)
  set(beside "$ORIGIN/lib;$ORIGIN/${from_program}")
endif()
berm_search_path(berm berm ${CMAKE_INSTALL_BINDIR}/berm "${beside}" "$ORIGIN/${from_program}")
foreach(unit IN LISTS BERM_UNITS)
  berm_folder_of(${unit} ${BERM_PRIVATE_LIBRARIES} folder)
  install(TARGETS berm_engine_${unit} LIBRARY DESTINATION ${folder} COMPONENT berm)
  berm_search_path(berm_engine_${unit} berm ${folder}/libberm_engine.so "" "")
endforeach()
if(TARGET berm_mpi)
  install(TARGETS berm_mpi LIBRARY DESTINATION ${BERM_PRIVATE_LIBRARIES} COMPONENT berm_mpi)
  berm_search_path(berm_mpi berm_mpi ${BERM_PRIVATE_LIBRARIES}/libberm_mpi.so "$ORIGIN" "$ORIGIN")
endif()
set_target_properties(berm_library PROPERTIES OUTPUT_NAME berm VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
install(TARGETS berm_library LIBRARY COMPONENT libberm)
berm_search_path(berm_library libberm ${CMAKE_INSTALL_LIBDIR}/libberm.so.${PROJECT_VERSION} "$ORIGIN/../lib" "$ORIGIN/berm")
install(DIRECTORY ${CMAKE_SOURCE_DIR}/include/berm TYPE INCLUDE COMPONENT libberm)

# Manual pages, completion and the schemas of its inputs, by the program itself.
set(BERM_SHARE ${CMAKE_BINARY_DIR}/share)
add_custom_command(OUTPUT ${BERM_SHARE}/man/man1/berm.1 DEPENDS berm VERBATIM
  COMMAND berm man ${BERM_SHARE}/man/man1
  COMMAND sh -c "gzip --force -9 --no-name --keep ${BERM_SHARE}/man/man1/*.1"
  COMMAND ${CMAKE_COMMAND} -E make_directory ${BERM_SHARE}/bash-completion/completions ${BERM_SHARE}/zsh/vendor-completions ${BERM_SHARE}/fish/vendor_completions.d
  COMMAND berm completion bash > ${BERM_SHARE}/bash-completion/completions/berm
  COMMAND berm completion zsh > ${BERM_SHARE}/zsh/vendor-completions/_berm
  COMMAND berm completion fish > ${BERM_SHARE}/fish/vendor_completions.d/berm.fish
  COMMAND ${CMAKE_COMMAND} -E make_directory ${BERM_SHARE}/berm
  COMMAND berm params --json-schema case > ${BERM_SHARE}/berm/case.schema.json
  COMMAND berm params --json-schema element > ${BERM_SHARE}/berm/element.schema.json
  COMMAND berm params --json-schema fit > ${BERM_SHARE}/berm/fit.schema.json
  COMMAND berm params --json-schema cyclic > ${BERM_SHARE}/berm/cyclic.schema.json
  COMMAND berm params --json-schema sea > ${BERM_SHARE}/berm/sea.schema.json
  COMMAND berm params --json-schema route > ${BERM_SHARE}/berm/route.schema.json
  COMMAND berm params --json-schema study > ${BERM_SHARE}/berm/study.schema.json)
add_custom_target(berm_manual ALL DEPENDS ${BERM_SHARE}/man/man1/berm.1)
install(DIRECTORY ${BERM_SHARE}/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT berm PATTERN "*.1" EXCLUDE)

# find_package(berm) gives the target berm::berm.
include(CMakePackageConfigHelpers)
set(BERM_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/berm)
list(GET BERM_UNITS 0 unit)
berm_folder_of(${unit} ${BERM_PRIVATE_LIBRARIES} BERM_ENGINE_FOLDER)
configure_package_config_file(cmake/berm-config.cmake.in ${CMAKE_BINARY_DIR}/berm-config.cmake INSTALL_DESTINATION ${BERM_PACKAGE} PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR BERM_ENGINE_FOLDER)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/berm-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/berm-config.cmake ${CMAKE_BINARY_DIR}/berm-config-version.cmake DESTINATION ${BERM_PACKAGE} COMPONENT libberm)
