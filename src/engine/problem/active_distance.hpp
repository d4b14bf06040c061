// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"

namespace berm::problem {

/// What does not go with mpm.active_distance: soil may rest where nothing but bounded rigid bodies moves it.
void check_active_distance(Describe& d, const Case& c);

}  // namespace berm::problem
