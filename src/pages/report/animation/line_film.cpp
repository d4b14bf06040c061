// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/line_film.hpp"

#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "report/animation/film_frames.hpp"
#include "report/animation/film_quantization.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/line/beds.hpp"
#include "structures/line/shapes.hpp"
#include "text/base64_zlib.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

using Json = nlohmann::ordered_json;
using line::Shape;
using Shapes = std::vector<Shape>;

constexpr Index max_frames_of_line = 400;                   // but for the ends of stages
constexpr Real parts_of_region = 400, parts_of_line = 400;  // nodes are kept where they are farther apart than such a part
constexpr std::pair<const char*, std::vector<Real> Shape::*> quantities_of_line[] = {
    {"y", &Shape::y}, {"P", &Shape::P}, {"M", &Shape::M}, {"strain_max", &Shape::strain_max}, {"strain_min", &Shape::strain_min}};

/// x of the slices that the history tells of.
std::vector<Real> places_of_slices(const record::RunRecord& run)
{
  std::vector<Real> places = settings::places_of(run.settings.pipeline->slices);
  std::size_t count = 1;
  while (count < places.size() && run.history.has(fmt::format("slice_{}_u_m", count))) ++count;
  places.resize(count);
  return places;
}

/// How far from x = 0 the line moves sideways, by more than a hundredth of the most; not less than to the last slice, and some more.
Real moved_region(const Shapes& shapes, Real last_slice)
{
  constexpr Real small = 0.01, more = 1.1;
  Real most = 0, region = last_slice;
  for (const Shape& shape : shapes)
    for (const Real y : shape.y) most = std::max(most, std::abs(y));
  for (const Shape& shape : shapes)
    for (std::size_t k = 0; k < shapes.front().x.size(); ++k)
      if (std::abs(shape.y[k]) > small * most) region = std::max(region, shapes.front().x[k]);
  return std::min(more * region, shapes.front().x.back());
}

/// Nodes that a page can tell apart; the first and the last among them.
std::vector<std::size_t> kept_nodes(const std::vector<Real>& x, Real region)
{
  std::vector<std::size_t> kept{0};
  for (std::size_t k = 1; k < x.size(); ++k) {
    const Real apart = x[kept.back()] < region ? region / parts_of_region : x.back() / parts_of_line;
    if (x[k] - x[kept.back()] >= apart || k + 1 == x.size()) kept.push_back(k);
  }
  return kept;
}

/// The numbers of a quantity at the nodes and frames that are kept, as a block; its range.
Json block_of(Film& film, const std::string& id, const std::vector<std::vector<Real>>& values)
{
  std::vector<const std::vector<Real>*> frames;
  for (const std::vector<Real>& frame : values) frames.push_back(&frame);
  const auto [low, high] = ends_of(frames);
  const Real step = high > low ? (high - low) / max_code : 1;
  film.blocks.push_back({id, text::packed(axis_bytes(frames, low, step))});
  return {{"low", low}, {"step", step}, {"block", id}};
}

/// How far the soil has risen, at the frames that are kept; null without it.
Json bed_of(Film& film, const line::Beds& beds, const std::vector<Index>& frames, const std::string& id)
{
  std::vector<std::vector<Real>> values;
  Json first;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const Index frame = frames[f] - beds.first_frame;
    if (frame < 0 || frame >= static_cast<Index>(beds.rise.size())) continue;
    if (values.empty()) first = f;
    values.push_back(beds.rise[static_cast<std::size_t>(frame)]);
  }
  if (values.empty()) return nullptr;
  Json bed = block_of(film, id, values);
  bed["first"] = first;
  bed["frames"] = values.size();
  bed["y"] = beds.y;
  return bed;
}

/// The last frames (of those kept) of the stages that load the line.
Json ends_of_stages(const record::RunRecord& run, const std::vector<std::string>& stages)
{
  Json ends = Json::array();
  for (const settings::StageSettings& stage : run.settings.stage) {
    const auto last = std::find(stages.rbegin(), stages.rend(), stage.name);
    if (stage.kind != settings::StageKind::pipeline || last == stages.rend()) continue;
    ends.push_back({{"name", stage.name}, {"frame", std::distance(last, stages.rend()) - 1}});
  }
  return ends;
}

const char* word_of(settings::LineHalf half)
{
  return half == settings::LineHalf::symmetric ? "symmetric" : half == settings::LineHalf::antisymmetric ? "antisymmetric" : "none";
}

Film film_of_shapes(const record::RunRecord& run, const Shapes& shapes, const line::Beds& beds, const std::string& prefix)
{
  std::vector<std::string> all_stages, stages;
  for (const Shape& shape : shapes) all_stages.push_back(shape.stage);
  const Index count = static_cast<Index>(shapes.size()), step = (count + max_frames_of_line - 1) / max_frames_of_line;
  const std::vector<Index> frames = kept_frames(all_stages, step);
  const std::vector<Real> places = beds.x.empty() ? places_of_slices(run) : beds.x;
  const Real region = moved_region(shapes, places.back());
  const std::vector<std::size_t> nodes = kept_nodes(shapes.front().x, region);
  const settings::PipelineSettings& line = *run.settings.pipeline;

  std::vector<std::string> left_out;
  if (step > 1) left_out.push_back(kept_words(step));
  if (nodes.size() < shapes.front().x.size()) left_out.push_back(fmt::format("{} of {} nodes", nodes.size(), shapes.front().x.size()));
  Film film;
  film.json = {{"half", word_of(line.half)},
               {"diameter", base::body_scale(run).width},
               {"weight", line.submerged_weight},
               {"region", region},
               {"slices", places},
               {"note", left_out.empty() ? Json() : Json(text_of_list(left_out, ", "))},
               {"frames", Json::array()},
               {"x", Json::array()}};
  for (const std::size_t node : nodes) film.json["x"].push_back(shapes.front().x[node]);
  for (const Index frame : frames) {
    film.json["frames"].push_back({{"time", shapes[frame].time}, {"stage", all_stages[frame]}});
    stages.push_back(all_stages[frame]);
  }
  film.json["ends"] = ends_of_stages(run, stages);
  for (const auto& [name, member] : quantities_of_line) {
    std::vector<std::vector<Real>> values;
    for (const Index frame : frames) {
      std::vector<Real>& of_frame = values.emplace_back();
      for (const std::size_t node : nodes) of_frame.push_back((shapes[frame].*member)[node]);
    }
    film.json[name] = block_of(film, fmt::format("{}-{}", prefix, name), values);
  }
  film.json["bed"] = bed_of(film, beds, frames, prefix + "-bed");
  return film;
}

}  // namespace

Film make_line_film(const record::RunRecord& run, const std::string& prefix)
{
  try {
    const Shapes shapes = line::read_shapes(run.folder);
    if (!shapes.empty()) return film_of_shapes(run, shapes, line::read_beds(run.folder), prefix);
    if (run.history.rows() == 0) return {};
    return {nullptr, {}, {"there is no film of the line: line.csv is missing"}};
  } catch (const RunError& error) {
    return {nullptr, {}, {fmt::format("there is no film of the line: {}", error.what())}};
  }
}

}  // namespace berm::report
