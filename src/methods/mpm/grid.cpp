// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/moments_test.cpp
#include "mpm/grid.hpp"

#include "mpm/body_sums.hpp"
#include "mpm/moments.hpp"

#include <atomic>

namespace berm::mpm {

template <int dim>
BodyGrid<dim>::BodyGrid(const mesh::Mesh<dim>& mesh)
    : moments(CellField<Moments<dim>>::zeros(mesh.cell_count())),
      corners(CellField<std::array<CornerSums<dim>, dim + 1>>::zeros(mesh.cell_count())),
      hoop(CellField<HoopMoments>::zeros(mesh.metric == mesh::Metric::axisymmetric ? mesh.cell_count() : 0)),
      volume_change(CellField<VolumeChange>::zeros(mesh.cell_count())),
      viscous_stress(CellField<Real>::zeros(mesh.cell_count())),
      gradients(CellField<mesh::Gradients<dim>>::zeros(mesh.cell_count())),
      height(CellField<Real>::zeros(mesh.cell_count())),
      volume(CellField<Real>::zeros(mesh.cell_count())),
      mass(NodeField<Real>::zeros(mesh.node_count())),
      volume_around(NodeField<Real>::zeros(mesh.node_count())),
      fill(NodeField<Real>::zeros(mesh.node_count())),
      velocity(NodeField<Vec<dim>>::zeros(mesh.node_count())),
      smooth_velocity(NodeField<Vec<dim>>::zeros(mesh.node_count())),
      acceleration(NodeField<Vec<dim>>::zeros(mesh.node_count())),
      mapped_velocity(NodeField<Vec<dim>>::zeros(mesh.node_count())),
      traction(NodeField<Vec<dim>>::zeros(mesh.node_count())),
      touching(NodeField<std::uint8_t>::zeros(mesh.node_count())),
      contact_points(NodeField<std::uint8_t>::zeros(mesh.node_count()))
{
  nodes.reserve(mesh.node_count());
}

template <int dim>
void WaterGrid<dim>::make_room(const mesh::Mesh<dim>& mesh, const settings::BodySoil& soil)
{
  for (const material::Material& material : soil.materials) soils.push_back({hydraulics(material).value(), inertia_density(material)});
  cells = CellField<WaterCell>::zeros(mesh.cell_count());
  corners = CellField<std::array<WaterAtCorner<dim>, dim + 1>>::zeros(mesh.cell_count());
  pressure = CellField<Real>::zeros(mesh.cell_count());
  outflow = CellField<VolumeChange>::zeros(mesh.cell_count());
  nodes = NodeField<WaterAtNode<dim>>::zeros(mesh.node_count());
  soil_inertia = NodeField<Vec<dim>>::zeros(mesh.node_count());
  normal = NodeField<Vec<dim>>::zeros(mesh.node_count());
  impermeable = NodeField<ImpermeableFlux>::zeros(mesh.node_count());
}

template <int dim>
void BodyGrid<dim>::enter(const mesh::Mesh<dim>& mesh, Index cell)
{
  gradients[cell] = mesh.shape(cell).gradients;
  if (bulk_viscosity > 0 || filter_speed > 0) height[cell] = mesh.height(cell);
  if (!full_cells) return;
  for (Index node : mesh.nodes[cell])
    if (!(volume_around[node] > 0))
      for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
        const Index around = mesh.entries[e] / (dim + 1);
        volume[around] = mesh.volume(around);
        volume_around[node] += volume[around];
      }
}

template <int dim>
void find_nodes(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid)
{
  const std::vector<Index>& active = particles.active();
  for_each("change cells: nodes", grid.chunks, [&](Index k) { grid.mass[grid.nodes[k]] = 0; });
  for_each("change cells: nodes", particles.active_chunks(), [&](Index c) {
    for (Index node : mesh.nodes[active[c]]) std::atomic_ref<Real>(grid.mass[node]).store(1, std::memory_order_relaxed);
  });
  const Halo& halo = grid.halo;
  for (const Halo::Side& side : halo.sides)
    for (const Index cell : side.got)
      for (const Index node : mesh.nodes[cell])
        if (halo.is_complete[node] != 0 && !particles.is_inactive(cell)) grid.mass[node] = 1;
  for_each("change cells: nodes", grid.chunks, [&](Index k) {
    if (!(grid.mass[grid.nodes[k]] > 0)) grid.mapped_velocity[grid.nodes[k]].setZero();
  });
  select(
      "change cells: nodes", mesh.node_chunks,
      [&](Index node) { return grid.mass[node] > 0 && (!halo.divided() || halo.is_complete[node] != 0); }, grid.nodes, grid.chunks);
}

namespace {

/// Whether cells of a patch have one pressure, as they have one dilation: where plastic shearing changes volume, always or by the state of the soil.
template <int dim>
bool shares_pressure(const problem::Model<dim>& model, const problem::Body<dim>& body)
{
  const auto changes_volume = [](const material::Material& material) {
    return dilates(material) || (yields(material) && !strength_at_rest(material));
  };
  return model.mpm.volumetric_projection && !model.update_stress_first &&
         std::any_of(body.soil.materials.begin(), body.soil.materials.end(), changes_volume);
}

}  // namespace

template <int dim>
Workspace<dim>::Workspace(const problem::Model<dim>& model, const problem::State<dim>& state)
    : contact_points(model.contacts.size()),
      cell_changes(omp_get_max_threads()),
      motion_before(model.conditions.rows.size(), Vec<dim>::Zero()),
      motion_after(model.conditions.rows.size(), Vec<dim>::Zero())
{
  std::size_t max = 0;
  const Halo halo = make_halo(model.mesh, model.patches);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    grids.emplace_back(model.mesh);
    grids[b].halo = halo;
    find_nodes(model.mesh, state.particles[b], grids[b]);
    const problem::Body<dim>& body = model.bodies[b];
    if (shares_pressure(model, body)) grids[b].pressure_shift = CellField<Real>::zeros(model.mesh.cell_count());
    if (model.mesh.metric == mesh::Metric::cartesian && dim == 2)
      grids[b].shift_across = 2 * young_poisson(body.soil.materials.front()).poisson_ratio;
    if (!model.conditions.reported.empty()) grids[b].support_force = NodeField<Vec<dim>>::zeros(model.mesh.node_count());
    if (body.flows()) grids[b].water.make_room(model.mesh, body.soil);
    grids[b].full_cells = model.mpm.quadrature != settings::Quadrature::particles;
    const auto rubs = [&](const problem::Contact& contact) { return contact.body == static_cast<Index>(b) && contact.rigid != none; };
    if (model.mpm.quadrature == settings::Quadrature::cut_cells && std::any_of(model.contacts.begin(), model.contacts.end(), rubs))
      grids[b].cut = {std::vector(model.contacts.size(), bodies::Pose<dim>::nowhere()), NodeField<Real>::zeros(model.mesh.node_count()),
                      CellField<mesh::CellPart<dim>>::zeros(model.mesh.cell_count()), NodeField<Real>::zeros(model.mesh.node_count())};
    if (yields(body.soil.materials.front())) {
      const Real wave_speed = body.waves.mean_speed;
      grids[b].bulk_viscosity = model.mpm.bulk_viscosity * body.waves.mean_density * wave_speed;
      if (!model.update_stress_first) grids[b].filter_speed = model.mpm.velocity_filter * wave_speed;
      if (grids[b].filter_speed > 0) {
        grids[b].kinetic = CellField<Real>::zeros(model.mesh.cell_count());
        if (grids[b].full_cells && !body.flows()) grids[b].stiffness_limit = CellField<Real>::zeros(model.mesh.cell_count());
      }
    }
    for (Index cell : state.particles[b].occupied()) grids[b].enter(model.mesh, cell);
    for (Index cell : grids[b].halo.outer) grids[b].enter(model.mesh, cell);
    grids[b].total_mass = sums_over(state.particles[b]).mass;
    laws.push_back(laws_of(body.soil, model.mpm, model.mesh));
    max = std::max<std::size_t>(max, state.particles[b].size());
  }
  // A sixteenth of all particles: far more than change cell in one step of a stable run.
  for (auto& list : cell_changes) list.reserve(max / 16 + 1024);
  transit.reserve(max / 16 + 1024);
  changed_cells.reserve(2 * (max / 16 + 1024));
  for (std::size_t b = 0; b < model.bodies.size(); ++b) sum_moments(model.mesh, state.particles[b], grids[b]);
}

template struct WaterGrid<2>;
template struct WaterGrid<3>;
template struct BodyGrid<2>;
template struct BodyGrid<3>;
template void find_nodes(const mesh::Mesh<2>&, const bodies::Particles<2>&, BodyGrid<2>&);
template void find_nodes(const mesh::Mesh<3>&, const bodies::Particles<3>&, BodyGrid<3>&);
template struct Workspace<2>;
template struct Workspace<3>;

}  // namespace berm::mpm
