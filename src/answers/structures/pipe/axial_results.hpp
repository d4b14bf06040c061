// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "run_folder/summary.hpp"

namespace berm::pipe {

/// What a pipe at the end of a stage could carry along its axis by friction, per metre: the integral of mu sigma'_n over its surface.
struct AxialState {
  std::string stage;
  Real w;      ///< m, embedment
  Real N_eff;  ///< N/m, effective normal force on the surface
  Real V;      ///< N/m
  Real mu;     ///< friction coefficient of the interface

  Real wedging() const { return N_eff / V; }  ///< normal force over the vertical one
  Real resistance() const { return mu * N_eff; }
};

/// Of all stages but geostatic ones that leave the pipe pressed on the soil; none where the history has no effective normal force.
std::vector<AxialState> axial_states(const record::RunRecord& run);

/// What a rest in which soil consolidates does to that resistance.
struct AxialGain {
  std::string stage;   ///< of the rest
  Real degree;         ///< U at its end
  Real before, after;  ///< N/m, resistance at the end of the stage before and at its own

  Real ratio() const { return after / before; }
};
std::vector<AxialGain> axial_gains(const record::RunRecord& run);

/// The same for the summary: wedging_of_STAGE, axial_friction_of_STAGE, and axial_gain_of_STAGE of rests.
std::vector<run_folder::Quantity> axial_quantities(const record::RunRecord& run);

/// The names of all that a run of a case may have of these.
std::vector<std::string> axial_names(const settings::Case& c);

}  // namespace berm::pipe
