# SPDX-License-Identifier: BSD-3-Clause
# cmake -DSOURCE=... -DOUTPUT=... -P: writes the revision of the sources into a C++ file, where it is another than there: git's, else that which git archive has put into
# revision.txt, else "".
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=10 HEAD OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
if(failed)
  file(STRINGS ${SOURCE}/cmake/revision.txt revision)
  if(NOT revision MATCHES "^[0-9a-f]+$")
    set(revision "")
  endif()
else()
  execute_process(COMMAND git -C ${SOURCE} diff-index --quiet HEAD -- RESULT_VARIABLE changed ERROR_QUIET)
  if(changed)
    string(APPEND revision "+")
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "// SPDX-License-Identifier: BSD-3-Clause\n#include \"io/revision.hpp\"\n\nconst char* const berm::io::revision = \"${revision}\";\n")
