// SPDX-License-Identifier: BSD-3-Clause
#include "picture/model_picture.hpp"

#include "os/text_of_list.hpp"
#include "picture/legend.hpp"
#include "picture/line_plan.hpp"
#include "picture/stage_words.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::picture {
namespace {

constexpr Real margin = 40, top = 112;               // pixels, around the picture
constexpr Real left_of_mesh = 74, below_mesh = 118;  // what dimensions, supports and the scale bar take
constexpr Real right_of_mesh = 40;
constexpr Real column_width = 560, gap = 60;  // of words beside a panel
constexpr Real max_wide = 430, max_high = 640, max_detail = 470;

/// Wide models: the whole across the picture, below it the detail, and words beside that. Gives the height of the picture.
Real lay_out_wide(Canvas& canvas, const Model& model)
{
  const Extent extent = whole_extent(model);
  const Scale whole(extent, {Vec<2>(margin + left_of_mesh, top), Vec<2>(picture_width - margin - right_of_mesh, top + max_wide)});
  const std::optional<Extent> detail = detail_extent(model);
  draw_whole(canvas, model, whole, !detail);
  const Real below = whole.window().lower_right[1] + below_mesh;
  const Real right = picture_width - margin - column_width;
  if (!detail)
    return std::max(draw_legend(canvas, model, {margin, below}, right - gap - margin),
                    draw_stages(canvas, model, {right, below}, column_width));
  const Scale enlarged(*detail, {Vec<2>(margin, below + 8), Vec<2>(right - gap, below + 8 + max_detail)});
  draw_detail(canvas, model, enlarged);
  const Real words = draw_legend(canvas, model, {right, below}, column_width), under = enlarged.window().lower_right[1] + 44;
  // Stages stand below the lower of the two.
  if (under + 100 < words) return std::max(words, draw_stages(canvas, model, {margin, under}, right - gap - margin));
  return std::max(under, draw_stages(canvas, model, {right, words}, column_width));
}

/// Others: the whole at the left, words at the right, and the detail above them.
Real lay_out_high(Canvas& canvas, const Model& model)
{
  const Real right = picture_width - margin - column_width;
  const Scale whole(whole_extent(model), {Vec<2>(margin + left_of_mesh, top), Vec<2>(right - gap, top + max_high)});
  const std::optional<Extent> detail = detail_extent(model);
  draw_whole(canvas, model, whole, !detail);
  Real level = top - 12;
  if (detail) {
    const Scale enlarged(*detail, {Vec<2>(right, top), Vec<2>(right + column_width, top + 0.8 * max_detail)});
    draw_detail(canvas, model, enlarged);
    level = enlarged.window().lower_right[1] + 40;
  }
  level = draw_legend(canvas, model, {right, level}, column_width);
  return std::max(whole.window().lower_right[1] + below_mesh - 20, draw_stages(canvas, model, {right, level}, column_width));
}

std::string description_of(const Model& model)
{
  const Sketch& sketch = model.sketch;
  const auto size_words = [](const Extent& extent) {
    return text::length_words(extent.size()[0]) + " by " + text::length_words(extent.size()[1]);
  };
  std::vector<std::string> parts;
  if (!model.ground.pieces.empty()) parts.push_back("mesh of " + size_words({model.ground.lower, model.ground.upper}));
  for (const NamedOutline& rigid : sketch.rigid_bodies) {
    const Extent extent = extent_of(rigid.outline);
    const Vec<2> middle = 0.5 * (extent.lower + extent.upper);
    parts.push_back(fmt::format("rigid body {} of {} at x = {}, y = {}", rigid.name, size_words(extent), text::length_words(middle[0]),
                                text::length_words(middle[1])));
  }
  for (const HeldSides& held : model.ground.held) parts.push_back(fmt::format("{}: {}", held.boundary, held.words));
  for (const settings::StageSettings& stage : model.settings.stage) parts.push_back(stage_words(stage, model.settings.force_dimension()));
  return text_of_list(parts, "; ");
}

void draw_gravity(Canvas& canvas, const Vec<2>& gravity, const Vec<2>& at)
{
  const Real size = gravity.norm();
  if (size == 0) return;
  const Vec<2> along = Vec<2>(gravity[0], -gravity[1]) / size;
  canvas.arrow(at - 24 * along, at + 24 * along, {quiet_color, 1.5});
  canvas.text(at + Vec<2>(0, 40), fmt::format("{:.3g} g", size / standard_gravity), {.anchor = Anchor::center});
}

// Of a drawing on a page.
constexpr Real page_scale = 0.82, page_top = 44, min_page_width = 400;

std::string whole_on_page(const Model& model, const std::string& title, bool with_path)
{
  const Scale scale(whole_extent(model), {Vec<2>(110, page_top), Vec<2>(110 + 560, page_top + 400)});
  const Window seen = scale.window();
  const Real width = std::max(seen.size()[0], min_page_width);
  Canvas canvas(Canvas::Place::page);
  draw_whole(canvas, model, scale, with_path);
  draw_gravity(canvas, model.sketch.gravity, Vec<2>(seen.lower_right[0] + 56, page_top + 30));
  Vec<2> at(seen.upper_left[0], seen.lower_right[1] + 108);
  at[1] = draw_names(canvas, model, at, width);
  if (with_path) at[1] = draw_stages(canvas, model, at, width);
  return canvas.svg({at[0] + width + 84, at[1]}, title, description_of(model), page_scale);
}

std::string detail_on_page(const Model& model, const std::string& title, const Extent& detail)
{
  const Scale scale(detail, {Vec<2>(16, page_top), Vec<2>(16 + 500, page_top + 340)});
  const Real width = std::max(scale.window().size()[0], min_page_width);
  Canvas canvas(Canvas::Place::page);
  canvas.text({16, 20}, "enlarged");
  draw_detail(canvas, model, scale);
  const Real height = draw_stages(canvas, model, {16, scale.window().lower_right[1] + 40}, width);
  return canvas.svg({16 + width + 16, height}, title + ", enlarged", description_of(model), page_scale);
}

std::string plan_on_page(const settings::Case& c, const std::string& title)
{
  constexpr Real width = 900;
  Canvas canvas(Canvas::Place::page);
  const Real height = draw_line_plan(canvas, c, {0, 12}, width);
  return canvas.svg({width, height}, title + ", plan of the line", "the line from above: imperfection, slices, springs beyond them, ends",
                    page_scale);
}

}  // namespace

void draw_model(const settings::Case& c, const mesh::Mesh<2>& mesh, const std::filesystem::path& file)
{
  std::vector<bodies::RigidShape<2>> shapes;
  for (const auto& [rigid_name, rigid] : c.rigid) shapes.push_back(bodies::make_shape<2>(rigid.shape));
  const problem::Ground bed = problem::ground_in(c, mesh, shapes);
  const Sketch sketch = sketch_of(c, bed);
  const Ground ground = ground_of(c, mesh, bed);
  const Model model{c, sketch, ground};
  const std::string title = c.title.empty() ? file.stem().string() : c.title;
  Canvas canvas(Canvas::Place::file);
  canvas.text({margin, 34}, title, {.size = 17, .bold = true});
  canvas.text({margin, 62}, method_words(model), {.color = quiet_color});
  const Vec<2> size = whole_extent(model).size();
  Real height = size[0] > 1.5 * size[1] ? lay_out_wide(canvas, model) : lay_out_high(canvas, model);
  if (c.pipeline) height = draw_line_plan(canvas, c, {margin, height + 30}, picture_width - 2 * margin);
  canvas.write(file, {picture_width, std::ceil(height + 20)}, title, description_of(model));
}

PageDrawing draw_on_page(const settings::Case& c, const problem::Ground& bed, const std::string& title)
{
  const Sketch sketch = sketch_of(c, bed);
  const Ground ground = ground_of(c, sketch);
  const Model model{c, sketch, ground};
  const std::optional<Extent> detail = detail_extent(model);
  PageDrawing drawing{whole_on_page(model, title, !detail), sketch.notes};
  if (detail) drawing.svgs += detail_on_page(model, title, *detail);
  if (c.pipeline) drawing.svgs += plan_on_page(c, title);
  return drawing;
}

}  // namespace berm::picture
