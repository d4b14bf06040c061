# SPDX-License-Identifier: BSD-3-Clause
# The libraries' headers that almost every file includes are parsed once for each set of compiler flags. A file still includes what it uses: for
# `make threads` and `make tidy` nothing is precompiled, and they find a missing include.
#
#   berm_precompile(GROUP TARGET [header...])    the first target of a group, whose flags all of them have, compiles the headers

set(BERM_PRECOMPILED <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <string> <string_view> <variant> <vector> <Eigen/Core> <fmt/format.h>)

function(berm_precompile group target)
  get_property(host GLOBAL PROPERTY BERM_PRECOMPILED_${group})
  if(host)
    target_precompile_headers(${target} REUSE_FROM ${host})
  else()
    set_property(GLOBAL PROPERTY BERM_PRECOMPILED_${group} ${target})
    target_precompile_headers(${target} PRIVATE ${BERM_PRECOMPILED} ${ARGN})
  endif()
endfunction()
