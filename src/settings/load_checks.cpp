// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/load_history_test.cpp
#include "settings/load_checks.hpp"

#include "bodies/rigid/shape.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {
namespace {

bool is_turn(LoadAlong along)
{
  return along == LoadAlong::rotation || along == LoadAlong::rotation_x || along == LoadAlong::rotation_y || along == LoadAlong::rotation_z;
}

/// Whether the stage's other keys drive the freedom of a column.
bool is_driven_otherwise(const StageSettings& s, const LoadColumn& column)
{
  const auto shift = [&](const FreedomSettings& f) {
    return f.velocity || f.force || f.hold || f.free || (f.spring && column.quantity != LoadQuantity::force);
  };
  const auto turn = [&](const TurnSettings& f) {
    return f.velocity || f.moment || f.fixed || f.free || (f.spring && column.quantity != LoadQuantity::force);
  };
  switch (column.along) {
  case LoadAlong::horizontal:
    return s.velocity || s.force;
  case LoadAlong::downwards:
    return s.kind == StageKind::push ? s.velocity || s.force : s.vertical_force || s.vertical_velocity || s.vertical == Vertical::fixed;
  case LoadAlong::x:
    return shift(s.drive.x);
  case LoadAlong::y:
    return shift(s.drive.y);
  case LoadAlong::z:
    return shift(s.drive.z);
  case LoadAlong::rotation:
    return turn(s.drive.rotation);
  case LoadAlong::rotation_x:
    return turn(s.drive.rotation_x);
  case LoadAlong::rotation_y:
    return turn(s.drive.rotation_y);
  case LoadAlong::rotation_z:
    return turn(s.drive.rotation_z);
  case LoadAlong::water:
    return s.velocity || s.force || s.vertical_force || s.vertical_velocity || s.vertical == Vertical::fixed;
  case LoadAlong::temperature:
  case LoadAlong::far_temperature:
  case LoadAlong::pressure:
  case LoadAlong::weight:
  case LoadAlong::lateral:
  case LoadAlong::pull:
    break;  // no other key goes with them (check_pipeline)
  }
  return false;
}

std::string fault_of_times(const StageSettings& s)
{
  const std::vector<Real>& t = s.load_times;
  if (s.loads.empty() && t.size() != s.load_factors.size()) return "load_times: needs as many times as load_factors has factors";
  if (t.empty() || t.front() < 0 || !(t.back() > 0))
    return "load_times: are measured from the start of the stage: the first must be 0 or more, the last more than 0";
  return "";
}

std::string fault_of_rows(const Case& c, const StageSettings& s)
{
  for (std::size_t row = 0; row < s.load_times.size(); ++row)
    if (const std::optional<RowFault> fault = fault_of_row(s, row)) return fault->key + ": " + fault->message;
  if (c.method == Method::fem && std::adjacent_find(s.load_times.begin(), s.load_times.end()) != s.load_times.end())
    return "load_times: the same time twice is a jump, and the finite element method goes from one equilibrium to the next: spread the "
           "change over some time";
  return "";
}

constexpr Real round_off = 1e-9;  // of the largest displacement of a column

Real largest_of(const std::vector<Real>& values)
{
  Real largest = 0;
  for (const Real value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

std::string fault_of_repeat(const StageSettings& s)
{
  constexpr Real most = 1e6;  // rows
  if (s.load_repeat == 1) return "";
  if (const Real rows = static_cast<Real>(s.load_times.size()) * s.load_repeat; rows > most)
    return fmt::format("load_repeat: makes {:.0f} rows of the load history, of which there may be {:.0f}", rows, most);
  for (std::size_t k = 0; k < load_columns.size(); ++k) {
    const std::vector<Real>& column = s.loads.columns[k];
    if (load_columns[k].quantity != LoadQuantity::displacement || column.empty()) continue;
    if (std::abs(column.back()) > round_off * largest_of(column))
      return fmt::format("load_repeat: {} ends at {:.6g} {} and begins again at 0, where the body cannot jump: add a row in which it is "
                         "back at 0, or write the repetitions one after the other with continuous displacement",
                         load_columns[k].key, column.back(), load_columns[k].unit);
  }
  return "";
}

/// A ramp is of what goes from one value to another; a body that follows a displacement has none.
std::string fault_of_ramp(const StageSettings& s)
{
  if (s.ramp == 0 || s.velocity || s.force || s.vertical_force || s.vertical_velocity) return "";
  if (s.kind == StageKind::pipeline) return "ramp: is not for loads of the line that a load history has: its rows give them";
  const DriveSettings& drive = s.drive;
  for (const FreedomSettings* f : {&drive.x, &drive.y, &drive.z})
    if (f->velocity || f->force) return "";
  for (const TurnSettings* f : {&drive.rotation, &drive.rotation_x, &drive.rotation_y, &drive.rotation_z})
    if (f->velocity || f->moment) return "";
  bool follows = false;
  for (std::size_t k = 0; k < load_columns.size(); ++k) {
    if (s.loads.columns[k].empty()) continue;
    if (load_columns[k].quantity != LoadQuantity::displacement) return "";
    follows = true;
  }
  return follows ? "ramp: is not for displacements, which the body follows exactly: leave it out, and start the rows smoothly" : "";
}

/// A force needs a mass to move, a moment what it turns.
std::string fault_of_inertia(const Case& c, const StageSettings& s, const LoadColumn& column)
{
  for (const auto& [name, rigid] : c.rigid) {
    if ((column.quantity != LoadQuantity::force && column.quantity != LoadQuantity::water) || (!s.rigid.empty() && name != s.rigid))
      continue;
    if (!(rigid.mass > 0) && !(is_turn(column.along) && rigid.moment_of_inertia))
      return fmt::format(": column {} of its load history {} [rigid.{}], which therefore needs a mass{}", column.name,
                         is_turn(column.along) ? "turns" : "moves", name, is_turn(column.along) ? " or a moment_of_inertia" : "");
  }
  return "";
}

std::string fault_of_column(const Case& c, const StageSettings& s, std::size_t k)
{
  const LoadColumn& column = load_columns[k];
  const std::string key = fmt::format("loads.{}: ", column.key);
  const std::vector<std::size_t> allowed = columns_for(c, s);
  if (std::find(allowed.begin(), allowed.end(), k) == allowed.end()) {
    std::string words;
    for (const std::size_t other : allowed) words += (words.empty() ? "" : ", ") + std::string(load_columns[other].key);
    return key + fmt::format("drives nothing in this stage (allowed: {})", words);
  }
  if (s.loads.columns[k].size() != s.load_times.size()) return key + "needs as many values as load_times has times";
  for (std::size_t other = k + 1; other < load_columns.size(); ++other)
    if (is_driven_by(column.along, load_columns[other].along) && !s.loads.columns[other].empty())
      return key + fmt::format("cannot be combined with {}: a degree of freedom is driven in one way only", load_columns[other].key);
  if (is_driven_otherwise(s, column)) return key + "drives what another key of the stage drives: leave one of them out";
  if (column.quantity == LoadQuantity::water && !s.water) return key + "needs [stage.water], with the coefficients of its forces";
  if (c.method == Method::fem && column.quantity != LoadQuantity::force && column.quantity != LoadQuantity::water)
    return key + "the finite element method has no time: it takes a load history of forces or of water, not of velocities or displacements";
  return fault_of_inertia(c, s, column);
}

/// The pipe moves with and against the water: neither its time nor its shape can be another.
std::string fault_of_water(const Case& c, const StageSettings& s)
{
  constexpr Real flat = 5 * degree * (1 - 1e-9);
  if (!s.water) return "";
  if (s.loads.of("water").empty()) return "water: is for a load history with the velocity of water: time_s,water_m_s";
  if (s.time_scale != 1) return "time_scale: must be 1 with [stage.water]: the forces depend on the velocity of the pipe in real time";
  for (const auto& [name, rigid] : c.rigid)
    if ((s.rigid.empty() || name == s.rigid) && !bodies::pipe_section(rigid.shape))
      return fmt::format("water: is for a circular pipe, and [rigid.{}] is none", name);
  if (s.water->trench_depth > 0 && !(s.water->trench_angle >= flat)) return "water.trench_angle: of a trench is from 5 to 45 deg";
  return "";
}

}  // namespace

std::optional<RowFault> fault_of_row(const StageSettings& s, std::size_t row)
{
  const std::vector<Real>& t = s.load_times;
  const auto of_times = [](std::string why) { return RowFault{"load_times", std::move(why)}; };
  if (t[row] < 0) return of_times("times are measured from the start of the stage: 0 or more");
  if (row > 0 && t[row] < t[row - 1]) return of_times("times must ascend");
  const bool jump = row > 0 && t[row] == t[row - 1];
  if (jump && row > 1 && t[row] == t[row - 2])
    return of_times(fmt::format("the time {:.6g} s occurs three times: twice is a jump, from the first value to the second", t[row]));
  for (std::size_t k = 0; k < load_columns.size(); ++k) {
    const std::vector<Real>& column = s.loads.columns[k];
    if (row >= column.size()) continue;
    const std::string key = fmt::format("loads.{}", load_columns[k].key);
    if (load_columns[k].along == LoadAlong::weight && !(column[row] > 0))
      return RowFault{key, fmt::format("weight is {:.6g} N/m at {:.6g} s: it must be more than 0", column[row], t[row])};
    if (load_columns[k].quantity != LoadQuantity::displacement) continue;
    if (row == 0 && (t[0] != 0 || column[0] != 0))
      return RowFault{
          key, fmt::format("{} is the displacement since the start of the stage: its first row must be 0 at the time 0, and is {:.6g} {} "
                           "at {:.6g} s; take its first value from all",
                           load_columns[k].name, column[0], load_columns[k].unit, t[0])};
    if (jump && column[row] != column[row - 1] && std::abs(column[row] - column[row - 1]) > round_off * largest_of(column))
      return RowFault{key, fmt::format("{} jumps from {:.6g} to {:.6g} {} at {:.6g} s: a body cannot jump; give it time to get there",
                                       load_columns[k].name, column[row - 1], column[row], load_columns[k].unit, t[row])};
  }
  return {};
}

std::vector<std::size_t> columns_for(const Case& c, const StageSettings& stage)
{
  const bool space = c.dimension() == 3, around_axis = c.geometry == Geometry::axisymmetric;
  const auto mirrored = [&](const char* axis) { return std::find(c.symmetry.begin(), c.symmetry.end(), axis) != c.symmetry.end(); };
  const auto goes = [&](LoadAlong along) {
    const bool drive = stage.kind == StageKind::drive, line = stage.kind == StageKind::pipeline;
    switch (along) {
    case LoadAlong::horizontal:
      return stage.kind == StageKind::drag;
    case LoadAlong::downwards:
      return stage.kind == StageKind::drag || stage.kind == StageKind::push;
    case LoadAlong::x:
      return drive && !around_axis && !mirrored("x");
    case LoadAlong::y:
      return drive;
    case LoadAlong::z:
      return drive && space && !mirrored("z");
    case LoadAlong::rotation:
      return drive && !space && !around_axis;
    case LoadAlong::rotation_x:
      return drive && space && !mirrored("z");
    case LoadAlong::rotation_y:
      return drive && space && !mirrored("x") && !mirrored("z");
    case LoadAlong::rotation_z:
      return drive && space && !mirrored("x");
    case LoadAlong::water:
      return stage.kind == StageKind::drag && c.geometry == Geometry::plane_strain;
    case LoadAlong::temperature:
    case LoadAlong::far_temperature:
      return line && (!c.pipeline || c.pipeline->expansion > 0);
    case LoadAlong::pressure:
      return line && (!c.pipeline || c.pipeline->wall);
    case LoadAlong::weight:
    case LoadAlong::lateral:
      return line;
    case LoadAlong::pull:
      return line && (!c.pipeline || c.pipeline->end != LineEnd::anchored);
    }
    return false;
  };
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < load_columns.size(); ++k)
    if (goes(load_columns[k].along)) found.push_back(k);
  return found;
}

std::string fault_of_loads(const Case& c, const StageSettings& s)
{
  if (s.load_times.empty() && s.load_factors.empty() && s.loads.empty()) return "";
  if (const std::string fault = fault_of_times(s); !fault.empty()) return fault;
  if (!s.loads.empty() && !s.load_factors.empty()) return "load_factors: cannot be combined with loads, which are not factors";
  if (const std::string fault = fault_of_water(c, s); !fault.empty()) return fault;
  if (s.loads.empty() && (s.kind == StageKind::drive || s.kind == StageKind::pipeline))
    return fmt::format("load_factors: multiply what a push or a drag drives; a {} has a load history with columns, such as {}",
                       s.kind == StageKind::drive ? "drive" : "stage of kind pipeline",
                       s.kind == StageKind::drive ? "time_s,x_N_m" : "time_s,temperature_K");
  for (std::size_t k = 0; k < load_columns.size(); ++k)
    if (!s.loads.columns[k].empty())
      if (const std::string fault = fault_of_column(c, s, k); !fault.empty()) return fault;
  for (const std::string& fault : {fault_of_rows(c, s), fault_of_repeat(s), fault_of_ramp(s)})
    if (!fault.empty()) return fault;
  const bool short_form = s.kind == StageKind::push || s.kind == StageKind::drag;
  const LoadAlong main = s.kind == StageKind::push ? LoadAlong::downwards : LoadAlong::horizontal;
  const bool by_column = s.loads.drives(main);
  if (short_form && !by_column && s.velocity.has_value() == s.force.has_value())
    return s.loads.empty() ? ": needs either velocity or force, and not both"
                           : fmt::format(": needs either velocity, force or a column {} of its load history, and not two of them",
                                         s.kind == StageKind::push ? "V or w" : "H or u");
  if (c.method == Method::fem && s.velocity)
    return "velocity: the finite element method has no time: it takes a load history of forces, not of velocities or displacements";
  return "";
}

}  // namespace berm::settings
