# SPDX-License-Identifier: BSD-3-Clause
# The Python package: python/berm, with the engine as a module where pybind11 and the headers of Python are there. build/.../python is a folder for PYTHONPATH.
set(BERM_PYTHON_FOLDER ${CMAKE_BINARY_DIR}/python)
file(MAKE_DIRECTORY ${BERM_PYTHON_FOLDER}/berm)
file(GLOB python_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/python/berm/*)
list(FILTER python_files EXCLUDE REGEX __pycache__)
file(GLOB earlier ${BERM_PYTHON_FOLDER}/berm/*.py) # a module that was removed must not be imported from here
if(earlier)
  file(REMOVE ${earlier})
endif()
foreach(file IN LISTS python_files)
  cmake_path(GET file FILENAME name)
  configure_file(${file} ${BERM_PYTHON_FOLDER}/berm/${name} COPYONLY)
endforeach()
install(FILES ${python_files} DESTINATION lib/python3/dist-packages/berm COMPONENT python)

if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3) # Debian's, whose packages these are; another may be first in PATH
endif()
find_package(Python COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.10 QUIET)
if(Python_Development.Module_FOUND AND pybind11_FOUND AND NOT BERM_SANITIZE AND NOT BERM_FUZZ)
  pybind11_add_module(berm_python MODULE NO_EXTRAS python/engine/engine.cpp python/engine/macro_element.cpp
                      src/pipeline/macro_element/macro_element.c src/pipeline/macro_element/parameters.cpp)
  target_link_libraries(berm_python PRIVATE berm_library nlohmann_json::nlohmann_json fmt::fmt)
  target_include_directories(berm_python PRIVATE ${CMAKE_SOURCE_DIR}/include ${CMAKE_SOURCE_DIR}/src/pipeline ${CMAKE_SOURCE_DIR}/src/base)
  set_target_properties(berm_python PROPERTIES OUTPUT_NAME engine LIBRARY_OUTPUT_DIRECTORY ${BERM_PYTHON_FOLDER}/berm UNITY_BUILD OFF)
  install(TARGETS berm_python LIBRARY DESTINATION lib/python3/dist-packages/berm COMPONENT python)
  berm_search_path(berm_python python lib/python3/dist-packages/berm/$<TARGET_FILE_NAME:berm_python> "$ORIGIN/../../lib" "$ORIGIN/../../..")
endif()
