// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_test.cpp
#include "structures/lateral/shaft.hpp"

#include "formulas/penetrometer.hpp"
#include "structures/penetration/penetration_run.hpp"

namespace berm::lateral {
namespace {

constexpr base::Limit pile_cells =
    base::too_large({32, 10, base::Effect::contact_width,
                     "soil beside the edge of the base moves with it up to a cell beyond it (examples/cone_in_clay)", true});

std::vector<penetration::Comparison> published_of_pile(const penetration::PenetrationRun& run)
{
  if (run.measure() != penetration::Measure::strength) return {};
  const penetration::SoilAt soil = run.soil.at(run.z_end());
  const Real N = run.last().factor;
  return {{"N<sub>c</sub>", N, formulas::deep_plate_factor(soil.interface_ratio),
           "soil flows around a plate, but the shaft is above the base of a pile", true},
          {"N<sub>c</sub>, compared with (p − p<sub>0</sub>)/s<sub>u</sub> of a cavity", N, formulas::sphere_limit(soil.rigidity_index),
           "the cavity is spherical around a point"}};
}

}  // namespace

/// A pile with a closed end: q_b = V over the area of its base, N_c = (q_b - sigma_v0)/s_u in clay, N_q = (q_b - sigma_v0)/sigma_v0 in sand.
const penetration::Penetrometer& pile()
{
  static const penetration::Penetrometer pile{.word = "pile",
                                              .level = "base of the pile",
                                              .resistance = {"q_b", "q<sub>b</sub>"},
                                              .in_clay = {"N_c", "N<sub>c</sub>"},
                                              .in_sand = {"N_q", "N<sub>q</sub>"},
                                              .sand_measure = penetration::SandMeasure::overburden,
                                              .flows_around = false,
                                              .averaging = 0.1,
                                              .last_travel = 1,
                                              .depths = {0.1, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30},
                                              .keeps_push = false,
                                              .cells = &pile_cells,
                                              .published = published_of_pile,
                                              .remark = "",
                                              .pushes_aside = true};
  return pile;
}

}  // namespace berm::lateral
