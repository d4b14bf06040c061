// SPDX-License-Identifier: BSD-3-Clause
#include "structures/pipe/axial_results.hpp"

#include "structures/base/answer.hpp"
#include "structures/base/soil_words.hpp"

#include <fmt/format.h>

namespace berm::pipe {

std::vector<AxialState> axial_states(const record::RunRecord& run)
{
  std::vector<AxialState> states;
  const Index rigid = main_rigid(run.settings);
  const contact::ContactSettings* contact = base::contact_of_body(run.settings);
  if (rigid == none || contact == nullptr || run.settings.geometry != settings::Geometry::plane_strain) return states;
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

namespace {

using base::AnswerUnit;

constexpr base::Answer<AxialState> state_answers[] = {
    {"wedging_of_{stage}", AnswerUnit::ratio, "effective normal force over V at the end of {stage}",
     [](const AxialState& state) { return state.wedging(); }},
    {"axial_friction_of_{stage}", AnswerUnit::force, "friction coefficient times the effective normal force at the end of {stage}",
     [](const AxialState& state) { return state.resistance(); }},
};
constexpr base::Answer<AxialGain> gain_answers[] = {
    {"axial_gain_of_{stage}", AnswerUnit::ratio,
     "axial friction at the end of {stage} over that at the end of the stage before, at U = {degree} %",
     [](const AxialGain& gain) { return gain.ratio(); }},
};

}  // namespace

std::vector<run_folder::Quantity> axial_quantities(const record::RunRecord& run)
{
  base::AnswerList list(2);
  for (const AxialState& state : axial_states(run)) {
    list.of(state.stage, "");
    list.fill({{"stage", state.stage}});
    list.add(state_answers, state);
  }
  for (const AxialGain& gain : axial_gains(run)) {
    list.of(gain.stage, "");
    list.fill({{"stage", gain.stage}, {"degree", fmt::format("{:.0f}", 100 * gain.degree)}});
    list.add(gain_answers, gain);
  }
  return list.list();
}

std::vector<std::string> axial_names(const settings::Case& c)
{
  base::AnswerList list(2);
  for (const settings::StageSettings& stage : c.stage) {
    list.fill({{"stage", stage.name}});
    list.add_names(state_answers);
    list.add_names(gain_answers);
  }
  return list.names();
}

}  // namespace berm::pipe
