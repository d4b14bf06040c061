# SPDX-License-Identifier: BSD-3-Clause
# What `cmake --install` puts where. Libraries are found by where the program or libberm.so lies, so that the whole may be moved; the engine and what the program
# opens lie in a folder of their own, which the loader searches for no other program.
include(GNUInstallDirs)
set(BERM_PRIVATE_LIBRARIES ${CMAKE_INSTALL_LIBDIR}/berm)
file(RELATIVE_PATH from_program /${CMAKE_INSTALL_BINDIR} /${BERM_PRIVATE_LIBRARIES})

# In the build folder: the libraries beside the program, wherever the folder was moved; of a copy of the program alone those that it was built with.
set_target_properties(berm PROPERTIES BUILD_RPATH_USE_ORIGIN OFF BUILD_RPATH "$ORIGIN/lib;${CMAKE_BINARY_DIR}/lib" INSTALL_RPATH "$ORIGIN/${from_program}")
set_target_properties(berm_library PROPERTIES OUTPUT_NAME berm VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "$ORIGIN/berm")

install(TARGETS berm RUNTIME COMPONENT berm)
foreach(unit IN LISTS BERM_UNITS)
  berm_folder_of(${unit} ${BERM_PRIVATE_LIBRARIES} folder)
  install(TARGETS berm_engine_${unit} LIBRARY DESTINATION ${folder} COMPONENT berm)
endforeach()
if(TARGET berm_mpi)
  set_target_properties(berm_mpi PROPERTIES INSTALL_RPATH "$ORIGIN")
  install(TARGETS berm_mpi LIBRARY DESTINATION ${BERM_PRIVATE_LIBRARIES} COMPONENT berm_mpi)
endif()
install(TARGETS berm_library LIBRARY COMPONENT libberm)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/include/berm TYPE INCLUDE COMPONENT libberm)

# Manual pages and completion, by the program itself.
set(BERM_SHARE ${CMAKE_BINARY_DIR}/share)
add_custom_command(OUTPUT ${BERM_SHARE}/man/man1/berm.1 DEPENDS berm VERBATIM
  COMMAND berm man ${BERM_SHARE}/man/man1
  COMMAND ${CMAKE_COMMAND} -E make_directory ${BERM_SHARE}/bash-completion/completions ${BERM_SHARE}/zsh/vendor-completions ${BERM_SHARE}/fish/vendor_completions.d
  COMMAND berm completion bash > ${BERM_SHARE}/bash-completion/completions/berm
  COMMAND berm completion zsh > ${BERM_SHARE}/zsh/vendor-completions/_berm
  COMMAND berm completion fish > ${BERM_SHARE}/fish/vendor_completions.d/berm.fish)
add_custom_target(berm_manual ALL DEPENDS ${BERM_SHARE}/man/man1/berm.1)
install(DIRECTORY ${BERM_SHARE}/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT berm)

# find_package(berm) gives the target berm::berm.
include(CMakePackageConfigHelpers)
set(BERM_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/berm)
list(GET BERM_UNITS 0 unit)
berm_folder_of(${unit} ${BERM_PRIVATE_LIBRARIES} BERM_ENGINE_FOLDER)
configure_package_config_file(cmake/berm-config.cmake.in ${CMAKE_BINARY_DIR}/berm-config.cmake INSTALL_DESTINATION ${BERM_PACKAGE} PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR BERM_ENGINE_FOLDER)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/berm-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/berm-config.cmake ${CMAKE_BINARY_DIR}/berm-config-version.cmake DESTINATION ${BERM_PACKAGE} COMPONENT libberm)
