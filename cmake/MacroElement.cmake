# SPDX-License-Identifier: BSD-3-Clause
# The C code of the macro-element as text in the program, which `berm macro-element` writes beside its parameters.
set(code "// Made from src/macro_element by cmake/MacroElement.cmake.\n#include \"macro_element/files.hpp\"\n\nnamespace berm::macro_element {\n")
foreach(end h c)
  set(file ${CMAKE_SOURCE_DIR}/src/macro_element/macro_element.${end})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  string(APPEND code "const char* const code_${end} = R\"code(${text})code\";\n")
endforeach()
string(APPEND code "}  // namespace berm::macro_element\n")
set(BERM_MACRO_ELEMENT_TEXT ${CMAKE_BINARY_DIR}/macro_element_text.cpp)
file(CONFIGURE OUTPUT ${BERM_MACRO_ELEMENT_TEXT} CONTENT "${code}" @ONLY)
