// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/run_charts_test.cpp
#include "structures/driven/run_charts.hpp"

#include "plot/figure.hpp"
#include "record/travel_curve.hpp"
#include "structures/driven/displacements.hpp"
#include "structures/driven/uplift.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace berm::driven {
namespace {

/// The way down to the bed does not count: its V = 0 would smooth away the first touch.
base::Curve curve_of(const PushPath& push)
{
  base::Curve curve{"push", push.rows, push.w, push.V, {}, push.w};
  for (Real& w : curve.travel)
    if (w < 0) w = nan;
  return curve;
}

/// The row of a drag at a time since the stage began, which is that of its first row.
Index row_at(const DragPath& drag, const run_folder::History& history, Real time)
{
  const std::vector<Real>& times = history["time_s"];
  const auto is_later = [&](Index row) { return times[row] - times[drag.rows.front()] >= time; };
  const auto found = std::ranges::find_if(drag.rows, is_later);
  return found == drag.rows.end() ? drag.rows.back() : *found;
}

}  // namespace

base::Charts run_charts(const run_folder::History& history, const base::BodyScale& scale, const Stages& stages)
{
  if (history.rows() == 0) return {};
  const Path path = path_of(history, stages);
  const Real half = averaging_half(scale);
  const base::Chart::Axis w{"embedment", "w", "m"}, u{"horizontal displacement since the first drag began", "u", "m"},
      travel{"travel of a drag", "s", "m"}, V{"vertical reaction", "V", scale.dimension == 2 ? "N/m" : "N"},
      H{"horizontal reaction along x", "H", V.unit}, R{"resistance to a drag", "H", V.unit};
  base::Chart u_t{"u_t", {"time", "t", "s"}, {"displacement", "u", "m"}, {}, "Displacement over time"},
      half_cycles{"half_cycles", {"half-cycle", "n", "1"}, {"displacement", "u", "m"}, {}, "Half-cycles"},
      by_drag{"H_s",
              {"displacement of the drag", "s", "m"},
              {"resistance to a drag", "H", scale.dimension == 2 ? "N/m" : "N"},
              {},
              "Each drag: H(s)"};
  base::Chart V_w{"V_w", w, V, {travelled(curve_of(path.push), half)}}, H_u{"H_u", u, H}, w_u{"w_u", u, w}, V_u{"V_u", u, V},
      ratio{"H_over_V_u", u, {"ratio of forces", "H/V", "1"}}, H_travel{"H_travel", travel, R}, V_s{"V_s", {"travel upwards", "s", "m"}, V};
  for (const DragPath& drag : path.drags) {
    const Real begin = drag.u_begin - path.drag().u_begin, direction = drag.stage.direction;
    base::Curve curve{drag.stage.name, drag.rows, {}, {}, {}, drag.travel, begin, direction};
    for (const Real s : drag.travel) curve.x.push_back(begin + direction * s);
    const auto add = [&](base::Chart& chart, std::vector<Real> y) {
      curve.y = std::move(y);
      chart.curves.push_back(travelled(curve, half));
    };
    if (drag.stage.varies) {
      base::Curve in_time{drag.stage.name, drag.rows, {}, plot::scaled(drag.travel, direction)}, by_number{drag.stage.name};
      for (const Index row : drag.rows) in_time.x.push_back(history["time_s"][row]);
      for (const HalfCycle& c : half_cycles_of(drag, history, scale.width)) {
        by_number.rows.push_back(row_at(drag, history, c.end_s));
        by_number.x.push_back(static_cast<Real>(by_number.x.size()) + 1);
        by_number.y.push_back(std::abs(c.u_end - c.u_begin));
      }
      u_t.curves.push_back(std::move(in_time));
      if (by_number.x.size() > 1) half_cycles.curves.push_back(std::move(by_number));
    }
    std::vector<Real> H_over_V;
    for (std::size_t k = 0; k < drag.H.size(); ++k) H_over_V.push_back(direction * drag.H[k] / drag.V[k]);
    add(H_u, plot::scaled(drag.H, direction));
    add(w_u, drag.w);
    add(V_u, drag.V);
    add(ratio, std::move(H_over_V));
    by_drag.curves.push_back(travelled(base::Curve{drag.stage.name, drag.rows, drag.travel, drag.H, {}, drag.travel}, half));
    if (const record::TravelCurve rows(drag.travel, drag.H); !rows.empty()) {
      const record::TravelCurve smooth = rows.smoothed(half);
      H_travel.curves.push_back({drag.stage.name, {}, smooth.travel(), smooth.value()});
    }
  }
  for (const OtherPush& push : path.other_pushes) {
    if (!push.upwards || push.rows.empty()) continue;
    const LiftPath lift = lift_path(push, history);
    V_s.curves.push_back(base::travelled({push.stage, lift.rows, lift.travel, plot::scaled(lift.R, -1), {}, lift.travel}, half));
  }
  base::Charts charts{V_w, H_u, w_u, V_u, ratio, H_travel, V_s};
  if (by_drag.curves.size() < 2 || !u_t.curves.empty()) by_drag.curves.clear();
  for (base::Chart& chart : std::array{std::move(u_t), std::move(half_cycles), std::move(by_drag)})
    if (!chart.curves.empty()) charts.push_back(std::move(chart));
  return charts;
}

}  // namespace berm::driven
