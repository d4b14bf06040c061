// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/spatial_seabed.hpp"

#include "mesh/coarsening.hpp"
#include "mesh/kuhn.hpp"
#include "os/error.hpp"

#include <fmt/format.h>

namespace berm::mesh {
namespace {

constexpr Real steepest_in_space = 60 * degree;  // cells are sheared along it
constexpr Real min_fraction = 0.5;               // of its height, to which the mesh above or below the fine zone is compressed
constexpr Real thinnest = 0.4;                   // brick, over near_size
constexpr Real slack = 1e-9;
constexpr Real most_along_axis = 1e5;

void refuse_unless(bool valid, const std::string& key, const std::string& message)
{
  if (!valid) throw KeyError(fmt::format("mesh.{}: {}", key, message));
}

/// The planes of the mesh along one axis: through all of `through`, which ascend, with cells as small as in the fine zone from near_from to near_to.
std::vector<Real> planes(const std::vector<Real>& through, Real near_from, Real near_to, const Coarsening& growth)
{
  std::vector<Real> all = {through.front()};
  for (std::size_t k = 1; k < through.size(); ++k) {
    const Real from = through[k - 1], to = through[k];
    const bool before = to <= near_from, after = from >= near_to;
    const Real edge = before ? near_from : near_to, sign = before ? -1 : 1;
    const auto cells_to = [&](Real x) { return before || after ? growth.count(std::abs(x - edge)) : (x - from) / growth.first; };
    const Real first = cells_to(from), last = cells_to(to);
    const Real cells = std::ceil(std::abs(last - first) - 1e-6);
    refuse_unless(cells <= most_along_axis, "near_size",
                  fmt::format("about {:.2g} cells would be made along one axis: enlarge near_size, growth or far_size", cells));
    const int count = std::max(1, static_cast<int>(cells));
    for (int n = 1; n < count; ++n) {
      const Real at = first + (last - first) * n / count;
      all.push_back(before || after ? edge + sign * growth.distance(at) : from + (to - from) * n / count);
    }
    all.push_back(to);
  }
  return all;
}

/// Planes between which the regions lie along one axis.
struct Walls {
  Real from, to;              ///< walls
  Real inner_from, inner_to;  ///< of the layer
  Real near_from, near_to;

  bool in_layer(Real x) const { return x < inner_from || x > inner_to; }
  bool in_fine_zone(Real x) const { return x > near_from && x < near_to; }
};

/// No layer lies along a wall at which the fine zone begins.
Walls walls(Real from, Real to, Real near_from, Real near_to, Real layer)
{
  return {from, to, near_from == from ? from : from + layer, near_to == to ? to : to - layer, near_from, near_to};
}

struct Bricks {
  Walls x, z;
  std::array<std::vector<Real>, 3> at;  ///< planes along each axis
};

std::vector<Real> sorted(std::vector<Real> values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// The surface without the slope; corners only inside of the walls.
GroundLine bent_surface(SeabedMesh bed)
{
  bed.slope = 0;
  return ground_of(bed);
}

Real back_of(const SeabedMesh& bed)
{
  return 0 - bed.back.value_or(*bed.width / 2);
}

Bricks bricks_of(const SeabedMesh& bed)
{
  const SeabedLayout plane = layout_of(bed);
  const Real back = back_of(bed);
  Bricks bricks{walls(plane.left, plane.right, bed.near_left, bed.near_right, bed.layer),
                walls(back, back + *bed.width, *bed.near_back, *bed.near_front, bed.layer),
                {}};
  const Coarsening growth{bed.near_size, bed.growth, plane.far_size};
  const auto through = [](const Walls& w) { return std::vector<Real>{w.from, w.inner_from, w.near_from, w.near_to, w.inner_to, w.to}; };
  std::vector<Real> xs = through(bricks.x);
  for (const Vec<2>& corner : bent_surface(bed).corners) xs.push_back(corner[0]);
  bricks.at[0] = planes(sorted(xs), bricks.x.near_from, bricks.x.near_to, growth);
  const std::vector<Real> ys = {-bed.depth, -bed.depth + bed.layer, -bed.near_depth, 0, bed.near_height, bed.headroom};
  bricks.at[1] = planes(sorted(ys), -bed.near_depth, bed.near_height, growth);
  bricks.at[2] = planes(sorted(through(bricks.z)), bricks.z.near_from, bricks.z.near_to, growth);
  return bricks;
}

/// How much of the rise of the surface a level y goes along with.
Real share_of_rise(const SeabedMesh& bed, Real y)
{
  const Real fixed_below = -bed.depth + bed.layer;
  if (y < -bed.near_depth) return std::max(Real(0), (y - fixed_below) / (-bed.near_depth - fixed_below));
  if (y > bed.near_height) return (bed.headroom - y) / (bed.headroom - bed.near_height);
  return 1;
}

void check_faces(const SeabedMesh& bed)
{
  const auto refuse_steep = [](const char* key, Real angle) {
    refuse_unless(
        angle <= steepest_in_space * (1 + slack), key,
        fmt::format("is {:.4g} deg; in space cells follow the face, which can have 60 deg at most: make it flatter, or draw the mesh "
                    "in Gmsh",
                    angle / degree));
  };
  if (bed.trench) refuse_steep("trench.side_slope", bed.trench->side_slope);
  if (bed.step) refuse_steep("step.face_slope", bed.step->face_slope);
  Real low = 0, high = 0;
  for (const Vec<2>& corner : bent_surface(bed).corners) low = std::min(low, corner[1]), high = std::max(high, corner[1]);
  const Real below = bed.depth - bed.layer - bed.near_depth, above = bed.headroom - bed.near_height;
  refuse_unless(below + low >= min_fraction * below, "depth",
                fmt::format("the surface falls by {:.6g} m, for which {:.6g} m below the fine zone are not enough: at least {:.6g} m deep",
                            -low, below, bed.layer + bed.near_depth - low / (1 - min_fraction)));
  refuse_unless(above - high >= min_fraction * above, "headroom",
                fmt::format("the surface rises by {:.6g} m, for which {:.6g} m above the fine zone are not enough: at least {:.6g} m", high,
                            above, bed.near_height + high / (1 - min_fraction)));
}

/// Refuses planes so near each other that cells between them would shorten the time step.
void refuse_thin_bricks(const SeabedMesh& bed)
{
  const Bricks bricks = bricks_of(bed);
  constexpr const char* names[3] = {"x", "y", "z"};
  for (int d = 0; d < 3; ++d)
    for (std::size_t k = 1; k < bricks.at[d].size(); ++k) {
      const Real from = bricks.at[d][k - 1], to = bricks.at[d][k];
      refuse_unless(
          to - from >= thinnest * bed.near_size, "near_size",
          fmt::format("between {0} = {1:.6g} and {2:.6g} m cells would be {3:.2g} of it thin: let walls, layer, ends of the fine zone and "
                      "corners of the surface coincide there, or lie further apart",
                      names[d], from, to, (to - from) / bed.near_size));
    }
}

}  // namespace

void refuse_other_dimension(const SeabedMesh& bed, int dim)
{
  refuse_unless(
      dim == 3 || (!bed.width && !bed.back && !bed.near_back && !bed.near_front), "width",
      "width, back, near_back and near_front are of a bed in space, and the case is plane: leave them out, or use geometry = \"space\"");
  for (const auto& [key, value] : {std::pair{"width", bed.width}, {"near_back", bed.near_back}, {"near_front", bed.near_front}})
    refuse_unless(dim == 2 || value, key, "is missing: a bed in space needs width, near_back and near_front, along z");
}

void check_across(const SeabedMesh& bed)
{
  if (!bed.in_space()) return;
  refuse_other_dimension(bed, 3);
  const Real h = bed.near_size, back = back_of(bed), front = back + *bed.width;
  refuse_unless(std::isfinite(*bed.width) && *bed.width > 0, "width", fmt::format("is {:.6g} m; it must be positive", *bed.width));
  const auto fits_wall = [&](Real near, Real wall, Real inward, const char* key, const char* name) {
    const Real furthest = wall + inward * (bed.layer + h);
    refuse_unless(
        near == wall || (near - furthest) * inward >= 0, key,
        fmt::format("{:.6g} m must be {:.6g} m or more from the {} wall, its layer and near_size, that is z = {:.6g} m; or at that wall: "
                    "{:.6g} m",
                    near, bed.layer + h, name, furthest, wall));
  };
  fits_wall(*bed.near_back, back, 1, "near_back", "back");
  fits_wall(*bed.near_front, front, -1, "near_front", "front");
  refuse_unless(*bed.near_front - *bed.near_back >= h, "near_front",
                fmt::format("the fine zone from near_back {:.6g} m to near_front {:.6g} m is narrower than near_size {:.6g} m",
                            *bed.near_back, *bed.near_front, h));
  check_faces(bed);
  refuse_thin_bricks(bed);
}

Real cells_in_space(const SeabedMesh& bed)
{
  Real product = 6;
  for (const std::vector<Real>& planes : bricks_of(bed).at) product *= static_cast<Real>(planes.size() - 1);
  return product;
}

Mesh<3> make_spatial_seabed(const SeabedMesh& bed)
{
  check(bed);
  const Bricks bricks = bricks_of(bed);
  const GroundLine surface = bent_surface(bed);
  const auto& [xs, ys, zs] = bricks.at;
  const Index nx = static_cast<Index>(xs.size()), ny = static_cast<Index>(ys.size()), nz = static_cast<Index>(zs.size());

  Mesh<3> mesh;
  mesh.region_names = {"near", "bed", "headroom"};
  if (bed.layer > 0) mesh.region_names.emplace_back("layer");
  mesh.boundary_names = {"left", "right", "base", "top", "back", "front", "surface"};
  mesh.boundary_nodes.resize(mesh.boundary_names.size());
  for (Index k = 0; k < nz; ++k)
    for (Index j = 0; j < ny; ++j)
      for (Index i = 0; i < nx; ++i) {
        const bool on[] = {i == 0, i == nx - 1, j == 0, j == ny - 1, k == 0, k == nz - 1, ys[j] == 0};
        for (std::size_t b = 0; b < mesh.boundary_nodes.size(); ++b)
          if (on[b]) mesh.boundary_nodes[b].push_back(mesh.node_count());
        const Real rise = surface.level() ? 0 : surface.height(xs[i]) * share_of_rise(bed, ys[j]);
        mesh.position.push_back(Vec<3>(xs[i], ys[j] + rise + std::tan(bed.slope) * xs[i], zs[k]));
      }
  const auto region_of = [&](Real x, Real y, Real z) -> Index {
    if (y > 0) return 2;
    if (bed.layer > 0 && (y < -bed.depth + bed.layer || bricks.x.in_layer(x) || bricks.z.in_layer(z))) return 3;
    return y > -bed.near_depth && bricks.x.in_fine_zone(x) && bricks.z.in_fine_zone(z) ? 0 : 1;
  };
  const auto point = [&](const std::array<Index, 3>& at) { return (at[2] * ny + at[1]) * nx + at[0]; };
  for (Index k = 0; k + 1 < nz; ++k)
    for (Index j = 0; j + 1 < ny; ++j)
      for (Index i = 0; i + 1 < nx; ++i) {
        add_kuhn_cells<3>(mesh, {i, j, k}, point);
        const Index region = region_of((xs[i] + xs[i + 1]) / 2, (ys[j] + ys[j + 1]) / 2, (zs[k] + zs[k + 1]) / 2);
        for (int n = 0; n < 6; ++n) mesh.region.push_back(region);
      }
  mesh.complete();
  return mesh;
}

}  // namespace berm::mesh
