// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/animation/film_test.cpp
#include "report/animation/film_frames.hpp"

#include "core/for_each_task.hpp"
#include "report/animation/film_flow.hpp"
#include "report/animation/film_quantization.hpp"
#include "report/animation/film_rigids.hpp"
#include "report/animation/film_view.hpp"
#include "structures/base/driven_body.hpp"
#include "text/base64_zlib.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace berm::report {
namespace {

using Json = nlohmann::ordered_json;

// Of the body's width: the way that strain increments are told for, and the shortest that counts as a way.
constexpr Real unit_way = 0.01, min_way = 0.001;

/// Blocks in the making: each is made and packed when all are known, over all threads.
class Blocks {
public:
  explicit Blocks(std::string prefix) : prefix_(std::move(prefix)) {}

  /// Adds a block; gives its id.
  std::string add(const std::string& name, std::function<std::string()> bytes)
  {
    blocks_.push_back({prefix_ + "-" + name, ""});
    bytes_.push_back(std::move(bytes));
    return blocks_.back().id;
  }
  std::vector<FilmBlock> make()
  {
    for_each_task("pack film", static_cast<Index>(blocks_.size()), [&](Index k) { blocks_[k].base64 = text::packed(bytes_[k]()); });
    return std::move(blocks_);
  }

private:
  std::string prefix_;
  std::vector<FilmBlock> blocks_;
  std::vector<std::function<std::string()>> bytes_;
};

/// What strain increments since the frame before are multiplied with, so that they are those of the unit way; 1 where the body rests.
std::vector<Real> increment_factors(const record::RunRecord& run, const FilmFrames& footage, const std::vector<Index>& kept)
{
  std::vector<Real> factors(kept.size(), 1);
  const Real D = base::body_scale(run.settings).width;
  for (std::size_t k = 1; k < kept.size() && D > 0; ++k) {
    const Real way = way_between(run.history, footage.time[kept[k - 1]], footage.time[kept[k]]);
    if (way >= min_way * D) factors[k] = unit_way * D / way;
  }
  return factors;
}

Json frames_json(const record::RunRecord& run, const FilmFrames& footage, const std::vector<Index>& kept)
{
  Json list = Json::array();
  const bool driven = base::drives_a_body(run.settings);
  for (const Index k : kept) {
    const FilmMoment& moment = footage.moments[k];
    const auto of_body = [&](Real value) { return driven && std::isfinite(value) ? Json(value) : Json(); };
    list.push_back({{"time", footage.time[k]},
                    {"stage", moment.stage},
                    {"u", of_body(moment.u)},
                    {"w", of_body(moment.w)},
                    {"H", of_body(moment.H)},
                    {"V", of_body(moment.V)}});
  }
  return list;
}

Json pair_of(const Vec<2>& x)
{
  return Json::array({x[0], x[1]});
}

/// The box that the soil covers: points are in the middle of what they stand for.
FilmBox covered(const FilmBox& points, const FilmFrames& footage)
{
  if (!footage.triangles.empty()) return points;
  const Vec<2> half = Vec<2>::Constant(*std::max_element(footage.sizes.begin(), footage.sizes.end()) / 2);
  return {points.lower - half, points.upper + half};
}

/// Values of a field by frame, then point.
std::vector<float> one_after_the_other(const std::vector<const FilmFrame*>& frames, std::size_t field)
{
  std::vector<float> all;
  all.reserve(frames.size() * frames.front()->x.size());
  for (const FilmFrame* frame : frames) all.insert(all.end(), frame->fields[field].begin(), frame->fields[field].end());
  return all;
}

/// The same of a field that is summed: its growth since the frame before, times the factor of the frame; 0 in the first.
std::vector<float> increments(const std::vector<const FilmFrame*>& frames, std::size_t field, const std::vector<Real>& factor)
{
  const std::size_t count = frames.front()->x.size();
  std::vector<float> all(count * frames.size(), 0);
  for (std::size_t f = 1; f < frames.size(); ++f)
    for (std::size_t k = 0; k < count; ++k)
      all[f * count + k] = static_cast<float>(factor[f] * (frames[f]->fields[field][k] - frames[f - 1]->fields[field][k]));
  return all;
}

/// The lowest z of the frames of a film of the whole of a run in space, m; a grid whose step is not enough along z is made coarser.
Real take_in_z(FilmGrid& grid, const std::vector<const FilmFrame*>& frames)
{
  std::vector<const std::vector<Real>*> z;
  for (const FilmFrame* frame : frames) z.push_back(&frame->z);
  const auto [lower, upper] = ends_of(z);
  grid.step = std::max(grid.step, (upper - lower) / max_code);
  return lower;
}

std::string name_of(std::int32_t rigid, const settings::Case& settings)
{
  const bool known = rigid >= 0 && rigid < static_cast<std::int32_t>(settings.rigid.size());
  return known ? settings.rigid[rigid].first : "rigid body";
}

}  // namespace

Film encoded_film(const record::RunRecord& run, const FilmFrames& footage, const std::vector<Index>& kept, std::size_t fields,
                  const std::string& prefix)
{
  std::vector<const FilmFrame*> frames;
  for (const Index k : kept) frames.push_back(&footage.frames[k]);
  const FilmBox soil = box_of(frames), view = film_view(run, covered(soil, footage));
  FilmGrid grid(soil);
  const bool whole = !frames.front()->z.empty();
  const Real lower_z = whole ? take_in_z(grid, frames) : 0;
  const std::optional<Real> surface = film_surface(run);
  const bool particles = footage.triangles.empty();
  Blocks blocks(prefix);

  Json film = {{"kind", particles ? "particles" : "triangles"},
               {"count", footage.count()},
               {"frames", frames_json(run, footage, kept)},
               {"lower", pair_of(grid.lower)},
               {"step", grid.step},
               {"view", {{"lower", pair_of(view.lower)}, {"upper", pair_of(view.upper)}}},
               {"surface", surface ? Json(*surface) : Json()},
               {"note", nullptr},
               {"around_axis", run.settings.geometry == settings::Geometry::axisymmetric},
               {"forces", run.settings.force_dimension() == 2 ? "N/m" : "N"}};
  if (whole) film["lower_z"] = lower_z, film["one_of"] = footage.one_of;
  for (const Vec<2>& corner : run.ground.line.corners) film["ground"].push_back(pair_of(corner));
  film["position"] = blocks.add("position", [&] { return position_bytes(frames, grid, lower_z); });
  film["size"] = particles ? Json(blocks.add("size", [&] { return size_bytes(footage.sizes, grid); })) : Json();
  film["triangles"] = particles ? Json() : Json(blocks.add("triangles", [&] { return triangle_bytes(footage.triangles); }));
  film["elements"] = particles ? 0 : parts_of_triangle;

  film["fields"] = Json::array();
  const std::vector<Real> factors = increment_factors(run, footage, kept);
  std::vector<FilmRange> ranges(fields);
  for (std::size_t f = 0; f < fields; ++f) {
    const FilmField& field = footage.fields[f];
    const std::string id = blocks.add(field.name, [&, f] {
      const std::vector<float> values = footage.fields[f].summed ? increments(frames, f, factors) : one_after_the_other(frames, f);
      ranges[f] = range_of(values);
      return field_bytes(values, footage.count(), ranges[f]);
    });
    film["fields"].push_back(
        {{"name", field.name}, {"label", field.label}, {"unit", field.unit}, {"low", nullptr}, {"high", nullptr}, {"block", id}});
  }
  const std::optional<FilmFlow> flow = film_flow(frames, footage.sizes, view);
  if (flow)
    film["flow"] = {{"lower", pair_of(flow->box.lower)}, {"side", flow->side},
                    {"columns", flow->columns},          {"rows", flow->rows},
                    {"largest", flow->largest},          {"block", blocks.add("flow", [&flow] { return bytes_of(flow->codes); })}};
  film["rigids"] = Json::array();
  const std::vector<FilmOutline> outlines = whole ? std::vector<FilmOutline>() : film_outlines(frames, run.settings.dimension());
  for (const FilmOutline& outline : outlines) {
    const std::string id =
        blocks.add(fmt::format("rigid-{}", film["rigids"].size()), [&outline, &grid] { return outline_bytes(outline, grid.lower); });
    film["rigids"].push_back({{"name", name_of(outline.rigid, run.settings)}, {"points", outline.points}, {"block", id}});
  }

  const std::vector<FilmSurface> surfaces = whole ? film_surfaces(frames) : std::vector<FilmSurface>();
  if (whole) film["surfaces"] = Json::array();
  for (const FilmSurface& s : surfaces) {
    const SurfaceGrid places(s);
    const std::string number = std::to_string(film["surfaces"].size());
    film["surfaces"].push_back({{"name", name_of(s.rigid, run.settings)},
                                {"points", s.points},
                                {"triangles", blocks.add("surface-" + number, [&s] { return bytes_of(s.triangles); })},
                                {"lower", Json::array({places.lower[0], places.lower[1], places.lower[2]})},
                                {"step", places.step},
                                {"position", blocks.add("surface-position-" + number, [&s, places] { return places.bytes(s); })}});
  }

  std::vector<FilmBlock> made = blocks.make();
  for (std::size_t f = 0; f < fields; ++f) {
    film["fields"][f]["low"] = ranges[f].low;
    film["fields"][f]["high"] = ranges[f].high;
  }
  return {std::move(film), std::move(made), {}};
}

}  // namespace berm::report
