// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/thin_questions_test.cpp
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

constexpr Real cells_wanted = 2;
constexpr Real tolerance = 0.05;  // of that: cells of a size in an unstructured mesh differ by some percent
constexpr Real edgeways = 0.1;    // sine of the angle between the travel and a face: less moves no soil behind it

/// A part of what a body does: from one displacement to another.
struct Leg {
  Place from = {}, to = {};
  std::array<bool, 3> may = {};  ///< move along an axis by as much as nothing in the input says
  bool turns = false, known = true;
  Place above = {};   ///< where it was before it sank by what is not known; where that is known: from
  bool held = false;  ///< it does not move, and soil may press on it from either side
};

Place point(const Place& from, const Place& along, Real length)
{
  return {from[0] + length * along[0], from[1] + length * along[1], from[2] + length * along[2]};
}
Place difference(const Place& to, const Place& from)
{
  return point(to, from, -1);
}
Real dot(const Place& a, const Place& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Real length_of(const Place& a)
{
  return std::sqrt(dot(a, a));
}

/// What the stages do with a body. Where a force moves it down it may sink by its own height.
std::vector<Leg> legs_of(const Scene& s, Index rigid)
{
  constexpr int parts_of_height = 4;
  std::vector<Leg> legs;
  Place now = {};
  bool known = true;
  const bool is_free = s.c.rigid[rigid].second.motion == bodies::Motion::free;
  const auto add = [&](Leg leg) {
    leg.known = known;
    leg.above = leg.from;
    legs.push_back(leg);
    now = leg.to;
    if (!leg.may[s.up] && known) return;
    leg.known = false;
    for (int sunk = 1; sunk <= parts_of_height; ++sunk) {
      const Real by = s.up_sign * s.rigids[rigid].space[s.up].length() / parts_of_height;
      leg.from[s.up] -= by, leg.to[s.up] -= by;
      legs.push_back(leg);
    }
  };
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const Way& way = s.ways[k];
    if (way.rigid == rigid) {
      Leg leg{way.begin(), way.end(), {}, way.turns};
      for (int d = 0; d < 3; ++d) leg.may[d] = way.axis[d].moves && !way.axis[d].known;
      add(leg);
      known = known && !leg.may[s.up];
    } else if (is_free && s.c.stage[k].kind != settings::StageKind::geostatic) {
      add({now, now, {true, true, true}, s.c.rigid[rigid].second.rotation == bodies::Rotation::free});
      known = false;
    }
  }
  return legs;
}

bool moves_along_normal(const Leg& leg, const ThinPlace& place, Real width)
{
  if (leg.held) return true;
  const Place way = difference(leg.to, leg.from);
  if (std::abs(dot(way, place.normal)) > edgeways * length_of(way)) return true;
  for (std::size_t d = 0; d < 3; ++d)
    if (leg.may[d] && std::abs(place.normal[d]) > edgeways) return true;
  return leg.turns && place.lever > edgeways * width;
}

/// Whether the body passes over a point on a straight way between displacements.
bool passes(const Scene& s, Index rigid, const Place& x, const Place& from, const Place& to)
{
  const Place way = difference(to, from);
  const Real length = length_of(way), least = 1e-4 * s.rigids[rigid].width;
  for (Real gone = 0;;) {
    const Real distance = s.distance(rigid, difference(x, point(from, way, length > 0 ? gone / length : 0)));
    if (distance < 0) return true;
    if (gone >= length) return false;
    gone = std::min(length, gone + std::max(distance, least));
  }
}

/// A thin place in soil of one body.
struct Thin {
  ThinPlace place;
  Real cell = 1;  ///< m, length of the cells there
  Index soil = none;

  Real cells() const { return soil == none ? infinity : place.thickness / cell; }
};

/// The thinnest place of a body in a part of its way that has soil of one body before it and behind it: not where the body has been.
Thin thinnest_in_soil(const Scene& s, Index rigid, const std::vector<Index>& soils, const std::vector<ThinPlace>& places,
                      const std::vector<Leg>& legs, std::size_t now)
{
  constexpr int parts = 20;
  const Leg& leg = legs[now];
  const Place way = difference(leg.to, leg.from);
  Thin found;
  for (const ThinPlace& place : places) {
    if (!moves_along_normal(leg, place, s.rigids[rigid].width)) continue;
    for (int part = 0; part <= (length_of(way) > 0 ? parts : 0); ++part) {
      const Place moved = point(leg.from, way, static_cast<Real>(part) / parts), face = point(moved, place.at, 1);
      Real cell = s.cell_along(point(face, place.normal, -place.thickness / 2), place.normal);
      if (!(cell > 0)) cell = s.cell_along(point(face, place.normal, 1e-3 * place.thickness), place.normal);
      if (!(place.thickness < (1 - tolerance) * cells_wanted * cell) || !(place.thickness / cell < found.cells())) continue;
      const Place front = point(face, place.normal, cell), back = point(face, place.normal, -place.thickness - cell);
      const auto soil = std::find_if(soils.begin(), soils.end(), [&](Index b) { return s.soil_at(b, front) && s.soil_at(b, back); });
      if (soil == soils.end()) continue;
      const auto is_clear = [&](const Place& x) {
        for (std::size_t k = 0; k < now; ++k)
          if (legs[k].known && passes(s, rigid, x, legs[k].from, legs[k].to)) return false;
        return !passes(s, rigid, x, leg.above, leg.from) && !passes(s, rigid, x, leg.from, moved);
      };
      // Beside an edge the normal may point past what the body leaves behind.
      const Real length = length_of(way), along = dot(way, place.normal);
      const Place behind = length > 0 ? point(point(face, place.normal, along > 0 ? -place.thickness : 0), way, -cell / length) : front;
      if (is_clear(front) && is_clear(back) && is_clear(behind)) found = {place, cell, *soil};
    }
  }
  return found;
}

std::string words_of_point(const Scene& s, const Place& x)
{
  std::string words = fmt::format("x = {}, y = {}", place_words(x[0]), place_words(x[1]));
  return s.c.dimension() == 3 ? words + ", z = " + place_words(x[2]) : words;
}

}  // namespace

void is_the_body_two_cells_thick(const Scene& s, Findings& found)
{
  if (!s.is_mpm()) return;
  for (Index rigid = 0; rigid < static_cast<Index>(s.rigids.size()); ++rigid) {
    const std::string& name = s.c.rigid[rigid].first;
    std::vector<Index> soils;
    for (const auto& [contact_name, contact] : s.c.contact)
      if (contact.rigid == name) soils.push_back(index_of(s.c.body, contact.body));
    if (soils.empty() || !s.rigids[rigid].bounded) continue;
    std::vector<Leg> legs = legs_of(s, rigid);
    const bool held = legs.empty();
    if (held) legs.push_back({.held = true});
    const std::vector<ThinPlace> places = s.thin_places(rigid);
    Thin thin;
    bool known = false;
    for (const bool wanted : {true, false})
      for (std::size_t k = 0; k < legs.size() && thin.soil == none; ++k)
        if (legs[k].known == wanted) thin = thinnest_in_soil(s, rigid, soils, places, legs, k), known = wanted;
    if (thin.soil == none) continue;
    const std::string message = fmt::format(
        "is {} thick at {} (at the start), {:.2g} cells of {}, {} soil of [body.{}] on both sides: contact moves whole cells whichever "
        "face touches them, so soil behind a body thinner than two cells moves with it, as if by suction; make cells there {} or "
        "smaller, or the body {} thick or more, or put a body of soil on each side of it, with a contact between the two",
        words_of(thin.place.thickness, "m"), words_of_point(s, thin.place.at), thin.cells(), words_of(thin.cell, "m"),
        known ? "with" : "and may sink in until it has", s.c.body[thin.soil].first,
        words_of(rounded_down(thin.place.thickness / cells_wanted), "m"), words_of(rounded_up(cells_wanted * thin.cell), "m"));
    known && !held ? found.refuse("rigid." + name, message) : found.warn("rigid." + name, message);
  }
}

}  // namespace berm::sanity
