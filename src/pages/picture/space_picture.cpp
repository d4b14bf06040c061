// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/draw_test.cpp
#include "os/text_of_list.hpp"
#include "picture/model_picture.hpp"

#include "picture/canvas.hpp"
#include "picture/sketch.hpp"
#include "picture/stage_words.hpp"
#include "soil_plot/raster.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::picture {
namespace {

using soil_plot::isometric;

constexpr Real box_left = 90, box_top = 110, box_width = 700, box_height = 560;  // pixels: of what shows the model
constexpr Real words_left = 880, row_height = 24;                                // pixels: of the words beside it
constexpr int picture_height = 780;                                              // pixels

struct Box {
  Vec<3> lower = Vec<3>::Constant(infinity), upper = Vec<3>::Constant(-infinity);

  /// A corner by the bits of its number: 1 upper x, 2 upper y, 4 upper z.
  Vec<3> corner(int k) const
  {
    return {(k & 1) != 0 ? upper[0] : lower[0], (k & 2) != 0 ? upper[1] : lower[1], (k & 4) != 0 ? upper[2] : lower[2]};
  }
  void take(const Vec<3>& x)
  {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
  bool empty() const { return !(lower[0] <= upper[0]); }
};

Box soil_of(const bodies::BodySettings& body, const mesh::Mesh<3>& mesh)
{
  Box box;
  if (body.block) {
    for (int d = 0; d < 3; ++d) {
      box.lower[d] = body.block->center[d] - body.block->size[d] / 2;
      box.upper[d] = body.block->center[d] + body.block->size[d] / 2;
    }
    return box;
  }
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const std::string& region = mesh.region_names[mesh.region[cell]];
    if (std::find(body.regions.begin(), body.regions.end(), region) == body.regions.end()) continue;
    for (const Index node : mesh.nodes[cell]) box.take(mesh.position[node]);
  }
  return box;
}

/// From metres of the isometric picture to pixels, such that all of a mesh is seen, and of bodies beyond it as much as half its size.
class Placing {
public:
  Placing(const settings::Case& c, const mesh::Mesh<3>& mesh)
  {
    const Box box{mesh.lower, mesh.upper};
    Vec<2> lower = Vec<2>::Constant(infinity), upper = Vec<2>::Constant(-infinity);
    const auto take = [&](const Vec<3>& x) {
      lower = lower.cwiseMin(isometric(x));
      upper = upper.cwiseMax(isometric(x));
    };
    for (int k = 0; k < 8; ++k) take(box.corner(k));
    const Vec<3> half = (mesh.upper - mesh.lower) / 2;
    for (const auto& [name, rigid] : c.rigid)
      for (const Vec<3>& x : surface_mesh<3>(bodies::make_shape<3>(rigid.shape), mesh.lower, mesh.upper).points)
        take(x.cwiseMax(mesh.lower - half).cwiseMin(mesh.upper + half));
    scale_ = std::min(box_width / (upper[0] - lower[0]), box_height / (upper[1] - lower[1]));
    middle_ = 0.5 * (lower + upper);
  }
  Vec<2> operator()(const Vec<3>& x) const
  {
    const Vec<2> from = scale_ * (isometric(x) - middle_);
    return {box_left + box_width / 2 + from[0], box_top + box_height / 2 - from[1]};
  }

private:
  Real scale_;
  Vec<2> middle_;
};

void draw_edges(Canvas& canvas, const Placing& at, const Box& box, bool hidden)
{
  for (int k = 0; k < 8; ++k)
    for (int bit = 1; bit < 8; bit *= 2)
      if ((k & bit) == 0 && (k == 0) == hidden)
        canvas.line({at(box.corner(k)), at(box.corner(k | bit))}, {"#7d8791", 1, hidden ? dotted : ""});
}

/// The three sides of a box that are seen.
void draw_soil(Canvas& canvas, const Placing& at, const Box& box)
{
  const auto side = [&](std::array<int, 4> corners, const char* color) {
    Points points;
    for (const int k : corners) points.push_back(at(box.corner(k)));
    canvas.polygon(points, color);
    canvas.outline(points, {"#8a7550", 1});
  };
  side({1, 3, 7, 5}, "#c9b283");
  side({4, 5, 7, 6}, "#b89f6e");
  side({2, 3, 7, 6}, "#dcc9a0");
}

struct Face {
  Points points;
  Real depth;  ///< m towards who looks
  std::string color;
};

void add_face(std::vector<Face>& faces, const Placing& at, const std::vector<Vec<3>>& corners)
{
  Vec<3> middle = Vec<3>::Zero(), normal = Vec<3>::Zero();
  Points points;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<3>&a = corners[k], &b = corners[(k + 1) % corners.size()];
    middle += a / static_cast<Real>(corners.size());
    normal += Vec<3>(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    points.push_back(at(a));
  }
  if (!(normal.norm() > 0)) return;
  const Real light = 0.55 + 0.45 * std::abs(normal.normalized().dot(Vec<3>(0.35, 0.85, 0.4)));
  const auto part = [&](Real of) { return static_cast<int>(std::clamp(light * of, 0., 255.)); };
  faces.push_back({points, middle.sum(), fmt::format("#{:02x}{:02x}{:02x}", part(168), part(177), part(187))});
}

void draw_bodies(Canvas& canvas, const Placing& at, const settings::Case& c, const mesh::Mesh<3>& mesh)
{
  using Kind = bodies::SurfaceMesh<3>::Kind;
  constexpr int sides[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::vector<Face> faces;
  for (const auto& [name, rigid] : c.rigid) {
    const bodies::SurfaceMesh<3> surface = surface_mesh<3>(bodies::make_shape<3>(rigid.shape), mesh.lower, mesh.upper);
    for (const auto& cell : surface.cells) {
      if (cell.kind == Kind::line) continue;
      std::vector<Vec<3>> corners;
      for (const Index point : cell.points) corners.push_back(surface.points[point]);
      if (cell.kind != Kind::hexahedron)
        add_face(faces, at, corners);
      else
        for (const auto& side : sides) add_face(faces, at, {corners[side[0]], corners[side[1]], corners[side[2]], corners[side[3]]});
    }
  }
  std::stable_sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.depth < b.depth; });
  for (const Face& face : faces) {
    canvas.polygon(face.points, face.color);
    canvas.outline(face.points, {face.color, 0.6});  // no gaps between faces
  }
}

void draw_path(Canvas& canvas, const Placing& at, const settings::Case& c)
{
  for (const PathStep& step : sketch_of(c).path) {
    const Real z = center_of<3>(bodies::make_shape<3>(c.rigid[step.rigid].second.shape))[2];
    canvas.arrow(at({step.from[0], step.from[1], z}), at({step.to[0], step.to[1], z}), {"#d9480f", 2});
  }
}

void draw_dimensions(Canvas& canvas, const Placing& at, const Box& box)
{
  const auto along = [&](int from, int to, const char* axis, int d, const Vec<2>& beside, Anchor anchor) {
    const Vec<2> middle = 0.5 * (at(box.corner(from)) + at(box.corner(to)));
    canvas.text(middle + beside, fmt::format("{}: {}", axis, text::length_words(box.upper[d] - box.lower[d])), {.anchor = anchor});
  };
  along(4, 5, "x", 0, {-12, 16}, Anchor::right);
  along(1, 5, "z", 2, {12, 16}, Anchor::left);
  along(4, 6, "y", 1, {-12, 0}, Anchor::right);
}

void draw_axes(Canvas& canvas)
{
  const Vec<2> origin(box_left - 20, picture_height - 70);
  constexpr const char* names[] = {"x", "y", "z"};
  constexpr const char* colors[] = {"#d1495b", "#2a9d4a", "#3a78c9"};
  for (int d = 0; d < 3; ++d) {
    const Vec<2> way = isometric(Vec<3>::Unit(d)), end = origin + 45 * Vec<2>(way[0], -way[1]);
    canvas.arrow(origin, end, {colors[d], 2});
    canvas.text(origin + 58 * Vec<2>(way[0], -way[1]), names[d], {.anchor = Anchor::center, .color = colors[d]});
  }
}

void write_words(Canvas& canvas, const settings::Case& c, const mesh::Mesh<3>& mesh)
{
  Real level = box_top;
  const auto write = [&](const std::string& words, bool bold = false) {
    for (const std::string& line : Canvas::wrapped(words, TextStyle{}.size, picture_width - words_left - 20)) {
      canvas.text({words_left, level}, line, {.bold = bold});
      level += row_height;
    }
  };
  if (!c.rigid.empty()) write("Rigid bodies", true);
  for (const auto& [name, rigid] : c.rigid) {
    std::vector<std::string> sizes;
    for (const bodies::ShapeSize& size : std::visit([](const auto& shape) { return sizes_of(shape); }, rigid.shape))
      sizes.push_back(fmt::format("{} {}", size.name, text::length_words(size.size)));
    write(fmt::format("{}: {}", name, text_of_list(sizes, ", ")));
  }
  if (!c.symmetry.empty()) {
    write("Symmetry", true);
    write(fmt::format("a {} of the whole, mirrored across {}", c.symmetry.size() == 1 ? "half" : "quarter",
                      text_of_list(c.symmetry, " and ")));
  }
  if (!c.support.empty()) write("Held", true);
  for (const auto& [name, support] : c.support)
    write(fmt::format("{}: {}", mesh.boundary_names[fixed_boundary(mesh, name, support)], text_of_list(support.fixed, ", ")) +
          motion_words(support));
  if (!c.stage.empty()) write("Stages", true);
  int number = 0;
  for (const settings::StageSettings& stage : c.stage) write(fmt::format("{}  {}", ++number, stage_words(stage, c.force_dimension())));
}

}  // namespace

void draw_space(const settings::Case& c, const mesh::Mesh<3>& mesh, const std::filesystem::path& file)
{
  const Box whole{mesh.lower, mesh.upper};
  const Placing at(c, mesh);
  const std::string title = c.title.empty() ? file.stem().string() : c.title;
  Canvas canvas(Canvas::Place::file);
  canvas.text({40, 34}, title, {.size = 17, .bold = true});
  const std::string words = fmt::format("three-dimensional, {} cells; isometric", mesh.cell_count());
  canvas.text({40, 62}, words, {.color = quiet_color});
  draw_edges(canvas, at, whole, true);
  for (const auto& [body_name, body] : c.body)
    if (const Box box = soil_of(body, mesh); !box.empty()) draw_soil(canvas, at, box);
  draw_bodies(canvas, at, c, mesh);
  draw_edges(canvas, at, whole, false);
  draw_path(canvas, at, c);
  draw_dimensions(canvas, at, whole);
  draw_axes(canvas);
  write_words(canvas, c, mesh);
  canvas.write(file, {picture_width, picture_height}, title, words);
}

}  // namespace berm::picture
