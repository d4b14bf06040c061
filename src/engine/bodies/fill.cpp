// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/fill.hpp"

#include "bodies/initial_stress.hpp"

#include "os/error.hpp"
#include "os/text_of_list.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::bodies {
namespace {

/// Position, cell and section (mesh::section_of) of a new particle.
template <int dim>
struct Seed {
  Vec<dim> x;
  Index cell;
  Real section;
};

template <int dim>
int particles_in_cells_of(const BodySettings& body, const std::string& region)
{
  const auto special = body.region_particles_per_cell.find(region);
  const int count = special == body.region_particles_per_cell.end() ? body.particles_per_cell : special->second;
  return count > 0 ? count : usual_particles_per_cell<dim>;
}

/// Particles along each side of a block; 1 where there is no such direction.
template <int dim>
std::array<Real, 3> counts_in(const BlockSettings& block)
{
  std::array<Real, 3> count = {1, 1, 1};
  for (int d = 0; d < dim; ++d) count[d] = std::max(Real(1), std::round(block.size[d] / block.spacing));
  return count;
}

/// Refuses more particles than can be numbered, before memory is allocated.
void check_count(const std::string& key, Real count)
{
  constexpr Index max = std::numeric_limits<Index>::max() / 2;
  if (!(count <= max)) throw KeyError(fmt::format("{}: {:.3g} particles are too many; at most {} can be numbered", key, count, max));
}

template <int dim>
std::vector<Seed<dim>> seeds_in_regions(const mesh::Mesh<dim>& mesh, const std::string& name, const BodySettings& body)
{
  std::vector<CellPoints<dim>> points(mesh.region_names.size());
  for (const std::string& region : body.regions)
    points[filled_region(mesh, name, region)] = CellPoints<dim>(particles_in_cells_of<dim>(body, region));

  Real total = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) total += points[mesh.region[cell]].count();
  check_count(fmt::format("body.{}.particles_per_cell", name), total);
  std::vector<Seed<dim>> seeds;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto& of_cell = points[mesh.region[cell]];
    for (int k = 0; k < of_cell.count(); ++k) seeds.push_back({of_cell.at(mesh, cell, k), cell, mesh.section(cell) / of_cell.count()});
  }
  return seeds;
}

/// Finds the cells of points that are near each other, for one `part` (block or disk) of a body.
template <int dim>
struct Finder {
  const mesh::Mesh<dim>& mesh;
  const std::string& body;
  const char* part;
  Index cell = 0;

  Index cell_at(const Vec<dim>& x)
  {
    const mesh::Location location = locate(mesh, x, cell);
    if (!location.inside) throw KeyError(fmt::format("body.{0}.{1}: the {1} leaves the mesh at ({2})", body, part, text_of_list(x, ", ")));
    return cell = location.cell;
  }
};

/// Particles of one cell are stored together, and cells that are neighbours in number near each other.
template <int dim>
void sort_by_cell(std::vector<Seed<dim>>& seeds)
{
  std::stable_sort(seeds.begin(), seeds.end(), [](const Seed<dim>& a, const Seed<dim>& b) { return a.cell < b.cell; });
}

template <int dim>
std::vector<Seed<dim>> seeds_in_block(const mesh::Mesh<dim>& mesh, const std::string& name, const BlockSettings& block)
{
  const Matrix<dim> axes = turn<dim>(block.angle);
  const std::array<Real, 3> count = counts_in<dim>(block);
  check_count(fmt::format("body.{}.block.spacing", name), count[0] * count[1] * count[2]);
  Vec<dim> center, spacing;
  for (int d = 0; d < dim; ++d) {
    center[d] = block.center[d];
    spacing[d] = block.size[d] / count[d];
  }
  std::vector<Seed<dim>> seeds;
  Finder<dim> finder{mesh, name, "block"};
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i) {
        const int index[3] = {i, j, k};
        Vec<dim> local;
        for (int d = 0; d < dim; ++d) local[d] = (index[d] + 0.5 - 0.5 * count[d]) * spacing[d];
        const Vec<dim> x = center + axes * local;
        seeds.push_back({x, finder.cell_at(x), spacing.prod()});
      }
  sort_by_cell(seeds);
  return seeds;
}

std::vector<Seed<2>> seeds_in_disk(const mesh::Mesh<2>& mesh, const std::string& name, const DiskSettings& disk)
{
  const Vec<2> center(disk.center[0], disk.center[1]);
  const Real radius = disk.diameter / 2;
  check_count(fmt::format("body.{}.disk.spacing", name), std::pow(disk.diameter / disk.spacing, 2));
  const int max = static_cast<int>(std::ceil(radius / disk.spacing));
  std::vector<Seed<2>> seeds;
  Finder<2> finder{mesh, name, "disk"};
  for (int j = -max; j < max; ++j)
    for (int i = -max; i < max; ++i) {
      const Vec<2> local = disk.spacing * Vec<2>(i + 0.5, j + 0.5);
      if (local.norm() < radius) seeds.push_back({center + local, finder.cell_at(center + local), 0});
    }
  for (Seed<2>& seed : seeds) seed.section = pi * radius * radius / static_cast<Real>(seeds.size());
  sort_by_cell(seeds);
  return seeds;
}

template <int dim>
std::vector<Seed<dim>> seeds_of(const mesh::Mesh<dim>& mesh, const std::string& name, const BodySettings& body)
{
  if (body.block) return seeds_in_block(mesh, name, *body.block);
  if constexpr (dim == 2)
    if (body.disk) return seeds_in_disk(mesh, name, *body.disk);
  return seeds_in_regions(mesh, name, body);
}

template <int dim>
Vec<dim> first_velocity(const BodySettings& body, const Vec<dim>& from_center, const Vec<dim>& x)
{
  Vec<dim> v = Vec<dim>::Zero();
  for (const InitialVelocity& wave : body.initial_velocity) {
    Real phase = wave.phase;
    for (std::size_t d = 0; d < wave.wave_number.size(); ++d) phase += wave.wave_number[d] * x[static_cast<Index>(d)];
    const Real size = wave.wave_number.empty() ? 1 : std::sin(phase);
    for (int d = 0; d < dim; ++d) v[d] += size * wave.amplitude[d];
  }
  v[0] -= body.initial_angular_velocity * from_center[1];
  v[1] += body.initial_angular_velocity * from_center[0];
  return v;
}

template <int dim>
Vec<dim> center_of_section(const std::vector<Seed<dim>>& seeds)
{
  Vec<dim> moment = Vec<dim>::Zero();
  Real section = 0;
  for (const Seed<dim>& seed : seeds) moment += seed.section * seed.x, section += seed.section;
  return moment / section;
}

}  // namespace

template <>
std::vector<std::array<Real, 3>> points_in_simplex<2>(int n)
{
  std::vector<std::array<Real, 3>> points;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i + j < n; ++i)
      for (const Real offset : {1. / 3, 2. / 3}) {
        const Real s = (i + offset) / n, t = (j + offset) / n;
        if (s + t < 1) points.push_back({1 - s - t, s, t});
      }
  return points;
}

// The tetrahedron 1 >= x >= y >= z >= 0 is cut like the cubes of a lattice, each into six such tetrahedra: one for each order of the axes.
template <>
std::vector<std::array<Real, 4>> points_in_simplex<3>(int n)
{
  constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  std::vector<std::array<Real, 4>> points;
  for (int k = 0; k < n; ++k)
    for (int j = k; j < n; ++j)
      for (int i = j; i < n; ++i)
        for (const auto& order : orders) {
          Real x[3] = {Real(i), Real(j), Real(k)};
          for (int d = 0; d < 3; ++d) x[order[d]] += 0.75 - 0.25 * d;  // the centroid
          if (x[0] >= x[1] && x[1] >= x[2]) points.push_back({1 - x[0] / n, (x[0] - x[1]) / n, (x[1] - x[2]) / n, x[2] / n});
        }
  return points;
}

namespace {

/// Points of a triangle that share it equally where the n^2 parts of a regular subdivision are cut in two, from the corner parallel to the triangle's corner 0.
std::vector<std::array<Real, 3>> points_in_halves(int n)
{
  std::vector<std::array<Real, 3>> points;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i + j < n; ++i)
      for (const int up : {1, -1}) {
        if (up < 0 && i + j + 1 == n) continue;
        // (2 a + 3 b + c)/6 and (2 a + b + 3 c)/6, with a the corner that is cut
        const Real a[2] = {up > 0 ? Real(i) : i + 1, up > 0 ? Real(j) : j + 1};
        for (const Real to_b : {3. / 6, 1. / 6}) {
          const Real s = (a[0] + up * to_b) / n, t = (a[1] + up * (4. / 6 - to_b)) / n;
          points.push_back({1 - s - t, s, t});
        }
      }
  return points;
}

/// n where count is times n^dim, else 0.
int root_of(int count, int times, int dim)
{
  const auto n = static_cast<int>(std::lround(std::pow(Real(count) / times, 1. / dim)));
  return times * (dim == 2 ? n * n : n * n * n) == count ? n : 0;
}

/// The corner opposite to the longest side.
template <int dim>
int across_longest_side(const mesh::Mesh<dim>& mesh, Index cell)
{
  int found = 0;
  Real longest = 0;
  for (int k = 0; k <= dim; ++k) {
    const auto corner = [&](int after) { return mesh.position[mesh.nodes[cell][(k + after) % (dim + 1)]]; };
    // Of sides that are equal but for rounding the first is taken.
    if (const Real side = (corner(2) - corner(1)).norm(); side > longest * (1 + 1e-9)) longest = side, found = k;
  }
  return found;
}

}  // namespace

template <int dim>
bool shares_cell(int count)
{
  return count > 0 && (root_of(count, 1, dim) > 0 || (dim == 2 && root_of(count, 2, dim) > 0));
}

template <int dim>
CellPoints<dim>::CellPoints(int count)
{
  if (const int n = root_of(count, 1, dim); n > 0) points_ = points_in_simplex<dim>(n);
  if constexpr (dim == 2)
    if (const int n = root_of(count, 2, dim); n > 0) points_ = points_in_halves(n), cuts_longest_side_ = true;
}

template <int dim>
Vec<dim> CellPoints<dim>::at(const mesh::Mesh<dim>& mesh, Index cell, int k) const
{
  const int corner_0 = cuts_longest_side_ ? across_longest_side(mesh, cell) : 0;
  Vec<dim> x = Vec<dim>::Zero();
  for (int c = 0; c <= dim; ++c) x += points_[static_cast<std::size_t>(k)][c] * mesh.position[mesh.nodes[cell][(corner_0 + c) % (dim + 1)]];
  return x;
}

template <int dim>
Real particles_in(const BlockSettings& block)
{
  Real product = 1;
  for (const Real count : counts_in<dim>(block)) product *= count;
  return product;
}

Real particles_in(const DiskSettings& disk)
{
  return pi / 4 * std::pow(disk.diameter / disk.spacing, 2);
}

template <int dim>
int particles_per_cell(const BodySettings& body, const std::string& region)
{
  return particles_in_cells_of<dim>(body, region);
}

template <int dim>
Index filled_region(const mesh::Mesh<dim>& mesh, const std::string& name, const std::string& region)
{
  const Index found = mesh.find_region(region);
  if (found == none)
    throw KeyError(
        fmt::format("body.{}.regions: the mesh has no region \"{}\"; it has {}", name, region, text_of_list(mesh.region_names, ", ")));
  return found;
}

template <int dim>
Particles<dim> fill(const mesh::Mesh<dim>& mesh, const std::string& name, const BodySettings& body, const StartState<dim>& start)
{
  auto seeds = seeds_of(mesh, name, body);
  std::erase_if(seeds, [&](const Seed<dim>& seed) {
    return std::any_of(start.holes.begin(), start.holes.end(), [&](const auto& hole) { return surface_at(hole, seed.x).distance < 0; });
  });
  Particles<dim> particles(mesh, static_cast<Index>(seeds.size()) + start.room, start.extra);
  const Vec<dim> center = center_of_section(seeds);
  std::int32_t id = 0;
  for (const Seed<dim>& seed : seeds) {
    Particle<dim> p;
    p.x = seed.x;
    p.volume = seed.section * weight_at(mesh.metric, seed.x);
    p.mass = start.density * p.volume;
    p.v = first_velocity<dim>(body, seed.x - center, seed.x);
    p.stress = initial_stress<dim>(body, start.density * start.vertical_gravity, start.surface - seed.x[1]);
    if (start.soil_at) {
      const SoilAtPoint soil = start.soil_at(seed.cell, seed.x);
      p.mass = soil.density * p.volume;
      p.stress = stress_at_rest<dim>(body, soil.vertical_stress, soil.depth);
      std::copy(soil.own.begin(), soil.own.end(), p.extra + start.first_local);
    }
    p.id = id++;
    particles.insert(seed.cell, p);
  }
  particles.sort_occupied();
  return particles;
}

template bool shares_cell<2>(int);
template bool shares_cell<3>(int);
template class CellPoints<2>;
template class CellPoints<3>;
template Real particles_in<2>(const BlockSettings&);
template Real particles_in<3>(const BlockSettings&);
template int particles_per_cell<2>(const BodySettings&, const std::string&);
template int particles_per_cell<3>(const BodySettings&, const std::string&);
template Index filled_region<2>(const mesh::Mesh<2>&, const std::string&, const std::string&);
template Index filled_region<3>(const mesh::Mesh<3>&, const std::string&, const std::string&);
template Particles<2> fill(const mesh::Mesh<2>&, const std::string&, const BodySettings&, const StartState<2>&);
template Particles<3> fill(const mesh::Mesh<3>&, const std::string&, const BodySettings&, const StartState<3>&);

}  // namespace berm::bodies
