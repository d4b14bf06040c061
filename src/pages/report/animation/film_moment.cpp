// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_moment.hpp"

#include <algorithm>

namespace berm::report {
namespace {

/// A column at a time, on the straight line between the rows around it; `after` is the first row that is not before that time.
Real between_rows(const std::vector<Real>& times, const std::vector<Real>& column, std::size_t after, Real time)
{
  if (after == 0) return column.front();
  if (after == times.size()) return column.back();
  const Real begin = times[after - 1], end = times[after];
  return column[after - 1] + (column[after] - column[after - 1]) * (time - begin) / (end - begin);
}

std::size_t first_row_from(const std::vector<Real>& times, Real time)
{
  return static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
}

}  // namespace

FilmMoment moment_at(const run_folder::History& history, Real time)
{
  FilmMoment moment;
  if (history.rows() == 0 || !history.has("time_s")) return moment;
  const std::vector<Real>& times = history["time_s"];
  const std::size_t after = first_row_from(times, time);
  std::size_t nearest = std::min(after, times.size() - 1);
  if (nearest > 0 && time - times[nearest - 1] <= std::abs(times[nearest] - time)) --nearest;
  moment.stage = history.stage[nearest];
  if (history.has("u_m")) moment.u = between_rows(times, history["u_m"], after, time);
  if (history.has("w_m")) moment.w = between_rows(times, history["w_m"], after, time);
  if (history.has_label("H")) moment.H = history.by_label("H")[nearest];
  if (history.has_label("V")) moment.V = history.by_label("V")[nearest];
  return moment;
}

Real way_between(const run_folder::History& history, Real from, Real to)
{
  if (history.rows() == 0 || !history.has("time_s") || !history.has("u_m") || !history.has("w_m")) return nan;
  const std::vector<Real>&times = history["time_s"], &u = history["u_m"], &w = history["w_m"];
  const FilmMoment begin = moment_at(history, from), end = moment_at(history, to);
  Real way = 0, u_before = begin.u, w_before = begin.w;
  const auto go_to = [&](Real u_now, Real w_now) {
    way += std::hypot(u_now - u_before, w_now - w_before);
    u_before = u_now;
    w_before = w_now;
  };
  for (std::size_t row = first_row_from(times, from); row < times.size() && times[row] < to; ++row) go_to(u[row], w[row]);
  go_to(end.u, end.w);
  return way;
}

}  // namespace berm::report
