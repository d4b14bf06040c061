// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_templates_test.cpp
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

/// Calls visit(key, body, settings) for each excavation; for each fill.
template <class Visit>
void for_each_excavation(const Scene& s, const Visit& visit)
{
  for (Index b = 0; b < static_cast<Index>(s.c.body.size()); ++b) {
    const auto& [name, body] = s.c.body[b];
    for (std::size_t k = 0; k < body.excavation.size(); ++k) visit(fmt::format("body.{}.excavation[{}]", name, k), b, body.excavation[k]);
  }
}
template <class Visit>
void for_each_fill(const Scene& s, const Visit& visit)
{
  for (Index b = 0; b < static_cast<Index>(s.c.body.size()); ++b) {
    const auto& [name, body] = s.c.body[b];
    for (std::size_t k = 0; k < body.fill.size(); ++k) visit(fmt::format("body.{}.fill[{}]", name, k), b, body.fill[k]);
  }
}

/// What the area takes along x and y, m.
std::array<Span, 2> space_of(const bodies::EarthworkSettings& work)
{
  std::array<Span, 2> space;
  for (const Real x : work.area.x) space[0].add(x);
  for (const Real y : work.area.y) space[1].add(y);
  return space;
}

bool contains(const bodies::EarthworkSettings& work, const Place& at)
{
  const bool along_z = work.z_range.empty() || (at[2] >= work.z_range[0] && at[2] <= work.z_range[1]);
  return along_z && surface_at(bodies::make_shape<2>(work.area), Vec<2>(at[0], at[1])).distance <= 0;
}

std::size_t stage_of(const Scene& s, const bodies::EarthworkSettings& work)
{
  std::size_t k = 0;
  while (k + 1 < s.c.stage.size() && !has_begun(s, work, k)) ++k;
  return k;
}

/// Places spread over the area; in space in the middle of what it takes along z.
std::vector<Place> places_in(const Scene& s, const bodies::EarthworkSettings& work)
{
  constexpr int parts = 60;
  const std::array<Span, 2> space = space_of(work);
  const Real z = s.c.dimension() == 2   ? 0
                 : work.z_range.empty() ? (s.mesh[2].from + s.mesh[2].to) / 2
                                        : (work.z_range[0] + work.z_range[1]) / 2;
  const auto within = [&](int d, int k) {
    const Real from = std::max(space[d].from, s.mesh[d].from), to = std::min(space[d].to, s.mesh[d].to);
    return std::lerp(from, to, (k + 0.5) / parts);
  };
  std::vector<Place> places;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j)
      if (const Place at = {within(0, i), within(1, j), z}; contains(work, at)) places.push_back(at);
  return places;
}

/// Width of the opening of an excavation at a level around x, m; 0 where it is not open there.
Real opening_at(const bodies::EarthworkSettings& work, Real x, Real y, const Span& mesh)
{
  const bodies::Polygon<2> area = bodies::make_shape<2>(work.area);
  const auto open = [&](Real at) { return surface_at(area, Vec<2>(at, y)).distance <= 0; };
  if (!open(x)) return 0;
  constexpr int parts = 2000;
  const Real step = mesh.length() / parts;
  Real left = x, right = x;
  while (left - step >= mesh.from && open(left - step)) left -= step;
  while (right + step <= mesh.to && open(right + step)) right += step;
  return right - left + step;
}

}  // namespace

void do_excavations_find_soil(const Scene& s, Findings& found)
{
  constexpr Real round_off = 1e-6;  // of the mesh
  for_each_excavation(s, [&](const std::string& key, Index body, const bodies::ExcavationSettings& work) {
    const std::array<Span, 2> space = space_of(work);
    const Span& soil = s.bodies[body].space[1];
    const std::size_t stage = stage_of(s, work);
    const auto is_filled = [&](const Place& at) {
      const std::vector<bodies::FillSettings>& fills = s.c.body[body].second.fill;
      return std::any_of(fills.begin(), fills.end(), [&](const auto& fill) { return has_begun(s, fill, stage) && contains(fill, at); });
    };
    const std::vector<Place> places = places_in(s, work);
    const auto digs = [&](const Place& at) { return s.soil_at(body, at) || is_filled(at); };
    if (std::none_of(places.begin(), places.end(), digs))
      return found.warn(key, fmt::format("digs nothing: it is at {} < y < {}, {} < x < {}, where [body.{}] has no soil; its soil is from y "
                                         "= {} to {}; give its corners where the soil is, y less than 0 below a seabed",
                                         place_words(space[1].from), place_words(space[1].to), place_words(space[0].from),
                                         place_words(space[0].to), s.c.body[body].first, place_words(soil.from), place_words(soil.to)));
    Span bare;  // x where no soil is left
    for (const Place& at : places)
      if (const Place base = {at[0], soil.from + round_off * soil.length(), at[2]}; contains(work, base) && s.soil_at(body, base))
        bare.add(at[0]);
    if (bare.length() >= 0)
      found.warn(key, fmt::format("digs through the base of the soil, at y = {}: from x = {} to {} no soil is left there; end it "
                                  "above the base, or make the mesh deeper",
                                  place_words(soil.from), place_words(bare.from), place_words(bare.to)));
    const Span& mesh = s.mesh[0];
    const bool left = space[0].from<mesh.from - round_off * mesh.length(), right = space[0].to> mesh.to + round_off * mesh.length();
    const Real wall = left ? mesh.from : mesh.to, middle = (space[0].from + space[0].to) / 2;
    const bool half = std::abs(middle - wall) < round_off * mesh.length();  // of a trench with its middle on the wall
    if (left != right && !half)
      found.warn(key, fmt::format("reaches x = {}, beyond the mesh, which ends at {}: all soil up to that wall is excavated; end it where "
                                  "the trench ends, or make the mesh longer",
                                  place_words(left ? space[0].from : space[0].to), place_words(wall)));
  });
}

void do_fills_lie_in_the_mesh(const Scene& s, Findings& found)
{
  for_each_fill(s, [&](const std::string& key, Index body, const bodies::FillSettings& work) {
    const std::size_t stage = stage_of(s, work);
    const auto is_dug = [&](const Place& at) {
      const std::vector<bodies::ExcavationSettings>& dug = s.c.body[body].second.excavation;
      return std::any_of(dug.begin(), dug.end(), [&](const auto& one) { return has_begun(s, one, stage) && contains(one, at); });
    };
    const std::vector<Place> places = places_in(s, work);
    const auto is_free = [&](const Place& at) { return !s.soil_at(body, at) || is_dug(at); };
    const Real below = 0.02 * s.mesh[1].length();
    const auto rests = [&](const Place& at) { return !is_free(at) || !is_free({at[0], at[1] - below, at[2]}); };
    const bool on_another = std::any_of(s.c.body[body].second.fill.begin(), s.c.body[body].second.fill.end(),
                                        [&](const auto& other) { return other.name != work.name && has_begun(s, other, stage); });
    if (!places.empty() && std::none_of(places.begin(), places.end(), rests) && !on_another)
      found.warn(key, fmt::format("is above the soil: below its lowest point, y = {}, there is no soil of [body.{}], so it falls when it "
                                  "is placed; start it at the surface of the soil, or below it",
                                  place_words(space_of(work)[1].from), s.c.body[body].first));
    if (std::none_of(places.begin(), places.end(), is_free))
      found.warn(key,
                 fmt::format("places no soil: there is soil of [body.{}] in all of it when stage \"{}\" begins, or it lies outside the "
                             "mesh; excavate first, or put its corners where there is no soil",
                             s.c.body[body].first, work.stage));
  });
}

void do_bodies_fit_into_trenches(const Scene& s, Findings& found)
{
  constexpr int levels = 8;
  constexpr Real round_off = 1e-3;  // of the width
  if (s.up != 1 || s.up_sign < 0 || s.c.geometry == settings::Geometry::axisymmetric) return;
  for_each_excavation(s, [&](const std::string& key, Index, const bodies::ExcavationSettings& work) {
    const std::array<Span, 2> space = space_of(work);
    for (Index r = 0; r < static_cast<Index>(s.rigids.size()); ++r) {
      const RigidScene& rigid = s.rigids[r];
      if (!rigid.bounded || !bodies::pipe_section(s.c.rigid[r].second.shape) || rigid.space[1].from < space[1].from) continue;
      const Real x = (rigid.space[0].from + rigid.space[0].to) / 2, width = rigid.space[0].length();
      const Real top = s.ground.line.level() ? s.c.surface : s.ground.line.height(x), bottom = space[1].from;
      Real narrowest = infinity;
      for (int k = 0; k < levels; ++k)
        if (const Real open = opening_at(work, x, std::lerp(bottom, top, (k + 0.5) / levels), s.mesh[0]); open > 0)
          narrowest = std::min(narrowest, open);
      if (!(narrowest < width * (1 - round_off)) || !(top - bottom > round_off * width)) continue;
      found.warn(
          key,
          fmt::format(
              "is {} wide below \"{}\", which is {} wide: it rests on the shoulders of the trench; make the trench wider than the body",
              words_of(narrowest, "m"), s.c.rigid[r].first, words_of(width, "m")));
    }
  });
}

void are_earthworks_done_while_the_body_rests(const Scene& s, Findings& found)
{
  const auto ask = [&](const std::string& key, Index, const bodies::EarthworkSettings& work) {
    const std::size_t k = stage_of(s, work);
    const Way& way = s.ways[k];
    if (way.rigid == none || s.c.stage[k].name != work.stage) return;
    const Move& move = way.axis[s.up];
    const settings::StageSettings& stage = s.c.stage[k];
    const bool lifts =
        s.up_sign * (move.end - move.begin) > 0 || (stage.kind == settings::StageKind::push && stage.velocity.value_or(0) < 0);
    if (!lifts) return;
    found.warn(key + ".stage", fmt::format("is \"{}\", in which \"{}\" is lifted: the soil changes while its uplift resistance is "
                                           "measured; put the earthwork into a stage of its own before, of kind \"free\"",
                                           work.stage, s.c.rigid[way.rigid].first));
  };
  for_each_excavation(s, ask);
  for_each_fill(s, ask);
}

void do_loads_keep_their_soil(const Scene& s, Findings& found)
{
  for_each_excavation(s, [&](const std::string& key, Index, const bodies::ExcavationSettings& work) {
    for (const LoadScene& load : s.loads) {
      const auto dug = std::find_if(load.points.begin(), load.points.end(), [&](const Place& at) { return contains(work, at); });
      if (dug == load.points.end()) continue;
      const bool head = load.key.starts_with("support.");
      const std::string words = fmt::format(
          "\"{}\" removes the soil at ({}, {}), on which [{}] {}: {}", work.name, place_words((*dug)[0]), place_words((*dug)[1]), load.key,
          head ? "acts as a head of water" : "acts",
          head ? "the head is lost from then on; excavate beside it, or give the new surface its own support"
               : "a load needs its soil to the end of the run; leave that length of the boundary out (x_range), or excavate beside it");
      head ? found.warn(key, words) : found.refuse(key, words);
    }
  });
}

}  // namespace berm::sanity
