// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_test.cpp
#include "structures/penetration/penetrometers.hpp"

#include "formulas/penetrometer.hpp"
#include "structures/penetration/penetration_run.hpp"

namespace berm::penetration {
namespace {

constexpr base::Limit cone_cells = base::too_large(
    {32, 10, base::Effect::contact_width,
     "soil beside the edge moves with the cone up to a cell beyond it, so that N_kt is too large (examples/cone_in_clay)", true});

std::vector<Comparison> published_of_cone(const PenetrationRun& run)
{
  if (run.measure() != Measure::strength) return {};
  const SoilAt soil = run.soil.at(run.z_end());
  const Real N = run.last().factor;
  const formulas::DeepInClay cone{soil.rigidity_index, soil.interface_ratio, soil.anisotropy};
  const char *symbol = "N<sub>kt</sub>", *cavity = "N<sub>kt</sub>, compared with (p − p<sub>0</sub>)/s<sub>u</sub> of a cavity";
  return {
      {symbol, N, formulas::cone_factor_strain_path(cone), "", true},
      {symbol, N, formulas::cone_factor_remeshed(cone), "", true},
      {symbol, N, formulas::cone_factor_steady(cone), "", true},
      {cavity, N, formulas::sphere_limit(soil.rigidity_index), "a cone has more resistance: the cavity is spherical around a point"},
      {cavity, N, formulas::cylinder_limit(soil.rigidity_index), "a cone has more resistance: the cavity is cylindrical, around an axis"}};
}

}  // namespace

/// A cone with its shaft, pushed in as in a cone penetration test: q_t over the depth of its shoulder, N_kt = (q_t - sigma_v0)/s_u in clay, Q_t = (q_t - sigma_v0)/sigma_v0 in sand.
const Penetrometer& cone()
{
  static const Penetrometer cone{
      .word = "cone",
      .level = "shoulder of the cone",
      .resistance = {"q_t", "q<sub>t</sub>"},
      .in_clay = {"N_kt", "N<sub>kt</sub>"},
      .in_sand = {"Q_t", "Q<sub>t</sub>"},
      .sand_measure = SandMeasure::overburden,
      .flows_around = false,
      .averaging = 0.2,
      .last_travel = 2,
      .depths = {0.5, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 20, 25, 30, 40, 50},
      .keeps_push = false,
      .cells = &cone_cells,
      .published = published_of_cone,
      .remark = "Published formulas of the cone factor (strain path, finite elements) are not shown: their sources have not been checked "
                "(docs/formulas.md). The cavity solutions are exact, and lower bounds in practice.",
      .pushes_aside = true};
  return cone;
}

}  // namespace berm::penetration
