// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "problem/cells_at_body.hpp"
#include "sanity/journey_on_springs.hpp"
#include "sanity/questions.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

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
                                    : "where a line snaps, some per cent of this are scatter";
  found.warn(stage_key(k, "ramp"),
             fmt::format("on the springs of far_soil the line stands {:.3g} m from its axis at the end, with a moment of {:.4g} kN m; with "
                         "stages of the line {:g} "
                         "times as long {:.3g} m and {:.4g} kN m: its inertia counts, and real heating takes hours; {}",
                         as_it_is.ends[k].y, as_it_is.ends[k].moment / 1e3, fmt::join(times, ", "), fmt::join(ways, ", "),
                         fmt::join(moments, ", "), advice));
}

void are_slices_near_enough(const Scene& s, const Journey& journey, Findings& found)
{
  constexpr Real wanted = 7;  // to a lobe
  Real spacing = 0;
  for (std::size_t k = 1; k < journey.places.size() && !(journey.places[k - 1] > journey.lobe); ++k)
    spacing = std::max(spacing, journey.places[k] - journey.places[k - 1]);
  if (!(spacing > (1 + 1e-9) * journey.lobe / wanted)) return;
  found.warn(
      s.c.pipeline->slices.spacing ? "pipeline.slices.spacing" : "pipeline.slices.at",
      fmt::format(
          "is {}, and a lobe of the line is {} long on the springs of far_soil: {:.2g} slices to a lobe, and {:g} are needed; {} or less",
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
    found.warn(key, fmt::format("ends the fine cells before the slices do: on the springs of far_soil that at x = {} of the line goes {} "
                                "sideways, and after {} cells "
                                "at its pipe are {}{}; let fine cells reach {}",
                                place_words(journey.places[static_cast<std::size_t>(slice - journey.sideways.begin())]), place_words(end),
                                place_words(at[s.along]), std::isfinite(size) ? words_of(size, "m") : "none, as the mesh ends",
                                std::isfinite(size) ? fmt::format(", and {} at the start", words_of(first, "m")) : "", place_words(edge)));
    return;
  }
}

}  // namespace

void is_the_laid_pipe_as_heavy_as_the_line(const Scene& s, Findings& found)
{
  constexpr Real allowed = 0.1;
  if (!s.c.pipeline) return;
  const auto line =
      std::find_if(s.c.stage.begin(), s.c.stage.end(), [](const auto& stage) { return stage.kind == problem::StageKind::pipeline; });
  const problem::StageSettings& last = *(line - 1);
  const bool push = last.kind == problem::StageKind::push;
  const std::optional<Real> force = push ? last.force : last.kind == problem::StageKind::drive ? last.drive.y.force : std::nullopt;
  const Real weight = s.c.pipeline->submerged_weight;
  if (!force || has_load_history(last) || std::abs(std::abs(*force) / weight - 1) <= allowed) return;
  found.warn(
      stage_key(static_cast<std::size_t>(line - s.c.stage.begin()) - 1, push ? "force" : "drive.y.force"),
      fmt::format("lays the pipe with {:.4g} N/m to the end, and the line weighs {:.4g} N/m: the slices jump when they hang on it; let "
                  "the last stage before the line push with its weight",
                  std::abs(*force), weight));
}

void does_the_case_fit_the_line_on_springs(const Scene& s, Findings& found)
{
  if (!s.c.pipeline) return;
  const std::optional<Journey> journey = journey_on_springs(s.c, 1, [](std::size_t, const LineThen&) { return true; });
  if (!journey) return;
  is_heating_slow(s, *journey, found);
  if (s.c.pipeline->slices.asleep == problem::SliceSleep::always) return;
  are_slices_near_enough(s, *journey, found);
  do_fine_cells_reach(s, *journey, true, found);
  do_fine_cells_reach(s, *journey, false, found);
}

}  // namespace berm::sanity
