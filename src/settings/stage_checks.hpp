// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::settings {

/// Refuses what does not go together in the stages of a case: what drives a body, and what ends a stage.
void check_stages(Describe& d, const Case& c);

/// What cannot be combined with mpm.active_distance: soil may rest where nothing but bounded rigid bodies moves it.
void check_active_distance(Describe& d, const Case& c);

}  // namespace berm::settings
