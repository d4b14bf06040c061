// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/structures_test.cpp
#include "structures/pipe/pipe_report.hpp"

#include "structures/driven/report.hpp"
#include "structures/pipe/axial_results.hpp"
#include "structures/pipe/published.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::pipe {
namespace {

/// Whether a number of the run is what formulas give for a state.
bool is_of_state(const std::string& quantity, const ComparedState& state)
{
  const auto ends = [&](const char* name) { return quantity.ends_with(name); };
  switch (state.kind) {
  case ComparedState::Kind::peak:
    return ends("H_breakout") || ends("H_onset") || ends("H_max");
  case ComparedState::Kind::end_of_push:
    return ends("V_end_of_push");
  case ComparedState::Kind::uplift:
    return ends(".R_max");
  case ComparedState::Kind::end_of_drag:
    return ends("H_residual");
  default:
    return false;
  }
}

/// The best estimate of a code, else the first formula that applies; null where none does.
const Comparison* best_of(const ComparedState& state)
{
  const auto applies = [](const Comparison& c) {
    return c.unit == Comparison::Unit::force && c.published.valid && c.published.source.label != formulas::Label::recalled;
  };
  const auto is_best = [&](const Comparison& c) { return applies(c) && c.about.find("best estimate") != std::string::npos; };
  auto found = std::ranges::find_if(state.comparisons, is_best);
  if (found == state.comparisons.end()) found = std::ranges::find_if(state.comparisons, applies);
  return found == state.comparisons.end() ? nullptr : &*found;
}

}  // namespace

base::Headline headline(const record::RunRecord& record, const base::DisplayUnits& shown)
{
  const driven::DrivenRun run(record);
  base::Headline numbers;
  if (const std::vector<AxialGain> gains = axial_gains(record); !gains.empty()) {
    const std::string& stage = gains.back().stage;
    numbers = {{"U_of_" + stage, "Degree of consolidation"},
               {"axial_gain_of_" + stage, "Axial set-up factor"},
               {"axial_friction_of_" + stage, "Axial resistance"}};
  }
  for (const base::HeadlineNumber& number : driven::headline(run)) numbers.push_back(number);
  for (const ComparedState& state : published_beside(run).states)
    for (base::HeadlineNumber& number : numbers)
      if (const Comparison* best = is_of_state(number.quantity, state) ? best_of(state) : nullptr; best != nullptr && number.beside.empty())
        number.beside =
            fmt::format("{} {}: {}", text::short_number(shown.in_force_unit(best->published.value)), shown.force_unit(run.scale),
                        text::html_text(citation(best->published.source) + (best->about.empty() ? "" : "; " + best->about)));
  return numbers;
}

}  // namespace berm::pipe
