// SPDX-License-Identifier: BSD-3-Clause
#include "beam/state.hpp"

#include <cstring>

namespace berm::beam {
namespace {

/// Their numbers, one state after the other.
void archive_macro_elements(Archive& k, std::vector<berm_macro_element_state>& states)
{
  constexpr std::size_t count = BERM_MACRO_ELEMENT_NUMBERS, first = offsetof(berm_macro_element_state, x);
  static_assert(sizeof(berm_macro_element_state) == first + count * sizeof(double));
  std::vector<Real> numbers(count * states.size());
  for (std::size_t i = 0; i < states.size(); ++i)
    std::memcpy(&numbers[i * count], reinterpret_cast<const char*>(&states[i]) + first, count * sizeof(double));
  k.fixed("macro_elements", numbers);
  for (std::size_t i = 0; i < states.size(); ++i)
    std::memcpy(reinterpret_cast<char*>(&states[i]) + first, &numbers[i * count], count * sizeof(double));
}

}  // namespace

State state_of(const Line& line)
{
  State state;
  state.displacement = line.shape;
  state.velocity.assign(line.freedoms(), 0);
  state.acceleration = state.force = state.velocity;
  state.constrained_force.assign(line.elements(), 0);
  for (const Spring& spring : line.springs) state.springs.push_back({spring.origin, 0, 0, 0});
  state.spring_factor.assign(line.springs.size(), 1);
  for (const MacroElement& element : line.macro_elements) state.macro_elements.push_back(line.macro_soils[element.soil].laid);
  state.mean_axial.assign(line.nodes(), 0);
  state.mean_lateral = state.mean_axial;
  state.sideways.assign(line.nodes(), 0);
  return state;
}

void archive(Archive& k, State& state)
{
  k("time", state.time);
  k.fixed("displacement", state.displacement);
  k.fixed("velocity", state.velocity);
  k.fixed("acceleration", state.acceleration);
  k.fixed("force", state.force);
  k.fixed("constrained_force", state.constrained_force);
  std::vector<Real> origin, slip, forward, backward;
  for (const SpringState& spring : state.springs) {
    origin.push_back(spring.origin), slip.push_back(spring.slip);
    forward.push_back(spring.forward), backward.push_back(spring.backward);
  }
  k.table("springs", [&] {
    k.fixed("origin", origin);
    k.fixed("slip", slip);
    k.fixed("forward", forward);
    k.fixed("backward", backward);
    k.fixed("factor", state.spring_factor);
  });
  for (std::size_t s = 0; s < state.springs.size(); ++s) state.springs[s] = {origin[s], slip[s], forward[s], backward[s]};
  archive_macro_elements(k, state.macro_elements);
  k.fixed("mean_axial", state.mean_axial);
  k.fixed("mean_lateral", state.mean_lateral);
  std::vector<Index> sideways(state.sideways.begin(), state.sideways.end());
  k.fixed("sideways", sideways);
  for (std::size_t i = 0; i < sideways.size(); ++i) state.sideways[i] = sideways[i] != 0;
  k.table("totals", [&] {
    k("work_of_loads", state.totals.work_of_loads);
    k("work_of_heat", state.totals.work_of_heat);
    k("work_on_springs", state.totals.work_on_springs);
    k("damped", state.totals.damped);
  });
}

}  // namespace berm::beam
