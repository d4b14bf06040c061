// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/consolidation.cpp
#include "mpm/flow.hpp"

#include "mpm/hoop.hpp"
#include "mpm/internal_forces.hpp"
#include "problem/stages.hpp"

namespace berm::mpm {

template <int dim>
void average_water(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, Index body, BodyGrid<dim>& grid)
{
  if (!grid.water.flows()) return;
  const settings::BodySoil& soil = model.bodies[body].soil;
  const int pressure = pore_pressure_index(soil.materials.front()), number = settings::material_index_offset(soil);
  for_each("pore pressure of cells", particles.chunks(), [&](Index c) {
    const Index cell = particles.occupied()[c];
    WaterCell sums;
    Real volume = 0;
    for (const auto& [p, b, count] : particles.blocks_in(cell)) {
      const Lanes* numbers = particles.extra(b);
      for (int l = 0; l < count; ++l) {
        const auto of = [&](int k) { return k == none ? 0 : numbers[k][l]; };
        const auto& [water, density] = grid.water.soils[static_cast<std::size_t>(of(number))];
        const Real V = p.volume[l], n = water.porosity_at(V * density / p.mass[l]);
        volume += V;
        sums.pressure += V * of(pressure);
        sums.inertia += V * material::water_density / n;
        sums.drag += V * material::unit_weight_of_water / water.permeability_at(n);
      }
    }
    grid.water.cells[cell] = {sums.pressure / volume, sums.inertia / volume, sums.drag / volume};
  });
}

namespace {

/// Means over the patch of a cell, weighted by the volume of its soil.
template <int dim>
struct PatchOfWater {
  Real pressure = 0;                   ///< excess pore pressure, Pa
  Vec<dim> centre = Vec<dim>::Zero();  ///< of the cells, m
};

template <int dim>
PatchOfWater<dim> patch_of_water(const problem::Model<dim>& model, const BodyGrid<dim>& grid, Index cell)
{
  PatchOfWater<dim> patch;
  Real volume = 0;
  mesh::for_each_in_patch(model.patches, cell, [&](Index member) {
    const Real V = grid.moments[member].volume;
    if (!(V > 0)) return;
    volume += V;
    patch.pressure += V * grid.water.cells[member].pressure;
    patch.centre += V * model.mesh.centroid(member);
  });
  patch.pressure /= volume;
  patch.centre /= volume;
  return patch;
}

template <mesh::Metric metric, int dim>
void spread_water_forces_in(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  for_each("water forces of cells", particles.chunks(), [&](Index c) {
    const Index cell = particles.occupied()[c];
    const Moments<dim>& t = grid.moments[cell];
    const PatchOfWater<dim> patch = patch_of_water(model, grid, cell);
    grid.water.pressure[cell] = patch.pressure;
    const std::array<Vec<dim>, dim + 1> forces = forces_of_pressure<metric>(mesh, grid, cell);
    auto& corners = grid.water.corners[cell];
    // Equal parts: the force on a corner does not vanish with the shape functions of the particles, so the water's inertia must not either.
    const Real of_corner = t.volume / (dim + 1), per_mass = t.volume / t.total_mass();
    for (int k = 0; k <= dim; ++k) {
      const Real of_soil = grid.corners[cell][k].mass * per_mass;
      corners[k] = {patch.pressure * forces[k], std::min(of_corner, of_soil) * material::water_density,
                    forces[k].cwiseProduct(mesh.position[mesh.nodes[cell][k]] - patch.centre)};
    }
  });
}

}  // namespace

template <int dim>
void spread_water_forces(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid)
{
  if (!grid.water.flows()) return;
  with_metric(model.mesh, [&](auto metric) { spread_water_forces_in<metric()>(model, particles, grid); });
}

template <int dim>
void gather_water(const problem::Model<dim>& model, Real dt, BodyGrid<dim>& grid)
{
  if (!grid.water.flows()) return;
  const mesh::Mesh<dim>& mesh = model.mesh;
  const NodeField<std::uint8_t>& impermeable = grid.conditions(model).closed;
  constexpr Real least = 0.5, most = 2;  // of equal parts
  for_each("gather water", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    WaterAtNode<dim>& water = grid.water.nodes[i];
    water = {};
    Real equal_parts = 0;
    Vec<dim> share = Vec<dim>::Zero();
    for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e) {
      const Index cell = mesh.entries[e] / (dim + 1);
      const WaterAtCorner<dim>& corner = grid.water.corners[cell][mesh.entries[e] % (dim + 1)];
      const Real part = grid.moments[cell].volume / (dim + 1);
      water.force += corner.force;
      water.mass += corner.mass;
      water.inertia += part * grid.water.cells[cell].inertia;
      water.drag += part * grid.water.cells[cell].drag;
      share += corner.share;
      equal_parts += part;
    }
    // The mean over the directions, but on the axis, where nothing flows along the radius.
    const bool on_axis = mesh.metric == mesh::Metric::axisymmetric && mesh.position[i][0] == 0;
    if (equal_parts > 0) {
      const Real volume = on_axis ? share[1] : share.sum() / dim;
      const Real factor = std::clamp(volume / equal_parts, least, most);
      water.mass *= factor, water.inertia *= factor, water.drag *= factor;
    }
    water.inertia += dt * water.drag;
    grid.water.normal[i].setZero();
    grid.water.impermeable[i] = {};
    for (int d = 0; d < dim; ++d)
      grid.water.soil_inertia[i][d] =
          grid.mass[i] - (impermeable[i] >> d & 1 || !(water.inertia > 0) ? 0 : water.mass * water.mass / water.inertia);
  });
}

template <int dim>
void apply_heads(const problem::Model<dim>& model, const problem::State<dim>& state, BodyGrid<dim>& grid)
{
  if (!grid.water.flows()) return;
  const mesh::Mesh<dim>& mesh = model.mesh;
  boundary::for_each_of<boundary::Head<dim>>(model.conditions, [&](std::size_t number, const auto& row, const auto& head) {
    const Real pressure = acting_fraction(row, state.heads[number], state.time) * head.pressure;
    if (pressure == 0) return;
    for_each("head of water outside", row.chunks, [&](Index k) {
      const Index i = row.nodes[k];
      const Vec<dim>& normal = head.normals[k];
      if (!(grid.mass[i] > 0)) return;
      Real area = 0;
      for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e)
        if (const Index cell = mesh.entries[e] / (dim + 1); grid.moments[cell].any())
          area -= normal.dot(
              with_metric(mesh, [&](auto metric) { return forces_of_pressure<metric()>(mesh, grid, cell)[mesh.entries[e] % (dim + 1)]; }));
      grid.water.nodes[i].force += pressure * area * normal;
    });
  });
}

namespace {

template <int dim>
struct TakenByWater {
  Vec<dim> impulse = Vec<dim>::Zero();
  Real work = 0;

  TakenByWater& operator+=(const TakenByWater& other)
  {
    impulse += other.impulse;
    work += other.work;
    return *this;
  }
};

}  // namespace

template <int dim>
void mark_impermeable_surfaces(const problem::Model<dim>& model, Workspace<dim>& workspace)
{
  for (std::size_t k = 0; k < model.contacts.size(); ++k)
    for (const Index b : {model.contacts[k].body, model.contacts[k].other_body}) {
      if (b == none || !workspace.grids[b].water.flows()) continue;
      BodyGrid<dim>& grid = workspace.grids[b];
      const bool seals = model.contacts[k].rigid != none && !model.contacts[k].drained;
      for (const contact::ContactPoint<dim>& point : workspace.contact_points[k].list)
        for (int n = 0; n < point.node_count; ++n) {
          const Index node = point.nodes[n];
          grid.water.soil_inertia[node].setConstant(grid.mass[node]);
          if (seals && point.touching) grid.water.normal[node] += point.weights[n] * point.normal;
        }
    }
}

namespace {

/// The cells around a node on one side of it along a normal.
struct Side {
  Real area = 0;   ///< m (per metre run) or m2: sum of the forces of 1 Pa along the normal
  Real force = 0;  ///< N: that of the excess pore pressure that acts
  void add(Real part, Real pressure) { area += part, force += part * pressure; }
};

/// What an impermeable body changes of the force on the water at a node along its normal, N, and of the outflow. The mean pressures of the cells on both sides of the
/// node act on the geometric mean of their areas: full cells of soil keep what they have; without soil on the side of the body nothing is left; and however
/// little soil there is, no wave through it is faster.
template <mesh::Metric metric, int dim>
Real close(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index node, const Vec<dim>& normal, ImpermeableFlux& impermeable)
{
  Side body, soil;
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index cell = mesh.entries[e] / (dim + 1);
    if (!(grid.moments[cell].any())) continue;
    const Real force = normal.dot(forces_of_pressure<metric>(mesh, grid, cell)[mesh.entries[e] % (dim + 1)]);
    (force > 0 ? body : soil).add(std::abs(force), grid.water.pressure[cell]);
  }
  const Real area = std::sqrt(body.area * soil.area);
  impermeable = {body.area > 0 ? area / body.area - 1 : 0, soil.area > 0 ? area / soil.area - 1 : 0};
  return impermeable.at_body * body.force - impermeable.at_soil * soil.force;
}

}  // namespace

template <int dim>
void advance_flux(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body)
{
  BodyGrid<dim>& grid = workspace.grids[body];
  if (!grid.water.flows()) return;
  NodeField<Vec<dim>>& flux = state.flux[body];
  const NodeField<std::uint8_t>& impermeable = grid.conditions(model).closed;
  const Real dt = state.dt;
  // At contact points neither feels the other's inertia, so that the equations stay symmetric, and stable; with four times its inertia there the water makes no
  // wave faster than that of waves_of.
  constexpr Real heavier = 3;
  const auto taken = sum_of<TakenByWater<dim>>("flux of water", grid.chunks, [&](Index k) {
    const Index i = grid.nodes[k];
    const WaterAtNode<dim>& water = grid.water.nodes[i];
    const Vec<dim> before = flux[i];
    if (!(grid.mass[i] > 0) || !(water.inertia > 0)) {
      flux[i].setZero();
      return TakenByWater<dim>();
    }
    const Vec<dim>& a = grid.acceleration[i];
    const bool at_contact = grid.contact_points[i] != 0;
    const Real inertia = at_contact ? water.inertia + heavier * (water.inertia - dt * water.drag) : water.inertia;
    Vec<dim> force = water.force - water.drag * before;
    // Where a support stops the water as well, only what is left of the normal counts.
    Vec<dim>& normal = grid.water.normal[i];
    normal = boundary::without_fixed<dim>(impermeable, i, normal);
    ImpermeableFlux& at_body = grid.water.impermeable[i];
    if (const Real length = normal.norm(); length > 0) {
      normal /= length;
      force += with_metric(model.mesh, [&](auto metric) { return close<metric()>(model.mesh, grid, i, normal, at_body); }) * normal;
    }
    Vec<dim> after = before + dt / inertia * force;
    if (!at_contact) after -= water.mass / inertia * (grid.mapped_velocity[i] - grid.velocity[i]);
    flux[i] = boundary::without_fixed<dim>(impermeable, i, after);
    const Real outward = flux[i].dot(normal);
    at_body = {outward * at_body.at_body, outward * at_body.at_soil};
    if (at_contact) return TakenByWater<dim>();
    Vec<dim> impulse = water.mass * (flux[i] - before + water.mass / inertia * (grid.mapped_velocity[i] - grid.velocity[i] - dt * a));
    for (int d = 0; d < dim; ++d)
      if (!(grid.water.soil_inertia[i][d] < grid.mass[i])) impulse[d] = 0;
    return TakenByWater<dim>{impulse, impulse.dot(grid.velocity[i] + 0.5 * dt * a)};
  });
  state.ledger.totals.flow_impulse -= taken.impulse;
  state.ledger.totals.internal += taken.work;
}

namespace {

constexpr Real least_filled = 0.5;  // of a cell: less may be a single particle, squeezed between others and a body

struct Largest {
  Real value = 0;

  Largest& operator+=(const Largest& other)
  {
    value = std::max(value, other.value);
    return *this;
  }
};

}  // namespace

template <int dim>
void note_pressures(const problem::Model<dim>& model, problem::State<dim>& state, const Workspace<dim>& workspace)
{
  problem::PressureMeans& means = state.stage.pressure_means;
  const Real weight = problem::weight_in_window(state.time - means.begin, model.pressure_window);
  means.weight += weight;
  const bool window_ends = state.time - means.begin >= model.pressure_window && means.weight > 0;
  Largest largest, mean;
  const auto add_all = [&](Largest& to, const char* label, const auto& of_cell) {
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      const bodies::Particles<dim>& particles = state.particles[b];
      if (!workspace.grids[b].water.flows()) continue;
      to += sum_of<Largest>(label, particles.chunks(), [&](Index c) { return Largest{std::abs(of_cell(b, particles.occupied()[c]))}; });
    }
  };
  add_all(largest, "largest pore pressure", [&](std::size_t b, Index cell) -> Real {
    const BodyGrid<dim>& grid = workspace.grids[b];
    if (!(grid.moments[cell].volume > least_filled * model.mesh.volume(cell))) return 0;
    state.pressure_sums[b][cell] += weight * grid.water.pressure[cell];
    return grid.water.pressure[cell];
  });
  state.stage.excess_pressure = largest.value;
  if (window_ends) {
    add_all(mean, "mean pore pressure", [&](std::size_t b, Index cell) { return state.pressure_sums[b][cell] / means.weight; });
    end_window(means, mean.value, state.time);
    for (CellField<Real>& sums : state.pressure_sums) sums.assign(sums.size(), 0);
  }
  means.now = mean_now(means, state.time - state.stage.begin_time, model.pressure_window);
}

namespace {

/// What impermeable bodies change of the water that leaves a cell, m3/s (per metre run: m2/s).
template <mesh::Metric metric, int dim>
Real held_back(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index cell)
{
  Real rate = 0;
  for (int k = 0; k <= dim; ++k) {
    const Index node = mesh.nodes[cell][k];
    const ImpermeableFlux& impermeable = grid.water.impermeable[node];
    if (impermeable.at_body == 0 && impermeable.at_soil == 0) continue;
    const Real force = grid.water.normal[node].dot(forces_of_pressure<metric>(mesh, grid, cell)[k]);
    rate += force * (force > 0 ? impermeable.at_body : impermeable.at_soil);
  }
  return rate;
}

}  // namespace

template <int dim>
void sum_outflows(const problem::Model<dim>& model, const problem::State<dim>& state, BodyGrid<dim>& grid, Index body)
{
  if (!grid.water.flows()) return;
  const mesh::Mesh<dim>& mesh = model.mesh;
  const bodies::Particles<dim>& particles = state.particles[body];
  const auto sum = [&](Index cell) {
    const Real volume = grid.moments[cell].volume;
    const Real change = with_metric(mesh, [&](auto metric) { return held_back<metric()>(mesh, grid, cell); });
    grid.water.outflow[cell] = {volume, (volume * divergence(mesh, grid, cell, state.flux[body]) + change) * state.dt};
  };
  for_each("outflow of cells", particles.chunks(), [&](Index c) { sum(particles.occupied()[c]); });
  for (const Index cell : grid.halo.partners)
    if (grid.moments[cell].any()) sum(cell);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void average_water(const problem::Model<dim>&, const bodies::Particles<dim>&, Index, BodyGrid<dim>&);                           \
  template void spread_water_forces(const problem::Model<dim>&, const bodies::Particles<dim>&, BodyGrid<dim>&);                            \
  template void gather_water(const problem::Model<dim>&, Real, BodyGrid<dim>&);                                                            \
  template void apply_heads(const problem::Model<dim>&, const problem::State<dim>&, BodyGrid<dim>&);                                       \
  template void mark_impermeable_surfaces(const problem::Model<dim>&, Workspace<dim>&);                                                    \
  template void advance_flux(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&, Index);                                    \
  template void note_pressures(const problem::Model<dim>&, problem::State<dim>&, const Workspace<dim>&);                                   \
  template void sum_outflows(const problem::Model<dim>&, const problem::State<dim>&, BodyGrid<dim>&, Index);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
