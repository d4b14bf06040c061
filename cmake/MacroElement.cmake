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

# What `berm macro-element` writes beside its parameters: the code, and that of functional mock-up units with their library.
function(berm_macro_element_units)
  set(units ${CMAKE_SOURCE_DIR}/src/studies/macro_element_fit/fmu.c)
  berm_beside(macro_element_fmu ${units} ${macro_element_code}.c)
  target_include_directories(macro_element_fmu PRIVATE ${CMAKE_SOURCE_DIR}/src/pipeline/macro_element)
  berm_embed(macro_element_fit macro_element_fit/fmu.hpp berm::macro_element_fit
    code_h ${macro_element_code}.h code_c ${macro_element_code}.c fmu_code ${units} fmu_library $<TARGET_FILE:macro_element_fmu>)
  target_compile_definitions(berm_macro_element_fit PRIVATE BERM_PROCESSOR="${CMAKE_SYSTEM_PROCESSOR}")
endfunction()
