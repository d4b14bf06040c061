// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/contact_schemes.cpp
#include "mpm/contact.hpp"

#include "contact/contact_law.hpp"
#include "contact/footprint.hpp"
#include "contact/strips.hpp"
#include "mpm/contact_velocity.hpp"
#include "mpm/exchange.hpp"
#include "mpm/hoop.hpp"
#include "mpm/interface.hpp"
#include "mpm/reaction.hpp"
#include "mpm/small_mass_nodes.hpp"

#include <atomic>

namespace berm::mpm {
namespace {

/// Surface of a body around a node: |sum V grad N|, zero inside. m2 (per metre run: m).
template <int dim>
Real surface_area(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index node)
{
  Vec<dim> area = Vec<dim>::Zero();
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index cell = mesh.entries[e] / (dim + 1), corner = mesh.entries[e] % (dim + 1);
    if (!(grid.moments[cell].volume > 0)) continue;
    area += with_metric(mesh, [&](auto metric) { return forces_of_pressure<metric()>(mesh, grid, cell)[corner]; });
  }
  return area.norm();
}

/// The surface in contact, for adhesion: that of the rigid body, in the plane; else that of the body around the nodes of the
/// points.
template <int dim>
void find_surface(const problem::Model<dim>& model, const problem::State<dim>& state, const Workspace<dim>& workspace,
                  const problem::Contact& contact, contact::ContactPoints<dim>& points)
{
  if (points.node_area.size() == 0) points.node_area = points.node_weight = NodeField<Real>::zeros(model.mesh.node_count());
  if constexpr (dim == 2)
    if (contact.rigid != none) {
      const bodies::RigidState<dim>& rigid = state.rigid_bodies[contact.rigid];
      const Real angle = rigid.orientation.angle;
      points.faces = workspace.grids[contact.body].cut.used() ? 4 : 1;
      if (points.faces > 1)
        for (contact::ContactPoint<dim>& point : points.list) point.face = contact::face_of(point.normal, angle);
      find_footprints(model.mesh, state.particles[contact.body], placed<dim>(model.rigid_bodies[contact.rigid], rigid), angle, points);
      return;
    }
  points.footprints.clear();
  points.footprints.reserve(points.list.capacity());
  const auto for_nodes = [&](const auto& visit) {
    for (const contact::ContactPoint<dim>& point : points.list)
      for (int n = 0; n < point.node_count; ++n) visit(point.nodes[n]);
  };
  for_nodes([&](Index node) { points.node_area[node] = 0; });
  for_nodes([&](Index node) {
    if (points.node_area[node] != 0) return;
    points.node_area[node] = 1;
    contact::Footprint<dim> footprint;
    footprint.nodes[0] = node;
    footprint.weights[0] = 1;
    points.footprints.push_back(footprint);
  });
  for_each("contact: surface", static_cast<Index>(points.footprints.size()), [&](Index k) {
    contact::Footprint<dim>& footprint = points.footprints[k];
    footprint.area = surface_area(model.mesh, workspace.grids[contact.body], footprint.nodes[0]);
  });
  Ranks& ranks = Ranks::of_run();
  ranks.share<Real>(
      static_cast<Index>(points.footprints.size()), [&](Index k) { return ranks.owner_of_node(points.footprints[k].nodes[0]); },
      [&](Index k, Real& area) { area = points.footprints[k].area; }, [&](Index k, Real area) { points.footprints[k].area = area; });
}

/// What impulses do to the nodes of the points of one contact, and effective masses. In a direction that a support fixes, a node has infinite mass.
template <int dim>
void set_responses(const problem::Model<dim>& model, const problem::State<dim>& state, const Workspace<dim>& workspace,
                   const problem::Contact& contact, contact::ContactPoints<dim>& points)
{
  constexpr Real immovable = 1e-4;  // of the compliance of a point without supports
  contact::for_each_point(points, [&](contact::ContactPoint<dim>& point) {
    Real free = 0;
    Vec<dim> compliance = Vec<dim>::Zero();
    const auto response = [&](Index b, Index node, Real N) {
      const Real m = workspace.grids[b].mass[node], unit = m > 0 ? N / m : 0;
      const Vec<dim> of_node = boundary::without_fixed<dim>(workspace.grids[b].held_directions(model), node, Vec<dim>::Constant(unit));
      free += N * unit;
      compliance += N * of_node;
      return of_node;
    };
    for (int k = 0; k < point.node_count; ++k) point.response.col(k) = response(contact.body, point.nodes[k], point.weights[k]);
    if (contact.other_body != none) point.response_of_other = response(contact.other_body, point.nodes[0], 1);
    if (contact.rigid != none)
      point.surface_velocity = velocity_at(model.rigid_bodies[contact.rigid], state.rigid_bodies[contact.rigid], point.position);
    const Real along_normal = compliance.dot(point.normal.cwiseAbs2());
    const Real along_surface = dim == 2 ? compliance.sum() - along_normal : compliance.maxCoeff();
    point.mass = {};
    if (!(along_normal > immovable * free)) return;
    point.mass.normal = 1 / along_normal;
    if (along_surface > immovable * free || !rules_of(contact.scheme).tied)
      point.mass.along = 1 / std::max(along_surface, immovable * free);
  });
}

/// Gives the nodes of a point an impulse, and those of the other body the opposite. Supports take the components in fixed
/// directions.
template <int dim, class Field>
void push(Workspace<dim>& workspace, const problem::Contact& contact, const contact::ContactPoint<dim>& point, const Vec<dim>& impulse,
          const Field& field)
{
  BodyGrid<dim>& grid = workspace.grids[contact.body];
  for (int n = 0; n < point.node_count; ++n) field.change(grid, point.nodes[n], point.response.col(n).cwiseProduct(impulse));
  if (contact.other_body != none)
    field.change(workspace.grids[contact.other_body], point.nodes[0], -point.response_of_other.cwiseProduct(impulse));
}

/// One step of the Gauss-Seidel iteration at a point; adds to the sums.
template <int dim, class Field>
void correct_point(const problem::State<dim>& state, Workspace<dim>& workspace, const problem::Contact& contact, const Field& field,
                   contact::ContactPoint<dim>& point, typename contact::ContactPoints<dim>::SweepSums& sums)
{
  const bool tied = rules_of(contact.scheme).tied;
  if (!(point.mass.normal > 0) || (tied && point.gap > 0)) return;
  const Vec<dim> relative = relative_velocity(workspace, contact, point, field);
  const Real allowed_approach = std::max(Real(0), point.gap) / (contact.gap_closing_steps * state.default_dt);
  const Real adhesion = contact.adhesion_law.differs() ? point.adhesion : contact.adhesion;
  const contact::Interface interface = {.friction = contact.adhesion_law.by_soil.empty() ? contact.friction : point.friction,
                                        .adhesion_impulse = adhesion * point.area * state.dt,
                                        .allowed_approach = allowed_approach,
                                        .tied = tied,
                                        .tension_impulse = most_tension(contact, point, state.dt),
                                        .water_fraction = point.water_fraction,
                                        .suction_impulse = std::max(Real(0), -point.pore_pressure) * point.area * state.dt};
  const bool bilateral = !Field::is_force && rules_of(contact.scheme).completes && point.status != contact::ContactStatus::open;
  const Vec<dim> impulse = bilateral ? bilateral_impulse<dim>(relative, point.normal, point.mass, interface, point.status, point.impulse)
                                     : contact_impulse<dim>(relative, point.normal, point.mass, interface, point.impulse);
  if (Field::is_force) point.status = status_of<dim>(impulse, point.normal, interface);
  const Vec<dim> change = impulse - point.impulse;
  point.impulse = impulse;
  push(workspace, contact, point, change, field);
  sums.changed += change.norm();
  sums.carried += impulse.norm();
}

/// One Gauss-Seidel sweep over the points of a contact, by all threads of the parallel region that it is called in. Returns to each of them the sum of the
/// changes of the impulses over the sum of the impulses; 0 where they carry none.
template <int dim, class Field>
Real sweep(const problem::Model<dim>& model, const problem::State<dim>& state, Workspace<dim>& workspace, Index k, const Field& field,
           int number)
{
  const problem::Contact& contact = model.contacts[k];
  contact::ContactPoints<dim>& points = workspace.contact_points[k];
  if (contact.needs_areas()) {
#pragma omp single
    share_surface(points);
  }
  // A thread may still add up the sums of one sweep while others are in the next, but not in the one behind that.
  const int slot = number % 2;
  contact::for_each_strip(points, [&](Index s) {
    typename contact::ContactPoints<dim>::SweepSums sums;
    for (Index p = points.strip_begin[s]; p < points.strip_begin[s + 1]; ++p)
      correct_point(state, workspace, contact, field, points.list[p], sums);
    points.sweep_sums[s][slot] = sums;
  });
  Real changed = 0, carried = 0;
  for (std::size_t s = 0; s + 1 < points.strip_begin.size(); ++s)
    if (points.strip_begin[s] != points.strip_begin[s + 1]) {
      changed += points.sweep_sums[s][slot].changed;
      carried += points.sweep_sums[s][slot].carried;
    }
  return carried > 0 ? changed / carried : 0;
}

/// Impulses at all points of the contacts that take part, by projected Gauss-Seidel sweeps until convergence.
template <int dim, class Field, class TakesPart>
void solve(const problem::Model<dim>& model, const problem::State<dim>& state, Workspace<dim>& workspace, const Field& field,
           const TakesPart& takes_part)
{
  constexpr int max_sweeps = 20;
  constexpr Real tolerance = 1e-3;  // relative to the sum of all impulses
  const int sweeps = workspace.contacts_share_nodes ? max_sweeps : 1;
  Index count = 0;
  for (std::size_t k = 0; k < model.contacts.size(); ++k)
    if (takes_part(model.contacts[k])) count += static_cast<Index>(workspace.contact_points[k].list.size());
  if (count == 0) return;
#pragma omp parallel if (count >= contact::min_points_for_threads)
  for (int n = 0; n < sweeps; ++n) {
    Real changed = 0;
    for (Index k = 0; k < static_cast<Index>(model.contacts.size()); ++k)
      if (takes_part(model.contacts[k])) changed = std::max(changed, sweep(model, state, workspace, k, field, n));
    if (changed <= tolerance) break;
  }
}

/// Update stress last at the nodes in contact: the velocity of step 4 moves and strains the particles, too. A node with
/// little mass keeps the re-mapped velocity: its acceleration is large and not representative of the particles around it.
template <int dim>
void move_with_predicted(const problem::Model<dim>& model, const problem::State<dim>& state, Workspace<dim>& workspace, Index k)
{
  const problem::Contact& contact = model.contacts[k];
  const auto use = [&](Index b, Index node) {
    BodyGrid<dim>& grid = workspace.grids[b];
    Real volume = 0;
    for (Index e = model.mesh.first_entry[node]; e < model.mesh.first_entry[node + 1]; ++e)
      volume += model.mesh.volume(model.mesh.entries[e] / (dim + 1));
    if (grid.mass[node] > small_mass_fraction * model.bodies[b].waves.min_density * volume / (dim + 1))
      grid.mapped_velocity[node] = grid.velocity[node] + state.dt * grid.acceleration[node];
  };
  contact::for_each_point(workspace.contact_points[k], [&](const contact::ContactPoint<dim>& point) {
    if (!point.touching) return;
    for (int n = 0; n < point.node_count; ++n) use(contact.body, point.nodes[n]);
    if (contact.other_body != none) use(contact.other_body, point.nodes[0]);
  });
}

}  // namespace

template <int dim>
void find_contacts(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace)
{
  const Index contacts = static_cast<Index>(model.contacts.size());
  const auto mark = [&](Index k, std::uint8_t touching, std::uint8_t points) {
    const problem::Contact& contact = model.contacts[k];
    contact::for_each_point(workspace.contact_points[k], [&](const contact::ContactPoint<dim>& point) {
      for (int n = 0; n < point.node_count; ++n)
        for (Index b : {contact.body, contact.other_body}) {
          if (b == none) continue;
          BodyGrid<dim>& grid = workspace.grids[b];
          const Index node = point.nodes[n];
          if (points != 0 && grid.contact_points[node] != 0)
            std::atomic_ref<bool>(workspace.contacts_share_nodes).store(true, std::memory_order_relaxed);
          grid.contact_points[node] = points;
          if (touching == 0 || point.touching) grid.touching[node] = touching;
        }
    });
  };
  for (Index k = 0; k < contacts; ++k) mark(k, 0, 0);
  workspace.contacts_share_nodes = false;
  for (Index k = 0; k < contacts; ++k) {
    const problem::Contact& contact = model.contacts[k];
    BodyGrid<dim>& grid = workspace.grids[contact.body];
    contact::ContactPoints<dim>& points = workspace.contact_points[k];
    if (contact.rigid != none) {
      detect<dim>(model.mesh, state.particles[contact.body], model.rigid_bodies[contact.rigid], state.rigid_bodies[contact.rigid],
                  state.listed_poses[contact.rigid], contact.detection, contact.particle_rim, grid.mass, points);
    } else {
      const BodyGrid<dim>& other = workspace.grids[contact.other_body];
      const BorrowedParticles<dim> borrowed(model.mesh, state.particles, workspace.grids, contact.body, contact.other_body);
      detect<dim>(model.mesh, {state.particles[contact.body], grid.mass, grid.nodes},
                  {state.particles[contact.other_body], other.mass, other.nodes}, contact.detection, points);
    }
    points.sweep_sums.resize(points.strip_begin.size());
    points.shared_out = false;
  }
  list_contact_nodes(model, workspace);
  exchange_at_contacts(workspace, &BodyGrid<dim>::mass);
  exchange_at_contacts(workspace, &BodyGrid<dim>::velocity);
  for (Index k = 0; k < contacts; ++k) {
    const problem::Contact& contact = model.contacts[k];
    contact::ContactPoints<dim>& points = workspace.contact_points[k];
    set_responses(model, state, workspace, contact, points);
    recall(model, state, contact, points);
    if (contact.needs_areas()) find_surface(model, state, workspace, contact, points);
    mark(k, 1, 1);
  }
}

namespace {

/// Moves particles whose centres are in a rigid body out of it, at a speed proportional to their depth but at most a
/// thousandth of that of a pressure wave. Their own velocities do not change.
template <int dim>
void push_out(const problem::Model<dim>& model, const problem::State<dim>& state, Workspace<dim>& workspace)
{
  constexpr Real of_wave = 1e-3;
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    const problem::Contact& contact = model.contacts[k];
    if (contact.rigid == none || !(workspace.contact_points[k].nearest_particle < 0)) continue;
    const Real max = of_wave * model.bodies[contact.body].waves.slowest;
    contact::for_each_point(workspace.contact_points[k], [&](const contact::ContactPoint<dim>& point) {
      if (!(point.distance < 0) || !(point.mass.normal > 0)) return;
      const Real wanted = std::min(-point.distance / (contact.gap_closing_steps * state.default_dt), max);
      const Real lacking = wanted - relative_velocity(workspace, contact, point, Moved<dim>{}).dot(point.normal);
      if (lacking > 0) push(workspace, contact, point, Vec<dim>(point.mass.normal * lacking * point.normal), Moved<dim>{});
    });
  }
}

}  // namespace

template <int dim>
void correct_accelerations(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace)
{
  const Timer timer("contact: step 4");
  for (contact::ContactPoints<dim>& points : workspace.contact_points)
    contact::for_each_point(points, [](contact::ContactPoint<dim>& point) { point.impulse.setZero(); });
  solve(model, state, workspace, Predicted<dim>{state.dt}, [](const problem::Contact&) { return true; });
  if (model.update_stress_first) react(model, state, workspace);
}

template <int dim>
void correct_velocities(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace)
{
  const Timer timer("contact: step 8");
  for (std::size_t k = 0; k < model.contacts.size(); ++k)
    if (rules_of(model.contacts[k].scheme).moves_with_predicted) move_with_predicted(model, state, workspace, static_cast<Index>(k));

  const auto note_second = [&](const auto& takes_part, Real sign) {
    for (std::size_t k = 0; k < model.contacts.size(); ++k) {
      const problem::Contact& contact = model.contacts[k];
      if (contact.rigid == none || !takes_part(contact)) continue;
      state.ledger.contact_sums[contact.rigid].second_impulse += sign * impulse_of(workspace.contact_points[k]);
    }
  };
  const auto completes = [](const problem::Contact& contact) {
    return rules_of(contact.scheme).completes && contact.detection == contact::Detection::particle;
  };
  const auto corrects = [&](const problem::Contact& contact) {
    return !completes(contact) && rules_of(contact.scheme).corrects_velocities;
  };
  if (!model.update_stress_first) {
    note_second(completes, -1);
    solve(model, state, workspace, MovedWithParticles<dim>{state.dt}, completes);
    note_second(completes, 1);
    react(model, state, workspace);
  }
  for (std::size_t k = 0; k < model.contacts.size(); ++k)
    if (corrects(model.contacts[k]))
      contact::for_each_point(workspace.contact_points[k], [](contact::ContactPoint<dim>& point) { point.impulse.setZero(); });
  solve(model, state, workspace, Moved<dim>{}, corrects);
  note_second(corrects, 1);
  if (!model.update_stress_first) push_out(model, state, workspace);
  remember(model, state, workspace);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void find_contacts(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&);                                          \
  template void correct_accelerations(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&);                                  \
  template void correct_velocities(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
