// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/senseless_inputs.hpp"

namespace berm::test {

/// Load histories that make no sense.
inline const std::vector<SenselessInput>& senseless_load_histories()
{
  using enum SenselessInput::Answer;
  static const std::vector<SenselessInput> all = {
      {"load_history_too_fast",
       "bed",
       warned,
       {"stage.drag.time_scale", "so fast that the ", "is slow enough); take "},
       {"stage.drag.load_times=[0, 1e-4, 2e-4, 3e-4]", "stage.drag.load_factors=[1, -1, 1, -1]"},
       "velocity = \"0.1 m/s\"\nramp = \"2 ms\"",
       "force = \"100 N/m\""},
      {"breakout_in_half_the_time",
       "bed",
       warned,
       {"stage.drag.time_scale", "is 0.5: H of 900 N/m at 0.5 s of the record is more than about 350 N/m", "run with time_scale = 1"},
       {"stage.drag.load_times=[0, 0.5, 1]", "stage.drag.loads.H=[0, 900, 0]", "stage.drag.loads.V=[500, 500, 500]",
        "stage.drag.time_scale=0.5"},
       "velocity = \"0.1 m/s\"\nramp = \"2 ms\"",
       ""},
      {"displacement_that_strikes",
       "bed",
       warned,
       {"stage.push.load_history", "changes the speed by 0.3 m/s at once, at 0 s of the record", "is an impact of",
        "spread the change over"},
       {},
       "velocity = \"0.1 m/s\"\nramp = \"1 ms\"",
       "load_times = [0, 0.05]\nloads.w_displacement = [0, 0.015]"},
      {"velocity_that_jumps",
       "bed",
       warned,
       {"stage.push.load_history", "changes the speed by 0.4 m/s at once, at 20 ms of the record"},
       {},
       "velocity = \"0.1 m/s\"\nramp = \"1 ms\"",
       "load_times = [0, 0.01, 0.02, 0.02, 0.05]\nloads.w = [0, -0.1, -0.1, 0.3, 0.3]"},
  };
  return all;
}

}  // namespace berm::test
