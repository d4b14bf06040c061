// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/move.hpp"

#include "mpm/body_laws.hpp"
#include "mpm/diagnose.hpp"
#include "mpm/moments.hpp"
#include "mpm/move_by_law.hpp"
#include "mpm/particle_motion.hpp"

namespace berm::mpm {
namespace {

template <int dim>
void pass_over_particles(Real motion, const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body)
{
  const BodyLaws& all = *workspace.laws[body];
  const auto by_law = [&]<class Law>(const Law&) {
    const SoilOf<Law> soil{all.laws,    all.laws_without_dilation, all.first_of_cell,        all.volume_rules,
                           all.dilates, all.local_strength,        all.material_index_offset};
    move_by_law<dim>(soil, motion, model, state, workspace, body);
  };
  std::visit(by_law, all.prepared.front());
}

}  // namespace

template <int dim>
void move_and_strain(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body)
{
  pass_over_particles(state.dt, model, state, workspace, body);
}

template <int dim>
void strain_particles(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body)
{
  const BodyGrid<dim>& grid = workspace.grids[body];
  const Real velocities =
      sum_of<Real>("velocities that strain", grid.chunks, [&](Index n) { return Real(grid.mapped_velocity[grid.nodes[n]].sum()); });
  if (!std::isfinite(velocities)) throw_not_finite(model, state, body);
  pass_over_particles(0, model, state, workspace, body);
}

template <int dim>
void move_particles(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  BodyGrid<dim>& grid = workspace.grids[body];
  bodies::Particles<dim>& particles = state.particles[body];
  for (auto& list : workspace.cell_changes) list.clear();
  const auto move_in_cell = [&](Index c) {
    const Index cell = particles.active()[c];
    const auto& nodes = mesh.nodes[cell];
    const mesh::Shape<dim> shape = grid.shape(mesh, cell);
    const LinearField<dim> gain(shape.gradients, velocity_gain(at_corners(nodes, grid.acceleration), nodes, grid, state.dt, {})),
        velocity(shape.gradients, at_corners(nodes, grid.mapped_velocity));
    particles.parts(cell, [&](const auto& part) {
      using V = typename std::decay_t<decltype(part)>::Vector;
      bodies::Block<dim>&p = particles.block(part.block), &q = particles.block(part.other);
      const V min_shape = move_part<V>(part, p, q, shape, gain, velocity, state.dt, 1);
      note_cell_changes(part, min_shape, mesh, workspace, cell, p, q);
    });
    sum_moments_of(mesh, particles, cell, grid);
  };
  for_each("move particles", particles.active_chunks(), move_in_cell);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void move_and_strain(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&, Index);                                 \
  template void strain_particles(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&, Index);                                \
  template void move_particles(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&, Index);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
