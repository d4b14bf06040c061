# SPDX-License-Identifier: BSD-3-Clause
# What berm writes beside its results as it is: C code, and shared libraries of it that were compiled with berm, so that their users need no compiler.
#
#   berm_beside(NAME SOURCE...)                          a shared library of C code by itself, which needs the C library only
#   berm_embed(ROOM HEADER NAMESPACE [NAME FILE]...)     files as constants of a room: std::string_view NAMESPACE::NAME, as HEADER declares it
#   cmake -D CODE=... -D FILES=... -P Embed.cmake        writes the source of these constants
if(CMAKE_SCRIPT_MODE_FILE)
  set(code "// Made by cmake/Embed.cmake.\n#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n")
  while(FILES)
    list(POP_FRONT FILES name file)
    file(READ ${file} bytes HEX)
    string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
    string(REGEX REPLACE "((\\\\x..)(\\\\x..)(\\\\x..)(\\\\x..)(\\\\x..)(\\\\x..)(\\\\x..)(\\\\x..))" "\"\\1\"\n" lines "${bytes}")
    string(REGEX REPLACE "(^|\n)(\\\\x[^\n\"]*)$" "\\1\"\\2\"\n" lines "${lines}")
    string(APPEND code "namespace {\nconstexpr char bytes_of_${name}[] =\n${lines};\n}\nconst std::string_view ${name}(bytes_of_${name}, sizeof bytes_of_${name} - 1);\n")
  endwhile()
  file(WRITE ${CODE} "${code}}  // namespace ${NAMESPACE}\n")
  return()
endif()

function(berm_beside name)
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/beside C_STANDARD 99 C_EXTENSIONS OFF BUILD_WITH_INSTALL_RPATH ON UNITY_BUILD OFF)
  target_compile_options(${name} PRIVATE -O2 -Wall -Wextra -Wconversion -Wno-sign-conversion -Werror)
  target_link_options(${name} PRIVATE -Wl,-s)
  target_link_libraries(${name} PRIVATE m berm_hardening)
endfunction()

function(berm_embed room header namespace)
  set(made ${CMAKE_BINARY_DIR}/embedded/${room}.cpp)
  set(files ${ARGN})
  set(read)
  set(pairs ${ARGN})
  while(pairs)
    list(POP_FRONT pairs name file)
    list(APPEND read ${file})
  endwhile()
  add_custom_command(OUTPUT ${made} DEPENDS ${read} ${CMAKE_SOURCE_DIR}/cmake/Embed.cmake VERBATIM
    COMMAND ${CMAKE_COMMAND} -D CODE=${made} -D HEADER=${header} -D NAMESPACE=${namespace} "-DFILES=${files}" -P ${CMAKE_SOURCE_DIR}/cmake/Embed.cmake)
  target_sources(berm_${room} PRIVATE ${made})
endfunction()
