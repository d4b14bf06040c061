// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/velocities.hpp"

#include "mpm/linear_field.hpp"
#include "mpm/moments.hpp"
#include "problem/stages.hpp"

namespace berm::mpm {
namespace {

/// Mean velocity of all particles in a node's cells: for a node without mass, which then strains nothing in rigid motion.
/// momentum_of(cell) gives the momentum of a cell.
template <int dim, class MomentumOf>
Vec<dim> velocity_of_cells(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index node, const MomentumOf& momentum_of)
{
  Vec<dim> momentum = Vec<dim>::Zero();
  Real mass = 0;
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index cell = mesh.entries[e] / (dim + 1);
    mass += grid.moments[cell].total_mass();
    momentum += momentum_of(cell);
  }
  return mass > 0 ? Vec<dim>(momentum / mass) : Vec<dim>(Vec<dim>::Zero());
}

/// The velocity of a node as the conditions leave it: none in the directions that are held, or the one that is prescribed.
template <int dim>
Vec<dim> held_velocity(const NodeField<std::uint8_t>& held, const NodeField<boundary::Holders<dim>>& moved,
                       const std::vector<Vec<dim>>& motions, Index node, const Vec<dim>& v)
{
  Vec<dim> velocity = boundary::without_fixed<dim>(held, node, v);
  for (int d = 0; d < dim && !moved.empty(); ++d)
    if (const Index by = moved[node][d]; by != none) velocity[d] = motions[by][d];
  return velocity;
}

}  // namespace

template <int dim>
void smooth_velocities(const mesh::Mesh<dim>& mesh, BodyGrid<dim>& grid)
{
  if (!grid.filters()) return;
  for_each("smooth velocities", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    const Real mass = grid.mass[i];
    const Components<dim> momentum = gathered(mesh, grid, i);
    store<dim>(mass > 0 ? 2 * components(grid.velocity[i]) - momentum / mass : Components<dim>{}, grid.smooth_velocity[i]);
  });
}

template <int dim>
void spread_new_momentum(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid)
{
  const auto& active = particles.active();
  for_each("momentum after the forces", particles.active_chunks(), [&](Index c) {
    const Index cell = active[c];
    const Moments<dim>& t = grid.moments[cell];
    const auto& nodes = mesh.nodes[cell];
    const FilterOfCell<dim> filter = grid.filter_of(cell, dt);
    const AtCorners<dim> gained = momentum_with(t, velocity_gain(at_corners(nodes, grid.acceleration), nodes, grid, dt, filter));
    auto& corners = grid.corners[cell];
    for (int k = 0; k <= dim; ++k) store<dim>((1 - filter.fraction) * components<dim>(t.momentum[k]) + gained[k], corners[k].sum);
  });
}

template <int dim>
void prescribe_velocities(const problem::Model<dim>& model, const problem::State<dim>& state, Workspace<dim>& workspace)
{
  const Real since = state.time - state.stage.begin_time;
  for (std::size_t k = 0; k < model.conditions.rows.size(); ++k) {
    workspace.motion_before[k] = velocity_of(model.conditions.rows[k], state.stage, since);
    workspace.motion_after[k] = velocity_of(model.conditions.rows[k], state.stage, since + state.dt);
  }
}

template <int dim>
void gather_new_velocities(const problem::Model<dim>& model, const std::vector<Vec<dim>>& motions, BodyGrid<dim>& grid)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  const NodeField<std::uint8_t>& held = grid.held_directions(model);
  const NodeField<boundary::Holders<dim>>& moved = grid.conditions(model).moved;
  for_each("gather new velocities", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    const auto momentum_of = [&](Index cell) {
      Vec<dim> sum = Vec<dim>::Zero();
      for (const CornerSums<dim>& corner : grid.corners[cell]) sum += Eigen::Map<const Vec<dim>>(corner.sum);
      return sum;
    };
    grid.mapped_velocity[i] = held_velocity<dim>(held, moved, motions, i,
                                                 grid.mass[i] > 0 ? vector_of<dim>(gathered(mesh, grid, i) / grid.mass[i])
                                                                  : velocity_of_cells(mesh, grid, i, momentum_of));
  });
}

template <int dim>
void predict_velocities(const problem::Model<dim>& model, Real ahead, const std::vector<Vec<dim>>& motions, BodyGrid<dim>& grid)
{
  const NodeField<std::uint8_t>& held = grid.held_directions(model);
  const NodeField<boundary::Holders<dim>>& moved = grid.conditions(model).moved;
  for_each("predict velocities", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    const auto momentum_of = [&](Index cell) { return vector_of<dim>(grid.moments[cell].total_momentum()); };
    grid.mapped_velocity[i] = held_velocity<dim>(held, moved, motions, i,
                                                 grid.mass[i] > 0 ? Vec<dim>(grid.velocity[i] + ahead * grid.acceleration[i])
                                                                  : velocity_of_cells(model.mesh, grid, i, momentum_of));
  });
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void smooth_velocities(const mesh::Mesh<dim>&, BodyGrid<dim>&);                                                                 \
  template void spread_new_momentum(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, Real, BodyGrid<dim>&);                          \
  template void prescribe_velocities(const problem::Model<dim>&, const problem::State<dim>&, Workspace<dim>&);                             \
  template void gather_new_velocities(const problem::Model<dim>&, const std::vector<Vec<dim>>&, BodyGrid<dim>&);                           \
  template void predict_velocities(const problem::Model<dim>&, Real, const std::vector<Vec<dim>>&, BodyGrid<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
