# SPDX-License-Identifier: BSD-3-Clause
# Functional mock-up units: C code and libraries that berm writes into them. Each library is a model and fmi.c, which has the functions of FMI.
#
#   berm_unit(NAME SOURCE...)   the library of a unit
#   berm_units()                those of `berm fmu` and `berm macro-element`, with the code of the latter
function(berm_unit name)
  berm_beside(${name} ${ARGN} ${CMAKE_SOURCE_DIR}/src/exports/fmu/fmi.c)
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR}/src/exports/fmu)
endfunction()

function(berm_units)
  set(fmu ${CMAKE_SOURCE_DIR}/src/exports/fmu)
  set(model ${CMAKE_SOURCE_DIR}/src/exports/macro_element_fit/fmu.c)
  berm_unit(macro_element_fmu ${model} ${macro_element_code}.c)
  target_include_directories(macro_element_fmu PRIVATE ${CMAKE_SOURCE_DIR}/src/pipeline/macro_element)
  berm_embed(macro_element_fit macro_element_fit/fmu.hpp berm::macro_element_fit
    code_h ${macro_element_code}.h code_c ${macro_element_code}.c fmu_code ${model} fmu_library $<TARGET_FILE:macro_element_fmu>)

  set(version ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  berm_unit(slice_fmu ${fmu}/slice.c)
  target_include_directories(slice_fmu PRIVATE ${CMAKE_SOURCE_DIR}/include)
  target_compile_definitions(slice_fmu PRIVATE BERM_LIBRARY="libberm.so.${version}")
  target_link_libraries(slice_fmu PRIVATE ${CMAKE_DL_LIBS})
  berm_embed(fmu fmu/embedded.hpp berm::fmu fmi_h ${fmu}/fmi.h fmi_c ${fmu}/fmi.c slice_library $<TARGET_FILE:slice_fmu>)
  target_compile_definitions(berm_fmu PRIVATE BERM_PROCESSOR="${CMAKE_SYSTEM_PROCESSOR}" BERM_LIBRARY_VERSION="${version}")
endfunction()
