// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "io/duration_text.hpp"
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"
#include "settings/drainage.hpp"
#include "settings/stage.hpp"
#include "settings/time_scale.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

using settings::StageKind;
using settings::StageSettings;

/// The freedom of a drive along an axis.
const settings::FreedomSettings& along_axis(const StageSettings& s, int axis)
{
  return axis == 0 ? s.drive.x : axis == 1 ? s.drive.y : s.drive.z;
}

std::optional<Real> downward_velocity_of_drive(const Scene& scene, const StageSettings& s)
{
  const settings::FreedomSettings& up = along_axis(s, scene.up);
  if (up.force || up.hold || up.free || up.spring || !s.drive.point.empty()) return {};
  return up.velocity ? -scene.up_sign * *up.velocity : 0;
}

/// Downward speed where a velocity gives it, m/s.
std::optional<Real> downward_velocity(const Scene& scene, const StageSettings& s)
{
  if (has_load_history(s)) return {};
  if (s.kind == StageKind::push) return s.velocity;
  if (s.kind == StageKind::drive) return downward_velocity_of_drive(scene, s);
  if (s.kind == StageKind::drag && s.vertical == settings::Vertical::fixed) return 0;
  return s.kind == StageKind::drag ? s.vertical_velocity : std::nullopt;
}

bool is_lifted(const Scene& scene, const StageSettings& s)
{
  return downward_velocity(scene, s).value_or(0) < 0;
}

constexpr const char* problem_axes[] = {"x", "y", "z"};

/// m, from the body where a stage begins to the end of the mesh along an axis.
Real room_to(const Scene& scene, const Way& way, int axis, Real sign)
{
  const Span &body = scene.rigids[way.rigid].space[axis], &mesh = scene.mesh[axis];
  const Real moved = way.axis[axis].begin;
  return sign > 0 ? mesh.to - (body.to + moved) : body.from + moved - mesh.from;
}

/// The direction in which a force drives a body that nothing else moves; empty where there are several or none.
struct Direction {
  int axis;
  Real sign;
};
std::optional<Direction> only_force(const Scene& scene, const StageSettings& s)
{
  std::optional<Direction> found;
  if (s.kind != StageKind::drive || has_load_history(s) || !s.drive.point.empty()) return {};
  for (int d = 0; d < scene.c.dimension(); ++d) {
    const settings::FreedomSettings& along = along_axis(s, d);
    if (along.velocity.value_or(0) != 0 || along.hold || along.free || along.spring || (along.force && found)) return {};
    if (along.force && *along.force != 0) found = {d, *along.force > 0 ? Real(1) : Real(-1)};
  }
  return found;
}

/// Whether the body is at the limit or beyond when the stage begins.
bool is_there_already(const Scene& scene, const StageSettings& s, const Way& way)
{
  if (!s.until.embedment || !way.begin_known) return false;
  return is_lifted(scene, s) ? *s.until.embedment >= way.begin_embedment : *s.until.embedment <= way.begin_embedment;
}

/// What stops a stage is listed here, for one limit after the other: why it is never reached, or reached at once; "" where it can be.
std::string fault_of_embedment(const Scene& scene, const StageSettings& s, const Way& way)
{
  if (!s.until.embedment) return "";
  const Real wanted = *s.until.embedment, w = way.begin_embedment;
  const std::optional<Real> down = downward_velocity(scene, s);
  if (is_there_already(scene, s, way) && is_lifted(scene, s))
    return fmt::format(
        "{} is never reached: the body moves up (velocity {}) from w = {}; give a smaller one, make the velocity positive, or "
        "end the stage by a time",
        words_of(wanted, "m"), words_of(*down, "m/s"), words_of(w, "m"));
  if (is_there_already(scene, s, way))
    return fmt::format("{} is reached before the stage begins, with w = {}: give a larger one", words_of(wanted, "m"), words_of(w, "m"));
  if (down && *down == 0)
    return fmt::format(
        "{} is never reached: the body does not move vertically (velocity {}); make the velocity positive, or end the stage by a "
        "time",
        words_of(wanted, "m"), words_of(*down, "m/s"));
  const Real deepest = s.until.embedment && scene.rigids[way.rigid].bounded ? room_to(scene, way, scene.up, -scene.up_sign) + w : infinity;
  if (way.begin_known && !way.axis[scene.up].known && wanted > deepest)
    return fmt::format("{} is never reached: the mesh ends at w = {}; give a smaller one, or make the mesh deeper", words_of(wanted, "m"),
                       words_of(deepest, "m"));
  return "";
}

std::string fault_of_displacement(const Scene& scene, const StageSettings& s, const Way& way)
{
  if (!s.until.displacement) return "";
  if (s.kind == StageKind::push) return "is horizontal, and a push is downwards only: end it by embedment, force or time";
  if (s.kind == StageKind::drag && s.velocity && *s.velocity == 0) return "is never reached: velocity is 0";
  if (s.kind == StageKind::drive && !is_by_force(s) && speed_of(s) == 0) return "is never reached: nothing in [stage.drive] moves the body";
  if (const auto way_out = only_force(scene, s); way_out && scene.rigids[way.rigid].bounded && way.axis[way_out->axis].begin_known) {
    const Real room = room_to(scene, way, way_out->axis, way_out->sign);
    if (*s.until.displacement > room)
      return fmt::format(
          "{} is never reached: the force moves the body towards {}{}, where the mesh ends {} from it; give a smaller one, or "
          "make the mesh larger there",
          words_of(*s.until.displacement, "m"), way_out->sign > 0 ? "+" : "-", problem_axes[way_out->axis], words_of(room, "m"));
  }
  return "";
}

/// The unit of forces, of which a plane run has those per metre.
const char* force_unit(const settings::Case& c)
{
  return c.force_dimension() == 2 ? "N/m" : "N";
}

/// The V that the stages before leave on the body of stage k, N/m or N, as far as the input says it: 0 where none drives it.
std::optional<Real> force_before(const Scene& s, std::size_t k)
{
  for (std::size_t before = k; before-- > 0;) {
    const StageSettings& stage = s.c.stage[before];
    if (s.ways[before].rigid != s.ways[k].rigid) continue;
    if (has_load_history(stage)) return {};
    if (stage.kind == StageKind::push && stage.force) return stage.force;
    if (stage.kind == StageKind::push) return stage.until.force;
    if (stage.kind != StageKind::drag || stage.vertical != settings::Vertical::hold || stage.vertical_velocity) return {};
    if (stage.vertical_force) return stage.vertical_force;
  }
  return 0;
}

std::string fault_of_force(const Scene& scene, const StageSettings& s, const std::optional<Real>& before, const char* unit)
{
  if (!s.until.force || has_load_history(s)) return "";
  if (s.kind == StageKind::push && s.velocity && *s.velocity == 0) return "is never reached: the body does not move (velocity 0 m/s)";
  if (s.kind == StageKind::push && is_lifted(scene, s) && before && *s.until.force >= *before)
    return fmt::format(
        "{0:.3g} {2} is reached before the stage begins: V is {1:.3g} {2} there, and falls while the body moves up (velocity "
        "{3}); give a smaller one, less than 0 where the soil is to hold the body down; or make the velocity positive",
        *s.until.force, *before, unit, words_of(*s.velocity, "m/s"));
  const Real largest = s.force.value_or(0);
  if (s.kind == StageKind::push && s.force && largest < *s.until.force && !(before.value_or(0) > *s.until.force))
    return fmt::format("{0:.3g} {2} is never reached: the drive gives {1:.3g} {2}", *s.until.force, largest, unit);
  if (s.kind == StageKind::drag && s.velocity && *s.velocity == 0) return "is never reached: velocity is 0";
  if (s.kind == StageKind::drag && s.force && std::abs(*s.force) < *s.until.force)
    return fmt::format("{0:.3g} {2} is never reached: the drive gives {1:.3g} {2}", *s.until.force, std::abs(*s.force), unit);
  return "";
}

/// The mass of the soil that the body displaces, kg/m or kg. Around an axis and in space about that of a ball.
Real displaced(const Scene& s, Index rigid, Index body)
{
  const Real width = s.rigids[rigid].width, density = inertia_density(s.material_of(body));
  return density * (s.c.force_dimension() == 2 ? 0.785 * width * width : 0.5 * width * width * width);
}

/// A change of speed that a load history makes at once, m/s, and the time in its record, s.
struct Blow {
  Real speed = 0, time = 0;
};

/// The largest change to another speed than 0 along the axes: where a velocity begins or jumps, and where a displacement bends.
Blow largest_blow(const StageSettings& s)
{
  Blow largest;
  const std::vector<Real>& t = s.load_times;
  const auto take = [&](Real before, Real after, Real time) {
    const Real speed = std::abs(after - before) / s.time_scale;
    if (after != 0 && speed > largest.speed) largest = {speed, time};
  };
  const auto take_velocities = [&](const std::vector<Real>& v, Real factor) {
    if (!v.empty() && s.ramp == 0) take(0, factor * v[0], 0);
    for (std::size_t k = 1; k < v.size(); ++k)
      if (t[k] == t[k - 1]) take(factor * v[k - 1], factor * v[k], t[k]);
  };
  if (s.velocity) take_velocities(s.load_factors, *s.velocity);
  for (std::size_t k = 0; k < settings::load_columns.size(); ++k) {
    const std::vector<Real>& column = s.loads.columns[k];
    if (settings::load_columns[k].along > settings::LoadAlong::z) continue;
    if (settings::load_columns[k].quantity == settings::LoadQuantity::velocity) take_velocities(column, 1);
    if (settings::load_columns[k].quantity != settings::LoadQuantity::displacement) continue;
    Real before = 0;
    for (std::size_t row = 1; row < column.size(); ++row) {
      if (t[row] == t[row - 1]) continue;
      const Real slope = (column[row] - column[row - 1]) / (t[row] - t[row - 1]);
      take(before, slope, t[row - 1]);
      before = slope;
    }
  }
  return largest;
}

}  // namespace

void can_the_limits_be_reached(const Scene& s, Findings& found)
{
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const StageSettings& stage = s.c.stage[k];
    if (s.ways[k].rigid == none) continue;
    const std::string w = fault_of_embedment(s, stage, s.ways[k]), u = fault_of_displacement(s, stage, s.ways[k]),
                      force = fault_of_force(s, stage, force_before(s, k), force_unit(s.c));
    const bool at_once = is_there_already(s, stage, s.ways[k]);
    const bool ends = stage.until.time || (stage.until.embedment && w.empty()) || (stage.until.displacement && u.empty()) ||
                      (stage.until.force && force.empty());
    for (const auto& [key, fault] : {std::pair("embedment", w), {"displacement", u}, {"force", force}}) {
      if (fault.empty()) continue;
      if (ends && !at_once)
        found.warn(stage_key(k, std::string("until.") + key), fault);
      else
        found.refuse(stage_key(k, std::string("until.") + key), fault);
    }
    const Real width = s.rigids[s.ways[k].rigid].width;
    constexpr Real nothing = 5e-3;  // of the width
    if (const std::optional<Real> travel = stage.until.displacement; travel && *travel < nothing * width && !s.c.small_strain())
      found.warn(
          stage_key(k, "until.displacement"),
          fmt::format(
              "is {}, {:.2g} of the width of the body, and a resistance needs a few hundredths of it to mobilise: is the unit right?",
              words_of(*travel, "m"), *travel / width));
    const std::optional<Direction> drive = only_force(s, stage);
    const Real force_alone = stage.force.value_or(drive ? along_axis(stage, drive->axis).force.value_or(0) : 0);
    const bool ends_by_itself = has_load_history(stage) || stage.until.time || stage.until.force || stage.until.consolidation;
    if (!s.c.small_strain() && force_alone != 0 && !ends_by_itself)
      found.warn(stage_key(k, "until"),
                 fmt::format("may never be reached: a force of {:.3g} {} drives, and the soil may carry it before; add until.time as well",
                             force_alone, force_unit(s.c)));
  }
}

void is_the_drive_slow(const Scene& s, Findings& found)
{
  if (!s.is_mpm()) return;
  for (Index rigid = 0; rigid < static_cast<Index>(s.rigids.size()); ++rigid) {
    const Index body = s.touched_by(rigid);
    if (body == none) continue;
    const Real density = inertia_density(s.material_of(body)), width = s.rigids[rigid].width;
    const Real strength = width > 0 ? strength_at_depth_of(s, body, width).value_or(0) : 0;
    const Real limit = strength > 0 ? std::sqrt(settings::large_inertia * strength / density) : 0.1 * s.bodies[body].wave_speed;
    // One warning, at the fastest stage.
    std::size_t fastest = 0;
    std::vector<std::size_t> fast;
    for (std::size_t k = 0; k < s.ways.size(); ++k) {
      const Real speed = s.ways[k].rigid == rigid && may_meet_soil(s, s.ways[k]) ? speed_of(s.c.stage[k]) : 0;
      if (speed <= limit) continue;
      if (fast.empty() || speed > speed_of(s.c.stage[fastest])) fastest = k;
      fast.push_back(k);
    }
    if (fast.empty()) continue;
    std::string others;
    for (const std::size_t k : fast)
      if (s.places.located(stage_key(k, "velocity"), "").text() !=
          s.places.located(stage_key(fastest, "velocity"), "").text())  // not of the same sweep
        others += (others.empty() ? "; also in stages " : ", ") + s.c.stage[k].name;
    const Real speed = speed_of(s.c.stage[fastest]), inertia = density * speed * speed;
    const std::string part = strength > 0 ? fmt::format(", {:.2g} of the strength at a depth of D", inertia / strength) : "";
    found.warn(stage_key(fastest, s.c.stage[fastest].kind == StageKind::drive ? "drive" : "velocity"),
               fmt::format("is {}: so fast that the inertia of the soil carries part of the force (density v^2 = {:.3g} Pa{}; waves in "
                           "the soil run at {:.3g} m/s); {} or less is slow enough{}",
                           words_of(speed, "m/s"), inertia, part, s.bodies[body].wave_speed,
                           words_of(rounded_down(limit * std::sqrt(settings::small_inertia / settings::large_inertia)), "m/s"), others));
  }
}

void is_the_load_history_slow(const Scene& s, Findings& found)
{
  constexpr Real too_fast = 3, long_run = 2 * 3600;
  if (!s.is_mpm()) return;
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const StageSettings& stage = s.c.stage[k];
    if (s.ways[k].rigid == none) continue;
    const std::optional<settings::TimeScale> slow = time_scale_of(s.c, stage);
    if (!slow) continue;
    const Real half_wave = slow->half_wave * stage.time_scale;
    if (half_wave < slow->shortest / too_fast)
      found.warn(stage_key(k, "time_scale"),
                 fmt::format("is {:.3g}: the load goes from one peak to the next in {}, so fast that {} matters ({} or more is slow "
                             "enough); take {:.2g}",
                             stage.time_scale, words_of(half_wave, "s"), words_of(slow->reason), words_of(slow->shortest, "s"),
                             slow->shortest / slow->half_wave));
    const Real seconds =
        s.cost.time_step > 0 ? expected_time(stage) / s.cost.time_step * s.cost.particles / s.cost.particle_steps_per_s : 0;
    if (seconds > long_run && slow->scale < 0.7 * stage.time_scale)
      found.warn(stage_key(k, "time_scale"),
                 fmt::format("is {:.3g}, and the load history takes about {}: {:.2g} is slow enough for a body that the soil holds, with "
                             "half cycles of {} ({} governs); time_scale = \"automatic\" takes it. One that breaks out needs 1",
                             stage.time_scale, io::duration_text(seconds), slow->scale, words_of(slow->shortest, "s"),
                             words_of(slow->reason)));
  }
}

namespace {

/// V of a stage where its record does not drive it, N/m: its own, or what an earlier stage left; empty where the input does not say it.
std::optional<Real> held_V(const settings::Case& c, std::size_t stage)
{
  if (c.stage[stage].vertical_force) return c.stage[stage].vertical_force;
  while (stage-- > 0) {
    const StageSettings& earlier = c.stage[stage];
    if (earlier.vertical_force) return earlier.vertical_force;
    if (earlier.kind == StageKind::push) return earlier.force ? earlier.force : earlier.until.force;
  }
  return {};
}

/// H of a drag by the row of its record, N/m along x; empty where no force drives it.
std::vector<Real> driven_H(const StageSettings& stage)
{
  if (stage.kind != StageKind::drag) return {};
  std::vector<Real> H = stage.loads.of("H");
  if (H.empty() && stage.force)
    for (const Real factor : stage.load_factors) H.push_back(factor * *stage.force);
  return H;
}

}  // namespace

void is_a_breakout_run_in_real_time(const Scene& s, Findings& found)
{
  if (s.c.small_strain() || s.c.geometry != settings::Geometry::plane_strain) return;
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const StageSettings& stage = s.c.stage[k];
    const Index rigid = s.ways[k].rigid, body = rigid == none ? none : s.touched_by(rigid);
    const Real width = body == none ? 0 : s.rigids[rigid].width;
    const std::vector<Real> H = driven_H(stage);
    if (!(stage.time_scale < 1) || H.empty() || width == 0) continue;
    const std::optional<material::Strength> strength = strength_at_rest(s.material_at(body, width));
    const std::optional<Real> held = held_V(s.c, k);
    const std::vector<Real>& V = stage.loads.of("V");
    if (!strength || (V.empty() && !held && strength->friction_angle > 0)) continue;
    for (std::size_t row = 0; row < H.size(); ++row) {
      const Real pressing = std::max(Real(0), V.empty() ? held.value_or(0) : V[row]),
                 holds = pressing * std::tan(strength->friction_angle) + 2 * strength->cohesion * width;
      if (std::abs(H[row]) <= holds) continue;
      found.warn(stage_key(k, "time_scale"),
                 fmt::format("is {:.3g}: H of {} at {} of the record is more than about {}, V tan(phi) + 2 c D, the estimated resistance "
                             "of the soil: {}, so its displacement is a lower estimate; run with time_scale = 1",
                             stage.time_scale, words_of(std::abs(H[row]), "N/m"), words_of(stage.load_times[row], "s"),
                             words_of(holds, "N/m"), settings::breakout_takes_time));
      break;
    }
  }
}

void does_the_drive_begin_gently(const Scene& s, Findings& found)
{
  if (!s.is_mpm()) return;
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const Index rigid = s.ways[k].rigid, body = rigid == none ? none : s.touched_by(rigid);
    const StageSettings& stage = s.c.stage[k];
    const Blow of_record = largest_blow(stage);
    const bool has_record = !stage.load_times.empty();
    const Real speed = has_record ? of_record.speed : speed_of(stage), width = body == none ? 0 : s.rigids[rigid].width;
    if (speed == 0 || width == 0 || !may_meet_soil(s, s.ways[k])) continue;
    const Real wave = s.bodies[body].wave_speed, blow = inertia_density(s.material_of(body)) * wave * speed, cross = width / wave;
    const std::optional<Real> strength = strength_at_depth_of(s, body, width);
    if (!strength || *strength <= 0 || blow < 3 * *strength || (!has_record && stage.ramp >= cross)) continue;
    if (has_record) {
      found.warn(stage_key(k, "load_history"), fmt::format("changes the speed by {} at once, at {} of the record: that is an impact of "
                                                           "{:.3g} times the strength of the soil; spread the change over {} or more",
                                                           words_of(speed, "m/s"), words_of(of_record.time, "s"), blow / *strength,
                                                           words_of(rounded_up(5 * cross), "s")));
      continue;
    }
    found.warn(stage_key(k, "ramp"),
               fmt::format("is {}: a drive that starts within the travel time of a wave across the body ({}) is an impact of {:.3g} times "
                           "the strength of the soil; take {} or more",
                           words_of(stage.ramp, "s"), words_of(cross, "s"), blow / *strength, words_of(rounded_up(5 * cross), "s")));
  }
}

void is_there_time_for_equilibrium(const Scene& s, Findings& found)
{
  if (!s.is_mpm() || s.gravity == 0) return;
  for (std::size_t k = 0; k < s.c.stage.size(); ++k) {
    const StageSettings& stage = s.c.stage[k];
    if (stage.kind != StageKind::geostatic) continue;
    Real longest = 0;
    bool stressed = true;
    for (Index b = 0; b < static_cast<Index>(s.bodies.size()); ++b) {
      longest = std::max(longest, s.depth_of(b) / s.bodies[b].wave_speed);
      stressed = stressed && (s.c.body[b].second.has_k0() || !s.c.body[b].second.initial_stress.empty());
    }
    const Real time = stage.until.time.value_or(0), least = stressed ? 0.9 * longest : 4 * longest,
               proposed = stressed ? 4 * longest : 40 * longest;
    if (time < least && !(ends_at_equilibrium(stage) && !stage.until.time))
      found.warn(
          stage_key(k, "until.time"),
          fmt::format(
              "is {}, and a wave takes {} from the base of the bed to its surface{}: too short to reach equilibrium; take {} or more",
              words_of(time, "s"), words_of(longest, "s"), stressed ? "" : ", where the weight is applied at once",
              words_of(rounded_up(proposed), "s")));
    const bool damped =
        stage.damping.value_or(0) > 0 ||
        (!stage.damping && std::any_of(s.c.body.begin(), s.c.body.end(), [](const auto& b) { return b.second.damping > 0; }));
    if (!damped)
      found.warn(stage_key(k, "damping"),
                 "there is none: the soil oscillates and does not reach equilibrium; take damping = 0.7 in this stage");
  }
}

void is_the_mass_that_of_a_pipe(const Scene& s, Findings& found)
{
  constexpr Real light = 0.02, no_mass = 1e-4, heavy = 200;
  std::vector<char> asked(s.rigids.size(), 0);
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const Index rigid = s.ways[k].rigid, body = rigid == none ? none : s.touched_by(rigid);
    if (body == none || !s.is_mpm() || !is_by_force(s.c.stage[k]) || s.rigids[rigid].width == 0 || !yields(s.material_of(body)) ||
        std::exchange(asked[rigid], 1) != 0)
      continue;
    const Real mass = s.c.rigid[rigid].second.mass, soil = displaced(s, rigid, body);
    const std::string key = fmt::format("rigid.{}.mass", s.c.rigid[rigid].first);
    const char* unit = s.c.force_dimension() == 2 ? "kg/m" : "kg";
    const std::string rest = fmt::format("the soil that it can displace has {}; stage \"{}\" holds a force with it: take about {}",
                                         words_of(soil, unit), s.c.stage[k].name, words_of(rounded_up(soil), unit));
    if (mass < no_mass * soil)
      found.refuse(key, fmt::format("is {}, too small for a force to be held: the body would be thrown out of the mesh; {}",
                                    words_of(mass, unit), rest));
    else if (mass < light * soil)
      found.warn(key, fmt::format("is {}, so small that the body vibrates; {}", words_of(mass, unit), rest));
    else if (mass > heavy * soil)
      found.warn(key, fmt::format("is {}, so large that the force is not held: the body keeps moving by its inertia; {}",
                                  words_of(mass, unit), rest));
  }
}

void is_the_mass_that_of_the_weight(const Scene& s, Findings& found)
{
  constexpr Real rounding = 0.95;
  if (!s.is_mpm() || !(s.gravity > 0)) return;
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const Index rigid = s.ways[k].rigid;
    const StageSettings& stage = s.c.stage[k];
    if (rigid == none || !bodies::pipe_section(s.c.rigid[rigid].second.shape)) continue;
    const auto& column = stage.loads.of("V");
    Real weight = stage.vertical_force.value_or(column.empty() ? 0 : *std::max_element(column.begin(), column.end()));
    if (stage.water) weight = s.gravity * mass_in_water(*stage.water, s.rigids[rigid].width);
    if (stage.kind == StageKind::drag && weight == 0 && stage.vertical == settings::Vertical::hold) weight = force_before(s, k).value_or(0);
    const std::optional<Direction> drive = only_force(s, stage);
    const bool sinks = drive && drive->axis == s.up && drive->sign == -s.up_sign,
               moves = sinks || (has_load_history(stage) && stage.kind == StageKind::drag && !stage.velocity);
    if (sinks) weight = std::abs(*along_axis(stage, s.up).force);
    const Real mass = s.c.rigid[rigid].second.mass;
    if (!moves || !(mass < rounding * weight / s.gravity)) continue;
    const char* unit = s.c.force_dimension() == 2 ? "kg/m" : "kg";
    found.warn(
        fmt::format("rigid.{}.mass", s.c.rigid[rigid].first),
        fmt::format("is {}, less than its submerged weight divided by g{}, {}: how it moves in stage \"{}\" depends on its mass; take "
                    "that{}, {} or more",
                    words_of(mass, unit), stage.water ? " with displaced water and added mass" : "", words_of(weight / s.gravity, unit),
                    stage.name, stage.water ? "" : ", the displaced water and the added mass",
                    words_of(rounded_up(weight / s.gravity), unit)));
    return;
  }
}

void is_damping_small(const Scene& s, Findings& found)
{
  constexpr Real much = 0.5;
  if (!s.is_mpm()) return;
  bool driven = false;  // in a stage that has no damping of its own
  for (std::size_t k = 0; k < s.ways.size(); ++k) driven = driven || (s.ways[k].rigid != none && !s.c.stage[k].damping);
  const auto advice = [](Real damping) {
    return fmt::format(
        "is {:.3g} while a body is driven: it carries a fraction of the force; take 0.02 to 0.05, and 0.7 in a geostatic stage alone",
        damping);
  };
  for (const auto& [name, body] : s.c.body)
    if (driven && body.damping > much) found.warn(fmt::format("body.{}.damping", name), advice(body.damping));
  for (std::size_t k = 0; k < s.ways.size(); ++k)
    if (s.ways[k].rigid != none && s.c.stage[k].damping.value_or(0) > much)
      found.warn(stage_key(k, "damping"), advice(*s.c.stage[k].damping));
}

void do_forces_press_down(const Scene& s, Findings& found)
{
  bool pressed = false;
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const StageSettings& stage = s.c.stage[k];
    if (s.ways[k].rigid == none) continue;
    const bool drag = stage.kind == StageKind::drag;
    if (drag && stage.vertical_force && *stage.vertical_force < 0)
      found.warn(stage_key(k, "vertical_force"),
                 fmt::format("is {:.3g} {}: it lifts the body out of the soil; a downward force is positive", *stage.vertical_force,
                             force_unit(s.c)));
    if (stage.kind == StageKind::push && stage.force && *stage.force < 0)
      found.warn(stage_key(k, "force"),
                 fmt::format("is {:.3g} {}: it lifts the body; a push down is positive", *stage.force, force_unit(s.c)));
    const Real pull = stage.kind == StageKind::drive ? s.up_sign * along_axis(stage, s.up).force.value_or(0) : 0;
    const bool bare = s.ways[k].begin_known && s.rigids[s.ways[k].rigid].bounded &&
                      s.ways[k].begin_embedment < s.rigids[s.ways[k].rigid].space[s.up].length();
    if (pull > 0 && bare)
      found.warn(
          stage_key(k, fmt::format("drive.{}.force", problem_axes[s.up])),
          fmt::format("is {:.3g} {} upwards, and there is no soil above the body: it leaves the soil; a weight is less than 0 along {}",
                      pull, force_unit(s.c), problem_axes[s.up]));
    const bool varies = stage.loads.drives(settings::LoadAlong::downwards);
    const bool holds = drag && stage.vertical == settings::Vertical::hold && !stage.vertical_force && !stage.vertical_velocity && !varies;
    if (holds && !pressed && !s.c.small_strain() && s.ways[k].begin_known && s.ways[k].begin_embedment <= 0)
      found.warn(stage_key(k, "vertical"), "holds the vertical force at the start of the stage, which is 0: nothing pushed the body down "
                                           "before; push it first, or give vertical_force");
    pressed = true;
  }
}

}  // namespace berm::sanity
