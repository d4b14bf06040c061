// SPDX-License-Identifier: BSD-3-Clause
#include "report/run_points.hpp"

#include <charconv>
#include <string_view>

namespace berm {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
constexpr Real wished_beyond = 0.01;  // of D

/// The 0.1 of "V_at_w_0.1D" after "V_at_w_"; nothing where the name is another.
std::optional<Real> part_of_D(std::string_view name, std::string_view begin)
{
  if (!name.starts_with(begin) || !name.ends_with("D")) return std::nullopt;
  name.remove_prefix(begin.size());
  name.remove_suffix(1);
  Real part = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), part);
  if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
  return part;
}

Real value_of(const RunRecord& run, const std::string& name)
{
  const Quantity* q = run.quantity(name);
  return q == nullptr ? nan : q->value;
}

}  // namespace

RunPoints points_of(const RunRecord& run)
{
  RunPoints points;
  const Real D = run.scale.diameter;
  points.first_w = run.history.rows() > 0 && run.history.has("w_m") ? run.history["w_m"].front() : nan;
  for (const Quantity& q : run.quantities) {
    if (const auto part = part_of_D(q.name, "V_at_w_")) points.push.push_back({*part * D, q.value});
    if (const auto part = part_of_D(q.name, "H_at_u_")) {
      const std::string at = q.name.substr(1);
      points.drag.push_back({*part * D, value_of(run, "w" + at), q.value, q.value / value_of(run, "H_over_V" + at)});
    }
  }
  if (run.quantity("V_end_of_push") != nullptr) points.push_end = PushPoint{value_of(run, "w_end_of_push"), value_of(run, "V_end_of_push")};
  if (run.quantity("H_max") != nullptr) points.largest_H = DragPoint{value_of(run, "u_at_H_max"), nan, value_of(run, "H_max"), nan};
  return points;
}

bool is_wished_in_place(const RunRecord& run)
{
  return points_of(run).first_w > wished_beyond * run.scale.diameter;
}

}  // namespace berm
