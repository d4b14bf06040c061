// SPDX-License-Identifier: BSD-3-Clause
#include "fem/cut_mesh.hpp"

#include "mesh/mesh_settings.hpp"
#include "os/error.hpp"
#include "problem/ground.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <system_error>

namespace berm::fem {
namespace {

namespace fs = std::filesystem;

// Changes of the bed's geometry by the rigid bodies.
struct Cuts {
  std::vector<std::string> surfaces;   // commands that draw the holes, after Surface(1)
  std::vector<Real> points;            // x of vertices that the surface y = 0 needs
  std::vector<std::string> distances;  // from the bodies, as formulas of x and y
};

std::vector<Vec<2>> corners_of(const bodies::Box<2>& box)
{
  const auto corner = [&](int a, int b) { return Vec<2>(box.center + box.axes * Vec<2>(a * box.half[0], b * box.half[1])); };
  return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
}

/// A polygon or a profile: its corners, also those of its arcs, and the middle of the rectangle around them.
struct Cornered {
  Vec<2> center, half;
  std::vector<Vec<2>> corners;
};
const std::vector<Vec<2>>& corners_of(const Cornered& shape)
{
  return shape.corners;
}

// Half the width and height of the upright rectangle around a shape.
Vec<2> half_extent(const bodies::Circle<2>& circle)
{
  return {circle.radius, circle.radius};
}
Vec<2> half_extent(const bodies::Box<2>& box)
{
  return box.axes.cwiseAbs() * box.half;
}

Vec<2> half_extent(const Cornered& shape)
{
  return shape.half;
}

std::string draw(const bodies::Circle<2>& circle, std::size_t tag)
{
  return fmt::format("Disk({}) = {{{}, {}, 0, {}}};\n", tag, circle.center[0], circle.center[1], circle.radius);
}
std::string draw(const bodies::Box<2>& box, std::size_t tag)
{
  const Vec<2>&c = box.center, &h = box.half;
  return fmt::format("Rectangle({}) = {{{}, {}, 0, {}, {}}};\n", tag, c[0] - h[0], c[1] - h[1], 2 * h[0], 2 * h[1]) +
         fmt::format("Rotate {{{{0, 0, 1}}, {{{}, {}, 0}}, {}}} {{ Surface{{{}}}; }}\n", c[0], c[1],
                     std::atan2(box.axes(1, 0), box.axes(0, 0)), tag);
}

std::string draw(const Cornered& shape, std::size_t tag)
{
  std::string text = "p = newp; l = newl; k = newll;\n";
  const std::size_t n = shape.corners.size();
  for (std::size_t k = 0; k < n; ++k) text += fmt::format("Point(p + {}) = {{{}, {}, 0}};\n", k, shape.corners[k][0], shape.corners[k][1]);
  for (std::size_t k = 0; k < n; ++k) text += fmt::format("Line(l + {}) = {{p + {}, p + {}}};\n", k, k, (k + 1) % n);
  return text + fmt::format("Curve Loop(k) = {{l:l + {}}};\nPlane Surface({}) = {{k}};\n", n - 1, tag);
}

std::string distance_formula(const bodies::Circle<2>& circle)
{
  return fmt::format("Abs(Sqrt((x - ({}))^2 + (y - ({}))^2) - {})", circle.center[0], circle.center[1], circle.radius);
}
/// From each side of a polygon, less the radius of its arcs.
std::vector<std::string> distance_formulas(const bodies::Polygon<2>& core, Real radius)
{
  std::vector<std::string> formulas;
  const std::vector<Vec<2>> corners = fem::corners_of(core);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2>&a = corners[k], &b = corners[(k + 1) % corners.size()];
    const Vec<2> middle = (a + b) / 2, along = (b - a).normalized();
    formulas.push_back(fmt::format("Max(0, Sqrt((({0}) * (y - ({3})) - ({1}) * (x - ({2})))^2 + Max(0, Abs(({0}) * (x - ({2})) + ({1}) * "
                                   "(y - ({3}))) - {4})^2) - {5})",
                                   along[0], along[1], middle[0], middle[1], (b - a).norm() / 2, radius));
  }
  return formulas;
}
std::string distance_formula(const bodies::Box<2>& box)
{
  const auto beyond = [&](int side) {
    return fmt::format("Max(0, Abs(({}) * (x - ({})) + ({}) * (y - ({}))) - {})^2", box.axes(0, side), box.center[0], box.axes(1, side),
                       box.center[1], box.half[side]);
  };
  return fmt::format("Sqrt({} + {})", beyond(0), beyond(1));
}

template <class Shape>
Cornered cornered(const Shape& shape)
{
  const std::vector<Vec<2>> corners = bodies::surface_mesh<2>(shape, Vec<2>::Zero(), Vec<2>::Zero()).points;
  Vec<2> lower = corners.front(), upper = lower;
  for (const Vec<2>& corner : corners) lower = lower.cwiseMin(corner), upper = upper.cwiseMax(corner);
  return {(lower + upper) / 2, (upper - lower) / 2, corners};
}

// x of the corners that lie on the surface of the bed, to rounding.
std::vector<Real> ends_on_surface(const bodies::Circle<2>&)
{
  return {};
}
template <class Shape>
std::vector<Real> ends_on_surface(const Shape& shape)
{
  const std::vector<Vec<2>> corners = corners_of(shape);
  const auto on_surface = [&](std::size_t k) { return std::abs(corners[k][1]) <= 1e-9 * shape.half.maxCoeff(); };
  std::vector<Real> ends;
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (const std::size_t next = (k + 1) % corners.size(); on_surface(k) && on_surface(next))
      ends.insert(ends.end(), {corners[k][0], corners[next][0]});
  if (ends.empty()) return ends;
  const auto [left, right] = std::minmax_element(ends.begin(), ends.end());
  return {*left, *right};
}

/// Whether part of a shape lies in soil whose surface is not level.
bool reaches_into(const mesh::GroundLine& ground, const bodies::Circle<2>& circle)
{
  return circle.center[1] < ground.height(circle.center[0]) || ground.distance(circle.center) < circle.radius * (1 - 1e-9);
}

void add_uneven_cut(Cuts& cuts, const mesh::SeabedMesh& bed, const mesh::GroundLine& ground, const std::string& name,
                    const bodies::RigidShape<2>& shape, bool may_lie_above)
{
  const auto* circle = std::get_if<bodies::Circle<2>>(&shape);
  if (circle == nullptr)
    throw KeyError(fmt::format(
        "rigid.{}.shape: of a bed that is not level only a \"circle\" can be cut out; a mesh of kind \"gmsh\" may have any hole", name));
  const mesh::SeabedLayout at = layout_of(bed);
  const Real x = circle->center[0], base = -bed.depth + std::tan(bed.slope) * x, r = circle->radius;
  const bool beside = x + r <= at.left || x - r >= at.right || circle->center[1] + r <= base, above = !reaches_into(ground, *circle);
  if (beside || (above && !may_lie_above))
    throw KeyError(fmt::format(
        "rigid.{}.center: the body at ({:.6g}, {:.6g}) m with its radius of {:.6g} m does not reach into the soil, whose surface is "
        "at y = {:.6g} m there; for finite elements it must lie in the soil at least partly; in large deformations it may also lie above "
        "it",
        name, x, circle->center[1], r, ground.height(x)));
  if (!above) cuts.surfaces.push_back(draw(*circle, cuts.surfaces.size() + 2));
}

template <class Shape>
void add_cut(Cuts& cuts, const mesh::SeabedMesh& bed, const std::string& name, const Shape& shape, bool may_lie_above)
{
  const mesh::SeabedLayout at = layout_of(bed);
  const Vec<2> half = half_extent(shape), lower = shape.center - half, upper = shape.center + half;
  const Real rounding = 1e-9 * half.maxCoeff();
  const std::vector<Real> ends = ends_on_surface(shape);
  const bool beside = lower[0] >= at.right || upper[0] <= at.left || upper[1] <= -bed.depth;
  const bool above = lower[1] >= -rounding, on_surface = above && ends.size() == 2;
  if (beside || (above && !on_surface && !may_lie_above))
    throw KeyError(fmt::format("rigid.{}.center: the body reaches from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m; for finite elements it must "
                               "lie in the soil, {:.6g} < x < {:.6g} m and {:.6g} < y < 0 m, at least partly, or lie on it with a flat "
                               "bottom; in large deformations it may also lie above it",
                               name, lower[0], lower[1], upper[0], upper[1], at.left, at.right, -bed.depth));
  if (on_surface)
    std::copy_if(ends.begin(), ends.end(), std::back_inserter(cuts.points), [&](Real x) { return at.left < x && x < at.right; });
  else if (!above)
    cuts.surfaces.push_back(draw(shape, cuts.surfaces.size() + 2));
}

Cuts cuts_of(const settings::Case& c, const mesh::SeabedMesh& bed)
{
  const mesh::GroundLine ground = ground_of(bed);
  Cuts cuts;
  for (const auto& [name, rigid] : c.rigid) {
    const auto touches = [&, &own = name](const auto& contact) { return contact.second.rigid == own; };
    if (std::none_of(c.contact.begin(), c.contact.end(), touches)) continue;
    const bodies::RigidShape<2> shape = make_shape<2>(rigid.shape);
    const Real width = width_of<2>(shape);
    if (c.fem.contact_size && *c.fem.contact_size < 1e-3 * width)
      throw KeyError(fmt::format("fem.contact_size: {:.6g} m is less than a thousandth of the width of [rigid.{}], {:.6g} m",
                                 *c.fem.contact_size, name, width));
    if (!ground.level())
      add_uneven_cut(cuts, bed, ground, name, shape, c.fem.large_deformation);
    else if (const auto* circle = std::get_if<bodies::Circle<2>>(&shape))
      add_cut(cuts, bed, name, *circle, c.fem.large_deformation);
    else if (const auto* box = std::get_if<bodies::Box<2>>(&shape))
      add_cut(cuts, bed, name, *box, c.fem.large_deformation);
    else if (const auto* polygon = std::get_if<bodies::Polygon<2>>(&shape))
      add_cut(cuts, bed, name, cornered(*polygon), c.fem.large_deformation);
    else if (const auto* profile = std::get_if<bodies::Profile<2>>(&shape))
      add_cut(cuts, bed, name, cornered(*profile), c.fem.large_deformation);
    else
      throw KeyError(fmt::format("rigid.{}.shape: a half-plane cannot be cut out of a mesh of kind \"seabed\": use kind \"gmsh\"", name));
    const std::vector<std::string> distances = distances_from(shape);
    cuts.distances.insert(cuts.distances.end(), distances.begin(), distances.end());
  }
  return cuts;
}

// A part of the bed: left < x < right, and above the bottom, which goes along the slope.
struct Part {
  Real left, right, bottom, incline;

  bool contains(const Vec<2>& x) const { return left < x[0] && x[0] < right && bottom < x[1] - incline * x[0]; }
};

Part fine_zone(const mesh::SeabedMesh& bed)
{
  const mesh::FineZone fine = fine_zone_of(bed);
  return {fine.left, fine.right, fine.lower, std::tan(bed.slope)};
}
Part inside_of_layer(const mesh::SeabedMesh& bed)
{
  const mesh::SeabedLayout at = layout_of(bed);
  return {at.left + bed.layer, at.right - bed.layer, -bed.depth + bed.layer, std::tan(bed.slope)};
}

// Whether the same bodies fill both regions.
bool alike(const settings::Case& c, const std::string& region, const std::string& other)
{
  return std::all_of(c.body.begin(), c.body.end(), [&](const auto& body) {
    const auto& regions = body.second.regions;
    return std::count(regions.begin(), regions.end(), region) == std::count(regions.begin(), regions.end(), other);
  });
}

// Lines of a rigid body and of a region that nearly touch make flat cells, so the border of a part is meshed only where it
// divides bodies.
std::vector<Part> parts_to_draw(const settings::Case& c, const mesh::SeabedMesh& bed)
{
  std::vector<Part> parts;
  if (!alike(c, "near", "bed")) parts.push_back(fine_zone(bed));
  if (bed.layer > 0 && !alike(c, "layer", "bed")) parts.push_back(inside_of_layer(bed));
  if (!parts.empty() && !ground_of(bed).level())
    throw KeyError(fmt::format(
        "body.{}.regions: of a bed that is not level finite elements take \"near\", \"bed\" and \"layer\" as one: fill all of them "
        "with the same body",
        c.body.front().first));
  return parts;
}

// The border of a part, from the surface down, along and up again.
std::string draw(const Part& part)
{
  return fmt::format("p = newp;\nPoint(p) = {{{0}, 0, 0}};\nPoint(p + 1) = {{{0}, {2}, 0}};\nPoint(p + 2) = {{{1}, {2}, 0}};\n"
                     "Point(p + 3) = {{{1}, 0, 0}};\nl = newl;\nLine(l) = {{p, p + 1}};\nLine(l + 1) = {{p + 1, p + 2}};\n"
                     "Line(l + 2) = {{p + 2, p + 3}};\nlines() += {{l, l + 1, l + 2}};\n",
                     part.left, part.right, part.bottom);
}

// The curves on a side of the bed, within a margin that is small for the mesh and large for round-off.
std::string curves_on(Real left, Real right, Real bottom, Real top, Real margin)
{
  return fmt::format("Curve In BoundingBox{{{}, {}, {}, {}, {}, {}}};\n", left - margin, bottom - margin, -margin, right + margin,
                     top + margin, margin);
}

// The outline of a bed that is not level, as Surface(1).
std::string draw(const mesh::SeabedMesh& bed, const mesh::GroundLine& ground)
{
  const mesh::SeabedLayout at = layout_of(bed);
  std::vector<Vec<2>> corners = ground.corners;
  for (const Real x : {at.right, at.left}) corners.emplace_back(x, -bed.depth + std::tan(bed.slope) * x);
  std::string text, loop;
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k) text += fmt::format("Point({}) = {{{}, {}, 0}};\n", k + 1, corners[k][0], corners[k][1]);
  for (std::size_t k = 0; k < n; ++k) {
    text += fmt::format("Line({}) = {{{}, {}}};\n", k + 1, k + 1, (k + 1) % n + 1);
    loop += fmt::format("{}{}", k == 0 ? "" : ", ", k + 1);
  }
  return text + fmt::format("Curve Loop(1) = {{{}}};\nPlane Surface(1) = {{1}};\n", loop);
}

// By the nodes' positions: in Gmsh a curve is found by a box around it, which of an inclined one may hold others.
void name_boundaries(mesh::Mesh<2>& mesh, const mesh::SeabedMesh& bed, const mesh::GroundLine& ground)
{
  const mesh::SeabedLayout at = layout_of(bed);
  const Real margin = 1e-6 * bed.near_size;
  mesh.boundary_names = {"left", "right", "base", "surface"};
  mesh.boundary_nodes.assign(4, {});
  for (Index i = 0; i < mesh.node_count(); ++i) {
    const Vec<2>& x = mesh.position[i];
    const bool on[] = {std::abs(x[0] - at.left) < margin, std::abs(x[0] - at.right) < margin,
                       std::abs(x[1] - std::tan(bed.slope) * x[0] + bed.depth) < margin, ground.distance(x) < margin};
    for (int k = 0; k < 4; ++k)
      if (on[k]) mesh.boundary_nodes[k].push_back(i);
  }
}

void write_cut_geo(const mesh::SeabedMesh& bed, const Cuts& cuts, const std::vector<Part>& parts, Real contact_size, const fs::path& path)
{
  const mesh::SeabedLayout at = layout_of(bed);
  std::ofstream out(path);
  out << "// A bed without the rigid bodies, made by berm. Lengths in metres.\n"
      << "SetFactory(\"OpenCASCADE\");\n";
  const mesh::GroundLine ground = ground_of(bed);
  if (!ground.level())
    out << draw(bed, ground);
  else
    out << fmt::format("Rectangle(1) = {{{}, {}, 0, {}, {}}};\n", at.left, -bed.depth, bed.length, bed.depth);
  for (const std::string& surface : cuts.surfaces) out << surface;
  if (!cuts.surfaces.empty())
    out << fmt::format("BooleanDifference{{ Surface{{1}}; Delete; }}{{ Surface{{2:{}}}; Delete; }}\n", cuts.surfaces.size() + 1);

  out << "lines() = {};\nends() = {};\n";
  for (const Part& part : parts) out << draw(part);
  for (const Real x : cuts.points) out << fmt::format("p = newp;\nPoint(p) = {{{}, 0, 0}};\nends() += {{p}};\n", x);
  if (!parts.empty()) out << "BooleanFragments{ Surface{:}; Delete; }{ Curve{lines()}; Delete; }\n";
  if (!cuts.points.empty()) out << "BooleanFragments{ Surface{:}; Delete; }{ Point{ends()}; Delete; }\n";

  const Real margin = 0.01 * bed.near_size;
  out << "Physical Surface(\"soil\") = Surface{:};\n";
  if (ground.level())
    out << "Physical Curve(\"left\") = " << curves_on(at.left, at.left, -bed.depth, 0, margin)
        << "Physical Curve(\"right\") = " << curves_on(at.right, at.right, -bed.depth, 0, margin)
        << "Physical Curve(\"base\") = " << curves_on(at.left, at.right, -bed.depth, -bed.depth, margin)
        << "Physical Curve(\"surface\") = " << curves_on(at.left, at.right, 0, 0, margin);

  std::vector<std::string> sizes = {size_formula(bed)};
  for (const std::string& distance : cuts.distances) sizes.push_back(fmt::format("{} + {} * {}", contact_size, bed.growth, distance));
  mesh::end_geometry(out, sizes, path);
}

/// Names the regions of a seabed by the centroids of cells.
void name_regions(mesh::Mesh<2>& mesh, const mesh::SeabedMesh& bed)
{
  mesh.region_names = {"near", "bed"};
  if (bed.layer > 0) mesh.region_names.emplace_back("layer");
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const Vec<2> x = mesh.centroid(cell);
    mesh.region[cell] = fine_zone(bed).contains(x) ? 0 : bed.layer == 0 || inside_of_layer(bed).contains(x) ? 1 : 2;
  }
}

}  // namespace

std::vector<std::string> distances_from(const bodies::RigidShape<2>& shape)
{
  if (const auto* circle = std::get_if<bodies::Circle<2>>(&shape)) return {distance_formula(*circle)};
  if (const auto* box = std::get_if<bodies::Box<2>>(&shape)) return {distance_formula(*box)};
  if (const auto* polygon = std::get_if<bodies::Polygon<2>>(&shape)) return distance_formulas(*polygon, 0);
  const auto& profile = std::get<bodies::Profile<2>>(shape);
  return distance_formulas(profile.core, profile.radius);
}

std::vector<Vec<2>> corners_of(const bodies::Polygon<2>& polygon)
{
  std::vector<Vec<2>> corners = *polygon.corners;
  for (Vec<2>& corner : corners) corner = polygon.center + polygon.axes * corner;
  return corners;
}

Real contact_size_of(const settings::Case& c)
{
  if (c.fem.contact_size) return *c.fem.contact_size;
  if (const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) return bed->near_size;
  const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh);
  Real size = 0;
  for (std::size_t d = 0; box != nullptr && d < box->size.size(); ++d)
    size = std::max(size, box->size[d] / static_cast<Real>(box->cells[d]));
  return size;
}

mesh::Mesh<2> make_cut_mesh(const settings::Case& c, const fs::path& case_folder, const fs::path& work_folder)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  if (bed == nullptr) return make_mesh<2>(c.mesh, case_folder, work_folder);
  check(*bed);
  const Cuts cuts = cuts_of(c, *bed);
  std::error_code failure;
  fs::create_directories(work_folder, failure);
  if (failure) throw RunError(fmt::format("the mesh cannot be written to {}: {}", work_folder.string(), failure.message()));
  const fs::path geo = work_folder / "mesh.geo", msh = work_folder / "mesh.msh";
  write_cut_geo(*bed, cuts, parts_to_draw(c, *bed), contact_size_of(c), geo);
  mesh::Mesh<2> mesh = mesh::mesh_by_gmsh<2>(geo, msh, "mesh");
  name_regions(mesh, *bed);
  if (const mesh::GroundLine ground = ground_of(*bed); !ground.level()) name_boundaries(mesh, *bed, ground);
  // The space above the bed is not in this mesh, so a support of its top fixes nothing.
  mesh.boundary_names.emplace_back("top");
  mesh.boundary_nodes.emplace_back();
  return mesh;
}

}  // namespace berm::fem
