# SPDX-License-Identifier: BSD-3-Clause
# The C code of the macro-element of a pipe.
set(macro_element_code ${CMAKE_SOURCE_DIR}/src/pipeline/macro_element/macro_element)

# Compiles it into its room: in a library of objects of its own, since what a room precompiles is C++.
function(berm_macro_element_code)
  add_library(berm_macro_element_c OBJECT ${macro_element_code}.c)
  target_link_libraries(berm_macro_element_c PRIVATE berm_flags)
  set_target_properties(berm_macro_element_c PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_sources(berm_macro_element PRIVATE $<TARGET_OBJECTS:berm_macro_element_c>)
endfunction()
