// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid/triangulated.hpp"

#include "bodies/rigid/triangle_faults.hpp"
#include "bodies/rigid/triangle_file.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <filesystem>

namespace berm::bodies {

void read_solid(TriangulatedSettings& surface)
{
  Triangles triangles = read_triangles(surface.file);
  for (Vec<3>& x : triangles.points) x *= surface.scale;
  if (const std::string fault = fault_of(triangles); !fault.empty()) throw InputError(fmt::format("{} {}", surface.file, fault));
  Contents contents = contents_of(triangles);
  if (contents.volume < 0) {  // all its triangles face inwards
    for (auto& corners : triangles.corners) std::swap(corners[1], corners[2]);
    contents.volume = -contents.volume;
  }
  Real left = infinity, right = -infinity;
  for (Vec<3>& x : triangles.points) {
    left = std::min(left, x[0]), right = std::max(right, x[0]);
    x = contents.axes.transpose() * (x - contents.center);
  }
  surface.solid = std::make_shared<const Solid>(Solid{contents, right - left, TriangleMesh(std::move(triangles))});
}

void describe(Describe& d, TriangulatedSettings& surface)
{
  d.value(
      "file", surface.file,
      {.meaning = "file of triangles, relative to the case file: STL, as text or binary, or OBJ. They must be closed", .required = true});
  d.value("scale", surface.scale, {.meaning = "length of a unit of the file: \"1 mm\"", .unit = "m", .range = positive});
  d.value("position", surface.position, {.meaning = "where the origin of the file lies; absent = at the origin", .unit = "m"});
  d.value("tilt", surface.rotation,
          {.meaning = "angles by which it is rotated about the fixed axes x, then y, then z, about the origin of the file", .unit = "rad"});
}

void check(Describe& d, const std::string& path, const TriangulatedSettings& surface, int dimension)
{
  d.check(dimension == 3, path + ".shape", "a surface of triangles needs three dimensions; in the plane use shape = \"polygon\"");
  check_entries(d, path + ".position", surface.position, 3, true);
  check_entries(d, path + ".tilt", surface.rotation, 3, true);
}

std::string name_of(const TriangulatedSettings& surface)
{
  return "surface of " + std::filesystem::path(surface.file).filename().string();
}
std::vector<ShapeSize> sizes_of(const TriangulatedSettings& surface)
{
  return surface.solid ? std::vector<ShapeSize>{{"width", surface.solid->width}} : std::vector<ShapeSize>{};
}
Outline outline_of(const TriangulatedSettings& surface)
{
  if (!surface.solid) return CornersOutline{};
  const Vec<3> none = Vec<3>::Zero();
  return hull_of(seen_along_z(surface_mesh<3>(make_shape<3>(surface), none, none).points));
}

template <int dim>
Triangulated<dim> make_shape(const TriangulatedSettings& s)
{
  Triangulated<dim> body{Vec<dim>::Zero(), Matrix<dim>::Identity(), s.solid};
  if constexpr (dim == 3) {
    if (!s.solid) throw InputError(fmt::format("{} is not read yet", s.file));
    const Matrix<3> rotated = turned_about_axes(s.rotation);
    body.center = to_vec<3>(s.position) + rotated * s.solid->contents.center;
    body.axes = rotated * s.solid->contents.axes;
  }
  return body;
}

template <int dim>
Real lowest_level(const Triangulated<dim>& body, const Vec<dim>& up)
{
  Real lowest = infinity;
  if constexpr (dim == 3) {
    const Vec<3> local = body.axes.transpose() * up;
    for (const Vec<3>& x : body.solid->mesh.triangles().points) lowest = std::min(lowest, local.dot(x));
  }
  return up.dot(body.center) + lowest;
}

template <int dim>
SurfaceMesh<dim> surface_mesh(const Triangulated<dim>& body, const Vec<dim>&, const Vec<dim>&)
{
  SurfaceMesh<dim> s;
  if constexpr (dim == 3) {
    for (const Vec<3>& x : body.solid->mesh.triangles().points) s.points.push_back(body.center + body.axes * x);
    for (const auto& [a, b, c] : body.solid->mesh.triangles().corners) s.add(SurfaceMesh<3>::Kind::polygon, {a, b, c});
  }
  return s;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template Triangulated<dim> make_shape<dim>(const TriangulatedSettings&);                                                                 \
  template Real lowest_level<dim>(const Triangulated<dim>&, const Vec<dim>&);                                                              \
  template SurfaceMesh<dim> surface_mesh<dim>(const Triangulated<dim>&, const Vec<dim>&, const Vec<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::bodies
