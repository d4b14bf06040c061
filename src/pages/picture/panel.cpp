// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/picture/model_picture_test.cpp
#include "picture/panel.hpp"

#include "picture/legend.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::picture {
namespace {

constexpr Real small_part = 0.3;       // of the whole: a driven body below this is drawn once more, enlarged
constexpr Real beyond = 0.5;           // of the mesh's size: so much of rigid bodies outside of it is drawn
constexpr Real smallest_cell = 3.5;    // pixels: of smaller cells no sides are drawn
constexpr Real support_distance = 22;  // pixels between two signs of a support
constexpr Real load_distance = 26;

Vec<2> in_pixels(const Vec<2>& metres)
{
  return {metres[0], -metres[1]};
}

Points in_pixels(const Scale& scale, const Points& points)
{
  Points moved;
  for (const Vec<2>& x : points) moved.push_back(scale(x));
  return moved;
}

void surface(Canvas& canvas, const Model& model, const Scale& scale)
{
  for (const Side& side : model.ground.surface) canvas.line({scale(side.from), scale(side.to)}, {surface_color, 1.8});
}

bool touches_soil(const Model& model, const std::string& rigid)
{
  const auto& contacts = model.settings.contact;
  return std::any_of(contacts.begin(), contacts.end(), [&](const auto& contact) { return contact.second.rigid == rigid; });
}

void blocks_and_disks(Canvas& canvas, const Model& model, const Scale& scale)
{
  for (const NamedOutline& body : model.sketch.bodies) {
    const Points points = outline_points(body.outline, scale, Vec<2>::Zero());
    canvas.polygon(points, soil_color(kind_of(model.ground, body.name)));
    canvas.outline(points, {surface_color, 1.8});
  }
}

/// The sides of cells that are long enough to be seen, each once; `soil`: of those with soil, else of those without.
void sides(Canvas& canvas, const Model& model, const Scale& scale, bool soil, const LineStyle& style)
{
  const auto before = [](const Vec<2>& a, const Vec<2>& b) { return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1]; };
  const auto side_before = [&](const auto& a, const auto& b) {
    return a.first != b.first ? before(a.first, b.first) : before(a.second, b.second);
  };
  std::vector<std::pair<Vec<2>, Vec<2>>> all;
  for (const Piece& piece : model.ground.pieces)
    for (std::size_t k = 0; k < piece.corners.size() && (piece.kind != none) == soil; ++k) {
      const Vec<2>&from = piece.corners[k], &to = piece.corners[(k + 1) % piece.corners.size()];
      if (scale.length((to - from).norm()) >= smallest_cell) all.emplace_back(std::minmax(from, to, before));
    }
  std::sort(all.begin(), all.end(), side_before);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (const auto& [from, to] : all) canvas.line({scale(from), scale(to)}, style);
}

void cells(Canvas& canvas, const Model& model, const Scale& scale)
{
  for (Index kind = 0; kind < static_cast<Index>(model.ground.kinds.size()); ++kind)
    for (const Piece& piece : model.ground.pieces)
      if (piece.kind == kind) canvas.polygon(in_pixels(scale, piece.corners), soil_color(kind));
  blocks_and_disks(canvas, model, scale);
  sides(canvas, model, scale, false, {"#a0a0a880", 0.8});
  if (model.ground.cells > 0) sides(canvas, model, scale, true, {mesh_color, 0.6});
}

/// Fills in the colour of their soil, excavations as a dashed line.
void earthworks(Canvas& canvas, const Model& model, const Scale& scale)
{
  for (const EarthworkSketch& work : model.sketch.earthworks) {
    const Points points = outline_points(work.outline, scale, Vec<2>::Zero());
    if (!work.material.empty()) canvas.polygon(points, soil_color(kind_of(model.ground, work.body, work.material)));
    canvas.outline(points, {work.material.empty() ? load_color : surface_color, 1.6, dashed});
  }
}

/// Their rim has the colour of contacts where there is one.
void rigid_bodies(Canvas& canvas, const Model& model, const Scale& scale)
{
  for (const NamedOutline& rigid : model.sketch.rigid_bodies) {
    const Points points = outline_points(rigid.outline, scale, Vec<2>::Zero());
    canvas.polygon(points, rigid_color);
    canvas.outline(points, {touches_soil(model, rigid.name) ? contact_color : rim_color, 2.4});
  }
}

void frame(Canvas& canvas, const Extent& extent, const Scale& scale)
{
  canvas.outline(in_pixels(scale, corners_of(extent)), {text_color, 1.4});
}

/// Whether a place is far enough from all earlier ones, which it joins then.
bool takes_place(std::vector<Vec<2>>& places, const Vec<2>& at, Real distance)
{
  const bool free = std::none_of(places.begin(), places.end(), [&](const Vec<2>& other) { return (other - at).norm() < distance; });
  if (free) places.push_back(at);
  return free;
}

/// What a support fixes, beside its boundary; a closed or bent boundary has no one place for it.
void support_words(Canvas& canvas, const HeldSides& held, const Scale& scale)
{
  Vec<2> middle = Vec<2>::Zero(), outward = Vec<2>::Zero();
  Real length = 0;
  for (const Side& side : held.sides) {
    const Vec<2> from = scale(side.from), to = scale(side.to);
    const Real part = (to - from).norm();
    middle += 0.5 * part * (from + to);
    outward += part * in_pixels(side.outward);
    length += part;
  }
  if (outward.norm() < 0.98 * length) return;
  outward.normalize();
  const bool upright = std::abs(outward[0]) > 0.7;
  canvas.text(middle / length + 21 * outward, held.words, {.size = 10, .anchor = Anchor::center, .upright = upright});
}

void supports(Canvas& canvas, const Model& model, const Scale& scale)
{
  std::vector<std::string> named;  // boundaries; there is no place for the words of a second support
  for (const HeldSides& held : model.ground.held) {
    if ((held.directions & 3) == 0 || held.sides.empty()) continue;
    std::vector<Side> in_turn = held.sides;  // so that signs are evenly apart
    std::sort(in_turn.begin(), in_turn.end(),
              [](const Side& a, const Side& b) { return (a.from + a.to).dot(Vec<2>(1, 1e-3)) < (b.from + b.to).dot(Vec<2>(1, 1e-3)); });
    std::vector<Vec<2>> places;
    for (const Side& side : in_turn) {
      Vec<2> from = scale(side.from), to = scale(side.to);
      if ((to - from).dot(Vec<2>(1, -1e-3)) < 0) std::swap(from, to);
      canvas.line({from, to}, {support_color, 2});
      const int parts = std::max(1, static_cast<int>((to - from).norm() / 2));
      for (int k = 0; k <= parts; ++k)
        if (const Vec<2> at = from + (to - from) * k / parts; takes_place(places, at, support_distance))
          support_sign(canvas, at, in_pixels(side.outward), held.directions & 3);
    }
    if (const bool has_words = std::find(named.begin(), named.end(), held.boundary) != named.end(); !has_words)
      support_words(canvas, held, scale);
    named.push_back(held.boundary);
  }
}

void loads(Canvas& canvas, const Model& model, const Scale& scale)
{
  std::vector<Vec<2>> places;
  for (const LoadedSpot& spot : model.ground.loaded)
    if (const Vec<2> at = scale(spot.at); takes_place(places, at, load_distance)) {
      const Vec<2> along = in_pixels(spot.along);
      canvas.arrow(at - 26 * along, at, {load_color, 1.5});
    }
}

/// Velocities at the start.
void flights(Canvas& canvas, const Model& model, const Scale& scale)
{
  for (const Flight& flight : model.sketch.flights) {
    const Vec<2> at = scale(flight.at), along = in_pixels(flight.velocity).normalized();
    canvas.arrow(at - 24 * along, at + 24 * along, {rim_color, 2});
    canvas.text(at + Vec<2>(0, along[1] > 0 ? -36 : 36), text::speed_words(flight.velocity.norm()), {.anchor = Anchor::center});
  }
}

/// Points that are watched; of those that lie close together one has its name.
void watches(Canvas& canvas, const Model& model, const Scale& scale)
{
  std::vector<Vec<2>> places;
  for (const auto& [name, watch] : model.settings.watch) {
    if (watch.point.size() < 2) continue;
    const Vec<2> at = scale(Vec<2>(watch.point[0], watch.point[1]));
    for (const Real way : {-1., 1.}) canvas.line({Vec<2>(at - Vec<2>(5, way * 5)), Vec<2>(at + Vec<2>(5, way * 5))}, {watch_color, 2});
    if (takes_place(places, at, 60)) canvas.text(at + Vec<2>(8, -6), name, {.size = 10, .color = watch_color});
  }
}

/// 1, 2 or 5 times a power of ten, not above a quarter of a width, m.
Real bar_length(Real width)
{
  const Real max = width / 4, power = std::pow(10., std::floor(std::log10(max)));
  for (const Real step : {5., 2.})
    if (step * power <= max) return step * power;
  return power;
}

void scale_bar(Canvas& canvas, const Scale& scale, const Vec<2>& at)
{
  const Real metres = bar_length(scale.extent().size()[0]);
  const Vec<2> end = at + Vec<2>(scale.length(metres), 0);
  canvas.line({at, end}, {text_color, 2});
  for (const Vec<2>& x : {at, end}) canvas.line({Vec<2>(x - Vec<2>(0, 4)), Vec<2>(x + Vec<2>(0, 4))}, {text_color, 2});
  canvas.text(end + Vec<2>(8, 0), text::length_words(metres), {.size = 10});
}

/// The level of the bed at x, where it has one.
std::optional<Real> level_at(const Model& model, Real x)
{
  const problem::Ground& bed = model.sketch.ground;
  return bed.line.level() ? model.sketch.surface : bed.line.height(x);
}

/// The lowest and the highest corner at the left wall.
std::pair<Real, Real> left_wall(const Ground& ground)
{
  const Real margin = 1e-9 * (ground.upper[0] - ground.lower[0]);
  Real low = infinity, high = -infinity;
  for (const Piece& piece : ground.pieces)
    for (const Vec<2>& x : piece.corners)
      if (x[0] <= ground.lower[0] + margin) low = std::min(low, x[1]), high = std::max(high, x[1]);
  return {low, high};
}

/// Length of the mesh below it; depth of the bed and headroom at the left wall, or its whole height there.
void mesh_dimensions(Canvas& canvas, const Model& model, const Scale& scale)
{
  if (model.ground.pieces.empty()) return;
  const Vec<2>&low = model.ground.lower, &high = model.ground.upper;
  const Vec<2> below(0, 48), aside(std::min(Real(0), scale.window().upper_left[0] - scale(low)[0]) - 42, 0);
  canvas.dimension(scale(low) + below, scale({high[0], low[1]}) + below, text::length_words(high[0] - low[0]));
  const auto height = [&](Real from, Real to) {
    canvas.dimension(scale({low[0], from}) + aside, scale({low[0], to}) + aside, text::length_words(to - from));
  };
  const auto [bottom, top] = left_wall(model.ground);
  const std::optional<Real> level = level_at(model, low[0]);
  if (level && scale.length(top - *level) > 14 && scale.length(*level - bottom) > 14) {
    height(bottom, *level);
    height(*level, top);
  } else {
    height(bottom, top);
  }
}

/// w beside a body: left of it where there is room for the words, else right of it.
void embedment(Canvas& canvas, const Scale& scale, const Extent& body, Real surface)
{
  constexpr Real room = 150;  // pixels
  const bool at_left = scale(body.lower)[0] > room;
  const Real x = at_left ? body.lower[0] : body.upper[0], axis = 0.5 * (body.lower[0] + body.upper[0]);
  const Vec<2> beside(at_left ? -16 : 16, 0), lowest = scale({x, body.lower[1]}) + beside, level = scale({x, surface}) + beside;
  canvas.line({lowest, scale({axis, body.lower[1]})}, {quiet_color, 0.8, dotted});
  canvas.line({level, scale({axis, surface})}, {quiet_color, 0.8, dotted});
  canvas.dimension(lowest, level, "");
  canvas.text(0.5 * (lowest + level) + 0.6 * beside, "w = " + text::length_words(surface - body.lower[1]),
              {.anchor = at_left ? Anchor::right : Anchor::left});
}

/// The width of each rigid body above it, and its embedment where it begins below the surface.
void rigid_dimensions(Canvas& canvas, const Model& model, const Scale& scale)
{
  for (const NamedOutline& rigid : model.sketch.rigid_bodies) {
    const Extent extent = extent_of(rigid.outline);
    if (extent.size()[0] <= 0) continue;
    const Vec<2> left = scale({extent.lower[0], std::min(extent.upper[1], scale.extent().upper[1])}),
                 right(scale(extent.upper)[0], left[1]);
    const std::string words =
        fmt::format("{} = {}", std::holds_alternative<DiskOutline>(rigid.outline) ? "D" : "B", text::length_words(extent.size()[0]));
    if (left[0] < scale.window().upper_left[0] || right[0] > scale.window().lower_right[0]) {  // not all of it is seen
      const Real middle = 0.5 * (std::max(left[0], scale.window().upper_left[0]) + std::min(right[0], scale.window().lower_right[0]));
      canvas.text({middle, left[1] + 20}, words, {.anchor = Anchor::center});
      continue;
    }
    canvas.dimension(left - Vec<2>(0, 14), right - Vec<2>(0, 14), words);
    const problem::Ground& bed = model.sketch.ground;
    if (!model.sketch.surface && bed.line.level()) continue;
    const Real surface = bed.level_at(0.5 * (extent.lower[0] + extent.upper[0]), model.sketch.surface.value_or(model.settings.surface));
    if (surface - extent.lower[1] <= 1e-3 * extent.size()[1] || extent.lower[1] < model.ground.lower[1]) continue;
    embedment(canvas, scale, extent, surface);
  }
}

void ground(Canvas& canvas, const Model& model, const Scale& scale)
{
  cells(canvas, model, scale);
  surface(canvas, model, scale);
  earthworks(canvas, model, scale);
  rigid_bodies(canvas, model, scale);
  canvas.outline(in_pixels(scale, model.sketch.fine), {fine_color, 1.6, dashed});
  watches(canvas, model, scale);
  flights(canvas, model, scale);
}

}  // namespace

std::string soil_color(Index kind)
{
  // Half of the ground below them is seen through them, white or dark.
  constexpr const char* colors[] = {"#cda74780", "#936b3780", "#6f935180", "#53839f80", "#b3674180", "#9179b180", "#3f8b7180", "#b18d8180"};
  return colors[static_cast<std::size_t>(kind < 0 ? 0 : kind) % std::size(colors)];
}

bool is_held_across(const Vec<2>& outward, int directions)
{
  return directions == (std::abs(outward[0]) > std::abs(outward[1]) ? 1 : 2);
}

void support_sign(Canvas& canvas, const Vec<2>& at, const Vec<2>& outward, int directions)
{
  const Vec<2> along(-outward[1], outward[0]);
  if (directions == 3) {
    for (const Real shift : {-7., 0., 7.}) {
      const Vec<2> foot = at + shift * along;
      canvas.line({foot, Vec<2>(foot + 8 * outward + 5 * along)}, {support_color, 1});
    }
  } else if (is_held_across(outward, directions)) {
    canvas.outline(Canvas::circle(at + 5 * outward, 4), {support_color, 1.2});
  } else {
    canvas.line({Vec<2>(at + 4 * outward - 7 * along), Vec<2>(at + 4 * outward + 7 * along)}, {support_color, 1.6});
  }
}

Points outline_points(const Outline& outline, const Scale& scale, const Vec<2>& moved)
{
  if (const auto* disk = std::get_if<DiskOutline>(&outline)) return Canvas::circle(scale(disk->center + moved), scale.length(disk->radius));
  if (const auto* plane = std::get_if<PlaneOutline>(&outline))
    return in_pixels(scale, part_inside({plane->point + moved, plane->normal}, scale.extent()));
  Points points;
  for (const Vec<2>& corner : std::get<CornersOutline>(outline).corners) points.push_back(scale(corner + moved));
  return points;
}

Scale::Scale(const Extent& extent, const Window& box)
    : extent_(extent),
      upper_left_(box.upper_left),
      scale_((box.size().array() / extent.size().array()).minCoeff())
{
}

void draw_whole(Canvas& canvas, const Model& model, const Scale& scale, bool with_path)
{
  canvas.open(scale.window());
  ground(canvas, model, scale);
  if (with_path) path_marks(canvas, model, scale);
  canvas.close();
  supports(canvas, model, scale);
  loads(canvas, model, scale);
  mesh_dimensions(canvas, model, scale);
  if (with_path) rigid_dimensions(canvas, model, scale);
  scale_bar(canvas, scale, Vec<2>(scale.window().upper_left[0], scale.window().lower_right[1] + 78));
  if (const std::optional<Extent> detail = detail_extent(model); detail && !with_path) {
    frame(canvas, *detail, scale);
    // Beside its foot: words of supports stand above and below the mesh.
    canvas.text(scale({detail->upper[0], std::max(detail->lower[1], model.ground.lower[1])}) + Vec<2>(5, -9), "enlarged", {.size = 10});
  }
}

void draw_detail(Canvas& canvas, const Model& model, const Scale& scale)
{
  canvas.open(scale.window());
  ground(canvas, model, scale);
  path_marks(canvas, model, scale);
  rigid_dimensions(canvas, model, scale);
  canvas.close();
  frame(canvas, scale.extent(), scale);
  scale_bar(canvas, scale, Vec<2>(scale.window().upper_left[0], scale.window().lower_right[1] + 18));
}

Extent whole_extent(const Model& model)
{
  Extent extent{model.ground.lower, model.ground.upper};
  const Vec<2> max = beyond * extent.size();
  const Extent limit{extent.lower - max, extent.upper + max};
  for (const NamedOutline& rigid : model.sketch.rigid_bodies) {
    const Extent body = extent_of(rigid.outline);
    extent = around(extent, {body.lower.cwiseMax(limit.lower), body.upper.cwiseMin(limit.upper)});
  }
  return extent;
}

std::optional<Extent> detail_extent(const Model& model)
{
  std::optional<Extent> way;
  Real size = 0;
  for (const PathStep& step : model.sketch.path) {
    const Extent start = extent_of(model.sketch.rigid_bodies[step.rigid].outline);
    const Vec<2> half = 0.5 * start.size();
    size = std::max(size, start.size().maxCoeff());
    for (const Vec<2>& center : {Vec<2>(0.5 * (start.lower + start.upper)), step.from, step.to}) {
      const Extent there{center - half, center + half};
      way = way ? around(*way, there) : there;
    }
  }
  const Extent mesh{model.ground.lower, model.ground.upper};
  if (!way || size <= 0 || size > small_part * mesh.size().maxCoeff()) return {};
  way->lower -= size * Vec<2>(0.8, 0.5);
  way->upper += size * Vec<2>(0.8, 0.35);
  return way;
}

}  // namespace berm::picture
