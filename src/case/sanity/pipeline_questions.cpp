// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "os/text_of_list.hpp"
#include "problem/cells_at_body.hpp"
#include "sanity/journey_on_springs.hpp"
#include "sanity/questions.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

/// Of two lines that have come to the end of a stage, and of which one has buckled.
bool are_alike(const Scene& s, const LineThen& a, const LineThen& b)
{
  constexpr Real allowed = 0.02;
  const auto alike = [](Real x, Real y) { return std::abs(x - y) <= allowed * std::max(x, y); };
  return std::max(a.gone, b.gone) < buckled * s.rigids[0].width || (alike(a.y, b.y) && alike(a.moment, b.moment));
}

void is_heating_slow(const Scene& s, const Journey& as_it_is, Findings& found)
{
  constexpr Real slowest = 16;
  std::optional<std::size_t> differs;
  const auto compare = [&](std::size_t k, const LineThen& then) {
    if (!std::isnan(as_it_is.ends[k].y) && !are_alike(s, as_it_is.ends[k], then)) differs = k;
    return !differs;
  };
  LineThen last = {};
  std::vector<Real> times, ways, moments;
  const auto note = [&](Real slower, const LineThen& then) {
    last = then;
    times.push_back(slower), ways.push_back(then.y), moments.push_back(then.moment / 1e3);
  };
  const std::optional<Journey> twice = journey_on_springs(s.c, 2, compare);
  if (!differs) return;
  const std::size_t k = *differs;
  bool enough = false;
  for (note(2, twice->ends[k]); !enough && times.back() < slowest;) {
    const Real slower = 2 * times.back();
    const LineThen then = journey_on_springs(s.c, slower, [&](std::size_t stage, const LineThen&) { return stage < k; })->ends[k];
    if (std::isnan(then.y)) break;
    enough = are_alike(s, last, then);
    note(slower, then);
  }
  const std::string advice = enough ? fmt::format("{:g} times as long would do, until.time = {} here", times.back() / 2,
                                                  words_of(times.back() / 2 * *s.c.stage[k].until.time, "s"))
                                    : "where a line buckles dynamically, a few per cent of this is scatter";
  found.warn(stage_key(k, "ramp"),
             fmt::format("on the springs of far_soil the line ends up {:.3g} m from its axis, with a moment of {:.4g} kN m; with stages "
                         "of the line {} times as long {} m and {} kN m: its inertia matters here, while real heating takes hours; {}",
                         as_it_is.ends[k].y, as_it_is.ends[k].moment / 1e3, text_of_list(times, ", ", "{:g}"),
                         text_of_list(ways, ", ", "{:.3g}"), text_of_list(moments, ", ", "{:.4g}"), advice));
}

void are_slices_near_enough(const Scene& s, const Journey& journey, Findings& found)
{
  constexpr Real wanted = 7;  // to a lobe
  Real spacing = 0;
  for (std::size_t k = 1; k < journey.places.size() && !(journey.places[k - 1] > journey.lobe); ++k)
    spacing = std::max(spacing, journey.places[k] - journey.places[k - 1]);
  if (!(spacing > (1 + 1e-9) * journey.lobe / wanted)) return;
  found.warn(s.c.pipeline->slices.spacing ? "pipeline.slices.spacing" : "pipeline.slices.at",
             fmt::format("is {}, and a lobe of the line is {} long on the springs of far_soil: {:.2g} slices per lobe, and {:g} are "
                         "needed; take {} or less",
                         words_of(spacing, "m"), words_of(journey.lobe, "m"), journey.lobe / spacing, wanted,
                         words_of(rounded_down(journey.lobe / wanted), "m")));
}

/// The first place on the way of the slices, to this side, whose cells are coarser than at the start.
void do_fine_cells_reach(const Scene& s, const Journey& journey, bool right, Findings& found)
{
  const auto far = [&](const Span& way) { return right ? way.to : -way.from; };
  const auto slice =
      std::max_element(journey.sideways.begin(), journey.sideways.end(), [&](const Span& a, const Span& b) { return far(a) < far(b); });
  constexpr int parts = 50;
  const Real first = s.cell_size(0, {}), end = (right ? 1 : -1) * far(*slice);
  for (int part = 1; part <= parts; ++part) {
    Place at = {};
    at[s.along] = end * part / parts;
    const Real size = s.cell_size(0, at);
    if (size <= problem::coarser_cells * first) continue;
    const bool seabed = std::holds_alternative<mesh::SeabedMesh>(s.c.mesh);
    const std::string key = !seabed ? "mesh" : right ? "mesh.near_right" : "mesh.near_left";
    const Real edge = end + (right ? s.rigids[0].space[s.along].to : s.rigids[0].space[s.along].from);
    found.warn(
        key,
        fmt::format(
            "the fine zone is too narrow: expected lateral displacement {} at x = {} of the line (on the springs of the far soil), and "
            "from {} on cells at the pipe are {}{}; set it to {} or more",
            place_words(end), place_words(journey.places[static_cast<std::size_t>(slice - journey.sideways.begin())]),
            place_words(at[s.along]), std::isfinite(size) ? words_of(size, "m") : "none, as the mesh ends",
            std::isfinite(size) ? fmt::format(", {} at the start", words_of(first, "m")) : "", place_words(edge)));
    return;
  }
}

}  // namespace

void is_the_laid_pipe_as_heavy_as_the_line(const Scene& s, Findings& found)
{
  constexpr Real allowed = 0.1;
  if (!s.c.pipeline) return;
  const auto line =
      std::find_if(s.c.stage.begin(), s.c.stage.end(), [](const auto& stage) { return stage.kind == settings::StageKind::pipeline; });
  const settings::StageSettings& last = *(line - 1);
  const bool push = last.kind == settings::StageKind::push;
  const std::optional<Real> force = push ? last.force : last.kind == settings::StageKind::drive ? last.drive.y.force : std::nullopt;
  const Real weight = s.c.pipeline->submerged_weight;
  if (!force || has_load_history(last) || std::abs(std::abs(*force) / weight - 1) <= allowed) return;
  found.warn(
      stage_key(static_cast<std::size_t>(line - s.c.stage.begin()) - 1, push ? "force" : "drive.y.force"),
      fmt::format("is {:.4g} N/m at the end of laying, and differs from the submerged weight of the line, {:.4g} N/m: the slices jump when "
                  "they take over the load of the line; set the vertical force of the last stage before the line to that weight",
                  std::abs(*force), weight));
}

void is_the_line_laid_by_its_weight(const Scene& s, Findings& found)
{
  constexpr Real most = 8;  // V at touchdown over the weight: 1 to 4 of most
  if (!s.c.pipeline) return;
  for (std::size_t k = 0; k < s.c.stage.size(); ++k) {
    const settings::StageSettings& stage = s.c.stage[k];
    if (stage.kind == settings::StageKind::pipeline) return;
    const bool push = stage.kind == settings::StageKind::push;
    const std::optional<Real> V = stage.vertical_force  ? stage.vertical_force
                                  : push && stage.force ? stage.force
                                  : push                ? stage.until.force
                                                        : std::nullopt;
    const char* key = stage.vertical_force ? "vertical_force" : push && stage.force ? "force" : "until.force";
    const Real weight = s.c.pipeline->submerged_weight;
    if (!V || has_load_history(stage) || *V <= most * weight) continue;
    found.warn(stage_key(k, key),
               fmt::format("is {:.4g} N/m, {:.3g} times the submerged weight of the line, {:.4g} N/m: in laying the contact force is "
                           "1 to 4 times the submerged weight; is the unit of either right?",
                           *V, *V / weight, weight));
  }
}

namespace {

/// kg/m, of the steel of the line's wall; empty of other lines.
std::optional<Real> mass_of_steel(const Scene& s)
{
  constexpr Real density = 7850, least_modulus = 1.5e11;  // kg/m3, Pa
  const settings::PipelineSettings& line = *s.c.pipeline;
  if (!line.wall || !line.young_modulus || *line.young_modulus < least_modulus) return {};
  return density * pi * *line.wall * (s.rigids[0].width - *line.wall);
}

}  // namespace

void is_the_line_a_pipe(const Scene& s, Findings& found)
{
  constexpr Real thinnest = 150, thickest = 5;       // diameter over wall; 15 to 60 of most steel pipes
  constexpr Real rounding = 0.95, sea_water = 1025;  // kg/m3
  if (!s.c.pipeline || s.rigids.empty() || !s.rigids[0].bounded || !(s.gravity > 0)) return;
  const settings::PipelineSettings& line = *s.c.pipeline;
  const Real D = s.rigids[0].width, mass = line.mass.value_or(s.c.rigid[0].second.mass), weight = line.submerged_weight;
  const std::string mass_key = line.mass ? "pipeline.mass" : fmt::format("rigid.{}.mass", s.c.rigid[0].first);
  if (line.wall && (D / *line.wall > thinnest || D / *line.wall < thickest))
    found.warn("pipeline.wall", fmt::format("is {}, 1/{:.3g} of the diameter of {}; pipes have 1/60 to 1/15: is the unit right (\"mm\")?",
                                            words_of(*line.wall, "m"), D / *line.wall, words_of(D, "m")));
  const std::optional<Real> steel = mass_of_steel(s);
  const Real buoyancy = sea_water * pi / 4 * D * D, in_air = weight / s.gravity + buoyancy;
  if (steel && mass < rounding * *steel)
    found.warn(mass_key,
               fmt::format("is {}, less than that of the steel of the wall alone, {}: its displacement in dynamic buckling depends on it; "
                           "take pipe, content and added mass of the water, {} or more",
                           words_of(mass, "kg/m"), words_of(*steel, "kg/m"), words_of(rounded_up(std::max(*steel, in_air)), "kg/m")));
  else if (mass < rounding * in_air)
    found.warn(
        mass_key,
        fmt::format("is {}, less than its submerged weight divided by g plus the mass of the displaced water, {} + {}: its displacement in "
                    "dynamic buckling depends on it; take {} or more",
                    words_of(mass, "kg/m"), words_of(weight / s.gravity, "kg/m"), words_of(buoyancy, "kg/m"),
                    words_of(rounded_up(in_air), "kg/m")));
  if (steel && *steel * s.gravity - buoyancy * s.gravity > weight / rounding)
    found.warn("pipeline.submerged_weight",
               fmt::format("is {:.4g} N/m, less than the dry weight of the steel wall alone, {:.4g} N/m, minus the buoyancy of the pipe, "
                           "{:.4g} N/m: is the wall thickness or the weight wrong?",
                           weight, *steel * s.gravity, buoyancy * s.gravity));
}

void does_the_line_go_beyond_its_slices(const Scene& s, Findings& found)
{
  if (!s.c.pipeline || s.c.pipeline->end == settings::LineEnd::free) return;
  const settings::PipelineSettings& line = *s.c.pipeline;
  const std::vector<Real> places = settings::places_of(line.slices);
  if (places.empty()) return;
  const Real beyond = line.length - places.back(), wanted = std::max(line.imperfection.length, places.back());
  if (!(beyond < wanted) || line.half == settings::LineHalf::none) return;
  found.warn("pipeline.length",
             fmt::format("is {}: the fixed end is {} beyond the last slice, which limits the feed-in; put it where the line "
                         "no longer slips, or half way to the next buckle, {} or more",
                         words_of(line.length, "m"), words_of(beyond, "m"), words_of(rounded_up(places.back() + wanted), "m")));
}

void does_the_case_fit_the_line_on_springs(const Scene& s, Findings& found)
{
  if (!s.c.pipeline) return;
  const std::optional<Journey> journey = journey_on_springs(s.c, 1, [](std::size_t, const LineThen&) { return true; });
  if (!journey) return;
  is_heating_slow(s, *journey, found);
  if (s.c.pipeline->slices.as_spring == settings::SliceAsSpring::always) return;
  are_slices_near_enough(s, *journey, found);
  do_fine_cells_reach(s, *journey, true, found);
  do_fine_cells_reach(s, *journey, false, found);
}

}  // namespace berm::sanity
