# SPDX-License-Identifier: BSD-3-Clause
# The C code of the macro-element as text in the program, which `berm macro-element` writes beside its parameters.
set(code "// Made from src/pipeline/macro_element by cmake/MacroElement.cmake.\n#include \"macro_element_fit/files.hpp\"\n\nnamespace berm::macro_element_fit {\n")
foreach(end h c)
  set(file ${CMAKE_SOURCE_DIR}/src/pipeline/macro_element/macro_element.${end})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  string(APPEND code "const char* const code_${end} = R\"code(${text})code\";\n")
endforeach()
string(APPEND code "}  // namespace berm::macro_element_fit\n")
set(BERM_MACRO_ELEMENT_TEXT ${CMAKE_BINARY_DIR}/macro_element_text.cpp)
file(CONFIGURE OUTPUT ${BERM_MACRO_ELEMENT_TEXT} CONTENT "${code}" @ONLY)

# Compiles it into its room: in a library of objects of its own, since what a room precompiles is C++.
function(berm_macro_element_code)
  add_library(berm_macro_element_c OBJECT ${CMAKE_SOURCE_DIR}/src/pipeline/macro_element/macro_element.c)
  target_link_libraries(berm_macro_element_c PRIVATE berm_flags)
  set_target_properties(berm_macro_element_c PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_sources(berm_macro_element PRIVATE $<TARGET_OBJECTS:berm_macro_element_c>)
endfunction()
