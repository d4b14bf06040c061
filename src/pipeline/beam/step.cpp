// SPDX-License-Identifier: BSD-3-Clause
#include "beam/step.hpp"

#include "beam/energy.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace berm::beam {
namespace {

constexpr Real gamma_of_newmark = 0.55, beta_of_newmark = (gamma_of_newmark + 0.5) * (gamma_of_newmark + 0.5) / 4;
constexpr int max_iterations = 30;
constexpr Real tolerance = 1e-8;    // of the largest force in the line
constexpr Real sideways_ratio = 5;  // of the displacement across the line to that along it

void predict(const Line& line, const State& state, Real dt, Work& work)
{
  for (Index i = 0; i < line.freedoms(); ++i) {
    const bool moves = line.held[i] == 0;
    work.predicted_velocity[i] = moves ? state.velocity[i] + dt * (1 - gamma_of_newmark) * state.acceleration[i] : 0;
    work.predicted[i] =
        state.displacement[i] + (moves ? dt * (state.velocity[i] + dt * (0.5 - beta_of_newmark) * state.acceleration[i]) : 0);
    work.displacement[i] = work.predicted[i];
  }
}

/// Where forces are out of balance most, and how much is allowed.
struct Unbalance {
  Real largest = 0, allowed = 0;  ///< N
  Index freedom = 0;
};
Unbalance unbalance_of(const Line& line, const Work& work)
{
  Unbalance now;
  Real rounded = 0;  // largest force that a displacement makes against its own stiffness: its last digits are lost
  for (Index i = 0; i < line.freedoms(); ++i) {
    const Real force = std::abs(work.residual[i]) / work.unit[i];
    rounded = std::max(rounded, std::abs(work.tangent.diagonal(i) * work.displacement[i]) / work.unit[i]);
    if (!(force <= now.largest)) now.largest = force, now.freedom = i;
    if (!std::isfinite(force)) break;
  }
  now.allowed = tolerance * work.largest_force + 64 * std::numeric_limits<Real>::epsilon() * rounded;
  return now;
}

std::string direction_of(const Line& line, Index freedom)
{
  const Index within = freedom % line.freedoms_of_node();
  if (within == 0) return "N along the line";
  const std::string unit = within % 2 == 0 ? "N m/m in the slope " : "N ";
  return unit + (line.planes[(within - 1) / 2] == Plane::lateral ? "sideways" : "upwards");
}

[[noreturn]] void refuse(const Line& line, const State& state, const Unbalance& now, int iterations, bool singular)
{
  const Index node = now.freedom / line.freedoms_of_node();
  throw NoEquilibrium(
      fmt::format("the pipeline does not reach equilibrium after t = {:.6g} s: {} {} iterations node {} at x = {:.6g} m lacks "
                  "{:.3g} {}; a smaller step may find one",
                  state.time, singular ? "its stiffness is singular, and after" : "after", iterations, node, line.x[node], now.largest,
                  direction_of(line, now.freedom)));
}

/// Newton's iteration for the displacement of `work`.
StepEnd iterate(const Line& line, const State& state, const Loads& loads, const TimeTerms& terms, Work& work)
{
  for (int iterations = 0;; ++iterations) {
    assemble(line, state, loads, terms, work);
    const Unbalance now = unbalance_of(line, work);
    if (now.largest <= now.allowed) return {iterations, now.largest};
    if (iterations == max_iterations || !std::isfinite(now.largest)) refuse(line, state, now, iterations, false);
    if (work.tangent.factorize() == none) refuse(line, state, now, iterations, true);
    work.tangent.solve(work.residual);
    for (Index i = 0; i < line.freedoms(); ++i) work.displacement[i] -= work.residual[i];
  }
}

/// Where the line slides sideways: a lateral spring slides, or, where there is none, the node goes sideways much more than along the
/// line, in the mean over the way that mobilises the friction along it.
void find_sideways(const Line& line, const Work& work, State& state)
{
  for (const Spring& spring : line.springs) {
    const Index i = spring.node, u = line.axial(i), v = line.across(Plane::lateral, i);
    const auto* friction = std::get_if<PlasticSpring>(&line.laws[spring.law]);
    if (spring.freedom != u || friction == nullptr) continue;
    const Real along = work.displacement[u] - state.displacement[u], across = work.displacement[v] - state.displacement[v];
    const Real way = std::hypot(along, across), part = 1 / (way + friction->backbone.points.front().displacement);
    state.mean_axial[i] += part * (along - way * state.mean_axial[i]);
    state.mean_lateral[i] += part * (across - way * state.mean_lateral[i]);
    state.sideways[i] = std::abs(state.mean_lateral[i]) > sideways_ratio * std::abs(state.mean_axial[i]);
  }
  for (std::size_t s = 0; s < line.springs.size(); ++s) {
    const Spring& spring = line.springs[s];
    if (state.spring_factor[s] == 0 || spring.freedom != line.across(Plane::lateral, spring.node) ||
        std::holds_alternative<OneSidedSpring>(line.laws[spring.law]))
      continue;
    state.sideways[spring.node] = force_of(line.laws[spring.law], state.springs[s], work.displacement[spring.freedom]).slides;
  }
}

void accept(const Line& line, const TimeTerms& terms, const Work& work, State& state)
{
  for (std::size_t s = 0; s < line.springs.size(); ++s) {
    const Spring& spring = line.springs[s];
    const Real u = work.displacement[spring.freedom];
    state.springs[s] = acts(line, state, spring) ? accepted(line.laws[spring.law], state.springs[s], u) : SpringState{u, 0, 0, 0};
  }
  state.macro_elements = work.macro_elements;
  if (!line.axial_where_sideways && line.moves(Plane::lateral)) find_sideways(line, work, state);
  for (Index i = 0; i < line.freedoms(); ++i) {
    const Real since = work.displacement[i] - work.predicted[i];
    state.displacement[i] = work.displacement[i];
    state.acceleration[i] = terms.acceleration * since;
    state.velocity[i] = work.predicted_velocity[i] + terms.velocity * since;
  }
}

}  // namespace

StepEnd step(const Line& line, const Loads& loads, Real dt, State& state, Work& work)
{
  predict(line, state, dt, work);
  const TimeTerms terms = {1 / (beta_of_newmark * dt * dt), gamma_of_newmark / (beta_of_newmark * dt)};
  const StepEnd end = iterate(line, state, loads, terms, work);
  add_work(line, loads, terms, dt, work, state);
  accept(line, terms, work, state);
  state.time += dt;
  return end;
}

StepEnd find_equilibrium(const Line& line, const Loads& loads, State& state, Work& work)
{
  work.displacement = work.predicted = state.displacement;
  std::fill(work.predicted_velocity.begin(), work.predicted_velocity.end(), 0.0);
  const StepEnd end = iterate(line, state, loads, {}, work);
  add_work(line, loads, {}, 0, work, state);
  accept(line, {}, work, state);
  return end;
}

Index modes_below(const Line& line, const State& state, Real angular_frequency, Work& work)
{
  Loads loads = no_loads(line);
  loads.constrained_force = state.constrained_force;
  work.displacement = work.predicted = state.displacement;
  std::fill(work.predicted_velocity.begin(), work.predicted_velocity.end(), 0.0);
  assemble(line, state, loads, {-angular_frequency * angular_frequency, 0}, work);
  const Index negative = work.tangent.factorize();
  if (negative == none) throw NoEquilibrium(fmt::format("the pipeline has a mode of exactly {} rad/s", angular_frequency));
  return negative;
}

}  // namespace berm::beam
