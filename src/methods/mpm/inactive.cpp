// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/inactive_cells.cpp
#include "mpm/inactive.hpp"

#include "mpm/moments.hpp"

namespace berm::mpm {
namespace {

/// What a rigid body goes before the active soil is found anew, over the active distance.
constexpr Real fraction_of_distance = 0.1;

/// Whether soil may be inactive far from this body: around one without bounds none is far.
template <int dim>
bool is_bounded(const bodies::RigidBody<dim>& rigid)
{
  return bodies::is_bounded<dim>(rigid.shape);
}

/// The largest distance that a point of a bounded rigid body has gone since the active soil was found, m: at most.
template <int dim>
Real gone_since(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  const problem::ActiveSoil<dim>& active = state.active_soil;
  Real farthest = 0;
  for (std::size_t r = 0; r < model.rigid_bodies.size(); ++r)
    if (is_bounded(model.rigid_bodies[r]))
      farthest = std::max(farthest, distance_between<dim>(model.rigid_bodies[r], active.poses[r], state.rigid_bodies[r]));
  return farthest;
}

/// 1 for each cell of a patch that has no centroid within the active distance of a bounded rigid body, as these were when the active soil was found.
template <int dim>
CellField<std::uint8_t> far_cells(const problem::Model<dim>& model, const problem::ActiveSoil<dim>& active)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  const Real distance = *model.mpm.active_distance;
  std::vector<bodies::RigidShape<dim>> shapes;
  for (std::size_t r = 0; r < model.rigid_bodies.size(); ++r)
    if (is_bounded(model.rigid_bodies[r])) shapes.push_back(placed(model.rigid_bodies[r], active.poses[r]));
  auto is_far = CellField<std::uint8_t>::zeros(mesh.cell_count());
  for_each("inactive cells", mesh.cell_count(), [&](Index cell) {
    const Vec<dim> center = mesh.centroid(cell);
    is_far[cell] =
        std::all_of(shapes.begin(), shapes.end(), [&](const auto& shape) { return !(surface_at<dim>(shape, center).distance < distance); })
            ? 1
            : 0;
  });
  auto far_patches = CellField<std::uint8_t>::zeros(mesh.cell_count());
  for_each("inactive cells", mesh.cell_count(), [&](Index cell) {
    bool all = true;
    mesh::for_each_in_patch(model.patches, cell, [&](Index member) { all = all && is_far[member] != 0; });
    far_patches[cell] = all ? 1 : 0;
  });
  return far_patches;
}

template <int dim>
struct Stopped {
  Vec<dim> momentum = Vec<dim>::Zero();
  Real kinetic = 0;

  Stopped& operator+=(const Stopped& other)
  {
    momentum += other.momentum;
    kinetic += other.kinetic;
    return *this;
  }
};

/// Takes the velocity of all particles in inactive cells.
template <int dim>
Stopped<dim> stop(bodies::Particles<dim>& particles)
{
  return sum_of<Stopped<dim>>("inactive cells", particles.chunks(), [&](Index c) {
    Stopped<dim> stopped;
    const Index cell = particles.occupied()[c];
    if (!particles.is_inactive(cell)) return stopped;
    for (const auto& [p, b, count] : particles.blocks_in(cell)) {
      for (int d = 0; d < dim; ++d) {
        stopped.momentum[d] += sum(p.mass * p.v[d]);
        stopped.kinetic += 0.5 * sum(p.mass * p.v[d] * p.v[d]);
        p.v[d] = Lanes{};
      }
    }
    return stopped;
  });
}

}  // namespace

template <int dim>
void set_inactive_cells(const problem::Model<dim>& model, problem::State<dim>& state)
{
  if (!model.mpm.active_distance) return;
  std::shared_ptr<const CellField<std::uint8_t>> inactive;
  if (!state.active_soil.everywhere) inactive = std::make_shared<CellField<std::uint8_t>>(far_cells(model, state.active_soil));
  for (bodies::Particles<dim>& particles : state.particles) particles.set_inactive(inactive);
}

template <int dim>
void update_inactive_cells(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace)
{
  if (!model.mpm.active_distance) return;
  problem::ActiveSoil<dim>& active = state.active_soil;
  const bool everywhere = model.driven[static_cast<std::size_t>(state.stage.index)] == none;
  if (everywhere == active.everywhere && (everywhere || !(gone_since(model, state) > fraction_of_distance * *model.mpm.active_distance)))
    return;
  active.everywhere = everywhere;
  active.poses.assign(state.rigid_bodies.begin(), state.rigid_bodies.end());
  set_inactive_cells(model, state);
  for (std::size_t b = 0; b < state.particles.size(); ++b) {
    bodies::Particles<dim>& particles = state.particles[b];
    BodyGrid<dim>& grid = workspace.grids[b];
    const Stopped<dim> stopped = particles.some_inactive() ? stop(particles) : Stopped<dim>();
    state.ledger.totals.support_impulse -= stopped.momentum;
    state.ledger.totals.damping += stopped.kinetic;
    active.stopped += stopped.kinetic;
    sum_moments(model.mesh, particles, grid);
    find_nodes(model.mesh, particles, grid);
    grid.held_with = none;
  }
}

template <int dim>
void hold_inactive_cells(const problem::Model<dim>& model, const problem::State<dim>& state, Workspace<dim>& workspace)
{
  if (!model.mpm.active_distance) return;
  constexpr std::uint8_t all_directions = (1 << dim) - 1;
  for (std::size_t b = 0; b < state.particles.size(); ++b) {
    const bodies::Particles<dim>& particles = state.particles[b];
    BodyGrid<dim>& grid = workspace.grids[b];
    if (!particles.some_inactive()) {
      grid.held = {};
      grid.held_with = none;
      continue;
    }
    if (grid.held_with == grid.table) continue;
    grid.held = grid.conditions(model).held;
    grid.held_with = grid.table;
    for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
      if (particles.is_inactive(cell))
        for (const Index node : model.mesh.nodes[cell]) grid.held[node] = all_directions;
  }
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void set_inactive_cells(const problem::Model<dim>&, problem::State<dim>&);                                                      \
  template void update_inactive_cells(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&);                                  \
  template void hold_inactive_cells(const problem::Model<dim>&, const problem::State<dim>&, Workspace<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
