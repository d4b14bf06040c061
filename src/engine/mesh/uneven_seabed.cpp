// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/uneven_seabed.hpp"

#include "os/error.hpp"
#include "os/text_of_list.hpp"

#include <algorithm>
#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <numbers>
#include <system_error>

namespace berm::mesh {
namespace {

constexpr Real steepest_slope = 45 * degree, steepest_face = 89 * degree;

/// Corners of the surface without the slope, from left to right; none where it is straight.
std::vector<Vec<2>> corners_of(const SeabedMesh& bed, bool with_trench)
{
  std::vector<Vec<2>> corners;
  if (bed.trench && with_trench) {
    const Trench& t = *bed.trench;
    const Real half = t.width / 2, run = t.depth / std::tan(t.side_slope);
    corners = {Vec<2>(t.center - half - run, 0), Vec<2>(t.center - half, -t.depth), Vec<2>(t.center + half, -t.depth),
               Vec<2>(t.center + half + run, 0)};
  }
  if (bed.step) {
    const Step& s = *bed.step;
    corners.emplace_back(s.position, 0);
    corners.emplace_back(s.position + std::abs(s.height) / std::tan(s.face_slope), s.height);
  }
  return corners;
}

/// The surface without the slope, from wall to wall.
GroundLine level_line(const SeabedMesh& bed, bool with_trench)
{
  const SeabedLayout at = layout_of(bed);
  GroundLine line{corners_of(bed, with_trench)};
  const Real first = line.level() ? 0 : line.corners.front()[1], last = line.level() ? 0 : line.corners.back()[1];
  line.corners.insert(line.corners.begin(), Vec<2>(at.left, first));
  line.corners.emplace_back(at.right, last);
  return line;
}

GroundLine line_of(const SeabedMesh& bed, bool with_trench)
{
  if (bed.slope == 0 && !(bed.trench && with_trench) && !bed.step) return {};
  GroundLine line = level_line(bed, with_trench);
  for (Vec<2>& corner : line.corners) corner[1] += std::tan(bed.slope) * corner[0];
  return line;
}

/// An end of the fine zone, moved where its upright line would make flat cells: off a steep face by a cell, onto a corner of a gentle one that is less than a cell away.
Real clear_of_faces(const SeabedMesh& bed, Real x, Real h)
{
  const std::vector<Vec<2>> corners = corners_of(bed, true);
  for (std::size_t k = 0; k + 1 < corners.size(); k += 2) {
    const Vec<2>&a = corners[k], &b = corners[k + 1];
    const bool steep = std::abs(b[1] - a[1]) > b[0] - a[0];
    if (steep && a[0] - h < x && x < b[0] + h) x = x - a[0] < b[0] - x ? a[0] - h : b[0] + h;
    for (const Real corner : {a[0], b[0]})
      if (!steep && std::abs(corner - x) < h) x = corner;
  }
  return x;
}

/// Draws points and lines of the geometry; a line is made once, and is then known by its number.
class Geometry {
public:
  explicit Geometry(const SeabedMesh& bed) : incline_(std::tan(bed.slope)) {}

  /// A point whose height is that at x = 0 of a line along the slope.
  int point(Real x, Real level)
  {
    text_ += fmt::format("Point({}) = {{{}, {}, 0}};\n", ++points_, x, level + incline_ * x);
    return points_;
  }
  int line(int from, int to)
  {
    text_ += fmt::format("Line({}) = {{{}, {}}};\n", ++lines_, from, to);
    return lines_;
  }
  /// Lines from point to point.
  std::vector<int> path(const std::vector<int>& points)
  {
    std::vector<int> lines;
    for (std::size_t k = 1; k < points.size(); ++k) lines.push_back(line(points[k - 1], points[k]));
    return lines;
  }
  int surface(const std::vector<int>& loop)
  {
    ++surfaces_;
    text_ += fmt::format("Curve Loop({0}) = {{{1}}};\nPlane Surface({0}) = {{{0}}};\n", surfaces_, text_of_list(loop, ", "));
    return surfaces_;
  }
  void name(const char* kind, const char* name, const std::vector<int>& members)
  {
    text_ += fmt::format("Physical {}(\"{}\") = {{{}}};\n", kind, name, text_of_list(members, ", "));
  }
  const std::string& text() const { return text_; }

private:
  Real incline_;
  int points_ = 0, lines_ = 0, surfaces_ = 0;
  std::string text_;
};

std::vector<int> backwards(std::vector<int> lines)
{
  std::reverse(lines.begin(), lines.end());
  for (int& line : lines) line = -line;
  return lines;
}

std::vector<int> joined(std::initializer_list<std::vector<int>> parts)
{
  std::vector<int> all;
  for (const std::vector<int>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::string geometry_of(const SeabedMesh& bed)
{
  const SeabedLayout at = layout_of(bed);
  const FineZone fine = fine_zone_of(bed);
  const GroundLine surface = level_line(bed, true);
  const Real left = at.left + bed.layer, right = at.right - bed.layer, bottom = -bed.depth + bed.layer;
  std::vector<Real> xs = {left, fine.left, fine.right, right};
  for (const Vec<2>& corner : corners_of(bed, true)) xs.push_back(corner[0]);
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());

  Geometry g(bed);
  std::vector<int> before, over, after;  // points of the surface left of the fine zone, in it, right of it
  for (const Real x : xs) {
    const int p = g.point(x, surface.height(x));
    if (x <= fine.left) before.push_back(p);
    if (x >= fine.left && x <= fine.right) over.push_back(p);
    if (x >= fine.right) after.push_back(p);
  }
  const std::vector<int> at_left = g.path(before), near = g.path(over), at_right = g.path(after);
  const int near_a = over.front(), near_b = over.back();
  const std::vector<int> below = g.path({near_a, g.point(fine.left, fine.lower), g.point(fine.right, fine.lower), near_b});
  const std::vector<int> above = g.path({near_a, g.point(fine.left, fine.upper), g.point(fine.right, fine.upper), near_b});
  const int base_a = g.point(left, bottom), base_b = g.point(right, bottom);
  const std::vector<int> around = g.path({before.front(), base_a, base_b, after.back()});
  const int top_a = g.point(at.left, bed.headroom), top_b = g.point(at.right, bed.headroom);
  const int top = g.line(top_a, top_b);

  const int near_soil = g.surface(joined({below, backwards(near)})), near_space = g.surface(joined({near, backwards(above)}));
  const int soil = g.surface(joined({around, backwards(at_right), backwards(below), backwards(at_left)}));
  std::vector<int> whole = joined({at_left, near, at_right}), left_wall = {around.front()}, right_wall = {around.back()},
                   base = {around[1]};
  int outer_a = before.front(), outer_b = after.back(), layer = 0;
  if (bed.layer > 0) {
    outer_a = g.point(at.left, surface.height(at.left)), outer_b = g.point(at.right, surface.height(at.right));
    const int first = g.line(outer_a, before.front()), last = g.line(after.back(), outer_b);
    const std::vector<int> outer = g.path({outer_a, g.point(at.left, -bed.depth), g.point(at.right, -bed.depth), outer_b});
    layer = g.surface(joined({outer, {-last}, backwards(around), {-first}}));
    whole.insert(whole.begin(), first), whole.push_back(last);
    left_wall = {outer.front()}, right_wall = {outer.back()}, base = {outer[1]};
  }
  const int up_left = g.line(outer_a, top_a), up_right = g.line(outer_b, top_b);
  std::vector<int> lower_side = whole;  // of the space: the surface, but around the fine zone
  const auto from = std::search(lower_side.begin(), lower_side.end(), near.begin(), near.end());
  lower_side.erase(from, from + static_cast<std::ptrdiff_t>(near.size()));
  const std::size_t index = at_left.size() + (bed.layer > 0 ? 1 : 0);
  lower_side.insert(lower_side.begin() + static_cast<std::ptrdiff_t>(index), above.begin(), above.end());
  const int space = g.surface(joined({lower_side, {up_right, -top, -up_left}}));

  g.name("Surface", "near", {near_soil});
  g.name("Surface", "bed", {soil});
  if (layer > 0) g.name("Surface", "layer", {layer});
  g.name("Surface", "headroom", {near_space, space});
  left_wall.push_back(up_left), right_wall.push_back(up_right);
  g.name("Curve", "surface", whole);
  g.name("Curve", "left", left_wall);
  g.name("Curve", "right", right_wall);
  g.name("Curve", "base", base);
  g.name("Curve", "top", {top});
  return g.text();
}

void fits(bool valid, const std::string& key, const std::string& message)
{
  if (!valid) throw KeyError(fmt::format("mesh.{}: {}", key, message));
}

void check_face(const std::string& key, Real angle, const char* what)
{
  fits(angle > 0 && angle <= steepest_face, key,
       fmt::format("is {:.4g} deg; {} must be more than 0 and at most 89 deg: write \"60 deg\", or \"89 deg\" for a vertical one",
                   angle / degree, what));
}

void check_trench(const SeabedMesh& bed)
{
  const Trench& t = *bed.trench;
  for (const auto& [key, value] : {std::pair{"depth", t.depth}, {"width", t.width}})
    fits(std::isfinite(value) && value > 0, std::string("trench.") + key, fmt::format("is {:.6g} m; it must be positive", value));
  check_face("trench.side_slope", t.side_slope, "the angle of the sides");
  const Real deepest = bed.depth - bed.layer - bed.near_size;
  fits(t.depth < deepest, "trench.depth",
       fmt::format(
           "{:.6g} m is too deep for the mesh, whose bed without its layer is {:.6g} m deep: make it shallower, or mesh.depth larger",
           t.depth, bed.depth - bed.layer));
  fits(t.width >= bed.near_size, "trench.width",
       fmt::format("{:.6g} m is narrower than a cell, near_size {:.6g} m: make it wider, or near_size smaller", t.width, bed.near_size));
  fits(t.depth >= bed.near_size, "trench.depth",
       fmt::format("{:.6g} m is less than a cell, near_size {:.6g} m: make it deeper, or near_size smaller", t.depth, bed.near_size));
}

void check_step(const SeabedMesh& bed)
{
  const Step& s = *bed.step;
  fits(std::isfinite(s.height) && std::abs(s.height) >= bed.near_size, "step.height",
       fmt::format("is {:.6g} m; it must be at least a cell, near_size {:.6g} m, up (positive) or down", s.height, bed.near_size));
  check_face("step.face_slope", s.face_slope, "the angle of the face");
  fits(-s.height < bed.depth - bed.layer - bed.near_size, "step.height",
       fmt::format(
           "goes {:.6g} m down, too deep for the mesh, whose bed without its layer is {:.6g} m deep: make it lower, or mesh.depth larger",
           -s.height, bed.depth - bed.layer));
}

}  // namespace

void describe(Describe& d, Trench& trench)
{
  d.value("depth", trench.depth, {.meaning = "depth below the bed beside it", .unit = "m", .range = positive, .required = true});
  d.value("width", trench.width, {.meaning = "width of its bottom", .unit = "m", .range = positive, .required = true});
  d.value("side_slope", trench.side_slope,
          {.meaning = "angle of its sides from the bed beside it, up to 89 deg", .unit = "rad", .range = positive, .required = true});
  d.value("center", trench.center, {.meaning = "x of its centre", .unit = "m"});
}

void describe(Describe& d, Step& step)
{
  d.value(
      "height", step.height,
      {.meaning = "level of the bed beyond the face relative to that before it, y = 0; less than 0: lower", .unit = "m", .required = true});
  d.value("position", step.position,
          {.meaning = "x where the face begins; beyond it, along x, is the other level", .unit = "m", .required = true});
  d.value("face_slope", step.face_slope,
          {.meaning = "angle of the face from the bed, up to 89 deg", .unit = "rad", .range = positive, .required = true});
}

GroundLine ground_of(const SeabedMesh& bed)
{
  return line_of(bed, true);
}

GroundLine ground_before_trench(const SeabedMesh& bed)
{
  return line_of(bed, false);
}

FineZone fine_zone_of(const SeabedMesh& bed)
{
  const Real left = clear_of_faces(bed, bed.near_left, bed.near_size), right = clear_of_faces(bed, bed.near_right, bed.near_size);
  const auto [low, high] = level_line(bed, true).heights(left, right);
  return {left, right, low - bed.near_depth, high + bed.near_height};
}

Real highest_surface_of(const SeabedMesh& bed)
{
  const SeabedLayout at = layout_of(bed);
  return level_line(bed, true).heights(at.left, at.right).second;
}

void check_ground(const SeabedMesh& bed)
{
  fits(std::isfinite(bed.slope) && std::abs(bed.slope) <= steepest_slope, "slope",
       fmt::format("is {:.4g} deg; it must lie between -45 and 45 deg: is the unit missing? A plain number is in radians, write \"10 deg\"",
                   bed.slope / degree));
  fits(!bed.trench || !bed.step, "step", "cannot be combined with a trench: leave one of them out, or draw both in a geometry of Gmsh");
  if (bed.trench) check_trench(bed);
  if (bed.step) check_step(bed);
  if (!bed.trench && !bed.step) return;
  const SeabedLayout at = layout_of(bed);
  const std::vector<Vec<2>> corners = corners_of(bed, true);
  const std::string key = bed.trench ? "trench.center" : "step.position";
  const Real left = at.left + bed.layer + 2 * bed.near_size, right = at.right - bed.layer - 2 * bed.near_size;
  fits(corners.front()[0] >= left && corners.back()[0] <= right, key,
       fmt::format(
           "the {} reaches from x = {:.6g} to {:.6g} m; it must lie between the walls and their layers, {:.6g} to {:.6g} m: move it, make "
           "it narrower or steeper, or mesh.length larger",
           bed.trench ? "trench" : "face", corners.front()[0], corners.back()[0], left, right));
  const FineZone fine = fine_zone_of(bed);
  for (const auto& [end, at_end] : {std::pair{"near_left", fine.left}, {"near_right", fine.right}})
    fits(clear_of_faces(bed, at_end, 0.5 * bed.near_size) == at_end, end,
         fmt::format("{:.6g} m lies between faces that are less than two cells apart: move it out of the trench", at_end));
  fits(fine.right - fine.left >= bed.near_size, "near_right", "the fine zone is narrower than near_size beside the faces");
  const Real lowest = -bed.depth + bed.layer + bed.near_size, highest = highest_surface_of(bed);
  fits(fine.lower >= lowest, "near_depth",
       fmt::format(
           "{:.6g} m below the lowest surface in the fine zone is y = {:.6g} m; it must stay above the base and its layer by near_size, "
           "{:.6g} m: make near_depth smaller, or mesh.depth larger",
           bed.near_depth, fine.lower, lowest));
  fits(bed.headroom >= std::max(fine.upper, highest) + bed.near_size, "headroom",
       fmt::format("{:.6g} m above y = 0 must be higher than the fine zone and all of the bed by near_size: at least {:.6g} m",
                   bed.headroom, std::max(fine.upper, highest) + bed.near_size));
}

void write_uneven_geo(const SeabedMesh& bed, const std::filesystem::path& path)
{
  std::ofstream out(path);
  out << "// A bed for a pipe that is not level, made by berm. Lengths in metres.\n" << geometry_of(bed);
  end_geometry(out, {size_formula(bed)}, path);
}

}  // namespace berm::mesh
