// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/condition.hpp"

#include "core/bytes.hpp"
#include "mpm/linear_field.hpp"

namespace berm::mpm {
namespace {

/// Calls visit(particle) for each particle of a cell.
template <int dim, class Visit>
void for_each_in_cell(const bodies::Particles<dim>& particles, Index cell, const Visit& visit)
{
  for (Index index = 0; index < particles.count_in(cell); ++index) visit(particles.read_at(cell, index));
}

/// The volume of the particles of each cell, and of those around the cells of this rank.
template <int dim>
CellField<Real> filled_volumes(const problem::Model<dim>& model, const bodies::Particles<dim>& particles)
{
  auto volumes = CellField<Real>::zeros(model.mesh.cell_count());
  for (const Index cell : particles.occupied())
    for_each_in_cell(particles, cell, [&](const bodies::Particle<dim>& p) { volumes[cell] += p.volume; });
  Halo halo = make_halo(model.mesh, model.patches);
  if (!halo.divided()) return volumes;
  halo.exchange(
      [&](const Halo::Side& side, std::vector<std::byte>& out) {
        for (const Index cell : side.inner) put_bytes(out, &cell), put_bytes(out, &volumes[cell]);
      },
      [&](const Halo::Side&, const std::vector<std::byte>& in) {
        Index cell = none;
        for (const std::byte* at = in.data(); at != in.data() + in.size();) {
          at = get_bytes(at, &cell);
          at = get_bytes(at, &volumes[cell]);
        }
      });
  return volumes;
}

/// Fraction of the cells around a node that particles fill.
template <int dim>
Real fill_at(const mesh::Mesh<dim>& mesh, const CellField<Real>& volumes, Index node)
{
  Real filled = 0, whole = 0;
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index cell = mesh.entries[e] / (dim + 1);
    whole += mesh.volume(cell);
    filled += volumes[cell];
  }
  return filled / whole;
}

/// Sums of the mass of a body's cells.
struct MassSums {
  Real all = 0, at_min_volume = 0, at_max_volume = 0, in_the_air = 0;

  MassSums& operator+=(const MassSums& other)
  {
    all += other.all;
    at_min_volume += other.at_min_volume;
    at_max_volume += other.at_max_volume;
    in_the_air += other.in_the_air;
    return *this;
  }
};

/// Sums over the soil near a rigid body.
struct ShakenSoil {
  Real mass = 0, noise = 0, volume = 0, pressure = 0,
       wave_impedance = 0;  // noise: sum m |v'|2; the others but mass are weighted with volume

  ShakenSoil& operator+=(const ShakenSoil& other)
  {
    mass += other.mass;
    noise += other.noise;
    volume += other.volume;
    pressure += other.pressure;
    wave_impedance += other.wave_impedance;
    return *this;
  }
};

}  // namespace

template <int dim>
SoilCondition soil_condition(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  constexpr Real little = 0.25, round_off = 1e-12;
  MassSums sums;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const settings::BodySoil& soil = model.bodies[b].soil;
    if (!yields(soil.materials.front())) continue;
    const bodies::Particles<dim>& particles = state.particles[b];
    const CellField<Real> volumes = filled_volumes(model, particles);
    sums += sum_of<MassSums>("condition of the soil", particles.chunks(), [&](Index c) {
      const Index cell = particles.occupied()[c];
      MassSums of_cell;
      for_each_in_cell(particles, cell, [&](const bodies::Particle<dim>& p) {
        const Real ratio = p.volume * inertia_density(material_of(soil, p.extra)) / p.mass;
        of_cell.all += p.mass;
        if (ratio <= model.mpm.min_volume_ratio * (1 + round_off)) of_cell.at_min_volume += p.mass;
        if (ratio >= model.mpm.max_volume_ratio * (1 - round_off)) of_cell.at_max_volume += p.mass;
      });
      const auto& nodes = model.mesh.nodes[cell];
      if (std::all_of(nodes.begin(), nodes.end(), [&](Index node) { return fill_at(model.mesh, volumes, node) < little; }))
        of_cell.in_the_air = of_cell.all;
      return of_cell;
    });
  }
  if (!(sums.all > 0)) return {};
  return {sums.at_min_volume / sums.all, sums.at_max_volume / sums.all, sums.in_the_air / sums.all};
}

namespace {

/// Whether a soil has less strength under less pressure.
bool needs_pressure(const material::Material& material)
{
  const std::optional<material::Strength> strength = strength_at_rest(material);
  return yields(material) && (!strength || strength->friction_angle > 0);
}

/// c cot(phi), Pa: how far the strength of a soil with friction is that of a higher pressure; 0 of one whose strength is not known so. Of cohesion that grows with depth that
/// at the surface.
Real attraction(const material::Material& material)
{
  const std::optional<material::Strength> strength = strength_at_rest(material);
  return strength && strength->friction_angle > 0 ? strength->cohesion / std::tan(strength->friction_angle) : 0;
}

}  // namespace

template <int dim>
Real shaking(const problem::Model<dim>& model, const problem::State<dim>& state, const Workspace<dim>& workspace)
{
  if (model.main_rigid == none) return nan;
  const bodies::RigidShape<dim> shape = placed<dim>(model.rigid_bodies[model.main_rigid], state.rigid_bodies[model.main_rigid]);
  const Real reach = 0.5 * width_of<dim>(shape);
  ShakenSoil all;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (!needs_pressure(model.bodies[b].soil.materials.front())) continue;
    const bodies::Particles<dim>& particles = state.particles[b];
    const BodyGrid<dim>& grid = workspace.grids[b];
    const Real impedance = model.bodies[b].waves.mean_impedance;
    all += sum_of<ShakenSoil>("shaking", particles.chunks(), [&](Index c) {
      const Index cell = particles.occupied()[c];
      ShakenSoil sums;
      const Vec<dim> center = model.mesh.centroid(cell);
      if (!(surface_at<dim>(shape, center).distance < reach)) return sums;
      Vec<dim> momentum = Vec<dim>::Zero(), moment = Vec<dim>::Zero();
      for_each_in_cell(particles, cell, [&](const bodies::Particle<dim>& p) {
        sums.mass += p.mass;
        momentum += p.mass * p.v;
        moment += p.mass * p.x;
        sums.volume += p.volume;
        sums.pressure += p.volume * (attraction(material_of(model.bodies[b].soil, p.extra)) - trace(p.stress) / 3);
      });
      const LinearField<dim> field(grid.gradients[cell], at_corners(model.mesh.nodes[cell], grid.mapped_velocity));
      for_each_in_cell(particles, cell, [&](const bodies::Particle<dim>& p) {
        const Vec<dim> from = p.x - moment / sums.mass;
        Vec<dim> rest = p.v - momentum / sums.mass;
        for (int d = 0; d < dim; ++d)
          for (int a = 0; a < dim; ++a) rest[d] -= field.slope[a][d] * from[a];
        sums.noise += p.mass * rest.squaredNorm();
      });
      sums.wave_impedance = impedance * sums.volume;
      return sums;
    });
  }
  if (!(all.pressure > 0)) return nan;
  return std::sqrt(all.noise / all.mass / dim) * all.wave_impedance / all.pressure;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template SoilCondition soil_condition(const problem::Model<dim>&, const problem::State<dim>&);                                           \
  template Real shaking(const problem::Model<dim>&, const problem::State<dim>&, const Workspace<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
