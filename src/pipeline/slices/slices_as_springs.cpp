// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/slices/coupled_line_test.cpp
#include "mpm/time_step.hpp"
#include "problem/stages.hpp"
#include "slices/coupled_line.hpp"

#include <algorithm>

namespace berm::slices {

/// As the case has it: all, all but the first, or none.
void CoupledLine::begin_as_springs()
{
  const settings::SliceAsSpring when = of_case_.settings.slices.as_spring;
  is_spring_.assign(count(), when != settings::SliceAsSpring::never);
  is_spring_.front() = when == settings::SliceAsSpring::always;
}

/// Slices become soil where their spring has much of its resistance, or carries much more or less than the weight.
void CoupledLine::resolve()
{
  if (of_case_.settings.slices.as_spring != settings::SliceAsSpring::until_sliding) return;
  for (Index i = 0; i < of_case_.line.freedoms(); ++i) moved_[i] = state_.displacement[i] - of_case_.line.shape[i];
  of_case_.stations.means(of_case_.line, beam::Direction::lateral, moved_, sideways_);
  of_case_.stations.means(of_case_.line, beam::Direction::vertical, moved_, upwards_);
  for (std::size_t k = 1; k < count(); ++k) {
    if (!is_spring(k) || (of_case_.mobilised(sideways_[k]) < much_mobilised &&
                          of_case_.vertical_stiffness * std::abs(upwards_[k]) < much_mobilised * of_case_.settings.submerged_weight))
      continue;
    is_spring_[k] = 0;
  }
}

/// Gives the springs at the nodes the length that is not on soil, and those along the line their resistance.
void CoupledLine::scale_springs(const problem::State<2>& first)
{
  const beam::Line& line = of_case_.line;
  if (!of_case_.may_be_springs() && !of_case_.has_interface()) return;
  on_springs_ = of_case_.length_beyond;
  for (std::size_t k = 0; k < count(); ++k) spring_parts_[k] = static_cast<Real>(is_spring_[k]);
  of_case_.stations.add_to_nodes(spring_parts_, on_springs_);
  const Real weight = of_case_.settings.submerged_weight, as_laid = of_case_.axial_resistance(laid_embedment_, weight);
  for (std::size_t k = 0; k < count(); ++k) {
    const problem::State<2>& slice = k == 0 ? first : *others_[k - 1];
    resistances_[k] =
        of_case_.axial_resistance(travel_of(model_of(k), slice, 0).w, is_spring(k) ? weight : slice.rigid_bodies[0].recent.force()[1]);
  }
  for (Index i = 0; i < line.nodes(); ++i) along_[i] = as_laid * of_case_.length_beyond[i];
  of_case_.stations.add_to_nodes(resistances_, along_);
  for (std::size_t s = 0; s < line.springs.size(); ++s) {
    const beam::Spring& spring = line.springs[s];
    const bool axial = spring.freedom == line.axial(spring.node);
    if (!axial && of_case_.may_be_springs()) state_.spring_factor[s] = on_springs_[spring.node] / spring.length;
    if (axial && of_case_.has_interface() && std::holds_alternative<beam::PlasticSpring>(line.laws[spring.law]))
      state_.spring_factor[s] = along_[spring.node] / (weight * spring.length);
  }
}

/// What the springs at the nodes would do to the pipe of each slice.
void CoupledLine::find_reactions_of_springs()
{
  const beam::Line& line = of_case_.line;
  std::fill(spring_forces_.begin(), spring_forces_.end(), 0.0);
  for (std::size_t s = 0; s < line.springs.size(); ++s) {
    const Index freedom = line.springs[s].freedom;
    if (freedom == line.axial(line.springs[s].node)) continue;
    spring_forces_[freedom] -= force_of(line.laws[line.springs[s].law], state_.springs[s], state_.displacement[freedom]).force;
  }
  of_case_.stations.means(line, beam::Direction::lateral, spring_forces_, springs_sideways_);
  of_case_.stations.means(line, beam::Direction::vertical, spring_forces_, springs_upwards_);
}

/// Of a slice whose soil is not stepped here.
void CoupledLine::let_time_pass(Real dt, problem::State<2>& state) const
{
  state.dt = dt;
  state.time += dt;
  ++state.step;
  state.stable_dt_holds = state.step % mpm::steps_between_time_steps != 0;
}

/// A step of a slice that is a spring. Where it stays a spring its pipe goes with the line.
void CoupledLine::step_as_spring(Index k, Real dt, problem::State<2>& state) const
{
  const Vec<2> velocity(sideways_[k], upwards_[k]), on_pipe(springs_sideways_[k], of_case_.settings.submerged_weight + springs_upwards_[k]);
  state.ledger.contact_sums[0].impulse -= dt * on_pipe;
  if (of_case_.settings.slices.as_spring == settings::SliceAsSpring::always) state.rigid_bodies[0].displacement += dt * velocity;
  let_time_pass(dt, state);
}

}  // namespace berm::slices
