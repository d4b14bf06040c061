// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/contact.hpp"

#include "contact/contact_law.hpp"
#include "core/timer.hpp"
#include "problem/stages.hpp"

namespace berm {
namespace {

/// Sweeps over the contact points where some of them move the same nodes; one sweep is exact where none do.
constexpr int most_sweeps = 10;

/// The surface that a body has around a node: |sum V grad N|, which vanishes inside. m2 (per metre run: m).
template <int dim>
Real surface_area(const Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index node)
{
  Vec<dim> gradient = Vec<dim>::Zero();
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index cell = mesh.entries[e] / (dim + 1), corner = mesh.entries[e] % (dim + 1);
    gradient += grid.moments[cell].volume * grid.shape(mesh, cell).gradient(corner);
  }
  return gradient.norm();
}

/// Area and effective mass of the points of one contact.
template <int dim>
void weigh(const Model<dim>& model, const Work<dim>& work, const Contact& contact, ContactPoints<dim>& points)
{
  const BodyGrid<dim>& grid = work.grids[contact.body];
  for (ContactPoint<dim>& point : points.list) {
    Real per_mass = 0;
    for (int k = 0; k < point.node_count; ++k) {
      const Real m = grid.mass[point.nodes[k]];
      if (m > 0) per_mass += point.weights[k] * point.weights[k] / m;
      if (contact.adhesion > 0) point.area += point.weights[k] * surface_area(model.mesh, grid, point.nodes[k]);
    }
    if (contact.other_body != none) per_mass += 1 / work.grids[contact.other_body].mass[point.nodes[0]];
    point.mass = per_mass > 0 ? 1 / per_mass : 0;
  }
}

/// What one correction works on: the nodal velocity that has to keep to the law, and how a change of it is kept.
template <int dim>
struct Predicted {  ///< step 4: v + dt a
  static constexpr bool is_force = true;
  Real dt;
  Vec<dim> velocity(const BodyGrid<dim>& grid, Index node) const { return grid.velocity[node] + dt * grid.acceleration[node]; }
  void change(BodyGrid<dim>& grid, Index node, const Vec<dim>& by) const { grid.acceleration[node] += by / dt; }
};
template <int dim>
struct Moved {  ///< step 8: the velocity that moves the particles
  static constexpr bool is_force = false;
  Vec<dim> velocity(const BodyGrid<dim>& grid, Index node) const { return grid.moved_velocity[node]; }
  void change(BodyGrid<dim>& grid, Index node, const Vec<dim>& by) const { grid.moved_velocity[node] += by; }
};

/// The work of one contact in one correction: all its points once.
template <int dim, class Field>
void sweep(const Model<dim>& model, const State<dim>& state, Work<dim>& work, Index k, const Field& field)
{
  const Contact& contact = model.contacts[k];
  BodyGrid<dim>& grid = work.grids[contact.body];
  const Real period = contact.approach_steps * state.dt;
  for (ContactPoint<dim>& point : work.contact_points[k].list) {
    if (!(point.mass > 0)) continue;
    const bool sticky = contact.scheme == Scheme::sticky;
    if (sticky && point.gap > 0) continue;
    Vec<dim> relative = contact.rigid != none
                            ? Vec<dim>(-velocity_at(model.rigids[contact.rigid], state.rigids[contact.rigid], point.place))
                            : Vec<dim>(-field.velocity(work.grids[contact.other_body], point.nodes[0]));
    for (int n = 0; n < point.node_count; ++n) relative += point.weights[n] * field.velocity(grid, point.nodes[n]);
    const Real allowed_approach = std::max(Real(0), point.gap) / period;
    const Interface interface = {contact.friction, contact.adhesion * point.area * state.dt, allowed_approach, sticky};
    const bool holds = !Field::is_force && contact.scheme == Scheme::two_sided && point.grip != Grip::open;
    const Vec<dim> impulse = holds ? holding_impulse<dim>(relative, point.normal, point.mass, interface, point.grip, point.impulse)
                                   : contact_impulse<dim>(relative, point.normal, point.mass, interface, point.impulse);
    if (Field::is_force) point.grip = grip_of<dim>(impulse, point.normal, interface);
    const Vec<dim> change = impulse - point.impulse;
    point.impulse = impulse;
    for (int n = 0; n < point.node_count; ++n) {
      const Index node = point.nodes[n];
      if (grid.mass[node] > 0)
        field.change(grid, node, without_held<dim>(model.fixed[grid.fixed], node, point.weights[n] / grid.mass[node] * change));
    }
    if (contact.other_body != none) {
      BodyGrid<dim>& other = work.grids[contact.other_body];
      field.change(other, point.nodes[0],
                   without_held<dim>(model.fixed[other.fixed], point.nodes[0], -change / other.mass[point.nodes[0]]));
    }
  }
}

/// Impulses at all points of the contacts that take part, by projected Gauss-Seidel sweeps.
template <int dim, class Field, class TakesPart>
void solve(const Model<dim>& model, const State<dim>& state, Work<dim>& work, const Field& field, const TakesPart& takes_part)
{
  for (ContactPoints<dim>& points : work.contact_points)
    for (ContactPoint<dim>& point : points.list) point.impulse.setZero();
  for (int n = 0; n < (work.contacts_share_nodes ? most_sweeps : 1); ++n)
    for (Index k = 0; k < static_cast<Index>(model.contacts.size()); ++k)
      if (takes_part(model.contacts[k])) sweep(model, state, work, k, field);
}

/// Update stress last at the nodes in contact: the velocity of step 4 moves and strains, too. A node with little mass keeps the re-mapped one:
/// its acceleration is large and says little of the particles around it.
template <int dim>
void move_with_predicted(const Model<dim>& model, const State<dim>& state, Work<dim>& work, Index k)
{
  constexpr Real little = 0.05;  // of the mass that the volume around a node gives it where particles fill its cells evenly
  const Contact& contact = model.contacts[k];
  const auto use = [&](Index b, Index node) {
    BodyGrid<dim>& grid = work.grids[b];
    Real volume = 0;
    for (Index e = model.mesh.first_entry[node]; e < model.mesh.first_entry[node + 1]; ++e)
      volume += model.mesh.volume(model.mesh.entries[e] / (dim + 1));
    if (grid.mass[node] > little * inertia_density(model.bodies[b].material) * volume / (dim + 1))
      grid.moved_velocity[node] = grid.velocity[node] + state.dt * grid.acceleration[node];
  };
  for (const ContactPoint<dim>& point : work.contact_points[k].list) {
    if (!point.touching) continue;
    for (int n = 0; n < point.node_count; ++n) use(contact.body, point.nodes[n]);
    if (contact.other_body != none) use(contact.other_body, point.nodes[0]);
  }
}

}  // namespace

template <int dim>
void find_contacts(const Model<dim>& model, State<dim>& state, Work<dim>& work)
{
  const Index contacts = static_cast<Index>(model.contacts.size());
  const auto mark = [&](Index k, std::uint8_t touching, std::uint8_t points) {
    const Contact& contact = model.contacts[k];
    for (const ContactPoint<dim>& point : work.contact_points[k].list)
      for (int n = 0; n < point.node_count; ++n)
        for (Index b : {contact.body, contact.other_body}) {
          if (b == none) continue;
          BodyGrid<dim>& grid = work.grids[b];
          const Index node = point.nodes[n];
          if (points != 0 && grid.contact_points[node] != 0) work.contacts_share_nodes = true;
          grid.contact_points[node] = points;
          if (touching == 0 || point.touching) grid.touching[node] = touching;
        }
  };
  for (Index k = 0; k < contacts; ++k) mark(k, 0, 0);
  work.contacts_share_nodes = false;
  for (Index k = 0; k < contacts; ++k) {
    const Contact& contact = model.contacts[k];
    const BodyGrid<dim>& grid = work.grids[contact.body];
    ContactPoints<dim>& points = work.contact_points[k];
    if (contact.rigid != none) {
      RigidState<dim>& rigid = state.rigids[contact.rigid];
      detect(model.mesh, state.particles[contact.body], model.rigids[contact.rigid], rigid, contact.detection, grid.mass, points);
      rigid.deepest = std::max(rigid.deepest, -points.nearest_particle);
    } else {
      const BodyGrid<dim>& other = work.grids[contact.other_body];
      detect<dim>(model.mesh, {state.particles[contact.body], grid.mass, grid.nodes},
                  {state.particles[contact.other_body], other.mass, other.nodes}, contact.detection, points);
    }
    weigh(model, work, contact, points);
    mark(k, 1, 1);
  }
}

template <int dim>
void correct_accelerations(const Model<dim>& model, State<dim>& state, Work<dim>& work)
{
  const Timer timer("contact: step 4");
  const Real dt = state.dt;
  const Vec<dim> gravity = gravity_now(model, state.time);
  solve(model, state, work, Predicted<dim>{dt}, [](const Contact&) { return true; });

  for (RigidState<dim>& rigid : state.rigids) rigid.reaction.setZero(), rigid.torque = 0;
  // Gives a node's share of an impulse to the totals: it also moves the mid velocity with which gravity and tractions were taken to work.
  const auto add = [&](Index b, Index node, const Vec<dim>& impulse, const Vec<dim>& partner_velocity) {
    const BodyGrid<dim>& grid = work.grids[b];
    state.totals.contact_impulse += impulse;
    state.totals.external += 0.5 * dt * model.bodies[b].weight_over_mass * gravity.dot(impulse);
    if (!model.load_points.empty() && grid.mass[node] > 0)
      state.totals.external += 0.5 * dt * grid.traction[node].dot(impulse) / grid.mass[node];
    const Vec<dim> mid_velocity = grid.velocity[node] + 0.5 * dt * grid.acceleration[node];
    state.totals.friction -= impulse.dot(mid_velocity - partner_velocity);
  };
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    const Contact& contact = model.contacts[k];
    for (const ContactPoint<dim>& point : work.contact_points[k].list) {
      if (point.impulse.isZero()) continue;
      if (contact.other_body != none) {
        const Index node = point.nodes[0];
        const Vec<dim> here = without_held<dim>(model.fixed[work.grids[contact.body].fixed], node, point.impulse);
        add(contact.body, node, here, Vec<dim>::Zero());
        add(contact.other_body, node, -here, Vec<dim>::Zero());
        state.pair_impulses[k] += here;
        continue;
      }
      RigidState<dim>& rigid = state.rigids[contact.rigid];
      const Vec<dim> surface_velocity = velocity_at(model.rigids[contact.rigid], rigid, point.place);
      Vec<dim> impulse = Vec<dim>::Zero();
      for (int n = 0; n < point.node_count; ++n) {
        const Vec<dim> of_node =
            without_held<dim>(model.fixed[work.grids[contact.body].fixed], point.nodes[n], point.weights[n] * point.impulse);
        add(contact.body, point.nodes[n], of_node, surface_velocity);
        impulse += of_node;
      }
      const Vec<dim> arm = point.place - center_now(model.rigids[contact.rigid], rigid);
      const Real turning = arm[0] * impulse[1] - arm[1] * impulse[0];
      rigid.reaction -= impulse / dt;
      rigid.torque -= turning / dt;
      rigid.impulse += impulse;
      rigid.torque_impulse += turning;
      if (point.distance < infinity) {
        rigid.pressed += impulse.norm();
        rigid.pressed_distance += impulse.norm() * point.distance;
      }
      state.totals.external += impulse.dot(surface_velocity);
    }
  }
}

template <int dim>
void correct_velocities(const Model<dim>& model, State<dim>& state, Work<dim>& work)
{
  const Timer timer("contact: step 8");
  for (std::size_t k = 0; k < model.contacts.size(); ++k)
    if (model.contacts[k].scheme == Scheme::hybrid) move_with_predicted(model, state, work, static_cast<Index>(k));
  solve(model, state, work, Moved<dim>{},
        [](const Contact& contact) { return contact.scheme != Scheme::once && contact.scheme != Scheme::hybrid; });
  for (std::size_t k = 0; k < model.contacts.size(); ++k)
    if (model.contacts[k].rigid != none)
      for (const ContactPoint<dim>& point : work.contact_points[k].list)
        state.rigids[model.contacts[k].rigid].second_impulse += point.impulse;
}

template <int dim>
void move_rigids(const Model<dim>& model, State<dim>& state)
{
  constexpr Real averaged_steps = 100;
  for (std::size_t r = 0; r < model.rigids.size(); ++r) {
    RigidState<dim>& rigid = state.rigids[r];
    rigid.displacement += state.dt * rigid.velocity;
    rigid.angle += state.dt * rigid.spin;
    rigid.smooth_reaction += (rigid.reaction - rigid.smooth_reaction) / averaged_steps;
  }
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void find_contacts(const Model<dim>&, State<dim>&, Work<dim>&);                                                                 \
  template void correct_accelerations(const Model<dim>&, State<dim>&, Work<dim>&);                                                         \
  template void correct_velocities(const Model<dim>&, State<dim>&, Work<dim>&);                                                            \
  template void move_rigids(const Model<dim>&, State<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm
