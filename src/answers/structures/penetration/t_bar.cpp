// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_test.cpp
#include "structures/penetration/penetrometers.hpp"

#include "formulas/pipe_in_clay.hpp"
#include "structures/penetration/penetration_run.hpp"

namespace berm::penetration {
namespace {

constexpr base::Limit t_bar_cells =
    base::too_large({40, 10, base::Effect::contact_width,
                     "a bar acts as if up to a cell larger on each side, 2 h/D of its resistance (examples/t_bar)", true});

std::vector<Comparison> published_of_t_bar(const PenetrationRun& run)
{
  if (run.measure() != Measure::strength) return {};
  const Real alpha = run.soil.at(run.z_end()).interface_ratio;
  std::vector<Comparison> list;
  const auto add = [&](Real roughness, const char* about) {
    formulas::Formula deep = formulas::clay_deep({1, std::max(run.w_end() / run.body.width, Real(2)), 1, roughness});
    list.push_back({"N<sub>T-bar</sub>", run.last().factor, deep, about, true});
  };
  if (!(alpha >= 1)) add(0, "smooth bar");
  if (!(alpha <= 0)) add(1, "rough bar");
  if (alpha > 0 && alpha < 1) add(alpha, "bar of this roughness");
  return list;
}

}  // namespace

/// A bar that is pushed across itself (plane strain): q = V/D, N_Tbar = q/s_u less the weight of the soil that it displaces, over the depth of its axis.
const Penetrometer& t_bar()
{
  static const Penetrometer t_bar{
      .word = "t_bar",
      .level = "axis of the bar",
      .resistance = {"q_Tbar", "q<sub>T-bar</sub>"},
      .in_clay = {"N_Tbar", "N<sub>T-bar</sub>"},
      .in_sand = {"Q_Tbar", "Q<sub>T-bar</sub>"},
      .sand_measure = SandMeasure::overburden,
      .flows_around = true,
      .averaging = 0.05,
      .last_travel = 1,
      .depths = {0, 0.25, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 9, 10, 12, 15, 20},
      .keeps_push = false,
      .cells = &t_bar_cells,
      .published = published_of_t_bar,
      .remark = "The factors are those of weightless clay that flows around the bar; strain rate and remoulding change them."};
  return t_bar;
}

}  // namespace berm::penetration
