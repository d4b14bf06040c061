// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/scene.hpp"

#include "settings/drives.hpp"

#include <algorithm>

namespace berm::sanity {
namespace {

using By = settings::FreedomDrive::By;

/// Travel at a speed after a time, when it grows to that speed in the ramp.
Real travel_in(Real speed, Real time, Real ramp)
{
  return time < ramp ? speed * time * time / (2 * ramp) : speed * (time - ramp / 2);
}

/// Whether a body at a depth w has reached the stage's embedment: from above, or from below where it is lifted.
bool at_embedment(const settings::StageSettings& s, Real down, Real w)
{
  return s.until.embedment && (down < 0 ? *s.until.embedment >= w : *s.until.embedment <= w);
}

/// The time that a stage takes to the first of its limits that the input says when it is reached; infinity where it says none.
template <int dim>
Real time_of(const problem::Model<dim>& model, const settings::StageSettings& s, const settings::StageDrives<dim>& drives, Real begin_w)
{
  Real time = s.until.time.value_or(infinity), speed = 0;
  if (!s.load_times.empty()) return time;  // when it is where, its load history says
  for (int d = 0; d < dim; ++d)
    if (drives[d].by == By::velocity && (s.kind == settings::StageKind::drive || d == model.axes.along))
      speed += drives[d].value * drives[d].value;
  speed = std::sqrt(speed);
  if (s.until.displacement && speed > 0) time = std::min(time, *s.until.displacement / speed + s.ramp / 2);
  const settings::FreedomDrive& vertical = drives[model.axes.up];
  const Real down = vertical.by == By::velocity ? -model.axes.sign * vertical.value : 0;
  if (at_embedment(s, down, begin_w)) return 0;
  if (s.until.embedment && down != 0) time = std::min(time, (*s.until.embedment - begin_w) / down + s.ramp / 2);
  return time;
}

/// Nothing says how deep free bodies are after a stage that leaves them to gravity and to the soil, nor where else, if they moved there before.
template <int dim>
void let_free_bodies_go(const problem::Model<dim>& model, std::size_t stage, std::vector<std::array<Move, 3>>& now)
{
  if (model.stages[stage].kind == settings::StageKind::geostatic) return;
  for (std::size_t r = 0; r < now.size(); ++r)
    if (model.rigid_bodies[r].motion == bodies::Motion::free && model.driven[stage] != static_cast<Index>(r))
      for (int d = 0; d < dim; ++d)
        if (Move& move = now[r][d]; d == model.axes.up || move.end != move.begin) move.known = false;
}

}  // namespace

template <int dim>
std::vector<Way> ways_of(const problem::Model<dim>& model)
{
  std::vector<Way> ways(model.stages.size());
  std::vector<std::array<Move, 3>> now(model.rigid_bodies.size());
  for (std::size_t k = 0; k < model.stages.size(); ++k) {
    Way& way = ways[k];
    let_free_bodies_go(model, k, now);
    way.stage = k;
    way.rigid = model.driven[k];
    if (way.rigid == none) continue;
    const settings::StageSettings& s = model.stages[k];
    const bodies::RigidBody<dim>& rigid = model.rigid_bodies[way.rigid];
    const auto drives = settings::drives_of<dim>(s, model.axes, rigid.rotation == bodies::Rotation::free);
    way.axis = now[way.rigid];
    for (Move& move : way.axis) move.begin = move.end, move.begin_known = move.known && !move.at_most;
    way.begin_known = way.axis[model.axes.up].known && !way.axis[model.axes.up].at_most;
    Vec<dim> center = center_of<dim>(rigid.shape);
    for (int d = 0; d < dim; ++d) center[d] += way.axis[d].begin;
    way.begin_embedment = model.axes.sign * (model.surface_at(center) - way.axis[model.axes.up].begin) -
                          lowest_level<dim>(rigid.shape, model.axes.up_vector());
    for (int d = dim; d < bodies::freedoms<dim>; ++d) way.turns = way.turns || drives[d].by != By::velocity || drives[d].value != 0;
    const settings::FreedomDrive& vertical = drives[model.axes.up];
    const Real down = vertical.by == By::velocity ? -model.axes.sign * vertical.value : 0;
    const Real time = time_of(model, s, drives, way.begin_embedment);
    for (int d = 0; d < dim; ++d) {
      Move& move = way.axis[d];
      const bool moves = drives[d].by != By::velocity || drives[d].value != 0;
      move.moves = moves;
      if (!moves) continue;
      const bool by_velocity = drives[d].by == By::velocity && time < infinity && s.load_times.empty();
      if (by_velocity) move.end += travel_in(drives[d].value, time, s.ramp);
      move.known = move.known && by_velocity;
      move.at_most = move.at_most || s.until.force.has_value() ||
                     (s.until.embedment && !at_embedment(s, down, way.begin_embedment) && d != model.axes.up);
    }
    now[way.rigid] = way.axis;
  }
  return ways;
}

Span swept(const Scene& s, const Way& way, int d)
{
  const Span& space = s.rigids[way.rigid].space[d];
  const Move& move = way.axis[d];
  return {space.from + std::min(move.begin, move.end), space.to + std::max(move.begin, move.end)};
}

bool may_meet(const Scene& s, const Way& way, const BodyScene& soil, int d)
{
  if (!way.axis[d].known) return true;
  const Span path = swept(s, way, d);
  const Real slack = 1e-6 * s.rigids[way.rigid].width;
  Real top = soil.space[d].to;
  if (d == s.up && way.axis[s.along].known && !s.ground.line.level()) {
    const Span along = swept(s, way, s.along);
    top = std::min(top, s.ground.line.heights(along.from, along.to).second);
  }
  return path.from <= top + slack && path.to >= soil.space[d].from - slack;
}

bool has_begun(const Scene& s, const bodies::EarthworkSettings& work, std::size_t stage)
{
  for (std::size_t k = 0; k <= stage; ++k)
    if (s.c.stage[k].name == work.stage) return true;
  return false;
}

bool may_meet(const Scene& s, const Way& way, Index body)
{
  const auto meets = [&](const BodyScene& soil) { return may_meet(s, way, soil, s.up) && may_meet(s, way, soil, s.along); };
  if (meets(s.bodies[body])) return true;
  const std::vector<bodies::FillSettings>& fills = s.c.body[body].second.fill;
  return std::any_of(fills.begin(), fills.end(), [&](const bodies::FillSettings& fill) {
    if (!has_begun(s, fill, way.stage)) return false;
    const auto overlaps = [&](int d, const std::vector<Real>& corners) {
      if (!way.axis[d].known) return true;
      const auto [least, most] = std::minmax_element(corners.begin(), corners.end());
      const Span path = swept(s, way, d);
      return path.from <= *most && path.to >= *least;
    };
    return overlaps(0, fill.area.x) && overlaps(1, fill.area.y);
  });
}

bool may_meet_soil(const Scene& s, const Way& way)
{
  if (!s.rigids[way.rigid].bounded) return true;
  const std::string& name = s.c.rigid[way.rigid].first;
  return std::any_of(s.c.contact.begin(), s.c.contact.end(), [&](const auto& contact) {
    return contact.second.rigid == name && may_meet(s, way, index_of(s.c.body, contact.second.body));
  });
}

template std::vector<Way> ways_of(const problem::Model<2>&);
template std::vector<Way> ways_of(const problem::Model<3>&);

}  // namespace berm::sanity
