// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "problem/cells_at_body.hpp"
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};

/// Level of the base of the mesh, m; below a slope that at x.
Real base_below(const Scene& s, Real x)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&s.c.mesh);
  return bed == nullptr || bed->slope == 0 ? s.mesh[s.up].from : -bed->depth + std::tan(bed->slope) * x;
}

/// Each bounded body that some stage drives, once: visit(rigid).
template <class Visit>
void for_each_driven(const Scene& s, const Visit& visit)
{
  std::vector<char> asked(s.rigids.size(), 0);
  for (const Way& way : s.ways)
    if (way.rigid != none && std::exchange(asked[way.rigid], 1) == 0 && s.rigids[way.rigid].bounded) visit(way.rigid);
}

/// The size of the cells, or of remeshed elements, at a rigid body where it begins, m.
Real size_at(const Scene& s, Index rigid)
{
  return !s.is_mpm() && !s.c.small_strain() && s.c.fem.contact_size ? *s.c.fem.contact_size : s.cell_size(rigid, {});
}

std::string stage_name(const Scene& s, std::size_t k)
{
  return s.c.stage[k].name;
}

constexpr int across_in_space = 2;  // z

bool in_space(const Scene& s)
{
  return s.c.geometry == settings::Geometry::space;
}
bool around_axis(const Scene& s)
{
  return s.c.geometry == settings::Geometry::axisymmetric;
}
/// The level axes along which the body ends and walls can be near, the first is that of the plane. Circles and polygons are endless along z.
std::vector<int> axes_of_walls(const Scene& s, Index rigid)
{
  return in_space(s) && !bodies::is_endless(s.c.rigid[rigid].second.shape) ? std::vector{s.along, across_in_space} : std::vector{s.along};
}
const char* wall_name(bool along, bool lower)
{
  return along ? (lower ? "left wall" : "right wall") : lower ? "back wall" : "front wall";
}

/// Whether a stage leaves the body to gravity: where it goes is not known, but it goes down.
bool falls(const Scene& s, Index rigid)
{
  if (!(s.gravity > 0) || s.c.rigid[rigid].second.motion != bodies::Motion::free) return false;
  for (std::size_t k = 0; k < s.ways.size(); ++k)
    if (s.c.stage[k].kind != settings::StageKind::geostatic && s.ways[k].rigid != rigid) return true;
  return false;
}

/// Whether a body that falls may come down on the soil: from somewhere above it, or with a speed along the bed.
bool may_fall_onto(const Scene& s, Index rigid, const BodyScene& soil)
{
  return falls(s, rigid) && std::any_of(s.ways.begin(), s.ways.end(), [&](const Way& way) {
           return way.rigid == rigid && (way.axis[s.along].end != way.axis[s.along].begin || may_meet(s, way, soil, s.along));
         });
}

/// Whether a rigid body comes to another that it has a contact with, which bears it or is borne by it; where a free one goes is not known.
bool may_meet_rigid(const Scene& s, Index rigid)
{
  const std::string& name = s.c.rigid[rigid].first;
  const auto overlap = [](const Span& a, const Span& b) { return a.from <= b.to && b.from <= a.to; };
  for (Index other = 0; other < static_cast<Index>(s.rigids.size()); ++other) {
    const auto joins_them = [&](const auto& contact) { return joins(contact.second, name, s.c.rigid[other].first); };
    if (other == rigid || std::none_of(s.c.rigid_contact.begin(), s.c.rigid_contact.end(), joins_them)) continue;
    if (falls(s, rigid) || falls(s, other) || !s.rigids[other].bounded) return true;
    for (const Way& way : s.ways) {
      if (way.rigid != rigid && way.rigid != other) continue;
      const Spans& still = s.rigids[way.rigid == rigid ? other : rigid].space;
      bool meets = true;
      for (int d = 0; d < s.c.dimension(); ++d) meets = meets && (!way.axis[d].known || overlap(swept(s, way, d), still[d]));
      if (meets) return true;
    }
  }
  return false;
}

}  // namespace

void does_the_driven_body_touch_soil(const Scene& s, Findings& found)
{
  constexpr Real far_above = 0.02;  // of its width
  std::vector<char> asked(s.rigids.size(), 0);
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const Index rigid = s.ways[k].rigid;
    if (rigid == none || std::exchange(asked[rigid], 1) != 0) continue;
    const std::string& name = s.c.rigid[rigid].first;
    const std::string key = stage_key(k, s.c.stage[k].rigid.empty() ? "kind" : "rigid");
    const auto touches_rigid = [&](const auto& contact) { return contact.second.rigid == name; };
    const bool meets_rigid = may_meet_rigid(s, rigid);
    if (std::none_of(s.c.contact.begin(), s.c.contact.end(), touches_rigid)) {
      for (Index body = 0; body < static_cast<Index>(s.bodies.size()) && meets_rigid; ++body)
        if (std::any_of(s.ways.begin(), s.ways.end(), [&](const Way& way) { return way.rigid == rigid && may_meet(s, way, body); }))
          found.warn(key,
                     fmt::format("drives \"{0}\", which has no contact with [body.{1}] and would pass through it: add [contact.NAME] with "
                                 "body = \"{1}\" and rigid = \"{0}\"",
                                 name, s.c.body[body].first));
      if (meets_rigid) continue;
      found.refuse(key, fmt::format("drives \"{0}\", which nothing touches: there is no contact of a body with it; add [contact.NAME] with "
                                    "body = \"{1}\" and rigid = \"{0}\"",
                                    name, s.c.body.front().first));
      continue;
    }
    if (!s.rigids[rigid].bounded) continue;
    bool meets = meets_rigid, above = true;
    const Real element = s.is_mpm() ? 0 : size_at(s, rigid);  // the tip of a profile is rounded, and so higher
    const Real far = far_above * s.rigids[rigid].width + (std::isfinite(element) ? element : 0);
    std::string where;
    for (const auto& [contact_name, contact] : s.c.contact) {
      if (contact.rigid != name) continue;
      const Index body = index_of(s.c.body, contact.body);
      const BodyScene& soil = s.bodies[body];
      meets = meets || may_fall_onto(s, rigid, soil);
      for (const Way& way : s.ways) meets = meets || (way.rigid == rigid && may_meet(s, way, body));
      const Span &x = soil.space[s.along], &own = s.rigids[rigid].space[s.along];
      above = above && (!s.ground.line.level() || s.rigids[rigid].space[s.up].from >= soil.space[s.up].to);
      where = fmt::format("it begins at {} < {} < {} with its lowest point {:.4g} m above the surface, and [body.{}] is at {} < {} < {}",
                          place_words(own.from), axis_names[s.along], place_words(own.to), -s.ways[k].begin_embedment, contact.body,
                          place_words(x.from), axis_names[s.along], place_words(x.to));
    }
    if (!meets)
      found.refuse(fmt::format("rigid.{}", name),
                   fmt::format("touches no soil on its whole path: {}; move its centre, or make it travel farther", where));
    else if (above && !falls(s, rigid) && s.c.stage[k].kind == settings::StageKind::push && -s.ways[k].begin_embedment > far &&
             !s.c.small_strain()) {
      const Span& y = s.rigids[rigid].space[s.up];
      found.warn(fmt::format("rigid.{}", name),
                 fmt::format("begins {} above the seabed, {:.2g} of its width of {}: it does not touch soil at first; put its "
                             "lowest point at the surface, with its centre at {} (has its size changed since?)",
                             words_of(-s.ways[k].begin_embedment, "m"), -s.ways[k].begin_embedment / s.rigids[rigid].width,
                             words_of(s.rigids[rigid].width, "m"),
                             place_words((y.from + y.to) / 2 + s.up_sign * s.ways[k].begin_embedment)));
    }
  }
}

void do_bodies_at_each_other_touch(const Scene& s, Findings& found)
{
  if (!s.is_mpm()) return;
  for (const auto& [a, b] : s.neighbors) {
    const std::string &one = s.c.body[a].first, &other = s.c.body[b].first;
    const auto joins = [&](const auto& contact) {
      const contact::ContactSettings& c = contact.second;
      return (c.body == one && c.other_body == other) || (c.body == other && c.other_body == one);
    };
    if (std::any_of(s.c.contact.begin(), s.c.contact.end(), joins)) continue;
    found.refuse("body." + other,
                 fmt::format("touches [body.{0}], and there is no contact between them: bodies without one pass through each other; add "
                             "[contact.NAME] with body = \"{0}\" and other_body = \"{1}\" (scheme = \"tied\" for layers of one bed)",
                             one, other));
  }
}

void do_rigid_bodies_pass_through_each_other(const Scene& s, Findings& found)
{
  if (s.c.small_strain() || around_axis(s)) return;
  const auto overlap = [](const Span& a, const Span& b) { return a.from < b.to && b.from < a.to; };
  std::vector<std::pair<Index, Index>> asked;
  for (std::size_t k = 0; k < s.ways.size(); ++k)
    for (Index other = 0; other < static_cast<Index>(s.rigids.size()); ++other) {
      const Index rigid = s.ways[k].rigid;
      if (rigid == none || rigid == other || !s.rigids[rigid].bounded || !s.rigids[other].bounded) continue;
      const std::string &name = s.c.rigid[rigid].first, &other_name = s.c.rigid[other].first;
      const auto joins_them = [&](const auto& contact) { return joins(contact.second, name, other_name); };
      bool meets = std::none_of(s.c.rigid_contact.begin(), s.c.rigid_contact.end(), joins_them) &&
                   std::find(asked.begin(), asked.end(), std::pair(rigid, other)) == asked.end();
      for (int d = 0; d < s.c.dimension(); ++d) meets = meets && overlap(swept(s, s.ways[k], d), s.rigids[other].space[d]);
      if (!meets) continue;
      asked.emplace_back(rigid, other);
      const std::string key = stage_key(k, s.c.stage[k].rigid.empty() ? "kind" : "rigid");
      if (!s.is_mpm()) {
        found.warn(key, fmt::format("\"{}\" may meet \"{}\" on its path, and finite elements end the run where they are a quarter of an "
                                    "element apart; make its travel shorter, or take method = \"mpm\" with [rigid_contact.NAME]",
                                    name, other_name));
        continue;
      }
      found.warn(
          key,
          fmt::format("\"{0}\" may meet \"{1}\" on its path, and no forces act between rigid bodies without a contact: the run stops "
                      "where they overlap; add [rigid_contact.NAME] with rigid = \"{0}\" and other_rigid = \"{1}\", and give the body that "
                      "is to be pushed aside a mass and motion = \"free\"",
                      name, other_name));
    }
}

void do_motions_fit_a_half(const Scene& s, Findings& found)
{
  constexpr Real round_off = 1e-6;  // of the width
  if (s.c.geometry != settings::Geometry::plane_strain) return;
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const Way& way = s.ways[k];
    if (way.rigid == none || !s.rigids[way.rigid].bounded) continue;
    const Span &body = s.rigids[way.rigid].space[s.along], &mesh = s.mesh[s.along];
    const Real middle = (body.from + body.to) / 2, slack = round_off * body.length();
    const bool half = std::abs(middle - mesh.from) < slack || std::abs(middle - mesh.to) < slack;
    if (!half || !(way.axis[s.along].moves || way.turns)) continue;
    found.refuse(stage_key(k, "kind"),
                 fmt::format("{} \"{}\", whose centre is on a wall of the mesh, {} = {}: one half of it is modelled, and its mirror image "
                             "would move in the opposite direction; model the whole, or move it along {} alone",
                             way.axis[s.along].moves ? fmt::format("moves along {}", axis_names[s.along]) : "rotates",
                             s.c.rigid[way.rigid].first, axis_names[s.along], place_words(middle), axis_names[s.up]));
    return;
  }
}

void does_the_path_stay_in_the_mesh(const Scene& s, Findings& found)
{
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const Way& way = s.ways[k];
    if (way.rigid == none || !s.rigids[way.rigid].bounded) continue;
    std::vector<int> axes = axes_of_walls(s, way.rigid);
    axes.insert(axes.begin() + 1, s.up);
    for (const int d : axes) {
      const Move& move = way.axis[d];
      const Span &first = s.rigids[way.rigid].space[d], &mesh = s.mesh[d];
      const Span path = swept(s, way, d);
      if (!move.known || move.begin == move.end) continue;
      const bool vertical = d == s.up, below = first.from >= mesh.from && path.from < mesh.from && move.end < move.begin;
      // Finite elements end at the bed's surface, and a footing that is lifted is above it at once.
      const bool above = vertical ? s.is_mpm() && first.from <= mesh.to && first.from + move.end > mesh.to
                                  : first.to <= mesh.to && path.to > mesh.to && move.end > move.begin;
      if (!below && !above) continue;
      const std::string& name = s.c.rigid[way.rigid].first;
      const std::string message = fmt::format(
          "takes \"{}\" out of the mesh: it reaches {} = {}, where the mesh ends at {}; make its travel shorter, or the mesh {}", name,
          axis_names[d], place_words(below ? path.from : path.to), place_words(below ? mesh.from : mesh.to),
          vertical ? (below == (s.up_sign > 0) ? "deeper" : "higher") : "longer there");
      const std::string key = stage_key(k, "until");
      if (move.at_most)
        found.warn(key, "may leave the mesh: it " + message);
      else
        found.refuse(key, message);
      return;
    }
  }
}

void does_the_path_stay_on_fine_cells(const Scene& s, Findings& found)
{
  constexpr Real parts = 20;  // along the way
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const Way& way = s.ways[k];
    if (way.rigid == none || !s.rigids[way.rigid].bounded || !s.is_mpm()) continue;
    const Real first = s.cell_size(way.rigid, {});
    for (Real part = 0; part <= 1; part += 1 / parts) {
      Place at = way.begin();
      for (int d = 0; d < 3; ++d) at[d] += part * (way.axis[d].end - way.axis[d].begin);
      if (!way.axis[s.up].known) at[s.up] += s.ground_rise(way.rigid, way.begin()[s.along], at[s.along]);
      const Real size = s.cell_size(way.rigid, at), width = s.rigids[way.rigid].width;
      if (!(size > problem::coarser_cells * first)) continue;
      Real travel = 0;
      for (int d = 0; d < 3; ++d) travel += std::pow(at[d] - way.axis[d].begin, 2);
      const bool seabed = std::holds_alternative<mesh::SeabedMesh>(s.c.mesh);
      found.warn(stage_key(k, "until"),
                 fmt::format("takes \"{}\" out of the fine zone: after {} of this stage cells at it are {} (D/{:.0f}), and {} (D/{:.0f}) "
                             "at the start; resistance increases with the size of the cells: {}",
                             s.c.rigid[way.rigid].first, words_of(std::sqrt(travel), "m"), words_of(size, "m"), width / size,
                             words_of(first, "m"), width / first,
                             seabed ? "enlarge mesh.near_left, near_right or near_depth, or make its travel shorter"
                                    : "refine the mesh there, or make its travel shorter"));
      return;
    }
  }
}

void do_fine_cells_reach_the_ends(const Scene& s, Findings& found)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&s.c.mesh);
  if (bed == nullptr || !in_space(s) || !s.is_mpm()) return;
  for_each_driven(s, [&](Index rigid) {
    if (axes_of_walls(s, rigid).back() != across_in_space) return;
    const Span &body = s.rigids[rigid].space[across_in_space], &mesh = s.mesh[across_in_space];
    for (const bool front : {true, false}) {
      const Real end = front ? std::min(body.to, mesh.to) : std::max(body.from, mesh.from),
                 fine = front ? *bed->near_front : *bed->near_back;
      if ((front ? end - fine : fine - end) <= bed->near_size) continue;
      const char* key = front ? "mesh.near_front" : "mesh.near_back";
      found.warn(key,
                 fmt::format("ends the fine zone at z = {:.4g} m, and \"{}\" reaches {:.4g} m: resistance increases with the size of the "
                             "cells at its end; make the fine zone reach beyond it",
                             fine, s.c.rigid[rigid].first, end));
    }
  });
}

void are_cells_small_enough(const Scene& s, Findings& found)
{
  constexpr Real wanted = 5;
  const bool has_elements = s.c.method == settings::Method::fem && s.c.fem.large_deformation;
  for_each_driven(s, [&](Index rigid) {
    const Real size = size_at(s, rigid), width = s.rigids[rigid].width;
    if (!(width < 0.85 * wanted * size)) return;
    const std::string key = has_elements                     ? "fem.contact_size"
                            : s.places.has("mesh.near_size") ? "mesh.near_size"
                            : s.places.has("mesh.cells")     ? "mesh.cells"
                                                             : "mesh";
    found.warn(key, fmt::format("{0} at \"{1}\" are {2}, and it is {3} wide: {4:.2g} {0}; at least {5:g} are needed, and 20 for a good "
                                "answer: make them {6} or smaller",
                                has_elements ? "elements" : "cells", s.c.rigid[rigid].first, words_of(size, "m"), words_of(width, "m"),
                                width / size, wanted, words_of(rounded_down(width / 10), "m")));
  });
}

void do_walls_cut_a_body(const Scene& s, Findings& found)
{
  constexpr Real middle = 0.05;  // of its width: a wall there is a plane of symmetry
  if (!in_space(s) && (s.is_mpm() || s.c.small_strain())) return;
  for_each_driven(s, [&](Index rigid) {
    for (const int d : axes_of_walls(s, rigid)) {
      const Span &body = s.rigids[rigid].space[d], &mesh = s.mesh[d];
      const bool below = body.from<mesh.from, above = body.to> mesh.to;
      if (below == above || body.to <= mesh.from || body.from >= mesh.to) continue;
      const Real wall = below ? mesh.from : mesh.to;
      if (std::abs(wall - (body.from + body.to) / 2) < middle * (body.to - body.from)) continue;
      const std::string& name = s.c.rigid[rigid].first;
      found.warn("rigid." + name,
                 fmt::format("the {0} cuts it: it reaches {1} = {2}, where the mesh ends at {3}, and there is no soil beyond; move it, "
                             "make the mesh wider, or put its centre on the wall as a plane of symmetry",
                             wall_name(d == s.along, below), axis_names[d], place_words(below ? body.from : body.to), place_words(wall)));
    }
  });
}

void are_walls_far_enough(const Scene& s, Findings& found)
{
  constexpr Real clear = 0.75;  // widths
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const Way& way = s.ways[k];
    if (way.rigid == none || !s.rigids[way.rigid].bounded || s.c.small_strain() || !std::holds_alternative<mesh::SeabedMesh>(s.c.mesh))
      continue;
    const Real width = s.rigids[way.rigid].width;
    const Span along = swept(s, way, s.along), high = swept(s, way, s.up);
    const Real right = s.mesh[s.along].to - along.to;
    const Real side = around_axis(s) ? right : std::min(along.from - s.mesh[s.along].from, right),
               base = high.from - base_below(s, (along.from + along.to) / 2);
    const auto tell = [&](const char* key, const char* what, Real distance) {
      found.warn(key,
                 fmt::format("the {} is {} from \"{}\" in stage \"{}\", and that is {} wide: it carries part of the force; keep {} or more",
                             what, words_of(distance, "m"), s.c.rigid[way.rigid].first, stage_name(s, k), words_of(width, "m"),
                             words_of(rounded_up(3 * width), "m")));
    };
    if (way.axis[s.along].known && side > 0 && side < clear * width) return tell("mesh.length", "wall", side);
    for (const int d : in_space(s) ? axes_of_walls(s, way.rigid) : std::vector<int>{})
      for (const bool lower : {true, false}) {  // one by one: the other may be a plane of symmetry
        const Span path = swept(s, way, d);
        const Real distance = lower ? path.from - s.mesh[d].from : s.mesh[d].to - path.to;
        if (way.axis[d].known && distance > 0 && distance < clear * width)
          return tell(d == s.along ? "mesh.length" : "mesh.width", wall_name(d == s.along, lower), distance);
      }
    if (way.axis[s.up].known && base > 0 && base < clear * width) return tell("mesh.depth", "base", base);
  }
}

void is_the_wall_beyond_the_plastic_zone(const Scene& s, Findings& found)
{
  if (!around_axis(s) || s.c.small_strain()) return;
  for (const Way& way : s.ways) {
    if (way.rigid == none || !s.rigids[way.rigid].bounded || !way.axis[s.up].known) continue;
    const RigidScene& rigid = s.rigids[way.rigid];
    const Real travel = s.up_sign * (way.axis[s.up].begin - way.axis[s.up].end);
    // Soil flows around a ball; what is pushed in by a few of its widths heaves soil up instead of pushing it aside.
    constexpr Real deep = 3;
    if (bodies::pipe_section(s.c.rigid[way.rigid].second.shape) || !(travel > deep * rigid.width)) continue;
    const Index body = s.touched_by(way.rigid);
    if (body == none) continue;
    const material::Material soil = s.material_at(body, way.begin_embedment + travel);
    const std::optional<material::Strength> strength = strength_at_rest(soil);
    if (!strength || strength->friction_angle > 0 || !(strength->cohesion > 0)) continue;
    const Real index = young_poisson(soil).shear_modulus() / strength->cohesion;
    const Real zone = rigid.width / 2 * std::sqrt(index), wall = s.mesh[s.along].to;
    if (!(wall < zone)) continue;
    found.warn("mesh.length", fmt::format("puts the wall at a radius of {}, and the plastic zone around \"{}\" has a radius of {} (its "
                                          "radius times the root of G/s_u = {:.3g}): the wall confines it; make the mesh {} long or longer",
                                          words_of(wall, "m"), s.c.rigid[way.rigid].first, words_of(zone, "m"), index,
                                          words_of(rounded_up(2 * zone), "m")));
    return;
  }
}

void is_the_bed_held(const Scene& s, Findings& found)
{
  if (!std::holds_alternative<mesh::SeabedMesh>(s.c.mesh) || s.gravity == 0) return;
  const auto holds = [&](const char* boundary, const char* direction) {
    return std::any_of(s.c.support.begin(), s.c.support.end(), [&](const auto& support) {
      const std::vector<std::string>& fixed = support.second.fixed;
      return support.second.boundary == boundary && std::find(fixed.begin(), fixed.end(), direction) != fixed.end();
    });
  };
  if (!holds("base", "y"))
    found.refuse("support",
                 "no support holds the base of the bed, so the soil falls out of the mesh; add [support.base] with boundary = \"base\" "
                 "and fixed = [\"x\", \"y\"]");
  const auto mirrors = [&](const char* axis) { return std::count(s.c.symmetry.begin(), s.c.symmetry.end(), axis) > 0; };
  for (const auto& [wall, axis, is_lowest] :
       {std::tuple{"left", "x", true}, {"right", "x", false}, {"back", "z", true}, {"front", "z", false}}) {
    const bool is_axis = around_axis(s) || mirrors(axis);
    if ((is_lowest && is_axis) || (*axis == 'z' && s.c.dimension() == 2) || holds(wall, axis)) continue;
    const std::string words = fmt::format("no support holds the {0} wall of the bed, so the soil flows out there; add [support.{0}] with "
                                          "boundary = \"{0}\" and fixed = [\"{1}\"]",
                                          wall, axis);
    s.is_mpm() ? found.refuse("support", words) : found.warn("support", words);
  }
}

void is_the_surface_where_the_bed_ends(const Scene& s, Findings& found)
{
  for (Index b = 0; b < static_cast<Index>(s.bodies.size()); ++b) {
    const Span& height = s.bodies[b].space[s.up];
    const bool level = s.c.body[b].second.has_k0() && !loads_by_gravity(s.c, s.ground) && s.up_sign > 0;
    if (!level || height.to - s.c.surface < 0.3 * height.length()) continue;
    found.refuse("surface", fmt::format("is {}, and [body.{}] reaches up to {:.3g} m: embedment is measured from `surface`, and soil above "
                                        "it has no stress at the start; set it to the level of the seabed",
                                        words_of(s.c.surface, "m"), s.c.body[b].first, height.to));
    return;
  }
  const auto* bed = std::get_if<mesh::SeabedMesh>(&s.c.mesh);
  if (bed != nullptr && bed->slope != 0 && s.c.surface_given && s.c.surface == 0)
    found.warn("surface", "is the level from which embedment is measured, and the bed has a slope (mesh.slope): leave `surface` out to "
                          "measure it from the ground below the body");
  if (bed == nullptr || s.c.surface == 0) return;
  found.refuse("surface", fmt::format("is {}, and the surface of a mesh of kind \"seabed\" is y = 0: leave `surface` out",
                                      words_of(s.c.surface, "m")));
}

void does_soil_fill_the_bed(const Scene& s, Findings& found)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&s.c.mesh);
  if (bed == nullptr) return;
  const auto fills = [&](const char* region) {
    return std::any_of(s.c.body.begin(), s.c.body.end(), [&](const auto& body) {
      const std::vector<std::string>& regions = body.second.regions;
      return std::find(regions.begin(), regions.end(), region) != regions.end();
    });
  };
  for (const char* region : {"near", "bed", "layer"})
    if ((region != std::string("layer") || bed->layer > 0) && !fills(region))
      found.warn(
          region == std::string("layer") ? "mesh.layer" : "mesh",
          fmt::format("has a region \"{0}\" that no body fills, so the adjacent soil is unsupported; add \"{0}\" to the regions of a "
                      "body",
                      region));
}

void is_there_soil_at_a_watch(const Scene& s, Findings& found)
{
  for (const auto& [name, watch] : s.c.watch) {
    const BodyScene& body = s.bodies[index_of(s.c.body, watch.body)];
    for (std::size_t d = 0; d < watch.point.size(); ++d) {
      const Span& space = body.space[d];
      const Real slack = 0.05 * space.length();
      if (watch.point[d] > space.from - slack && watch.point[d] < space.to + slack) continue;
      found.warn("watch." + name + ".point",
                 fmt::format("{} = {} is not in [body.{}], which is at {} < {} < {}: the nearest soil is recorded instead", axis_names[d],
                             place_words(watch.point[d]), watch.body, place_words(space.from), axis_names[d], place_words(space.to)));
      break;
    }
  }
}

}  // namespace berm::sanity
