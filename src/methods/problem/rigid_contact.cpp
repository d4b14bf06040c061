// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/rigid_contact_test.cpp
#include "problem/rigid_contact.hpp"

#include "core/names.hpp"
#include "os/error.hpp"
#include "problem/stages.hpp"
#include "settings/rigid_contact_checks.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::problem {
namespace {

/// Over the size of a body: less is round-off.
constexpr Real overlap_that_counts = 1e-9;

/// How deep the two overlap there, m; 0 or less where they do not.
template <int dim>
Real overlap_of(const Model<dim>& model, const RigidPair<dim>& pair, const bodies::Pose<dim>& first, const bodies::Pose<dim>& second)
{
  const bodies::ProximityPoints<dim> points =
      proximity_points(pair.proximity, model.rigid_bodies[pair.first], first, model.rigid_bodies[pair.second], second, 0);
  return points.count == 0 ? 0 : -points.points[0].gap;
}

template <int dim>
Real size_of(const Model<dim>& model, const RigidPair<dim>& pair)
{
  return std::max(bodies::reach_of<dim>(model.rigid_bodies[pair.first].shape),
                  bodies::reach_of<dim>(model.rigid_bodies[pair.second].shape));
}

template <int dim>
void refuse_overlap_at_start(const Model<dim>& model, const RigidPair<dim>& pair, const std::string& key)
{
  const Real overlap = overlap_of<dim>(model, pair, {}, {});
  if (overlap <= overlap_that_counts * size_of(model, pair)) return;
  throw KeyError(fmt::format("{}: \"{}\" and \"{}\" overlap by {:.3g} m at the start: move one of them, or make it smaller", key,
                             model.rigid_bodies[pair.first].name, model.rigid_bodies[pair.second].name, overlap));
}

}  // namespace

template <int dim>
void add_rigid_contacts(const settings::Case& c, Model<dim>& model)
{
  for (const auto& [name, s] : c.rigid_contact) {
    const Index first = index_of(c.rigid, s.rigid), second = index_of(c.rigid, s.other_rigid);
    const std::string path = "rigid_contact." + name;
    const auto proximity = bodies::proximity_of<dim>(c.rigid[first].second.shape, c.rigid[second].second.shape);
    if (!proximity)
      throw KeyError(
          path + (dim == 2
                      ? ": two half-planes cannot be in contact"
                      : ": in space one of the two must be a sphere, or they are two circles along z, or such a circle and a half-plane"));
    if (!may_move(c, s.rigid) && !may_move(c, s.other_rigid))
      throw KeyError(fmt::format("{}: neither \"{}\" nor \"{}\" moves: no stage drives them, and neither has motion = \"free\"", path,
                                 s.rigid, s.other_rigid));
    model.rigid_contacts.push_back({{first, second, *proximity}, name, std::tan(s.friction_angle), s.restitution});
    refuse_overlap_at_start<dim>(model, model.rigid_contacts.back(), path);
  }
  if (c.method != settings::Method::mpm && !c.fem.large_deformation) return;
  const auto touches = [&](const std::string& one, const std::string& other) {
    return std::any_of(c.rigid_contact.begin(), c.rigid_contact.end(),
                       [&](const auto& contact) { return joins(contact.second, one, other); });
  };
  const Index count = static_cast<Index>(c.rigid.size());
  for (Index a = 0; a < count; ++a)
    for (Index b = a + 1; b < count; ++b) {
      const auto& [name, first] = c.rigid[a];
      const auto& [other_name, second] = c.rigid[b];
      const bool bounded = bodies::is_bounded(model.rigid_bodies[a].shape) && bodies::is_bounded(model.rigid_bodies[b].shape);
      if (touches(name, other_name) || !bounded || (!may_move(c, name) && !may_move(c, other_name))) continue;
      if (const auto proximity = bodies::proximity_of<dim>(first.shape, second.shape)) {
        model.apart.push_back({a, b, *proximity});
        refuse_overlap_at_start(model, model.apart.back(), "rigid." + other_name);
      }
    }
}

template <int dim>
RigidVelocities<dim> velocities_at_contacts(const Model<dim>& model, const State<dim>& state)
{
  RigidVelocities<dim> now;
  for (std::size_t k = 0; k < model.rigid_contacts.size(); ++k)
    for (int side = 0; side < 2; ++side) {
      const bodies::RigidState<dim>& body = state.rigid_bodies[side == 0 ? model.rigid_contacts[k].first : model.rigid_contacts[k].second];
      now.velocity[k][side] = body.velocity, now.angular[k][side] = body.angular_velocity;
    }
  return now;
}

namespace {

/// One of two bodies at a point where they meet.
template <int dim>
struct Side {
  Index body = none;
  bodies::DriveNow<dim> movable{};  ///< by_force alone
  Vec<dim> arm = Vec<dim>::Zero();  ///< m, from its centre
};

template <int dim>
struct Point {
  std::size_t contact = 0;
  std::array<Side<dim>, 2> sides{};
  Vec<dim> normal = Vec<dim>::Zero();
  Real gap = 0, closing = 0;  ///< m; the relative normal velocity that closes it in the step, m/s
  Real rests_within = 0;      ///< m: with a smaller gap it rests there
  Real least = 0;             ///< the relative normal velocity that must be left, m/s
  bool later = false;         ///< it collides once other impulses have thrown its bodies together, if at all
  Real response = 0;          ///< of the relative normal velocity to a normal impulse, m/kg or 1/kg
  Real pressed = 0;
  Vec<dim> rubbed = Vec<dim>::Zero();  ///< impulse on the first body along the normal, and across it
};

template <int dim>
bodies::DriveNow<dim> movable(const Model<dim>& model, const State<dim>& state, Index r)
{
  const bodies::RigidBody<dim>& body = model.rigid_bodies[r];
  const bool driven = r == model.driven[state.stage.index];
  const bool free = body.motion == bodies::Motion::free && model.stages[state.stage.index].kind != settings::StageKind::geostatic;
  bodies::DriveNow<dim> drive{};
  for (int f = 0; f < bodies::freedoms<dim>; ++f)
    drive.by_force[f] = driven ? state.stage.drive[f].by_force : free && (f < dim || body.rotation == bodies::Rotation::free);
  return drive;
}

template <int dim>
Vec<dim> velocity_at(const State<dim>& state, const Side<dim>& side)
{
  const bodies::RigidState<dim>& body = state.rigid_bodies[side.body];
  return body.velocity + bodies::cross(body.angular_velocity, side.arm);
}

/// Of the first body less that of the second.
template <int dim>
Vec<dim> slip_at(const State<dim>& state, const Point<dim>& point)
{
  return velocity_at(state, point.sides[0]) - velocity_at(state, point.sides[1]);
}

template <int dim>
void push(const Model<dim>& model, State<dim>& state, const Point<dim>& point, const Vec<dim>& impulse)
{
  for (int k = 0; k < 2; ++k) {
    const Side<dim>& side = point.sides[k];
    add_impulse(model.rigid_bodies[side.body], state.rigid_bodies[side.body], side.movable, side.arm,
                Vec<dim>(k == 0 ? impulse : -impulse));
  }
}

/// What a unit impulse along a direction changes of the slip along it, 1/kg m or 1/kg.
template <int dim>
Real response_along(const Model<dim>& model, const State<dim>& state, const Point<dim>& point, const Vec<dim>& direction)
{
  Real response = 0;
  for (const Side<dim>& side : point.sides) {
    bodies::RigidState<dim> moved = state.rigid_bodies[side.body];
    const Vec<dim> before = moved.velocity;
    const bodies::Angular<dim> turning = moved.angular_velocity;
    add_impulse(model.rigid_bodies[side.body], moved, side.movable, side.arm, direction);
    response += direction.dot(moved.velocity - before + bodies::cross(bodies::Angular<dim>(moved.angular_velocity - turning), side.arm));
  }
  return response;
}

constexpr int max_points = static_cast<int>(settings::max_rigid_contacts) * bodies::max_proximity_points;

template <int dim>
struct Points {
  int count = 0;
  Real reach = 0;                           ///< reach_in_step(), m
  std::array<Point<dim>, max_points> list;  ///< the first are in use
};

/// No point of a body goes farther than this in the step, whatever the impulses, unless light bodies are hit by heavy ones that are faster still: these meet in the next
/// step.
template <int dim>
Real reach_in_step(const Model<dim>& model, const State<dim>& state, Real dt)
{
  Real speed = 0;
  for (const RigidContact<dim>& contact : model.rigid_contacts)
    for (const Index r : {contact.first, contact.second})
      speed = std::max(speed, state.rigid_bodies[r].velocity.norm() + bodies::size_of_angular(state.rigid_bodies[r].angular_velocity) *
                                                                          bodies::reach_of<dim>(model.rigid_bodies[r].shape));
  constexpr Real both_and_thrown = 4;
  return both_and_thrown * dt * speed;
}

/// What a point asks for: where it collides, the restitution of the normal velocity before; where two that bounce may still fly, nothing.
template <int dim>
void take_impact(Real restitution, Point<dim>& point, bool collides, Real before)
{
  point.least = collides ? std::max(point.closing, -restitution * before) : point.closing;
  point.later = !collides && restitution > 0 && point.gap > point.rests_within;
}

template <int dim>
void find_points(const Model<dim>& model, const State<dim>& state, const RigidVelocities<dim>& last, Real dt, Points<dim>& points)
{
  // Of an overlap that rotations leave, a tenth is taken back in a step.
  constexpr Real taken_back = 0.1;
  points.reach = reach_in_step(model, state, dt);
  for (std::size_t k = 0; k < model.rigid_contacts.size(); ++k) {
    const RigidContact<dim>& contact = model.rigid_contacts[k];
    const bodies::ProximityPoints<dim> found =
        proximity_points(contact.proximity, model.rigid_bodies[contact.first], state.rigid_bodies[contact.first],
                         model.rigid_bodies[contact.second], state.rigid_bodies[contact.second], points.reach);
    for (int p = 0; p < found.count; ++p) {
      const bodies::ProximityPoint<dim>& at = found.points[p];
      Point<dim>& point = points.list[points.count++];
      point = Point<dim>();
      point.contact = k, point.normal = at.normal, point.gap = at.gap;
      point.rests_within = overlap_that_counts * size_of<dim>(model, contact);
      Vec<dim> before = Vec<dim>::Zero();
      for (int side = 0; side < 2; ++side) {
        const Index r = side == 0 ? contact.first : contact.second;
        point.sides[side] = {r, movable(model, state, r), Vec<dim>(at.position - center_now(model.rigid_bodies[r], state.rigid_bodies[r]))};
        const Vec<dim> before_here = last.velocity[k][side] + bodies::cross(last.angular[k][side], point.sides[side].arm);
        before += (side == 0 ? 1 : -1) * before_here;
        point.rests_within += dt * (velocity_at(state, point.sides[side]) - before_here).norm();
      }
      point.response = response_along(model, state, point, point.normal);
      point.closing = -(at.gap > 0 ? 1 : taken_back) * at.gap / dt;
      take_impact(contact.restitution, point, point.normal.dot(slip_at(state, point)) < point.closing, point.normal.dot(before));
    }
  }
}

template <int dim>
void refuse_where_neither_moves(const Model<dim>& model, const State<dim>& state, const Point<dim>& point, Real dt)
{
  const RigidContact<dim>& contact = model.rigid_contacts[point.contact];
  if (point.gap + dt * point.normal.dot(slip_at(state, point)) >= -overlap_that_counts * size_of<dim>(model, contact)) return;
  throw RunError(
      fmt::format("\"{}\" and \"{}\" meet at t = {:.4g} s, and neither can yield: both are fixed or driven by a velocity; give one of them "
                  "motion = \"free\" or drive it by a force, or end the stage before they meet",
                  model.rigid_bodies[contact.first].name, model.rigid_bodies[contact.second].name, state.time));
}

/// Impulses at one point after the other until none changes.
template <int dim>
void find_impulses(const Model<dim>& model, State<dim>& state, Points<dim>& points)
{
  constexpr int sweeps = 1000;
  constexpr Real settled = 1e-14;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    Real change = 0, largest = 0;
    for (int p = 0; p < points.count; ++p) {
      Point<dim>& point = points.list[p];
      if (!(point.response > 0) || point.later) continue;
      const Real missing = (point.least - point.normal.dot(slip_at(state, point))) / point.response;
      const Real pressed = std::max(Real(0), point.pressed + missing);
      push(model, state, point, Vec<dim>((pressed - point.pressed) * point.normal));
      change = std::max(change, std::abs(pressed - point.pressed));
      point.pressed = pressed;
      largest = std::max(largest, pressed);
      const Real friction = model.rigid_contacts[point.contact].friction;
      if (friction == 0) continue;
      const Vec<dim> slip = slip_at(state, point), across = slip - point.normal.dot(slip) * point.normal;
      const Real speed = across.norm();
      Vec<dim> rubbed = point.rubbed;
      if (speed > 0)
        if (const Real response = response_along(model, state, point, Vec<dim>(across / speed)); response > 0) rubbed -= across / response;
      if (const Real most = friction * pressed; rubbed.norm() > most) rubbed *= most / rubbed.norm();
      push(model, state, point, Vec<dim>(rubbed - point.rubbed));
      change = std::max(change, (rubbed - point.rubbed).norm());
      point.rubbed = rubbed;
    }
    if (change <= settled * largest) return;
  }
}

/// Of the work of an impulse on a body what is no kinetic energy in the balance: all of it, and of a free body that of freedoms that a velocity prescribes.
template <int dim>
Real work_on_held(bool free, const Side<dim>& side, const Vec<dim>& impulse, const Vec<dim>& velocity, const bodies::Angular<dim>& turning)
{
  const auto held = [&](int freedom) { return !free || !side.movable.by_force[freedom]; };
  Real work = 0;
  for (int d = 0; d < dim; ++d)
    if (held(d)) work += impulse[d] * velocity[d];
  const bodies::Angular<dim> moment = bodies::moment_of(side.arm, impulse);
  if constexpr (dim == 2) {
    if (held(2)) work += moment * turning;
  } else {
    for (int d = 0; d < 3; ++d)
      if (held(3 + d)) work += moment[d] * turning[d];
  }
  return work;
}

/// Books the impulses and their work.
template <int dim>
void count_impulses(const Model<dim>& model, State<dim>& state, const RigidVelocities<dim>& before, const Points<dim>& points)
{
  for (int p = 0; p < points.count; ++p) {
    const Point<dim>& point = points.list[p];
    const Vec<dim> impulse = point.pressed * point.normal + point.rubbed;
    state.ledger.rigid_impulses[point.contact] += impulse;
    for (int k = 0; k < 2; ++k) {
      const Side<dim>& side = point.sides[k];
      const bodies::RigidState<dim>& body = state.rigid_bodies[side.body];
      const Vec<dim> given = k == 0 ? impulse : Vec<dim>(-impulse);
      const Vec<dim> velocity = (body.velocity + before.velocity[point.contact][k]) / 2;
      const bodies::Angular<dim> turning = (body.angular_velocity + before.angular[point.contact][k]) / 2;
      state.ledger.totals.friction -= given.dot(velocity + bodies::cross(turning, side.arm));
      const bool free = model.rigid_bodies[side.body].motion == bodies::Motion::free;
      state.ledger.totals.external -= work_on_held(free, side, given, velocity, turning);
    }
  }
}

/// Whether impulses have thrown bodies together that bounce, and makes the points ready for it; at the last of the step without bouncing.
template <int dim>
bool collide_again(const Model<dim>& model, const State<dim>& state, Real dt, bool last, Points<dim>& points)
{
  const Real round_off = overlap_that_counts * points.reach / dt;
  bool again = false;
  for (int p = 0; p < points.count; ++p) {
    Point<dim>& point = points.list[p];
    const Real restitution = model.rigid_contacts[point.contact].restitution, before = point.normal.dot(slip_at(state, point));
    const bool collides = restitution > 0 && point.response > 0 && before < point.closing - round_off;
    again = again || collides;
    take_impact(last ? 0 : restitution, point, collides, before);
    point.pressed = 0, point.rubbed = Vec<dim>::Zero();
  }
  return again;
}

}  // namespace

template <int dim>
void push_apart(const Model<dim>& model, State<dim>& state, const RigidVelocities<dim>& last, Real dt)
{
  Points<dim> points;
  find_points(model, state, last, dt, points);
  if (points.count == 0) return;
  for (int p = 0; p < points.count; ++p)
    if (!(points.list[p].response > 0)) refuse_where_neither_moves(model, state, points.list[p], dt);
  constexpr int most_collisions =
      1000;  // one after the other in a step: of bodies that fly to and fro between others they lose their bounce
  for (int n = 1; n == 1 || collide_again(model, state, dt, n == most_collisions, points); ++n) {
    const RigidVelocities<dim> before = velocities_at_contacts(model, state);
    find_impulses(model, state, points);
    count_impulses(model, state, before, points);
    if (n == most_collisions) break;
  }
}

template <int dim>
void refuse_overlap(const Model<dim>& model, const State<dim>& state)
{
  for (const RigidPair<dim>& pair : model.apart) {
    const Real overlap = overlap_of<dim>(model, pair, state.rigid_bodies[pair.first], state.rigid_bodies[pair.second]);
    if (overlap <= overlap_that_counts * size_of(model, pair)) continue;
    const std::string &first = model.rigid_bodies[pair.first].name, &second = model.rigid_bodies[pair.second].name;
    throw RunError(
        fmt::format("\"{0}\" and \"{1}\" overlap by {2:.3g} m at t = {3:.4g} s: rigid bodies without a contact pass through each "
                    "other; add [rigid_contact.NAME] with rigid = \"{0}\" and other_rigid = \"{1}\", and give the body that is to be "
                    "pushed aside a mass and motion = \"free\"",
                    first, second, overlap, state.time));
  }
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void add_rigid_contacts(const settings::Case&, Model<dim>&);                                                                    \
  template RigidVelocities<dim> velocities_at_contacts(const Model<dim>&, const State<dim>&);                                              \
  template void push_apart(const Model<dim>&, State<dim>&, const RigidVelocities<dim>&, Real);                                             \
  template void refuse_overlap(const Model<dim>&, const State<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
