// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_test.cpp
#include "structures/lateral/shaft.hpp"

#include "formulas/penetrometer.hpp"
#include "formulas/pile_axial.hpp"
#include "structures/penetration/penetration_run.hpp"
#include "text/quantity_words.hpp"

#include <fmt/format.h>

namespace berm::lateral {
namespace {

constexpr base::Limit pile_cells =
    base::too_large({32, 10, base::Effect::contact_width,
                     "soil beside the edge of the base moves with it up to a cell beyond it (examples/cone_in_clay)", true});

/// kN, of the outer face down to this depth.
formulas::Formula shaft_by_api(const penetration::PenetrationRun& run, Real depth)
{
  constexpr int slices = 50;
  formulas::Formula sum = formulas::api_clay_friction(run.soil.at(depth).strength, run.soil.at(depth).overburden);
  sum.value = 0;
  for (int k = 0; k < slices; ++k) {
    const penetration::SoilAt at = run.soil.at((k + 0.5) / slices * depth);
    sum.value += formulas::api_clay_friction(at.strength, at.overburden).value * pi * run.body.width * depth / slices / 1e3;
  }
  return sum;
}

std::vector<penetration::Comparison> published_of_pile(const penetration::PenetrationRun& run)
{
  if (run.measure() != penetration::Measure::strength) return {};
  const penetration::SoilAt soil = run.soil.at(run.z_end());
  const Real N = run.last().factor;
  formulas::Formula base = formulas::api_clay_base(soil.strength);
  base.value /= soil.strength;
  std::vector<penetration::Comparison> list{{"N<sub>c</sub>", N, formulas::deep_plate_factor(soil.interface_ratio),
                                             "soil flows around a plate, but the shaft is above the base of a pile", true},
                                            {"N<sub>c</sub>", N, base, "of the whole pressure on the base"},
                                            {"N<sub>c</sub>, compared with (p − p<sub>0</sub>)/s<sub>u</sub> of a cavity", N,
                                             formulas::sphere_limit(soil.rigidity_index), "the cavity is spherical around a point"}};
  if (run.knows_shaft()) {
    const Real depth = run.z_end() - run.last().travel / 2;
    list.push_back({"friction of the shaft, kN", run.last().friction * run.shaft_area(depth) / 1e3, shaft_by_api(run, depth),
                    fmt::format("z = {}, with the α of the code", text::length_words(depth))});
  }
  return list;
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
