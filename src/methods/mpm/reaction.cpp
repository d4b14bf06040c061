// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/momentum.cpp
#include "mpm/reaction.hpp"

#include "contact/detect.hpp"
#include "contact/strips.hpp"
#include "mpm/support_reactions.hpp"
#include "problem/stages.hpp"

namespace berm::mpm {
namespace {

/// What the impulses of a contact add up to.
template <int dim>
struct Reaction {
  Vec<dim> impulse = Vec<dim>::Zero(), of_support = Vec<dim>::Zero();  ///< on the body, N s; the part of it that supports take
  bodies::Angular<dim> torque = bodies::no_angular<dim>();             ///< on the body, N m s
  Real external = 0, friction = 0;                                     ///< work, J
  Real sum = 0, times_gap = 0;                                         ///< of |impulse|, and of |impulse| times distance
  Real shaft = 0;                                                      ///< along the axis, of sides parallel to it, N s
  Real effective = 0;                                                  ///< along the normals less the pressure of the water, N s

  /// What goes around the axis balances itself but for the part along it. Of a wall around it, which may widen, the part across it is that of a radian.
  void keep_on_axis(const bodies::RigidShape<dim>& shape)
  {
    const auto* plane = std::get_if<bodies::HalfPlane<dim>>(&shape);
    if (plane == nullptr || plane->normal[1] != 0) impulse[0] = 0;
    torque = bodies::no_angular<dim>();
  }

  /// What a plane of symmetry mirrors: the part across it balances itself, and so do moments but that about its normal.
  void keep_in_planes(const std::array<bool, dim>& mirrored)
  {
    for (int d = 0; d < dim; ++d) {
      if (!mirrored[d]) continue;
      impulse[d] = 0;
      if constexpr (dim == 3)
        for (int about = 0; about < 3; ++about) torque[about] = about == d ? torque[about] : 0;
    }
  }

  Reaction& operator+=(const Reaction& other)
  {
    impulse += other.impulse, of_support += other.of_support, torque += other.torque;
    external += other.external, friction += other.friction;
    sum += other.sum, times_gap += other.times_gap;
    shaft += other.shaft, effective += other.effective;
    return *this;
  }
};

template <int dim>
Reaction<dim> reaction_at(const problem::Model<dim>& model, const problem::State<dim>& state, const Workspace<dim>& workspace,
                          const problem::Contact& contact, const contact::ContactPoint<dim>& point, const Vec<dim>& gravity)
{
  Reaction<dim> reaction;
  const Vec<dim>& impulse = point.impulse;
  if (impulse.isZero()) return reaction;
  const Real dt = state.dt;
  // A node's share of an impulse. It also changes the mid-step velocity at which the work of gravity and tractions was
  // taken; supports take the components in fixed directions.
  const auto add = [&](Index b, Index node, const Vec<dim>& share, const Vec<dim>& partner_velocity) {
    const BodyGrid<dim>& grid = workspace.grids[b];
    const Vec<dim> taken = boundary::without_fixed<dim>(grid.held_directions(model), node, share);
    reaction.of_support += taken - share;
    reaction.external += 0.5 * dt * model.bodies[b].weight_over_mass * gravity.dot(taken);
    if (!model.load_points.empty() && grid.mass[node] > 0) reaction.external += 0.5 * dt * grid.traction[node].dot(taken) / grid.mass[node];
    const Vec<dim> mid_velocity = grid.velocity[node] + 0.5 * dt * grid.acceleration[node];
    reaction.friction -= share.dot(mid_velocity - partner_velocity);
  };
  reaction.impulse = impulse;
  if (contact::is_shaft(point.normal[1])) reaction.shaft = impulse[1];
  if (contact.other_body != none) {
    add(contact.body, point.nodes[0], impulse, Vec<dim>::Zero());
    add(contact.other_body, point.nodes[0], -impulse, Vec<dim>::Zero());
    return reaction;
  }
  const bodies::RigidState<dim>& rigid = state.rigid_bodies[contact.rigid];
  for (int n = 0; n < point.node_count; ++n) add(contact.body, point.nodes[n], point.weights[n] * impulse, point.surface_velocity);
  reaction.torque = bodies::moment_of(Vec<dim>(point.position - center_now(model.rigid_bodies[contact.rigid], rigid)), impulse);
  reaction.external += impulse.dot(point.surface_velocity);
  if (problem::rubs_in_water(contact, model.bodies)) reaction.effective = impulse.dot(point.normal) - point.pore_pressure * point.area * dt;
  if (point.distance < infinity) reaction.sum = impulse.norm(), reaction.times_gap = reaction.sum * point.distance;
  return reaction;
}

/// Half of the extent of a contact point along the surface, m: of its particle, or of the square (cube) that a node has of its cells.
template <int dim>
Real half_extent(const mesh::Mesh<dim>& mesh, const contact::ContactPoint<dim>& point)
{
  if (point.node_count > 1) return point.half_width;
  Real around = 0;
  for (Index e = mesh.first_entry[point.nodes[0]]; e < mesh.first_entry[point.nodes[0] + 1]; ++e)
    around += mesh.section(mesh.entries[e] / (dim + 1));
  return contact::half_width<dim>(around / (dim + 1));
}

/// Adds the impulses of all points to the depth slices of the rigid body: those along the bed, which a plane of symmetry across it and an axis balance, and those
/// of upright sides along them. A point lies in the slices that its extent reaches, in each with its part of that, so that thin slices have no holes.
template <int dim>
void add_to_slices(const problem::Model<dim>& model, problem::State<dim>& state, Index rigid, const contact::ContactPoints<dim>& points)
{
  const problem::DepthSlices& slices = model.depth_slices[rigid];
  if (slices.count == 0) return;
  const bool balanced = model.mirrored[model.axes.along] || model.mesh.metric == mesh::Metric::axisymmetric;
  const Real center = model.axes.height(center_now(model.rigid_bodies[rigid], state.rigid_bodies[rigid]));
  for (const contact::ContactPoint<dim>& point : points.list) {
    if (point.impulse.isZero()) continue;
    const Real upright = std::sqrt(std::max(Real(0), 1 - point.normal[model.axes.up] * point.normal[model.axes.up]));
    const Real height = model.axes.height(point.position) - center, half = upright * half_extent(model.mesh, point);
    const bool of_shaft = contact::is_shaft(point.normal[model.axes.up]);
    slices.share(height - half, height + half, [&](Index slice, Real fraction) {
      if (!balanced) state.ledger.slice_impulses[rigid][slice] += fraction * point.impulse[model.axes.along];
      if (of_shaft) state.ledger.slice_shaft_impulses[rigid][slice] += fraction * model.axes.height(point.impulse);
    });
  }
}

}  // namespace

template <int dim>
void react(const problem::Model<dim>& model, problem::State<dim>& state, const Workspace<dim>& workspace)
{
  const Vec<dim> gravity = gravity_now(model, state.time);
  for (bodies::RigidState<dim>& rigid : state.rigid_bodies) rigid.reaction.setZero(), rigid.torque = bodies::no_angular<dim>();
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    const problem::Contact& contact = model.contacts[k];
    const auto& list = workspace.contact_points[k].list;
    Reaction<dim> all = sum_of<Reaction<dim>>(
        "contact: reaction", static_cast<Index>(list.size()),
        [&](Index p) { return reaction_at(model, state, workspace, contact, list[p], gravity); }, contact::min_points_for_threads);
    state.ledger.totals.support_impulse += all.of_support;
    state.ledger.totals.external += all.external;
    state.ledger.totals.friction += all.friction;
    if (contact.other_body != none) {
      state.ledger.pair_impulses[k] += all.impulse;
      continue;
    }
    state.ledger.totals.contact_impulse += all.impulse;
    if (model.mesh.metric == mesh::Metric::axisymmetric) all.keep_on_axis(model.rigid_bodies[contact.rigid].shape);
    all.keep_in_planes(model.mirrored);
    bodies::RigidState<dim>& rigid = state.rigid_bodies[contact.rigid];
    rigid.reaction -= all.impulse / state.dt;
    rigid.torque -= all.torque / state.dt;
    contact::ContactSums<dim>& sums = state.ledger.contact_sums[contact.rigid];
    sums.impulse += all.impulse;
    sums.torque_impulse += all.torque;
    sums.shaft_impulse += all.shaft;
    sums.effective_impulse += all.effective;
    sums.impulse_sum += all.sum;
    sums.impulse_times_gap += all.times_gap;
    add_to_slices(model, state, contact.rigid, workspace.contact_points[k]);
  }
  react_at_supports(model, state, workspace);
}

template <int dim>
Vec<dim> impulse_of(const contact::ContactPoints<dim>& points)
{
  struct Impulse {
    Vec<dim> sum = Vec<dim>::Zero();
    Impulse& operator+=(const Impulse& other)
    {
      sum += other.sum;
      return *this;
    }
  };
  const auto at = [&](Index p) { return Impulse{points.list[p].impulse}; };
  return sum_of<Impulse>("contact: impulses", static_cast<Index>(points.list.size()), at, contact::min_points_for_threads).sum;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void react(const problem::Model<dim>&, problem::State<dim>&, const Workspace<dim>&);                                            \
  template Vec<dim> impulse_of(const contact::ContactPoints<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
