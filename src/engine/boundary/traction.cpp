// SPDX-License-Identifier: BSD-3-Clause
#include "boundary/traction.hpp"

#include "bodies/fill.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::boundary {
namespace {

constexpr int points_along_edge = 4, points_along_triangle = 3;

/// The corners of the face opposite to a corner.
template <int dim>
std::array<Index, dim> face_of(const mesh::Mesh<dim>& mesh, Index cell, int corner)
{
  std::array<Index, dim> face;
  for (int k = 0, n = 0; k <= dim; ++k)
    if (k != corner) face[n++] = mesh.nodes[cell][k];
  return face;
}

/// Points on a face, each with an equal part of it, and the part of the face that is loaded.
template <int dim>
std::pair<std::vector<Vec<dim>>, Real> points_on(const mesh::Mesh<dim>& mesh, const TractionSettings& traction,
                                                 const std::array<Index, dim>& face)
{
  std::vector<Vec<dim>> points;
  if constexpr (dim == 2) {
    const Vec<2>&begin = mesh.position[face[0]], &end = mesh.position[face[1]];
    const LoadedRange range = loaded_range(traction, begin, end);
    const Real loaded = range.to - range.from;
    if (!(loaded > 0)) return {points, 0};
    for (int n = 0; n < points_along_edge; ++n)
      points.push_back(begin + (range.from + loaded * (n + 0.5) / points_along_edge) * (end - begin));
    return {points, loaded};
  } else {
    for (const auto& at : bodies::points_in_simplex<2>(points_along_triangle))
      points.push_back(at[0] * mesh.position[face[0]] + at[1] * mesh.position[face[1]] + at[2] * mesh.position[face[2]]);
    return {points, 1};
  }
}

}  // namespace

void describe(Describe& d, TractionSettings& traction)
{
  d.value("boundary", traction.boundary,
          {.meaning = "boundary of the mesh; the soil that is at it at the start is loaded, and the load moves with it", .required = true});
  d.value("stress", traction.stress,
          {.meaning = "force per area at the start, one number per direction, such as [0, \"-100 kPa\"]; its direction is constant",
           .unit = "Pa"});
  d.value("pressure", traction.pressure,
          {.meaning = "instead of stress: force per area against the soil, at a right angle to the boundary at the start; its "
                      "direction is constant",
           .unit = "Pa"});
  d.value(
      "pressure_gradient", traction.pressure_gradient,
      {.meaning =
           "increase of the pressure with depth below `level`, as that of water or of wet concrete does: pressure + gradient (level - y)",
       .unit = "Pa/m",
       .range = not_negative});
  d.value("level", traction.level,
          {.meaning = "y from which the pressure increases downwards; above it the pressure is `pressure`", .unit = "m"});
  d.value("x_range", traction.x_range,
          {.meaning = "from and to, in two dimensions: only this part of the boundary is loaded; absent = all of it", .unit = "m"});
  d.value("ramp", traction.ramp,
          {.meaning = "time over which it increases from zero, and falls to zero in a stage without it; 0 = at once",
           .unit = "s",
           .range = not_negative});
  d.value("stages", traction.stages, {.meaning = "names of the stages in which it acts; absent or empty = all"});
}

template <int dim>
Index loaded_boundary(const mesh::Mesh<dim>& mesh, const std::string& name, const TractionSettings& traction)
{
  const Index boundary = mesh.find_boundary(traction.boundary);
  if (boundary == none)
    throw KeyError(fmt::format("traction.{}.boundary: the mesh has no boundary \"{}\"; it has {}", name, traction.boundary,
                               text_of_list(mesh.boundary_names, ", ")));
  return boundary;
}

template <int dim>
Vec<dim> stress_on(const TractionSettings& traction, const Vec<dim>& normal, const Vec<dim>& x)
{
  if (traction.pressure)
    return -(*traction.pressure + traction.pressure_gradient * std::max(Real(0), traction.level.value_or(x[1]) - x[1])) * normal;
  return Eigen::Map<const Vec<dim>>(traction.stress.data());
}

LoadedRange loaded_range(const TractionSettings& traction, const Vec<2>& begin, const Vec<2>& end)
{
  LoadedRange range{0, 1};
  if (traction.x_range.empty()) return range;
  const Real length = end[0] - begin[0];
  if (length == 0) return traction.x_range[0] <= begin[0] && begin[0] <= traction.x_range[1] ? range : LoadedRange{0, 0};
  const Real a = (traction.x_range[0] - begin[0]) / length, b = (traction.x_range[1] - begin[0]) / length;
  return {std::max(range.from, std::min(a, b)), std::min(range.to, std::max(a, b))};
}

template <int dim>
std::vector<LoadedPoint<dim>> loaded_points(const mesh::Mesh<dim>& mesh, const std::string& name, const TractionSettings& traction,
                                            const std::vector<Index>& body_of_region)
{
  NodeField<char> at_boundary(mesh.node_count(), 0);
  for (const Index i : mesh.boundary_nodes[loaded_boundary(mesh, name, traction)]) at_boundary[i] = 1;
  const auto holds_soil = [&](Index cell) { return cell != none && body_of_region[mesh.region[cell]] != none; };
  std::vector<LoadedPoint<dim>> points_on_boundary;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (int corner = 0; corner <= dim && holds_soil(cell); ++corner) {
      const std::array<Index, dim> face = face_of(mesh, cell, corner);
      if (!std::all_of(face.begin(), face.end(), [&](Index i) { return at_boundary[i] != 0; })) continue;
      if (holds_soil(mesh.neighbor(cell, corner))) continue;
      const Vec<dim> inwards = mesh.shape(cell).gradient(corner);  // 1 / height long
      const auto [points, loaded] = points_on<dim>(mesh, traction, face);
      const Real area = loaded * dim * mesh.section(cell) * inwards.norm() / static_cast<Real>(std::max<std::size_t>(points.size(), 1));
      for (const Vec<dim>& x : points) {
        const Real weighted = area * weight_at(mesh.metric, x);
        points_on_boundary.push_back({cell, x, weighted * stress_on<dim>(traction, -inwards.normalized(), x), weighted});
      }
    }
  if (points_on_boundary.empty()) refuse_without_soil(name, traction);
  return points_on_boundary;
}

void refuse_without_soil(const std::string& name, const TractionSettings& traction)
{
  throw KeyError(fmt::format("traction.{}.{}: no body that fills regions has soil at the boundary \"{}\"{}", name,
                             traction.x_range.empty() ? "boundary" : "x_range", traction.boundary,
                             traction.x_range.empty() ? "" : " in this range"));
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template Index loaded_boundary(const mesh::Mesh<dim>&, const std::string&, const TractionSettings&);                                     \
  template Vec<dim> stress_on(const TractionSettings&, const Vec<dim>&, const Vec<dim>&);                                                  \
  template std::vector<LoadedPoint<dim>> loaded_points(const mesh::Mesh<dim>&, const std::string&, const TractionSettings&,                \
                                                       const std::vector<Index>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::boundary
