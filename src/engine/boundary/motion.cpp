// SPDX-License-Identifier: BSD-3-Clause
#include "boundary/motion.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::boundary {

void describe(Describe& d, MotionSettings& motion)
{
  d.value(
      "stages", motion.stages,
      {.meaning = "names of the stages in which it acts, from the start of each; in others the boundary does not move", .required = true});
  d.value("table", motion.table,
          {.meaning =
               "CSV file, relative to the case file, of the time since the start of such a stage and the velocities: its first line is "
               "time_s,x_m_s, with any of the columns x, y, z. Linear between its rows, constant after"});
  d.value("times", motion.times,
          {.meaning = "instead of a table: times since the start of such a stage, the first one 0", .unit = "s", .range = not_negative});
  for (std::size_t k = 0; k < motion.velocity.size(); ++k)
    d.value(motion_axes[k], motion.velocity[k],
            {.meaning = k == 0   ? "velocities along x at these times"
                        : k == 1 ? "velocities along y at these times"
                                 : "velocities along z at these times, in space",
             .unit = unit_of_motion});
}

Real velocity_at(const MotionSettings& motion, int axis, Real since)
{
  const std::vector<Real>&t = motion.times, &v = motion.velocity[static_cast<std::size_t>(axis)];
  if (v.empty()) return 0;
  const auto after = std::upper_bound(t.begin(), t.end(), since);
  if (after == t.begin()) return v.front();
  if (after == t.end()) return v.back();
  const std::size_t k = static_cast<std::size_t>(after - t.begin());
  return std::lerp(v[k - 1], v[k], (since - t[k - 1]) / (t[k] - t[k - 1]));
}

namespace {

/// Whether a value leaves rest as a sine does, with its largest slope at once, in a quarter of its wave; a change that begins level takes half of it. Rows from `rest` to
/// the turning point at `turn`, which may lie before it.
bool is_quarter(const std::vector<std::pair<Real, Real>>& rows, std::size_t rest, std::size_t turn)
{
  constexpr Real early = 0.25,
                 least = 0.2;  // of the time and of the change: 0.38 of a sine, 0.25 of a straight line, 0.15 of one that begins level
  const Real at = std::lerp(rows[rest].first, rows[turn].first, early);
  std::size_t k = rest;
  const int step = turn > rest ? 1 : -1;
  while ((rows[k + step].first - at) * step < 0) k += step;
  const auto [t0, v0] = rows[k];
  const auto [t1, v1] = rows[k + step];
  const Real value = t1 == t0 ? v1 : std::lerp(v0, v1, (at - t0) / (t1 - t0));
  return (value - rows[rest].second) / (rows[turn].second - rows[rest].second) > least;
}

/// The rows up to a time, the last one at that time: it goes on at its last velocity.
std::vector<std::pair<Real, Real>> rows_until(const MotionSettings& motion, int axis, Real time)
{
  std::vector<std::pair<Real, Real>> rows;
  for (std::size_t k = 0; k < motion.times.size() && motion.times[k] < time; ++k)
    rows.emplace_back(motion.times[k], motion.velocity[static_cast<std::size_t>(axis)][k]);
  rows.emplace_back(time, velocity_at(motion, axis, time));
  return rows;
}

}  // namespace

MotionMeasures measures_of(const MotionSettings& motion, int axis, Real time)
{
  constexpr Real counts = 0.1;  // of the largest speed
  MotionMeasures found;
  if (motion.velocity[static_cast<std::size_t>(axis)].empty()) return found;
  if (!std::isfinite(time)) time = motion.times.back();
  const std::vector<std::pair<Real, Real>> rows = rows_until(motion, axis, time);
  for (const auto& row : rows) found.speed = std::max(found.speed, std::abs(row.second));
  found.last = rows.back().second;
  if (std::abs(rows.front().second) > counts * found.speed) found.half_wave = 0;
  const auto sign = [](Real x) { return (x > 0) - (x < 0); };
  const auto turns_at = [&](std::size_t k) {
    return k > 0 && k + 1 < rows.size() && sign(rows[k + 1].second - rows[k].second) * sign(rows[k].second - rows[k - 1].second) < 0;
  };
  const auto rests = [&](std::size_t k, int side) {
    const bool at_end = side < 0 ? k == 0 : k + 1 == rows.size();
    return std::abs(rows[k].second) < counts * found.speed && (at_end || rows[k + side].second == rows[k].second);
  };
  std::size_t begin = 0;  // of the rise or fall in hand
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const auto [t0, v0] = rows[k - 1];
    const auto [t1, v1] = rows[k];
    // Within a row that crosses 0 the displacement turns.
    if (v0 * v1 < 0) {
      const Real there = found.residual + 0.5 * v0 * (t1 - t0) * v0 / (v0 - v1);
      found.excursion = std::max(found.excursion, std::abs(there));
    }
    found.residual += 0.5 * (v0 + v1) * (t1 - t0);
    found.excursion = std::max(found.excursion, std::abs(found.residual));
    const bool goes_on = k + 1 < rows.size() && sign(rows[k + 1].second - v1) == sign(v1 - v0);
    if (goes_on) continue;
    const bool quarter =
        (rests(begin, -1) && turns_at(k) && is_quarter(rows, begin, k)) || (rests(k, 1) && turns_at(begin) && is_quarter(rows, k, begin));
    if (std::abs(v1 - rows[begin].second) > counts * found.speed)
      found.half_wave = std::min(found.half_wave, (quarter ? 2 : 1) * (t1 - rows[begin].first));
    begin = k;
  }
  return found;
}

std::string fault_of_row(const std::vector<Real>& times, std::size_t row)
{
  if (row == 0 && times[0] != 0)
    return fmt::format("begins at {:.6g} s: times are measured from the start of each stage, and the first must be 0; give the velocity of "
                       "the boundary from there on",
                       times[0]);
  if (row > 0 && !(times[row] > times[row - 1]))
    return "times must ascend, and none may occur twice: a boundary cannot jump to another velocity";
  return "";
}

std::string fault_of_table(const MotionSettings& motion)
{
  if (motion.times.size() < 2) return "times: needs two times at least, the first 0";
  for (std::size_t row = 0; row < motion.times.size(); ++row)
    if (const std::string fault = fault_of_row(motion.times, row); !fault.empty()) return "times: " + fault;
  bool any = false;
  for (std::size_t k = 0; k < motion.velocity.size(); ++k) {
    if (motion.velocity[k].empty()) continue;
    any = true;
    if (motion.velocity[k].size() != motion.times.size())
      return fmt::format("{}: needs as many velocities as times has times, {}, and has {}", motion_axes[k], motion.times.size(),
                         motion.velocity[k].size());
  }
  return any ? "" : "times: needs velocities at these times: x, y or z";
}

}  // namespace berm::boundary
