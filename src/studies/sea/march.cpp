// SPDX-License-Identifier: BSD-3-Clause
#include "sea/march.hpp"

#include "macro_element/under_force.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::sea {
namespace {

constexpr Real end_weight = 0.6, steps_a_row = 16, longest_way = 0.05, turn = 0.01;  // the last two over D

struct Moving {
  berm_macro_element_state soil;
  Real v = 0;  ///< m/s
};

class Integrator {
public:
  Integrator(const macro_element::Parameters& soil, const settings::StageSettings& stage, Real mass)
      : soil_(soil),
        stage_(stage),
        mass_(mass)
  {
  }

  void step(Moving& now, Real time, Real dt) const
  {
    constexpr Real shortest = 1e-5;  // s
    Moving next = now;
    if (find(next, time, dt)) {
      now = next;
      return;
    }
    if (dt < shortest)
      throw RunError(
          fmt::format("the macro-element carries the pipe in no equilibrium at {:.4g} s of the record, at u = {:.3g} m, w = {:.3g} m", time,
                      now.soil.u, now.soil.w));
    step(now, time, dt / 2);
    step(now, time + dt / 2, dt / 2);
  }

private:
  /// The force that is missing across the pipe where it moves by du; `next` is the pipe there.
  Real missing(const Moving& now, const settings::WaterMotion& water, Real dt, Real du, Moving& next) const
  {
    next.v = (du / dt - (1 - end_weight) * now.v) / end_weight;
    const settings::WaterForce force = water_force(*stage_.water, water, soil_.diameter, next.v, now.soil.w);
    next.soil = macro_element::moved_under(soil_, now.soil, 0, now.soil.u + du, std::max(force.V, Real(0)));
    return mass_ * (next.v - now.v) / dt + next.soil.H - force.H;
  }

  /// By the secant from the stiffness of a step within yield.
  bool find(Moving& now, Real time, Real dt) const
  {
    constexpr int most = 20;
    constexpr Real part = 1e-6;
    settings::WaterMotion water = water_at(stage_, time + dt);
    water.acceleration = water_at(stage_, time + dt / 2).acceleration;  // at the end of a row the slope is that of the next
    const Real tolerance = part * (stage_.water->weight + std::abs(now.soil.H));
    Real slope = mass_ / (end_weight * dt * dt) + soil_.horizontal_stiffness, du = dt * now.v;
    Moving next;
    Real left = missing(now, water, dt, du, next);
    for (int k = 0; k < most && std::abs(left) > tolerance; ++k) {
      const Real change = -left / slope;
      if (!(std::abs(du + change) < longest_way * soil_.diameter)) return false;
      du += change;
      const Real after = missing(now, water, dt, du, next);
      slope = std::max((after - left) / change, slope / 10);
      left = after;
    }
    if (!(std::abs(left) <= tolerance)) return false;
    now = next;
    return true;
  }

  const macro_element::Parameters& soil_;
  const settings::StageSettings& stage_;
  Real mass_;
};

}  // namespace

TrackNumbers numbers_of(const Track& track, Real diameter)
{
  TrackNumbers found;
  if (track.u.empty()) return found;
  const Real start = track.u.front();
  Real turned = start, extreme = start;  // the last turn, and the farthest since
  for (std::size_t k = 0; k < track.u.size(); ++k) {
    const Real u = track.u[k];
    found.largest = std::max(found.largest, std::abs(u - start));
    found.largest_w = std::max(found.largest_w, track.w[k]);
    if (std::abs(u - turned) >= std::abs(extreme - turned) && (u - turned) * (extreme - turned) >= 0)
      extreme = u;
    else if (std::abs(u - extreme) > turn * diameter)
      turned = extreme, extreme = u;
    found.half_cycle = std::max(found.half_cycle, std::abs(extreme - turned));
  }
  found.end = track.u.back() - start;
  return found;
}

Track march(const macro_element::Parameters& soil, const berm_macro_element_state& laid, const settings::StageSettings& water, Real mass)
{
  const Integrator integrator(soil, water, mass);
  Moving now{.soil = laid};
  Track track{{water.load_times.front()}, {now.soil.u}, {now.soil.w}};
  for (std::size_t row = 1; row < water.load_times.size(); ++row) {
    const Real begin = water.load_times[row - 1], dt = (water.load_times[row] - begin) / steps_a_row;
    for (int k = 0; k < steps_a_row; ++k) integrator.step(now, begin + k * dt, dt);
    track.time.push_back(water.load_times[row]), track.u.push_back(now.soil.u), track.w.push_back(now.soil.w);
  }
  return track;
}

}  // namespace berm::sea
