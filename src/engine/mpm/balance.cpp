// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/momentum.cpp
#include "mpm/balance.hpp"

#include "boundary/damping.hpp"

#include "mpm/diagnose.hpp"
#include "mpm/light_corners.hpp"
#include "mpm/moments.hpp"
#include "problem/stages.hpp"

namespace berm::mpm {
namespace {

/// What the nodes contribute to the totals of one step: masses, momenta, forces and powers.
template <int dim>
struct NodalSums {
  Real mass = 0;                                     // of nodes that have one, kg
  Components<dim> momentum{};                        // theirs in the middle of the step, N s
  Components<dim> unbalanced{};                      // sum of the absolute components, N
  Components<dim> all{};                             // velocities and internal forces; finite where all of them are
  Components<dim> traction{}, damping{}, support{};  // forces, N
  Real traction_size = 0;                            // sum of |tractions of nodes|, N
  Real traction_power = 0, damping_power = 0, support_power = 0;

  NodalSums& operator+=(const NodalSums& other)
  {
    mass += other.mass;
    momentum += other.momentum;
    unbalanced += other.unbalanced;
    all += other.all;
    traction += other.traction;
    damping += other.damping;
    support += other.support;
    traction_size += other.traction_size;
    traction_power += other.traction_power;
    damping_power += other.damping_power;
    support_power += other.support_power;
    return *this;
  }
};

}  // namespace

template <int dim>
void solve_momentum_balance(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  BodyGrid<dim>& grid = workspace.grids[body];
  const Vec<dim> gravity = model.bodies[body].weight_over_mass * gravity_now(model, state.time);
  const Components<dim> gravity_components = components(gravity);
  const NodeField<std::uint8_t>& fixed = grid.supports(model);
  const Real dt = state.dt;
  const bool flows = grid.water.flows();
  const bool reported = !grid.support_force.empty();
  const bool absorbing = !model.dashpots.empty() && model.dashpots[body].any();
  const Index stage = state.stage.index;
  const bool moving = !model.moved.empty() && !model.moved[stage].empty();
  const bool holding = model.stages[state.stage.index].kind == problem::StageKind::geostatic;
  const bool loaded = !model.load_points.empty();
  // F_rest and the wave that comes in, this at the middle of the step.
  const auto from_outside = [&](Index node, Index dashpot) {
    const boundary::Dashpots<dim>& dashpots = model.dashpots[body];
    Vec<dim> force = state.held_forces[body][node];
    if (!dashpots.incoming.empty())
      force += (dashpots.incoming_force(dashpot, workspace.motion_before) + dashpots.incoming_force(dashpot, workspace.motion_after)) / 2;
    return force;
  };
  // Damping, against the velocity before the step, would drive a light node.
  const Real least_damped = light_node_part * model.bodies[body].waves.min_density / (dim + 1);
  const std::optional<Real> stage_damping = model.stages[state.stage.index].damping;
  const auto sums = sum_of<NodalSums<dim>>("momentum balance of nodes", grid.chunks, [&](Index n, NodalSums<dim>& to) {
    const Index i = grid.nodes[n];
    const Real m = grid.mass[i];
    Vec<dim>& acceleration = grid.acceleration[i];
    Components<dim> force = gathered(mesh, grid, i);
    const Components<dim> v = components(grid.velocity[i]);
    to.all += force + v;
    if (!(m > 0)) {
      acceleration.setZero();
      return;
    }
    force += m * gravity_components;
    if (loaded) force += components(grid.traction[i]);
    // The water takes a part of the force, and gives way by a flux that the acceleration makes.
    Components<dim> inertia = m - Components<dim>{};
    if (flows) {
      const WaterAtNode<dim>& water = grid.water.nodes[i];
      for (int d = 0; d < dim; ++d) inertia[d] = grid.water.soil_inertia[i][d];
      for (int d = 0; d < dim; ++d)
        if (inertia[d] < m) force[d] -= water.mass / water.inertia * (water.force[d] - water.drag * state.flux[body][i][d]);
    }
    const Index dashpot = absorbing ? model.dashpots[body].of_node[i] : none;
    const bool gives_way = dashpot != none && !holding;
    Components<dim> unbalanced = force;
    if (gives_way) unbalanced += components(state.held_forces[body][i]);
    const std::uint8_t held = fixed[i];
    Components<dim> free = 1 - Components<dim>{};  // 0 where held
    for (int d = 0; d < dim && held != 0; ++d)
      if (held >> d & 1) free[d] = 0;
    Real factor = grid.touching[i] ? 0 : stage_damping ? *stage_damping : model.bodies[body].damping[i];
    if (factor != 0 && m < least_damped * grid.volume_around[i]) factor = 0;
    if (!grid.touching[i]) to.unbalanced += magnitude(free * unbalanced);
    Components<dim> damping{};
    if (factor != 0) damping = free * boundary::local_damping(factor, unbalanced, v);
    const Components<dim> total = force + damping;
    Components<dim> a = total / inertia;
    if (gives_way) {
      const Vec<dim> from = from_outside(i, dashpot);
      a = components(boundary::acceleration_with<dim>(model.dashpots[body].resistance[dashpot], vector_of<dim>(inertia),
                                                      vector_of<dim>(total + components(from)), grid.velocity[i], dt));
    }
    for (int d = 0; d < dim && held != 0; ++d)
      if (held >> d & 1) a[d] = -v[d] / dt;
    const boundary::Holders<dim>* motions = moving ? &model.moved[stage][i] : nullptr;
    for (int d = 0; d < dim && moving; ++d)
      if (const Index motion = (*motions)[d]; motion != none) a[d] += workspace.motion_after[motion][d] / dt;
    store<dim>(a, acceleration);
    const Components<dim> mid_velocity = v + 0.5 * dt * a;
    to.mass += m;
    to.momentum += m * mid_velocity;
    if (factor != 0) {
      to.damping += damping;
      to.damping_power += sum_of_components<dim>(damping * mid_velocity);
    }
    if (loaded) {
      to.traction += components(grid.traction[i]);
      to.traction_size += grid.traction[i].norm();
      to.traction_power += sum_of_components<dim>(components(grid.traction[i]) * mid_velocity);
    }
    if (held == 0 && dashpot == none) {
      if (reported) grid.support_force[i].setZero();
      return;
    }
    const Components<dim> support = inertia * a - total;
    to.support += support;
    if (reported) store<dim>(support, grid.support_force[i]);
    for (int d = 0; d < dim && moving; ++d)
      if (const Index motion = (*motions)[d]; motion != none)
        to.support_power += support[d] * (workspace.motion_before[motion][d] + workspace.motion_after[motion][d]) / 2;
    if (dashpot != none) {
      for (int d = 0; d < dim && holding; ++d)
        if (model.dashpots[body].directions[dashpot] >> d & 1) state.held_forces[body][i][d] = support[d];
      for (int d = 0; d < dim && !holding; ++d)
        if (!(held >> d & 1)) to.support_power += support[d] * mid_velocity[d];
    }
  });

  if (!std::isfinite(sum_of_components<dim>(sums.all) + state.totals.internal)) throw_not_finite(model, state, body);
  problem::Totals<dim>& totals = state.totals;
  totals.gravity_impulse += dt * sums.mass * gravity;
  totals.traction_impulse += dt * vector_of<dim>(sums.traction);
  totals.damping_impulse += dt * vector_of<dim>(sums.damping);
  totals.support_impulse += dt * vector_of<dim>(sums.support);
  totals.external += dt * (gravity.dot(vector_of<dim>(sums.momentum)) + sums.traction_power + sums.support_power);
  totals.damping -= dt * sums.damping_power;
  workspace.unbalanced = (body == 0 ? 0 : workspace.unbalanced) + sum_of_components<dim>(sums.unbalanced);
  workspace.weight = (body == 0 ? 0 : workspace.weight) + sums.mass * gravity.norm() + sums.traction_size;
}

template void solve_momentum_balance(const problem::Model<2>&, problem::State<2>&, Workspace<2>&, Index);
template void solve_momentum_balance(const problem::Model<3>&, problem::State<3>&, Workspace<3>&, Index);

}  // namespace berm::mpm
