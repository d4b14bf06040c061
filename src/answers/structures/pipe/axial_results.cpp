// SPDX-License-Identifier: BSD-3-Clause
#include "structures/pipe/axial_results.hpp"

#include "structures/base/soil_words.hpp"

#include <fmt/format.h>

namespace berm::pipe {

std::vector<AxialState> axial_states(const record::RunRecord& run)
{
  std::vector<AxialState> states;
  const Index rigid = main_rigid(run.settings);
  const contact::ContactSettings* contact = base::contact_of_body(run.settings);
  if (rigid == none || contact == nullptr || run.settings.geometry != problem::Geometry::plane_strain) return states;
  if (!bodies::pipe_section(run.settings.rigid[rigid].second.shape)) return states;
  for (const base::SurfaceForce& force : base::surface_forces_of(run))
    if (force.V > 0) states.push_back({force.stage, force.w, force.N_eff, force.V, std::tan(contact->friction_angle)});
  return states;
}

std::vector<AxialGain> axial_gains(const record::RunRecord& run)
{
  std::vector<AxialGain> gains;
  const std::vector<AxialState> states = axial_states(run);
  const std::vector<base::Dissipation> rests = base::dissipation_of(run);
  for (std::size_t k = 1; k < states.size(); ++k)
    for (const base::Dissipation& rest : rests)
      if (rest.stage == states[k].stage && states[k - 1].resistance() > 0)
        gains.push_back({rest.stage, rest.degree, states[k - 1].resistance(), states[k].resistance()});
  return gains;
}

std::vector<run_folder::Quantity> axial_quantities(const record::RunRecord& run)
{
  std::vector<run_folder::Quantity> quantities;
  for (const AxialState& state : axial_states(run)) {
    quantities.push_back({"wedging_of_" + state.stage, state.wedging(), "1", "effective normal force over V at the end of " + state.stage,
                          run_folder::QuantityKind::answer, state.stage});
    quantities.push_back({"axial_friction_of_" + state.stage, state.resistance(), "N/m",
                          "friction coefficient times the effective normal force at the end of " + state.stage,
                          run_folder::QuantityKind::answer, state.stage});
  }
  for (const AxialGain& gain : axial_gains(run))
    quantities.push_back({"axial_gain_of_" + gain.stage, gain.ratio(), "1",
                          fmt::format("axial friction at the end of {} over that at the end of the stage before, at U = {:.0f} %",
                                      gain.stage, 100 * gain.degree),
                          run_folder::QuantityKind::answer, gain.stage});
  return quantities;
}

}  // namespace berm::pipe
