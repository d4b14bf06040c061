# SPDX-License-Identifier: BSD-3-Clause
# The script and style of the page of a report and of the desk: web/ is copied to the build folder, npm fetches what package-lock.json names there, once, and esbuild
# makes them C++ constants. Nothing is fetched when the program runs or a page is opened.
find_program(BERM_NODE node REQUIRED)
find_program(BERM_NPM npm REQUIRED)

set(BERM_WEB ${CMAKE_BINARY_DIR}/web)
set(web_source ${CMAKE_SOURCE_DIR}/web)
file(GLOB_RECURSE web_sources CONFIGURE_DEPENDS ${web_source}/src/* ${web_source}/tests/* ${web_source}/*.mjs ${web_source}/tsconfig.json)
list(FILTER web_sources EXCLUDE REGEX "/node_modules/")

add_custom_command(
  OUTPUT ${BERM_WEB}/node_modules/fetched
  COMMAND ${CMAKE_COMMAND} -E make_directory ${BERM_WEB}
  COMMAND ${CMAKE_COMMAND} -E copy ${web_source}/package.json ${web_source}/package-lock.json ${web_source}/.npmrc ${BERM_WEB}
  COMMAND ${CMAKE_COMMAND} -E chdir ${BERM_WEB} ${BERM_NPM} ci --loglevel=error
  COMMAND ${CMAKE_COMMAND} -E touch ${BERM_WEB}/node_modules/fetched
  DEPENDS ${web_source}/package.json ${web_source}/package-lock.json ${web_source}/.npmrc
  COMMENT "Fetching the page's packages with npm"
  VERBATIM)

add_custom_command(
  OUTPUT ${BERM_WEB}/page_files.cpp ${BERM_WEB}/desk_files.cpp ${BERM_WEB}/licences.txt
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${BERM_WEB}/src ${BERM_WEB}/tests
  COMMAND ${CMAKE_COMMAND} -E copy_directory ${web_source}/src ${BERM_WEB}/src
  COMMAND ${CMAKE_COMMAND} -E copy_directory ${web_source}/tests ${BERM_WEB}/tests
  COMMAND ${CMAKE_COMMAND} -E copy ${web_source}/build.mjs ${web_source}/measure.mjs ${web_source}/measure_desk.mjs ${web_source}/tsconfig.json ${BERM_WEB}
  COMMAND ${CMAKE_COMMAND} -E chdir ${BERM_WEB} ${BERM_NODE} build.mjs pages ${BERM_WEB}
  DEPENDS ${BERM_WEB}/node_modules/fetched ${web_sources}
  COMMENT "Bundling the pages"
  VERBATIM)

# Types are checked and the tests bundled with the tests of the program.
if(BERM_TESTS)
  add_custom_command(
    OUTPUT ${BERM_WEB}/tests_built/made
    COMMAND ${CMAKE_COMMAND} -E chdir ${BERM_WEB} ${BERM_NODE} node_modules/typescript/bin/tsc --noEmit --project .
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${BERM_WEB}/tests_built
    COMMAND ${CMAKE_COMMAND} -E make_directory ${BERM_WEB}/tests_built
    COMMAND ${CMAKE_COMMAND} -E chdir ${BERM_WEB} ${BERM_NODE} build.mjs tests ${BERM_WEB}/tests_built
    COMMAND ${CMAKE_COMMAND} -E touch ${BERM_WEB}/tests_built/made
    DEPENDS ${BERM_WEB}/page_files.cpp ${web_sources}
    COMMENT "Bundling the tests of the pages"
    VERBATIM)
  add_custom_target(web_tests ALL DEPENDS ${BERM_WEB}/tests_built/made)
endif()
