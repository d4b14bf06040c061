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

/// The velocity of a node as its supports leave it: none in the directions that they fix, or that of their motion.
template <int dim>
Vec<dim> held_velocity(const problem::Model<dim>& model, const NodeField<std::uint8_t>& fixed, const std::vector<Vec<dim>>& motions,
                       Index stage, Index node, const Vec<dim>& v)
{
  Vec<dim> held = boundary::without_fixed<dim>(fixed, node, v);
  if (model.moved.empty() || model.moved[stage].empty()) return held;
  const boundary::Holders<dim>& moved = model.moved[stage][node];
  for (int d = 0; d < dim; ++d)
    if (moved[d] != none) held[d] = motions[moved[d]][d];
  return held;
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
    for (int k = 0; k <= dim; ++k) store<dim>((1 - filter.part) * components<dim>(t.momentum[k]) + gained[k], corners[k].sum);
  });
}

template <int dim>
void move_supports(const problem::Model<dim>& model, const problem::State<dim>& state, Workspace<dim>& workspace)
{
  const Real since = state.time - state.stage.begin_time;
  for (std::size_t m = 0; m < model.motions.size(); ++m) {
    workspace.motion_before[m] = velocity_of(model.motions[m], state.stage, since);
    workspace.motion_after[m] = velocity_of(model.motions[m], state.stage, since + state.dt);
  }
}

template <int dim>
void gather_new_velocities(const problem::Model<dim>& model, const std::vector<Vec<dim>>& motions, Index stage, BodyGrid<dim>& grid)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  const NodeField<std::uint8_t>& fixed = grid.supports(model);
  for_each("gather new velocities", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    const auto momentum_of = [&](Index cell) {
      Vec<dim> sum = Vec<dim>::Zero();
      for (const CornerSums<dim>& corner : grid.corners[cell]) sum += Eigen::Map<const Vec<dim>>(corner.sum);
      return sum;
    };
    grid.mapped_velocity[i] = held_velocity(model, fixed, motions, stage, i,
                                            grid.mass[i] > 0 ? vector_of<dim>(gathered(mesh, grid, i) / grid.mass[i])
                                                             : velocity_of_cells(mesh, grid, i, momentum_of));
  });
}

template <int dim>
void predict_velocities(const problem::Model<dim>& model, Real ahead, const std::vector<Vec<dim>>& motions, Index stage,
                        BodyGrid<dim>& grid)
{
  const NodeField<std::uint8_t>& fixed = grid.supports(model);
  for_each("predict velocities", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    const auto momentum_of = [&](Index cell) { return vector_of<dim>(grid.moments[cell].total_momentum()); };
    grid.mapped_velocity[i] = held_velocity(model, fixed, motions, stage, i,
                                            grid.mass[i] > 0 ? Vec<dim>(grid.velocity[i] + ahead * grid.acceleration[i])
                                                             : velocity_of_cells(model.mesh, grid, i, momentum_of));
  });
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void smooth_velocities(const mesh::Mesh<dim>&, BodyGrid<dim>&);                                                                 \
  template void spread_new_momentum(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, Real, BodyGrid<dim>&);                          \
  template void move_supports(const problem::Model<dim>&, const problem::State<dim>&, Workspace<dim>&);                                    \
  template void gather_new_velocities(const problem::Model<dim>&, const std::vector<Vec<dim>>&, Index, BodyGrid<dim>&);                    \
  template void predict_velocities(const problem::Model<dim>&, Real, const std::vector<Vec<dim>>&, Index, BodyGrid<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
