// SPDX-License-Identifier: BSD-3-Clause
#include "fem/newton.hpp"

#include "fem/line_search.hpp"

#include <algorithm>

namespace berm::fem {
namespace {

constexpr int max_iterations = 25;
constexpr Real rounding_of_gap = 1e-12;     // over the width
constexpr Real least_part = 1. / 64;        // of a step, where the residual decides
constexpr Real barrier = 10;                // over the residual: one that a whole step may end at where no part of it is better
constexpr Real max_unbalanced_flow = 1e-6;  // of the water: its balance is linear, and holds after a whole step but for rounding
constexpr Real tolerance_of_flow = 0.1;     // of that without water that flows
constexpr Real fast = 0.3;                  // a matrix that brings the unbalanced forces down to this part is kept for the next step

}  // namespace

Newton::Newton(const FemModel& model)
    : model_(model),
      assembly_(model),
      contact_(model),
      solver_(std::in_place_type<FrontalSolver>, model.mesh, model.unknowns(), contact_.unknowns()),
      min_force_(std::max(1e-3 * model.weight, 1e-300))
{
  if (model.unsymmetric || model.flow.count > 0)
    solver_.emplace<DirectSolver>(model.pattern, contact_.unknowns(), model.unsymmetric ? MatrixKind::unsymmetric : MatrixKind::indefinite);
  // Positions are rounded, and so are the gaps that follow from them.
  if (model.settings.large_deformation) min_force_ += rounding_of_gap * model.contact_stiffness() * model.width * model.width;
  for (const std::vector<NodalLoad>& loads : model.loads)
    for (const NodalLoad& load : loads) min_force_ += 1e-3 * load.force.norm();
  boundary::for_each_of<boundary::Head<2>>(model.model.conditions, [&](std::size_t h, const auto&, const auto& head) {
    const std::vector<Index>& nodes = model.mesh.head_nodes[h];
    if (nodes.empty()) return;
    Vec<2> lower = model.mesh.position[nodes.front()], upper = lower;
    for (const Index node : nodes) lower = lower.cwiseMin(model.mesh.position[node]), upper = upper.cwiseMax(model.mesh.position[node]);
    min_force_ += 1e-3 * std::abs(head.pressure) * (upper - lower).norm();
  });
}

/// The right-hand side of the equations of the step; whether the prescribed unknowns have moved as prescribed.
bool Newton::set_step(const FemState& begin, const FemLoads& loads, const std::vector<Real>& change)
{
  bool moves_as_prescribed = true;
  for (Index k = 0; k < model_.unknowns(); ++k) {
    if (!assembly_.prescribed(k)) {
      step_[k] = -assembly_.soil_residual()[k];
      continue;
    }
    Real prescribed = 0;
    if (k >= model_.pressure_unknown())
      prescribed = assembly_.outside_pressure(k) - begin.displacement[k];
    else if (k >= model_.rigid_unknown())
      prescribed = loads.direction_of((k - model_.rigid_unknown()) / 3, (k - model_.rigid_unknown()) % 3).value;
    step_[k] = prescribed - change[k];
    moves_as_prescribed = moves_as_prescribed && std::abs(step_[k]) <= 1e-12 * std::abs(prescribed);
  }
  return moves_as_prescribed;
}

/// False where the matrix is singular.
bool Newton::factorize()
{
  if (auto* frontal = std::get_if<FrontalSolver>(&solver_)) return frontal->factorize(assembly_.stiffness(), assembly_.prescribed());
  return std::get<DirectSolver>(solver_).factorize(assembly_.matrix());
}

/// From the right-hand side to the step.
void Newton::find_step(const FemState& begin, const std::vector<Real>& change)
{
  std::visit(
      [&](auto& solver) {
        if (contact_.unknowns().empty()) return solver.solve(step_);
        contact_.find(begin, change, assembly_, solver.kept_matrix(), solver.condense(step_));
        solver.expand(step_);
      },
      solver_);
}

Real Newton::slope() const
{
  Real sum = 0;
  for (Index k = 0; k < model_.pressure_unknown(); ++k)
    if (!assembly_.prescribed(k)) sum += step_[k] * assembly_.residual()[k];
  return sum;
}

/// Where no part makes the residual smaller the whole step is taken: soil that changes its branch may be beyond a higher residual.
void Newton::search_by_residual(const FemState& begin, const FemLoads& loads, Real viscosity, std::vector<Real>& change)
{
  const Real first = assembly_.norm();
  Real at = 0;
  const auto go_to = [&](Real part) {
    for (Index k = 0; k < model_.unknowns(); ++k) change[k] += (part - at) * step_[k];
    at = part;
    assembly_.evaluate(begin, change, loads, viscosity);
    return assembly_.norm();
  };
  const Real whole = go_to(1);
  Real here = whole, best = 1, least = whole;
  for (Real part = 0.5; part >= least_part && !(here < (1 - 0.01 * at) * first); part /= 2)
    if (here = go_to(part); here < least || !std::isfinite(least)) least = here, best = part;
  if (!(least < first) && whole < barrier * first) best = 1;
  if (at != best) go_to(best);
}

void Newton::search_line(const FemState& begin, const FemLoads& loads, Real viscosity, std::vector<Real>& change)
{
  const Real first = slope();
  const auto go = [&](Real by) {
    for (Index k = 0; k < model_.unknowns(); ++k) change[k] += by * step_[k];
    assembly_.evaluate(begin, change, loads, viscosity);
    return slope();
  };
  search_along_step(first, go);
}

IncrementEnd Newton::find_equilibrium(const FemState& begin, const FemLoads& loads, Real viscosity, std::vector<Real>& change)
{
  // The error of the pressures in time, which is found from their changes, must not be that of the equilibrium.
  const bool flows = model_.flow.count > 0;
  const int least_iterations = flows && loads.dt > 0 ? 1 : 0;
  const Real tolerance = model_.settings.tolerance * (flows ? tolerance_of_flow : 1);
  IncrementEnd end;
  Real last = 0;
  step_.resize(change.size());
  assembly_.evaluate(begin, change, loads, viscosity);
  for (;; ++end.iterations) {
    const bool linear_done = set_step(begin, loads, change) && assembly_.unbalanced_flow() <= max_unbalanced_flow;
    end.unbalance = assembly_.unbalanced() / std::max(assembly_.contact_force(), min_force_);
    end.converged = linear_done && end.unbalance <= tolerance && end.iterations >= least_iterations;
    if (end.converged || end.iterations == max_iterations || !std::isfinite(end.unbalance)) return end;
    if (!(end.unbalance < fast * last)) {
      assembly_.differentiate(begin, change, viscosity);
      if (!factorize()) return end;
    }
    last = end.unbalance;
    find_step(begin, change);
    if (linear_done && model_.unsymmetric) {
      search_by_residual(begin, loads, viscosity, change);
    } else if (linear_done) {
      search_line(begin, loads, viscosity, change);
    } else {
      for (Index k = 0; k < model_.unknowns(); ++k) change[k] += step_[k];
      assembly_.evaluate(begin, change, loads, viscosity);
    }
  }
}

}  // namespace berm::fem
