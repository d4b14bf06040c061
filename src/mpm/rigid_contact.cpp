// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/rigid_contact.hpp"

#include "contact/friction.hpp"
#include "core/timer.hpp"
#include "problem/stages.hpp"

namespace berm {
namespace {

/// The surface that a body has around a node: |sum V grad N|, which vanishes inside. m2 (per metre run: m).
template <int dim>
Real surface_area(const Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index node)
{
  Vec<dim> gradient = Vec<dim>::Zero();
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index cell = mesh.entries[e] / (dim + 1), corner = mesh.entries[e] % (dim + 1);
    gradient += grid.corner_sums[mesh.entries[e]].volume * mesh.shape[cell].gradient(corner);
  }
  return gradient.norm();
}

/// The change of velocity of one contact node; held directions do not change.
template <int dim>
Vec<dim> correction(const Model<dim>& model, const BodyGrid<dim>& grid, const Contact& contact, const ContactNode<dim>& c,
                    const Vec<dim>& relative, Real dt)
{
  const Real period = contact.approach_steps * dt;
  const Real adhesion = contact.adhesion > 0 ? contact.adhesion * surface_area(model.mesh, grid, c.node) * dt / grid.mass[c.node] : 0;
  Vec<dim> change = contact_correction<dim>(relative, c.normal, {contact.friction, adhesion, std::max(Real(0), c.gap) / period});
  for (int d = 0; d < dim; ++d)
    if (model.fixed[c.node] >> d & 1) change[d] = 0;
  return change;
}

}  // namespace

template <int dim>
void find_contacts(const Model<dim>& model, State<dim>& state, Work<dim>& work)
{
  for (std::size_t k = 0; k < model.contacts.size(); ++k)
    for (const ContactNode<dim>& c : work.contact_nodes[k].list) work.grids[model.contacts[k].body].touching[c.node] = 0;
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    const Contact& contact = model.contacts[k];
    BodyGrid<dim>& grid = work.grids[contact.body];
    detect(model.mesh, state.particles[contact.body], model.rigids[contact.rigid], state.rigids[contact.rigid], contact.detection,
           grid.mass, work.contact_nodes[k]);
    for (const ContactNode<dim>& c : work.contact_nodes[k].list)
      if (c.touching) grid.touching[c.node] = 1;
    RigidState<dim>& rigid = state.rigids[contact.rigid];
    rigid.deepest = std::max(rigid.deepest, -work.contact_nodes[k].nearest_particle);
  }
}

template <int dim>
void correct_accelerations(const Model<dim>& model, State<dim>& state, Work<dim>& work)
{
  const Timer timer("contact: step 4");
  const Real dt = state.dt;
  const Vec<dim> gravity = gravity_now(model, state.time);
  for (RigidState<dim>& rigid : state.rigids) rigid.reaction.setZero();
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    const Contact& contact = model.contacts[k];
    BodyGrid<dim>& grid = work.grids[contact.body];
    RigidState<dim>& rigid = state.rigids[contact.rigid];
    for (const ContactNode<dim>& c : work.contact_nodes[k].list) {
      const Vec<dim> relative = grid.velocity[c.node] + dt * grid.acceleration[c.node] - rigid.velocity;
      const Vec<dim> change = correction(model, grid, contact, c, relative, dt);
      grid.acceleration[c.node] += change / dt;
      const Vec<dim> impulse = grid.mass[c.node] * change;
      rigid.reaction -= impulse / dt;
      rigid.impulse += impulse;
      if (c.distance < infinity) {
        rigid.pressed += impulse.norm();
        rigid.pressed_distance += impulse.norm() * c.distance;
      }
      state.totals.contact_impulse += impulse;
      // The change also moves the mid velocity with which gravity was taken to work.
      state.totals.external += impulse.dot(rigid.velocity) + 0.5 * dt * gravity.dot(impulse);
      const Vec<dim> mid_velocity = grid.velocity[c.node] + 0.5 * dt * grid.acceleration[c.node];
      state.totals.friction -= impulse.dot(mid_velocity - rigid.velocity);
    }
  }
}

template <int dim>
void correct_velocities(const Model<dim>& model, State<dim>& state, Work<dim>& work)
{
  const Timer timer("contact: step 8");
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    const Contact& contact = model.contacts[k];
    if (contact.scheme == Scheme::once) continue;
    BodyGrid<dim>& grid = work.grids[contact.body];
    RigidState<dim>& rigid = state.rigids[contact.rigid];
    for (const ContactNode<dim>& c : work.contact_nodes[k].list) {
      const Vec<dim> change = correction(model, grid, contact, c, Vec<dim>(grid.moved_velocity[c.node] - rigid.velocity), state.dt);
      grid.moved_velocity[c.node] += change;
      rigid.second_impulse += grid.mass[c.node] * change;
    }
  }
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
