// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/structures_test.cpp
#include "structures/driven/report.hpp"

#include "settings/time_scale.hpp"

#include <algorithm>

namespace berm::driven {
namespace {

base::Headline numbers_of_force(const DrivenRun& run, const DragResults& drag, const std::string& prefix)
{
  const auto stage = std::ranges::find(run.stages, drag.stage, &Stage::name);
  const bool varies = stage != run.stages.end() && stage->varies;
  return {{prefix + "u_largest", "Largest displacement", varies ? settings::time_scale_words(stage->asked) : ""},
          {prefix + "u_end", "Residual displacement"},
          {prefix + "u_largest_half_cycle", "Largest half-cycle"},
          {prefix + "w_largest", "Largest embedment"}};
}

base::Headline numbers_of_uplift(const std::string& stage)
{
  return {{stage + ".R_max", "Uplift resistance"},
          {stage + ".travel_at_R_max", "Displacement at the peak"},
          {stage + ".R_end", "Resistance at the end"},
          {stage + ".w_begin", "Embedment at the start"}};
}

/// Breakout, and where a drag has none what stands for it; then the residual.
base::Headline numbers_of_drag(const DragResults& drag, const std::string& prefix)
{
  const std::string of = prefix.empty() ? "" : " (" + drag.stage + ")";
  base::Headline numbers;
  if (drag.breakout) {
    numbers = {{prefix + "H_breakout", "Breakout resistance" + of}, {prefix + "u_at_breakout", "Displacement at breakout"}};
  } else if (drag.onset) {
    numbers = {{prefix + "H_onset", "Resistance at the onset of sliding, no peak" + of}};
  } else {
    numbers = {{prefix + "H_max", "Largest lateral resistance, no peak" + of}};
  }
  if (drag.residual)
    numbers.push_back({prefix + "H_residual", "Residual resistance"});
  else if (drag.berm)
    numbers.push_back({prefix + "H_berm", "Resistance against the berm"});
  else
    numbers.push_back({prefix + "H_end_of_drag", "Resistance at the end"});
  return numbers;
}

}  // namespace

base::Headline headline(const DrivenRun& run)
{
  const Results results = run.results();
  base::Headline numbers;
  const auto add = [&](const base::Headline& more) { numbers.insert(numbers.end(), more.begin(), more.end()); };
  const bool has_drag = !results.drags.empty();
  if (has_drag && results.main_drag().moved)
    add(numbers_of_force(run, results.main_drag(), results.prefix_of(results.main_drag())));
  else if (!results.uplifts.empty())
    add(numbers_of_uplift(results.uplifts.back().stage));
  else if (has_drag)
    add(numbers_of_drag(results.main_drag(), results.prefix_of(results.main_drag())));
  if (results.uplifts.empty()) {
    const auto has_state = [&](const char* name) {
      return std::ranges::find(results.states, name, &StateResults::name) != results.states.end();
    };
    if (has_state("operation"))
      add({{"operation.w", "Embedment in operation"}});
    else if (has_state("laid"))
      add({{"laid.w", "Embedment as laid"}});
    else if (!has_drag || !results.main_drag().moved)
      add({{"w_end_of_push", "Embedment after the push"}, {"V_end_of_push", "Vertical reaction after the push"}});
  }
  return numbers;
}

}  // namespace berm::driven
