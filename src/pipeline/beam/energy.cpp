// SPDX-License-Identifier: BSD-3-Clause
#include "beam/energy.hpp"

namespace berm::beam {
namespace {

/// 1/2 int m v^2 dx in a plane, v of a vector of all freedoms or what a function makes of them.
template <class Velocity>
Real energy_across(const Line& line, int plane, const Velocity& velocity)
{
  Real sum = 0;
  const Index size = line.freedoms_of_node();
  for (Index e = 0; e < line.elements(); ++e) {
    const Index a = line.axial(e) + 1 + 2 * plane, b = a + size;
    const Real L = line.length(e);
    sum += line.section[e].mass * L / 2 * inertia.square({velocity(a), L * velocity(a + 1), velocity(b), L * velocity(b + 1)});
  }
  return sum;
}

}  // namespace

Real kinetic_energy(const Line& line, const State& state)
{
  Real sum = 0;
  for (Index e = 0; e < line.elements(); ++e) {
    const Real a = state.velocity[line.axial(e)], b = state.velocity[line.axial(e + 1)];
    sum += line.section[e].axial_mass * line.length(e) / 6 * (a * a + a * b + b * b);
  }
  for (int plane = 0; plane < static_cast<int>(line.planes.size()); ++plane)
    sum += energy_across(line, plane, [&](Index i) { return state.velocity[i]; });
  return sum;
}

Real elastic_energy(const Line& line, const State& state)
{
  Real sum = 0;
  const Index size = line.freedoms_of_node();
  for (Index e = 0; e < line.elements(); ++e) {
    const ElementNow now = membrane(line, e, state.displacement, state.constrained_force[e]);
    sum += now.length * now.force * now.force / (2 * line.section[e].axial_stiffness);
    const Real L = now.length, EI = line.section[e].bending_stiffness / (L * L * L);
    for (Index a = line.axial(e) + 1, b = a + size; a < line.axial(e) + size; a += 2, b += 2) {
      AtEnds bent = at_ends(&state.displacement[a], &state.displacement[b], L);
      const AtEnds shape = at_ends(&line.shape[a], &line.shape[b], L);
      for (int i = 0; i < 4; ++i) bent[i] -= shape[i];
      sum += EI / 2 * bending.square(bent);
    }
  }
  return sum;
}

void add_work(const Line& line, const Loads& loads, const TimeTerms& terms, Real dt, const Work& work, State& state)
{
  const auto velocity = [&](Index i) { return work.predicted_velocity[i] + terms.velocity * (work.displacement[i] - work.predicted[i]); };
  Totals& totals = state.totals;
  for (Index i = 0; i < line.freedoms(); ++i) {
    const Real force = loads.force[i] - loads.impedance[i] * (velocity(i) - loads.velocity_then[i]);
    totals.work_of_loads += (state.force[i] + force) / 2 * (work.displacement[i] - state.displacement[i]);
    state.force[i] = force;
  }
  for (Index e = 0; e < line.elements(); ++e) {
    const ElementNow before = membrane(line, e, state.displacement, state.constrained_force[e]);
    const ElementNow after = membrane(line, e, work.displacement, loads.constrained_force[e]);
    totals.work_of_heat -= after.length * (before.force + after.force) / 2 * (loads.constrained_force[e] - state.constrained_force[e]) /
                           line.section[e].axial_stiffness;
    state.constrained_force[e] = loads.constrained_force[e];
  }
  for (std::size_t s = 0; s < line.springs.size(); ++s) {
    const Spring& spring = line.springs[s];
    if (!acts(line, state, spring)) continue;
    const Real u = state.displacement[spring.freedom], change = work.displacement[spring.freedom] - state.displacement[spring.freedom];
    const SpringLaw& law = line.laws[spring.law];
    totals.work_on_springs += spring.length * state.spring_factor[s] *
                              (force_of(law, state.springs[s], u).force + force_of(law, state.springs[s], u + change).force) / 2 * change;
  }
  for (std::size_t m = 0; m < line.macro_elements.size(); ++m) {
    const berm_macro_element_state &before = state.macro_elements[m], &after = work.macro_elements[m];
    totals.work_on_springs += line.macro_elements[m].length / 2 *
                              ((before.T + after.T) * (after.x - before.x) + (before.H + after.H) * (after.u - before.u) +
                               (before.V + after.V) * (after.w - before.w));
  }
  for (int plane = 0; plane < static_cast<int>(line.planes.size()); ++plane)
    if (line.damping[plane] > 0)
      totals.damped += dt * line.damping[plane] *
                       (energy_across(line, plane, [&](Index i) { return state.velocity[i]; }) + energy_across(line, plane, velocity));
}

}  // namespace berm::beam
