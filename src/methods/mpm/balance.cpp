// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/momentum.cpp
#include "mpm/balance.hpp"

#include "boundary/damping.hpp"

#include "mpm/diagnose.hpp"
#include "mpm/moments.hpp"
#include "mpm/small_mass_nodes.hpp"
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

/// What is the same for all nodes of a body in a step.
template <int dim>
struct BodyBalance {
  const problem::Model<dim>& model;
  problem::State<dim>& state;
  const Workspace<dim>& workspace;
  BodyGrid<dim>& grid;
  Index body;
  const settings::StageSettings& stage = model.stages[state.stage.index];
  Real dt = state.dt;                                                                       // s
  Vec<dim> gravity = model.bodies[body].weight_over_mass * gravity_now(model, state.time);  // m/s2
  Components<dim> gravity_components = components(gravity);
  const NodeField<std::uint8_t>& held = grid.held_directions(model);
  const NodeField<boundary::Holders<dim>>& moved = grid.conditions(model).moved;
  const boundary::Dashpots<dim>* dashpots = model.conditions.absorbs(body) ? &model.conditions.dashpots[body] : nullptr;
  bool flows = grid.water.flows(), loaded = !model.load_points.empty(), reported = !grid.support_force.empty();
  bool holding = stage.kind == settings::StageKind::geostatic;  // also the boundaries that absorb in other stages
  bool moving = !moved.empty();
  std::optional<Real> stage_damping = stage.damping;
  // Damping, against the velocity before the step, would drive a node of small mass.
  Real least_damped = small_mass_fraction * model.bodies[body].waves.min_density / (dim + 1);  // kg/m3

  Index dashpot_of(Index node) const { return dashpots != nullptr ? dashpots->of_node[node] : none; }
  /// Calls act(d, row) for the directions in which a condition prescribes the velocity of a node.
  template <class Act>
  [[gnu::always_inline]] void for_each_motion(Index node, const Act& act) const
  {
    if (!moving) return;
    for (int d = 0; d < dim; ++d)
      if (moved[node][d] != none) act(d, moved[node][d]);
  }
};

/// The equation of a node: inertia a = force + damping + support.
template <int dim>
struct NodeBalance {
  Index i;
  Real m;                                           // kg
  Components<dim> v;                                // before the step, m/s
  std::uint8_t held;                                // bit d: direction d
  Index dashpot;                                    // or none
  bool absorbs;                                     // waves, by its dashpot
  Components<dim> force;                            // first of stress, then of all but damping and support, N
  Components<dim> inertia = m - Components<dim>{};  // kg, by direction
  Components<dim> damping{}, unbalanced{};          // N; this where nothing holds the node
  Components<dim> a{};                              // m/s2

  bool holds(int d) const { return held >> d & 1; }
};

/// (2), (3) and tractions. The water takes a part of the force, and moves by a flux that the acceleration makes.
template <int dim>
[[gnu::always_inline]] inline void add_forces(const BodyBalance<dim>& all, NodeBalance<dim>& node)
{
  node.force += node.m * all.gravity_components;
  if (all.loaded) node.force += components(all.grid.traction[node.i]);
  if (!all.flows) return;
  const WaterAtNode<dim>& water = all.grid.water.nodes[node.i];
  for (int d = 0; d < dim; ++d) node.inertia[d] = all.grid.water.soil_inertia[node.i][d];
  for (int d = 0; d < dim; ++d)
    if (node.inertia[d] < node.m)
      node.force[d] -= water.mass / water.inertia * (water.force[d] - water.drag * all.state.flux[all.body][node.i][d]);
}

/// Local damping, against the force that nothing holds; none near a contact.
template <int dim>
[[gnu::always_inline]] inline void damp(const BodyBalance<dim>& all, NodeBalance<dim>& node)
{
  node.unbalanced = node.force;
  if (node.absorbs) node.unbalanced += components(all.state.held_forces[all.body][node.i]);
  for (int d = 0; d < dim && node.held != 0; ++d)
    if (node.holds(d)) node.unbalanced[d] = 0;
  if (all.grid.touching[node.i]) return;
  const Real factor = all.stage_damping ? *all.stage_damping : all.model.bodies[all.body].damping[node.i];
  if (factor == 0 || node.m < all.least_damped * all.grid.volume_around[node.i]) return;
  node.damping = boundary::local_damping(factor, node.unbalanced, node.v);
}

/// (4); of a node that absorbs with its dashpot, F_rest and the wave that comes in at the middle of the step.
template <int dim>
[[gnu::always_inline]] inline void accelerate(const BodyBalance<dim>& all, NodeBalance<dim>& node)
{
  const Components<dim> total = node.force + node.damping;
  node.a = total / node.inertia;
  if (!node.absorbs) return;
  const boundary::Dashpots<dim>& dashpots = *all.dashpots;
  const Workspace<dim>& w = all.workspace;
  Vec<dim> from_outside = all.state.held_forces[all.body][node.i];
  if (!dashpots.incoming.empty())
    from_outside += (dashpots.incoming_force(node.dashpot, w.motion_before) + dashpots.incoming_force(node.dashpot, w.motion_after)) / 2;
  node.a =
      components(boundary::acceleration_with<dim>(dashpots.resistance[node.dashpot], vector_of<dim>(node.inertia),
                                                  vector_of<dim>(total + components(from_outside)), all.grid.velocity[node.i], all.dt));
}

/// Supports take the velocity in the directions that they hold, or give it that of their motion.
template <int dim>
[[gnu::always_inline]] inline void hold(const BodyBalance<dim>& all, NodeBalance<dim>& node)
{
  for (int d = 0; d < dim && node.held != 0; ++d)
    if (node.holds(d)) node.a[d] = -node.v[d] / all.dt;
  all.for_each_motion(node.i, [&](int d, Index motion) { node.a[d] += all.workspace.motion_after[motion][d] / all.dt; });
}

/// The node's part of the totals, and what its supports give it.
template <int dim>
[[gnu::always_inline]] inline void add_to_totals(const BodyBalance<dim>& all, const NodeBalance<dim>& node, NodalSums<dim>& to)
{
  const Components<dim> mid_velocity = node.v + 0.5 * all.dt * node.a;
  to.mass += node.m;
  to.momentum += node.m * mid_velocity;
  if (!all.grid.touching[node.i]) to.unbalanced += magnitude(node.unbalanced);
  to.damping += node.damping;
  to.damping_power += sum_of_components<dim>(node.damping * mid_velocity);
  if (all.loaded) {
    const Components<dim> traction = components(all.grid.traction[node.i]);
    to.traction += traction;
    to.traction_size += all.grid.traction[node.i].norm();
    to.traction_power += sum_of_components<dim>(traction * mid_velocity);
  }
  const bool supported = node.held != 0 || node.dashpot != none;
  const Components<dim> support = supported ? node.inertia * node.a - (node.force + node.damping) : Components<dim>{};
  if (all.reported) store<dim>(support, all.grid.support_force[node.i]);
  if (!supported) return;
  to.support += support;
  all.for_each_motion(node.i, [&](int d, Index motion) {
    to.support_power += support[d] * (all.workspace.motion_before[motion][d] + all.workspace.motion_after[motion][d]) / 2;
  });
  for (int d = 0; d < dim && node.absorbs; ++d)
    if (!node.holds(d)) to.support_power += support[d] * mid_velocity[d];
  for (int d = 0; d < dim && all.holding && node.dashpot != none; ++d)
    if (all.dashpots->directions[node.dashpot] >> d & 1) all.state.held_forces[all.body][node.i][d] = support[d];
}

}  // namespace

template <int dim>
void solve_momentum_balance(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body)
{
  BodyGrid<dim>& grid = workspace.grids[body];
  const BodyBalance<dim> all{model, state, workspace, grid, body};
  const auto sums = sum_of<NodalSums<dim>>("momentum balance of nodes", grid.chunks, [&](Index n, NodalSums<dim>& to) {
    const Index i = grid.nodes[n], dashpot = all.dashpot_of(i);
    NodeBalance<dim> node{.i = i,
                          .m = grid.mass[i],
                          .v = components(grid.velocity[i]),
                          .held = all.held[i],
                          .dashpot = dashpot,
                          .absorbs = dashpot != none && !all.holding,
                          .force = gathered(model.mesh, grid, i)};
    to.all += node.force + node.v;
    if (node.m > 0) {
      add_forces(all, node);
      damp(all, node);
      accelerate(all, node);
      hold(all, node);
      add_to_totals(all, node, to);
    }
    store<dim>(node.a, grid.acceleration[i]);
  });

  if (!std::isfinite(sum_of_components<dim>(sums.all) + state.ledger.totals.internal)) throw_not_finite(model, state, body);
  const Real dt = state.dt;
  problem::Totals<dim>& totals = state.ledger.totals;
  totals.gravity_impulse += dt * sums.mass * all.gravity;
  totals.traction_impulse += dt * vector_of<dim>(sums.traction);
  totals.damping_impulse += dt * vector_of<dim>(sums.damping);
  totals.support_impulse += dt * vector_of<dim>(sums.support);
  totals.external += dt * (all.gravity.dot(vector_of<dim>(sums.momentum)) + sums.traction_power + sums.support_power);
  totals.damping -= dt * sums.damping_power;
  workspace.unbalanced = (body == 0 ? 0 : workspace.unbalanced) + sum_of_components<dim>(sums.unbalanced);
  workspace.weight = (body == 0 ? 0 : workspace.weight) + sums.mass * all.gravity.norm() + sums.traction_size;
}

template void solve_momentum_balance(const problem::Model<2>&, problem::State<2>&, Workspace<2>&, Index);
template void solve_momentum_balance(const problem::Model<3>&, problem::State<3>&, Workspace<3>&, Index);

}  // namespace berm::mpm
