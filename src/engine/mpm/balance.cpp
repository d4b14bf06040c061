// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/momentum.cpp
#include "mpm/balance.hpp"

#include "boundary/damping.hpp"

#include "mpm/diagnose.hpp"
#include "problem/stages.hpp"

namespace berm::mpm {
namespace {

/// What the nodes contribute to the totals in one step, per unit of time.
template <int dim>
struct NodalSums {
  Vec<dim> gravity = Vec<dim>::Zero(), traction = Vec<dim>::Zero(), damping = Vec<dim>::Zero(), support = Vec<dim>::Zero();  // forces, N
  Real gravity_power = 0, traction_power = 0, damping_power = 0, support_power = 0;
  Real traction_size = 0;  // sum of |tractions of nodes|, N
  Real unbalanced = 0;     // sum of the absolute components, N
  Real all = 0;            // of velocities and internal forces; finite where all of them are

  NodalSums& operator+=(const NodalSums& other)
  {
    gravity += other.gravity;
    traction += other.traction;
    damping += other.damping;
    support += other.support;
    gravity_power += other.gravity_power;
    traction_power += other.traction_power;
    support_power += other.support_power;
    traction_size += other.traction_size;
    damping_power += other.damping_power;
    unbalanced += other.unbalanced;
    all += other.all;
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
  const NodeField<std::uint8_t>& fixed = grid.supports(model);
  const Real dt = state.dt;
  const bool flows = grid.water.flows();
  const bool reported = grid.support_force.size() > 0;
  const bool absorbing = !model.dashpots.empty() && model.dashpots[body].any();
  const Index stage = state.stage.index;
  const bool moving = !model.moved.empty() && model.moved[stage].size() > 0;
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
  const std::optional<Real> stage_damping = model.stages[state.stage.index].damping;
  const auto sums = sum_of<NodalSums<dim>>("momentum balance of nodes", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    NodalSums<dim> sums_i;
    const Real m = grid.mass[i];
    Vec<dim>& a = grid.acceleration[i];
    Vec<dim> force = Vec<dim>::Zero();
    for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e) force += Eigen::Map<const Vec<dim>>(grid.at(mesh.entries[e]).sum);
    sums_i.all = force.sum() + grid.velocity[i].sum();
    if (!(m > 0)) {
      a.setZero();
      return sums_i;
    }
    const Vec<dim> weight = m * gravity;
    force += weight;
    if (loaded) force += grid.traction[i];
    // The water takes a part of the force, and gives way by a flux that the acceleration makes.
    Vec<dim> inertia = Vec<dim>::Constant(m);
    if (flows) {
      const WaterAtNode<dim>& water = grid.water.nodes[i];
      inertia = grid.inertia(i);
      for (int d = 0; d < dim; ++d)
        if (inertia[d] < m) force[d] -= water.mass / water.inertia * (water.force[d] - water.drag * state.flux[body][i][d]);
    }
    const Index dashpot = absorbing ? model.dashpots[body].of_node[i] : none;
    const bool gives_way = dashpot != none && !holding;
    Vec<dim> unbalanced = force;
    if (gives_way) unbalanced += state.held_forces[body][i];
    const Vec<dim>& v = grid.velocity[i];
    const Real factor = grid.touching[i] ? 0 : stage_damping ? *stage_damping : model.bodies[body].damping[i];
    Vec<dim> damping = Vec<dim>::Zero();
    for (int d = 0; d < dim; ++d) {
      const bool held = fixed[i] >> d & 1;
      if (!held) damping[d] = boundary::local_damping(factor, unbalanced[d], v[d]);
      if (!held && !grid.touching[i]) sums_i.unbalanced += std::abs(unbalanced[d]);
    }
    const Vec<dim> total = force + damping;
    a = !gives_way
            ? Vec<dim>(total.cwiseQuotient(inertia))
            : boundary::acceleration_with<dim>(model.dashpots[body].resistance[dashpot], inertia, total + from_outside(i, dashpot), v, dt);
    for (int d = 0; d < dim; ++d)
      if (fixed[i] >> d & 1) a[d] = -v[d] / dt;
    if (moving)
      for (int d = 0; d < dim; ++d)
        if (const Index motion = model.moved[stage][i][d]; motion != none) a[d] += workspace.motion_after[motion][d] / dt;
    const Vec<dim> mid_velocity = v + 0.5 * dt * a;
    sums_i.gravity = weight;
    sums_i.damping = damping;
    sums_i.support = inertia.cwiseProduct(a) - total;
    if (moving)
      for (int d = 0; d < dim; ++d)
        if (const Index motion = model.moved[stage][i][d]; motion != none)
          sums_i.support_power += sums_i.support[d] * (workspace.motion_before[motion][d] + workspace.motion_after[motion][d]) / 2;
    if (reported) grid.support_force[i] = sums_i.support;
    if (dashpot != none) {
      for (int d = 0; d < dim && holding; ++d)
        if (model.dashpots[body].directions[dashpot] >> d & 1) state.held_forces[body][i][d] = sums_i.support[d];
      for (int d = 0; d < dim && !holding; ++d)
        if (!(fixed[i] >> d & 1)) sums_i.support_power += sums_i.support[d] * mid_velocity[d];
    }
    sums_i.gravity_power = weight.dot(mid_velocity);
    if (loaded) {
      sums_i.traction = grid.traction[i];
      sums_i.traction_size = grid.traction[i].norm();
      sums_i.traction_power = grid.traction[i].dot(mid_velocity);
    }
    sums_i.damping_power = damping.dot(mid_velocity);
    return sums_i;
  });

  if (!std::isfinite(sums.all + state.totals.internal)) throw_not_finite(model, state, body);
  problem::Totals<dim>& totals = state.totals;
  totals.gravity_impulse += dt * sums.gravity;
  totals.traction_impulse += dt * sums.traction;
  totals.damping_impulse += dt * sums.damping;
  totals.support_impulse += dt * sums.support;
  totals.external += dt * (sums.gravity_power + sums.traction_power + sums.support_power);
  totals.damping -= dt * sums.damping_power;
  workspace.unbalanced = (body == 0 ? 0 : workspace.unbalanced) + sums.unbalanced;
  workspace.weight = (body == 0 ? 0 : workspace.weight) + sums.gravity.norm() + sums.traction_size;
}

template void solve_momentum_balance(const problem::Model<2>&, problem::State<2>&, Workspace<2>&, Index);
template void solve_momentum_balance(const problem::Model<3>&, problem::State<3>&, Workspace<3>&, Index);

}  // namespace berm::mpm
