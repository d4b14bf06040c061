// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/senseless_inputs.hpp"

namespace berm::test {

/// Roles of stages that make no sense.
inline const std::vector<SenselessInput>& senseless_roles()
{
  using enum SenselessInput::Answer;
  static const std::vector<SenselessInput> all = {
      {"role_of_a_stage_that_drives_nothing",
       "bed",
       refused,
       {"stage.geostatic.role", "this one drives nothing"},
       {"stage.geostatic.role=operation"},
       "",
       ""},
      {"laid_after_operation",
       "bed",
       warned,
       {"stage.drag.role", "is \"lay\", and stage \"push\" before it is \"operation\""},
       {"stage.push.role=operation", "stage.drag.role=lay"},
       "",
       ""},
      {"emptied_before_touchdown",
       "bed",
       warned,
       {"stage.drag.role", "is \"touchdown\", and stage \"push\" before it is \"emptied\""},
       {"stage.push.role=emptied", "stage.drag.role=touchdown"},
       "",
       ""},
      {"roles_without_that_of_the_answers",
       "bed",
       warned,
       {"stage.push.role", "the key results are those of stage \"drag\""},
       {"stage.push.role=touchdown"},
       "",
       ""},
      {"roles_of_which_all_lay_the_pipe",
       "bed",
       warned,
       {"stage.drag.role", "the key results are those of stage \"drag\""},
       {"stage.drag.role=lay"},
       "",
       ""},
  };
  return all;
}

}  // namespace berm::test
