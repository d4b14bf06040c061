// SPDX-License-Identifier: BSD-3-Clause
#include "picture/model_picture.hpp"

#include "picture/legend.hpp"

#include <algorithm>

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
  const report::Extent extent = whole_extent(model);
  const Scale whole(extent, {Vec<2>(margin + left_of_mesh, top), Vec<2>(picture_width - margin - right_of_mesh, top + max_wide)});
  const std::optional<report::Extent> detail = detail_extent(model);
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
  const std::optional<report::Extent> detail = detail_extent(model);
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

}  // namespace

bool draw_model(const problem::Case& c, const mesh::Mesh<2>& mesh, const std::filesystem::path& folder, const std::string& name,
                plot::PlotFormat format)
{
  std::vector<bodies::RigidShape<2>> shapes;
  for (const auto& [rigid_name, rigid] : c.rigid) shapes.push_back(bodies::make_shape<2>(rigid.shape));
  const problem::Ground bed = problem::ground_in(c, mesh, shapes);
  const report::Sketch sketch = report::sketch_of(c, bed);
  const Ground ground = ground_of(c, mesh, bed);
  const Model model{c, sketch, ground};
  Canvas canvas;
  canvas.text({margin, 34}, c.title.empty() ? name : c.title, {.size = 17, .bold = true});
  canvas.text({margin, 62}, method_words(model), {.size = 11, .color = "#555555"});
  const Vec<2> size = whole_extent(model).size();
  const Real height = size[0] > 1.5 * size[1] ? lay_out_wide(canvas, model) : lay_out_high(canvas, model);
  return canvas.draw(folder, name, picture_width, static_cast<int>(std::ceil(height + 20)), format);
}

}  // namespace berm::picture
