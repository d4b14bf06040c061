// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/space_steps_limit_load_test.cpp
#include "fem/space_newton.hpp"

#include "fem/line_search.hpp"

#include <algorithm>

namespace berm::fem {
namespace {

constexpr int max_iterations = 30;  // the mean volumetric strain takes more of them than the plane
constexpr Real fast = 0.3;          // a matrix that brings the unbalanced forces down to this part is kept for the next step

}  // namespace

SpaceNewton::SpaceNewton(const SpaceModel& model)
    : model_(model),
      assembly_(model),
      solver_(model.pattern, {}, MatrixKind::positive_definite, Ordering::scotch),
      entries_(static_cast<std::size_t>(model.pattern.entry_count())),
      step_(static_cast<std::size_t>(model.unknowns()))
{
}

/// Minus the residual, and of prescribed unknowns the step; whether these have moved as prescribed.
bool SpaceNewton::set_step(const ElementLoads<3>& loads, const std::vector<Real>& change)
{
  bool moves_as_prescribed = true;
  for (Index k = 0; k < model_.unknowns(); ++k) {
    if (!assembly_.prescribed(k)) {
      step_[k] = -assembly_.residual()[k];
      continue;
    }
    if (k < model_.rigid_unknown()) {
      step_[k] = model_.tied[k / 3] == none ? -change[k] : 0;
      continue;
    }
    const Real prescribed = loads.direction_of((k - model_.rigid_unknown()) / 6, (k - model_.rigid_unknown()) % 6).value;
    step_[k] = prescribed - change[k];
    moves_as_prescribed = moves_as_prescribed && std::abs(step_[k]) <= 1e-12 * std::abs(prescribed);
  }
  return moves_as_prescribed;
}

Real SpaceNewton::slope() const
{
  Real sum = 0;
  for (Index k = 0; k < model_.unknowns(); ++k)
    if (!assembly_.prescribed(k)) sum += step_[k] * assembly_.residual()[k];
  return sum;
}

IncrementEnd SpaceNewton::find_equilibrium(const SpaceState& begin, const ElementLoads<3>& loads, Real viscosity, std::vector<Real>& change)
{
  const Real min_force = std::max(1e-3 * model_.weight, 1e-300);
  IncrementEnd end;
  Real last = 0;
  assembly_.carry_tied_nodes(change);
  assembly_.evaluate(begin, change, loads, viscosity);
  for (;; ++end.iterations) {
    const bool linear_done = set_step(loads, change);
    end.unbalance = assembly_.unbalanced() / std::max(assembly_.contact_force(), min_force);
    end.converged = linear_done && end.unbalance <= model_.settings.tolerance;
    if (end.converged || end.iterations == max_iterations || !std::isfinite(end.unbalance)) return end;
    if (!linear_done || !(end.unbalance < fast * last)) {
      assembly_.differentiate(begin, change, viscosity, entries_, step_);
      if (!solver_.factorize(entries_)) return end;
    }
    last = end.unbalance;
    solver_.solve(step_);
    assembly_.carry_tied_nodes(step_);
    const auto go = [&](Real by) {
      for (Index k = 0; k < model_.unknowns(); ++k) change[k] += by * step_[k];
      assembly_.evaluate(begin, change, loads, viscosity);
      return slope();
    };
    if (linear_done)
      search_along_step(slope(), go);
    else
      go(1);
  }
}

}  // namespace berm::fem
