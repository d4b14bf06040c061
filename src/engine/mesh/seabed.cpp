// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/seabed.hpp"

#include "mesh/lattice_seabed.hpp"
#include "mesh/spatial_seabed.hpp"
#include "mesh/uneven_seabed.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <system_error>

namespace berm::mesh {
namespace {

/// An interval of one coordinate, and its distance from the fine zone.
struct Interval {
  Real distance, length;
};

/// Divides what lies beyond the fine zone, over `reach`, into intervals of nearly uniform cell size.
void add_stretches(std::vector<Interval>& intervals, const SeabedMesh& bed, Real reach)
{
  constexpr int count = 100;
  const Real grows = bed.growth * reach / bed.near_size;
  const auto position = [&](Real fraction) {
    return grows > 1e-6 ? bed.near_size / bed.growth * std::expm1(fraction * std::log1p(grows)) : fraction * reach;
  };
  for (int k = 0; k < count; ++k)
    intervals.push_back({position((k + 0.5) / count), position((k + 1.) / count) - position(Real(k) / count)});
}

// Points and lines of every bed; lines run to the right or up. The fine zone above the surface is a surface of its own,
// which improves its cells.
constexpr const char* lines_of_bed = R"(
Point(1) = {near_left, 0, 0};
Point(2) = {near_right, 0, 0};
Point(3) = {near_left, -near_depth, 0};
Point(4) = {near_right, -near_depth, 0};
Point(6) = {right - layer, 0, 0};
Point(8) = {right - layer, -depth + layer, 0};
Point(9) = {left, headroom, 0};
Point(10) = {right, headroom, 0};
Point(11) = {near_left, near_height, 0};
Point(12) = {near_right, near_height, 0};
Line(1) = {1, 2};
Line(2) = {3, 4};
Line(3) = {3, 1};
Line(4) = {4, 2};
Line(6) = {2, 6};
Line(8) = {8, 6};
Line(10) = {9, 10};
Line(11) = {1, 11};
Line(12) = {2, 12};
Line(13) = {11, 12};
)";

// On its left, and where the fine zone begins at the left wall, which has no layer.
constexpr const char* lines_on_left = R"(Point(5) = {left + layer, 0, 0};
Point(7) = {left + layer, -depth + layer, 0};
Line(5) = {5, 1};
Line(7) = {7, 5};
Line(9) = {7, 8};
)";
constexpr const char* lines_at_wall = R"(Point(7) = {left, -depth + layer, 0};
Line(7) = {7, 3};
Line(9) = {7, 8};
Line(14) = {11, 9};
)";

constexpr const char* lines_of_layer = R"(Point(22) = {right, 0, 0};
Point(23) = {left, -depth, 0};
Point(24) = {right, -depth, 0};
Line(24) = {6, 22};
Line(26) = {24, 22};
Line(27) = {23, 24};
)";

/// What closes a bed around its fine zone: further lines, the loops of the bed, the headroom and the layer, and the lines of its boundaries.
struct Outside {
  const char *lines, *bed, *headroom, *layer, *surface, *left, *right, *base;
};
/// With the fine zone away from the left wall, or at it; without a layer, or with one.
constexpr Outside outsides[2][2] = {
    {{"Line(21) = {5, 9};\nLine(22) = {6, 10};\n", "9, 8, -6, -4, -2, 3, -5, -7", "5, 11, 13, -12, 6, 22, -10, -21", "", "5, 1, 6", "7, 21",
      "8, 22", "9"},
     {"Point(21) = {left, 0, 0};\nLine(21) = {21, 9};\nLine(22) = {22, 10};\nLine(23) = {21, 5};\nLine(25) = {23, 21};\n",
      "9, 8, -6, -4, -2, 3, -5, -7", "23, 5, 11, 13, -12, 6, 24, 22, -10, -21", "27, 26, -24, -8, -9, 7, -23, -25", "23, 5, 1, 6, 24",
      "25, 21", "26, 22", "27"}},
    {{"Line(22) = {6, 10};\n", "9, 8, -6, -4, -2, -7", "13, -12, 6, 22, -10, -14", "", "1, 6", "7, 3, 11, 14", "8, 22", "9"},
     {"Line(22) = {22, 10};\nLine(28) = {23, 7};\n", "9, 8, -6, -4, -2, -7", "13, -12, 6, 24, 22, -10, -14", "27, 26, -24, -8, -9, -28",
      "1, 6, 24", "28, 7, 3, 11, 14", "26, 22", "27"}}};

std::string surfaces_of(const Outside& o)
{
  const bool layer = *o.layer != '\0';
  std::string text;
  const auto surface = [&](int number, const char* loop) {
    text += fmt::format("Curve Loop({0}) = {{{1}}};\nPlane Surface({0}) = {{{0}}};\n", number, loop);
  };
  surface(1, "2, 4, -1, -3");
  surface(2, o.bed);
  surface(3, "1, 12, -13, -11");
  surface(4, o.headroom);
  if (layer) surface(5, o.layer);
  text += "Physical Surface(\"near\") = {1};\nPhysical Surface(\"bed\") = {2};\nPhysical Curve(\"top\") = {10};\n"
          "Physical Surface(\"headroom\") = {3, 4};\n";
  if (layer) text += "Physical Surface(\"layer\") = {5};\n";
  for (const auto& [name, lines] : {std::pair{"surface", o.surface}, {"left", o.left}, {"right", o.right}, {"base", o.base}})
    text += fmt::format("Physical Curve(\"{}\") = {{{}}};\n", name, lines);
  return text;
}

/// Whether the fine zone begins at the left wall.
bool is_at_wall(const SeabedMesh& bed)
{
  return bed.near_left == layout_of(bed).left;
}

// Of Gmsh's algorithms for the plane, frontal Delaunay (6) with smoothing gives the largest smallest height, which sets the time step.
constexpr const char* gmsh_options = R"(
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeFromCurvature = 0;
Mesh.Algorithm = 6;
Mesh.Smoothing = 5;
Mesh.RandomSeed = 1;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 0;
General.NumThreads = 1;
)";

}  // namespace

void describe(Describe& d, SeabedMesh& bed)
{
  d.value("length", bed.length, {.meaning = "length of the bed, from wall to wall", .unit = "m", .range = positive, .required = true});
  d.value("depth", bed.depth,
          {.meaning = "depth of the bed, from its surface y = 0 to the base", .unit = "m", .range = positive, .required = true});
  d.value("headroom", bed.headroom,
          {.meaning = "height of free space above the surface, for the berm", .unit = "m", .range = positive, .required = true});
  d.value("left", bed.left,
          {.meaning = "distance from the pipe's initial position x = 0 to the left wall; left out: half the length. 0 for half a bed, or "
                      "one around an "
                      "axis: the fine zone then begins there, with near_left = 0",
           .unit = "m",
           .range = not_negative});
  d.value("near_size", bed.near_size,
          {.meaning = "size of the cells in the fine zone around the pipe's path", .unit = "m", .range = positive, .required = true});
  d.value("near_left", bed.near_left,
          {.meaning = "x where the fine zone begins (negative: left of the pipe's initial position)", .unit = "m", .required = true});
  d.value("near_right", bed.near_right, {.meaning = "x where the fine zone ends", .unit = "m", .required = true});
  d.value("near_depth", bed.near_depth,
          {.meaning = "depth of the fine zone below the surface", .unit = "m", .range = positive, .required = true});
  d.value("near_height", bed.near_height,
          {.meaning = "height of the fine zone above the surface", .unit = "m", .range = positive, .required = true});
  d.value("growth", bed.growth, {.meaning = "increase of the cell size per distance from the fine zone (m/m)", .range = not_negative});
  d.value("far_size", bed.far_size, {.meaning = "largest size of a cell; left out: not limited", .unit = "m", .range = positive});
  d.value("layer", bed.layer,
          {.meaning = "thickness of the outer layer along walls and base, and then the largest size of any cell; 0: none",
           .unit = "m",
           .range = not_negative});
  d.choice("pattern", bed.pattern, {"unstructured", "lattice"},
           {.meaning = "triangles of a plane bed by the material point method: as Gmsh lays them; or rows of equilateral triangles fixed "
                       "at x = 0, wider and "
                       "higher outside of the fine zone up to the walls, for level and sloping beds: results scatter less from mesh to "
                       "mesh, with up to twice the cells in all "
                       "(examples/mesh_patterns). Finite elements have a mesh of their own"});
  d.value("slope", bed.slope,
          {.meaning = "angle of the surface from the horizontal; positive rises along x, so that a drag along x is uphill. The surface "
                      "passes through y = 0 at x = 0; base and top follow the slope",
           .unit = "rad"});
  d.optional_table("trench", bed.trench, {.meaning = "a trench in the bed"});
  d.optional_table("step", bed.step, {.meaning = "a step of the bed"});
  d.value("width", bed.width,
          {.meaning = "in space, where it is required: width of the bed along z, from the back wall to the front wall",
           .unit = "m",
           .range = positive});
  d.value("back", bed.back,
          {.meaning = "in space: distance from z = 0 to the back wall; left out: half the width. 0 for half a bed with symmetry = [\"z\"]",
           .unit = "m",
           .range = not_negative});
  d.value("near_back", bed.near_back,
          {.meaning = "in space, where it is required: z where the fine zone begins, which may be at the back wall", .unit = "m"});
  d.value("near_front", bed.near_front,
          {.meaning = "in space, where it is required: z where the fine zone ends, which may be at the front wall", .unit = "m"});
}

SeabedLayout layout_of(const SeabedMesh& bed)
{
  const Real left = 0 - bed.left.value_or(bed.length / 2);
  // A layer thinner than its cells would be made of flat ones.
  const Real far_size = std::min(bed.far_size.value_or(infinity), bed.layer > 0 ? bed.layer : infinity);
  return {left, left + bed.length, std::max(far_size, bed.near_size)};
}

void check(const SeabedMesh& bed)
{
  const SeabedLayout at = layout_of(bed);
  const auto fits = [](bool valid, const std::string& key, const std::string& message) {
    if (!valid) throw KeyError(fmt::format("mesh.{}: {}", key, message));
  };
  for (const auto& [key, value] :
       {std::pair{"length", bed.length}, {"depth", bed.depth}, {"headroom", bed.headroom}, {"near_size", bed.near_size}})
    fits(std::isfinite(value) && value > 0, key, fmt::format("is {:.6g} m; it must be positive", value));
  for (const auto& [key, value] : {std::pair{"growth", bed.growth}, {"layer", bed.layer}})
    fits(std::isfinite(value) && value >= 0, key, fmt::format("is {:.6g}; it must not be negative", value));
  const Real h = bed.near_size;
  fits(!bed.far_size || *bed.far_size >= h, "far_size",
       fmt::format("{:.6g} m is smaller than near_size {:.6g} m; make it larger, or near_size smaller", bed.far_size.value_or(0), h));
  fits(bed.layer == 0 || bed.layer >= h, "layer",
       fmt::format("{:.6g} m is thinner than near_size {:.6g} m; make it thicker, or leave it out", bed.layer, h));
  fits(bed.near_height >= h, "near_height", fmt::format("{:.6g} m is lower than near_size {:.6g} m", bed.near_height, h));
  fits(bed.headroom >= bed.near_height + h, "headroom",
       fmt::format("{:.6g} m must be higher than near_height by near_size: at least {:.6g} m", bed.headroom, bed.near_height + h));
  fits(bed.near_depth >= h, "near_depth", fmt::format("{:.6g} m is smaller than near_size {:.6g} m", bed.near_depth, h));
  fits(bed.near_right - bed.near_left >= h, "near_right",
       fmt::format("the fine zone from near_left {:.6g} m to near_right {:.6g} m is narrower than near_size {:.6g} m", bed.near_left,
                   bed.near_right, h));
  fits(is_at_wall(bed) || bed.near_left >= at.left + bed.layer + h, "near_left",
       fmt::format("{:.6g} m must be right of the left wall and its layer by near_size: at least {:.6g} m; or at that wall: {:.6g} m",
                   bed.near_left, at.left + bed.layer + h, at.left));
  fits(!is_at_wall(bed) || ground_of(bed).level(), "near_left", "the fine zone can begin at the left wall of a level bed only");
  fits(bed.near_right <= at.right - bed.layer - h, "near_right",
       fmt::format("{:.6g} m must be left of the right wall and its layer by near_size: at most {:.6g} m", bed.near_right,
                   at.right - bed.layer - h));
  fits(bed.near_depth <= bed.depth - bed.layer - h, "near_depth",
       fmt::format("{:.6g} m must stay above the base and its layer by near_size: at most {:.6g} m", bed.near_depth,
                   bed.depth - bed.layer - h));
  fits(bed.pattern == SeabedPattern::unstructured || !(bed.in_space() || bed.trench || bed.step), "pattern",
       "a lattice is a level or sloping bed in the plane, without trench or step: leave pattern out");
  const bool begins_at_axis = at.left == 0 && bed.near_left == 0;
  fits(bed.pattern == SeabedPattern::unstructured || ((begins_at_axis || bed.near_left < 0) && bed.near_right > 0), "pattern",
       "a lattice is fixed at x = 0, where the body starts: near_left must be less than 0 and near_right more, or left and near_left 0; "
       "or leave pattern out");
  check_ground(bed);
  check_across(bed);
  const Real cells = bed.pattern == SeabedPattern::lattice ? cells_in_lattice(bed) : expected_cells(bed);
  fits(cells <= max_seabed_cells, "near_size",
       fmt::format("about {:.2g} cells would be made; at most {:.0e}: enlarge near_size, growth or far_size", cells, max_seabed_cells));
}

std::string size_formula(const SeabedMesh& bed)
{
  const Real far_size = layout_of(bed).far_size;
  const std::string limit = std::isfinite(far_size) ? fmt::format("Min({}, ", far_size) : "(";
  if (!ground_of(bed).level()) {
    const FineZone fine = fine_zone_of(bed);
    const std::string y = fmt::format("(y - ({}) * x)", std::tan(bed.slope));
    return fmt::format("{}{} + {} * Sqrt(Max(0, Max({} - x, x - ({})))^2 + Max(0, Max({} - {}, {} - ({})))^2))", limit, bed.near_size,
                       bed.growth, fine.left, fine.right, fine.lower, y, y, fine.upper);
  }
  return fmt::format("{}{} + {} * Sqrt(Max(0, Max({} - x, x - ({})))^2 + Max(0, Max({} - y, y - {}))^2))", limit, bed.near_size, bed.growth,
                     bed.near_left, bed.near_right, -bed.near_depth, bed.near_height);
}

Real expected_cells(const SeabedMesh& bed)
{
  if (bed.in_space()) return cells_in_space(bed);
  const SeabedLayout at = layout_of(bed);
  const FineZone fine = fine_zone_of(bed);
  std::vector<Interval> across = {{0, fine.right - fine.left}}, down = {{0, fine.upper - fine.lower}};
  for (const Real reach : {fine.left - at.left, at.right - fine.right}) add_stretches(across, bed, reach);
  for (const Real reach : {bed.depth + fine.lower, bed.headroom - fine.upper}) add_stretches(down, bed, reach);
  Real sum = 0;
  for (const Interval& x : across)
    for (const Interval& y : down) {
      const Real size = std::min(at.far_size, bed.near_size + bed.growth * std::hypot(x.distance, y.distance));
      sum += x.length * y.length / (size * size);
    }
  constexpr Real more = 1.1;  // than equilateral triangles of that size: 7 to 15 % in the beds of the tests
  return more * sum / (std::sqrt(3.) / 4);
}

void end_geometry(std::ofstream& out, const std::vector<std::string>& sizes, const std::filesystem::path& path)
{
  const std::size_t n = sizes.size();
  out << "\n// The size of a cell increases with its distance from where cells are fine.\n";
  for (std::size_t k = 0; k < n; ++k) out << fmt::format("Field[{0}] = MathEval;\nField[{0}].F = \"{1}\";\n", k + 1, sizes[k]);
  if (n > 1) out << fmt::format("Field[{0}] = Min;\nField[{0}].FieldsList = {{1:{1}}};\n", n + 1, n);
  out << fmt::format("Background Field = {};\n", n > 1 ? n + 1 : 1) << gmsh_options;
  out.close();
  if (!out) throw RunError(fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(errno)));
}

void write_geo(const SeabedMesh& bed, const std::filesystem::path& path)
{
  check(bed);
  const SeabedLayout at = layout_of(bed);
  if (!ground_of(bed).level()) return write_uneven_geo(bed, path);
  std::ofstream out(path);
  out << "// A flat bed for a pipe, made by berm. Lengths in metres; the seabed is y = 0.\n";
  for (const auto& [name, value] : {std::pair{"left", at.left},
                                    {"right", at.right},
                                    {"depth", bed.depth},
                                    {"headroom", bed.headroom},
                                    {"layer", bed.layer},
                                    {"near_left", bed.near_left},
                                    {"near_right", bed.near_right},
                                    {"near_depth", bed.near_depth},
                                    {"near_height", bed.near_height},
                                    {"near_size", bed.near_size},
                                    {"growth", bed.growth}})
    out << fmt::format("{} = {};\n", name, value);
  const Outside& outside = outsides[is_at_wall(bed)][bed.layer > 0];
  out << lines_of_bed << (is_at_wall(bed) ? lines_at_wall : lines_on_left) << (bed.layer > 0 ? lines_of_layer : "") << outside.lines
      << surfaces_of(outside);
  end_geometry(out, {size_formula(bed)}, path);
}

}  // namespace berm::mesh
