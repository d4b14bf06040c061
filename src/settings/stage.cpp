// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/stages_test.cpp
#include "settings/stage.hpp"

#include "core/usual.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::settings {

void describe(Describe& d, FreedomSettings& freedom)
{
  d.value("velocity", freedom.velocity, {.meaning = "velocity along the axis", .unit = "m/s"});
  d.value("force", freedom.force, {.meaning = "force on the body along the axis, instead of a velocity", .unit = "N/m"});
  d.value("hold", freedom.hold, {.meaning = "hold the force that balances the soil at the start of the stage"});
  d.value("free", freedom.free, {.meaning = "free: moved only by its contacts and a spring"});
  d.value("spring", freedom.spring,
          {.meaning = "stiffness of a spring to the position of the body at the start of the stage, alone or with force or hold",
           .unit = "N/m^2",
           .range = positive});
}

void describe(Describe& d, TurnSettings& turn)
{
  d.value("velocity", turn.velocity, {.meaning = "angular velocity, counter-clockwise seen from the end of the axis", .unit = "rad/s"});
  d.value("moment", turn.moment, {.meaning = "moment on the body, instead of a velocity", .unit = "N"});
  d.value("fixed", turn.fixed, {.meaning = "does not rotate, whatever [rigid.NAME] says"});
  d.value("free", turn.free, {.meaning = "free: rotated only by its contacts and a spring, whatever [rigid.NAME] says"});
  d.value("spring", turn.spring,
          {.meaning = "stiffness of a spring to the orientation of the body at the start of the stage, alone or with a moment",
           .unit = "N/rad",
           .range = positive});
}

void describe(Describe& d, DriveSettings& drive)
{
  d.table("x", drive.x, {.meaning = "displacement along x"});
  d.table("y", drive.y, {.meaning = "displacement along y"});
  d.table("z", drive.z, {.meaning = "displacement along z, in space"});
  d.table("rotation", drive.rotation, {.meaning = "rotation in the plane"});
  d.table("rotation_x", drive.rotation_x, {.meaning = "rotation about x, in space"});
  d.table("rotation_y", drive.rotation_y, {.meaning = "rotation about y, in space"});
  d.table("rotation_z", drive.rotation_z, {.meaning = "rotation about z, in space"});
  d.value("point", drive.point,
          {.meaning = "point at which x, y and z act and until.displacement is measured: it moves with the body and is given by its "
                      "position before the first stage; absent = its centre",
           .unit = "m"});
}

void describe(Describe& d, Until& until)
{
  d.value("time", until.time, {.meaning = "time since the start of the stage", .unit = "s", .range = not_negative});
  d.value("real_time", until.real_time,
          {.meaning = "for a stage at rest in soil whose water flows: time in reality, such as \"30 days\"; the run takes "
                      "real_permeability / permeability times that",
           .unit = "s",
           .range = positive});
  d.value(
      "displacement", until.displacement,
      {.meaning = "horizontal travel of the rigid body in this stage; in a stage of kind drive its distance from the start of the stage",
       .unit = "m",
       .range = positive});
  d.value("embedment", until.embedment,
          {.meaning = "depth of the rigid body's lowest point below the surface, w; a lift ends where w has fallen to it", .unit = "m"});
  d.value("force", until.force,
          {.meaning =
               "soil reaction: V in a push, H in a drag. A drive by velocity slows down near it. In a push upwards V falls to it; less "
               "than 0: the soil holds the body down",
           .unit = "N/m"});
  d.value("consolidation", until.consolidation,
          {.meaning =
               "degree of consolidation U where water flows: 1 - the largest excess pore pressure in the soil now, divided by the largest "
               "in this stage, both without waves (means over 8 H/c of the soil's height H and the speed c of waves)",
           .range = {0.01, 0.999}});
  d.value("equilibrium", until.equilibrium,
          {.meaning =
               "geostatic: the soil is in equilibrium and at rest, within `equilibrium` of the stage; for a geostatic stage without "
               "another limit it is true. `time` is then the longest that it may take; left out: as long as waves and damping need"});
  declare_usual(d, {{"real_time", {1, 1e10}}});
}

void describe(Describe& d, PipelineLoads& loads)
{
  d.value("temperature", loads.temperature, {.meaning = "rise of temperature since the line was laid", .unit = "K"});
  d.value("far_temperature", loads.far_temperature,
          {.meaning = "the same at the far end of the line, linear between; left out: as at x = 0", .unit = "K"});
  d.value("pressure", loads.pressure, {.meaning = "rise of internal pressure since the line was laid", .unit = "Pa"});
  d.value("weight", loads.weight, {.meaning = "submerged weight", .unit = "N/m", .range = positive});
  d.value("lateral", loads.lateral, {.meaning = "lateral load, along x of the slices, such as that of a current", .unit = "N/m"});
  d.value("pull", loads.pull, {.meaning = "effective tension at the far end, where it is not anchored", .unit = "N"});
  declare_usual(d, {{"temperature", {0, 250}},
                    {"far_temperature", {0, 250}},
                    {"pressure", {1e4, 2e8}},
                    {"weight", {10, 5e4}},
                    {"lateral", {0.1, 5e4}},
                    {"pull", {100, 2e7}}});
}

void describe(Describe& d, StageSettings& stage)
{
  d.value("name", stage.name, {.meaning = "name of the stage, for the history and for --set", .required = true});
  d.choice("kind", stage.kind, {"geostatic", "push", "drag", "free", "drive", "sweep", "pipeline"},
           {.meaning = "find equilibrium; push down; drag sideways; let time pass; drive each degree of freedom as given in [stage.drive]; "
                       "drag out and back, several times; or load the [pipeline], which drives its slices",
            .required = true});
  d.choice(
      "role", stage.role, {"automatic", "touchdown", "lay", "flooded", "emptied", "operation", "breakout", "sweep"},
      {.meaning =
           "role of the stage in the life of a pipe: its results and springs are those of the state at the end of such a stage (touchdown, "
           "laid, "
           "flooded, emptied, operation), its breakout that of this drag; automatic infers touchdown, lay and operation from the stages"});
  d.value("rigid", stage.rigid, {.meaning = "rigid body that is driven; may be left out where there is only one"});
  d.value("velocity", stage.velocity, {.meaning = "speed of the drive: down in a push, along x in a drag", .unit = "m/s"});
  d.value("force", stage.force, {.meaning = "force of the drive, instead of a velocity", .unit = "N/m"});
  d.choice("vertical", stage.vertical, {"hold", "fixed"},
           {.meaning = "in a drag: hold the vertical force at the start of the stage (after a push by velocity the reaction of the soil), "
                       "or fix the vertical position"});
  d.value("vertical_force", stage.vertical_force, {.meaning = "in a drag: downward force, instead of the one held", .unit = "N/m"});
  d.value("vertical_velocity", stage.vertical_velocity,
          {.meaning = "in a drag: downward speed, instead of holding a force; less than 0 = upwards", .unit = "m/s"});
  d.value("ramp", stage.ramp,
          {.meaning = "time over which the drive changes from its previous value to its new one; directions that a push or a drive does "
                      "not name stop at once",
           .unit = "s",
           .range = not_negative});
  d.table("drive", stage.drive,
          {.meaning = "degrees of freedom of the driven body, in a stage of kind drive; what is left out is fixed. Its rotations also in a "
                      "push or a drag"});
  d.table("pipeline", stage.pipeline,
          {.meaning = "in a stage of kind pipeline: the loads of the line after the ramp; those left out do not change"});
  d.value(
      "repeat", stage.repeat,
      {.meaning = "how often the stages from `repeat_from` to this one run, one after the other; later ones are called NAME_2, NAME_3, ...",
       .range = {1, 1000}});
  d.value("repeat_from", stage.repeat_from, {.meaning = "the first of the stages that are repeated; left out: this one"});
  d.value("amplitude", stage.amplitude, {.meaning = "in a sweep: travel of each drag, out and back", .unit = "m", .range = positive});
  d.value("sweeps", stage.sweeps, {.meaning = "in a sweep: number of drags; two make a cycle", .range = {0, 10000}});
  d.value("pause", stage.pause,
          {.meaning = "in a sweep: time between two drags, with the vertical force held", .unit = "s", .range = not_negative});
  d.value(
      "load_history", stage.load_history,
      {.meaning =
           "CSV file, relative to the case file, of the time since the start of the stage and, in a push or a drag, the factor of velocity "
           "or force; or of forces, velocities and displacements that vary together, which its header names: time_s,H_N_m,V_N_m; in a "
           "stage of kind pipeline of the loads of the line: time_s,temperature_K,pressure_Pa"});
  d.value("load_times", stage.load_times,
          {.meaning = "instead of a file: the times, ascending; the same time twice is a jump from the first value to the second",
           .unit = "s"});
  d.value("load_factors", stage.load_factors, {.meaning = "the factors at these times"});
  d.optional_table(
      "loads", stage.loads,
      {.meaning =
           "instead of factors: forces, velocities and displacements at these times, which drive the degrees of freedom that they name"});
  d.optional_table("water", stage.water,
                   {.meaning = "forces on the pipe of a drag by the velocity of the water that its load history has: by Morison's "
                               "equation, with the present velocity and embedment of the pipe"});
  d.value("load_repeat", stage.load_repeat,
          {.meaning = "number of times the load history runs, one after the other; displacements must end where they started",
           .range = {1, 1e6}});
  d.value("time_scale", stage.time_scale,
          {.meaning = "time of the run divided by that of the load history, forces and travels unchanged; automatic: the smallest at which "
                      "inertia is small, 1 at most",
           .range = positive,
           .words = {{"automatic", automatic_time_scale}}});
  d.value(
      "strength_recovery", stage.strength_recovery,
      {.meaning =
           "fraction of the strength lost by remoulding that clay has regained at the start of the stage, by consolidation or thixotropy "
           "in a pause before it; of a sweep: in each of its pauses",
       .range = {0, 1}});
  d.value("damping", stage.damping,
          {.meaning = "local damping of all bodies in this stage, instead of their own; 0.7 is recommended for a geostatic stage",
           .range = {0, 1}});
  d.value("zero_displacements", stage.zero_displacements,
          {.meaning =
               "displacements are measured from the start of this stage: of watched points, soil bodies, loaded boundaries and the fields "
               "of frames, with "
               "the strains of displacement; rigid bodies get columns of their own for it, since_u_m and since_w_m"});
  d.table("until", stage.until, {.meaning = "the stage ends at the first of these that is reached"});
  d.value("equilibrium", stage.equilibrium,
          {.meaning =
               "geostatic: largest out-of-balance force, divided by the weight, that counts as equilibrium; the same limit applies to the "
               "motion of the soil",
           .range = positive});
}

std::string displacements_since(const std::vector<StageSettings>& stages)
{
  std::string names;
  int count = 0;
  for (const StageSettings& stage : stages)
    if (stage.zero_displacements) names += fmt::format("{}\"{}\"", count++ > 0 ? ", " : "", stage.name);
  if (count == 0) return "";
  return count == 1 ? fmt::format("since stage {} began", names) : fmt::format("since the last of the stages {} began", names);
}

namespace {

Real max_size(const std::vector<Real>& values)
{
  Real max = 0;
  for (const Real value : values) max = std::max(max, std::abs(value));
  return max;
}

/// Of values at the stage's load_times: the value at a time, and its slope over the record's time.
struct AlongRecord {
  Real value, slope;
};
AlongRecord along_record(const StageSettings& stage, const std::vector<Real>& values, Real since)
{
  const std::vector<Real>& t = stage.load_times;
  const Real time = since / stage.time_scale;
  const auto after = std::upper_bound(t.begin(), t.end(), time);
  if (after == t.begin()) return {values.front(), 0};
  if (after == t.end()) return {values.back(), 0};
  const std::size_t k = after - t.begin();
  return {std::lerp(values[k - 1], values[k], (time - t[k - 1]) / (t[k] - t[k - 1])), (values[k] - values[k - 1]) / (t[k] - t[k - 1])};
}

/// The largest speed of values at the stage's load_times, by size: that of the steepest row; a jump has none.
Real steepest(const StageSettings& stage, const std::vector<Real>& values)
{
  const std::vector<Real>& t = stage.load_times;
  Real max = 0;
  for (std::size_t k = 1; k < values.size(); ++k)
    if (t[k] > t[k - 1]) max = std::max(max, std::abs(values[k] - values[k - 1]) / (t[k] - t[k - 1]));
  return max;
}

/// What a factor is divided by: a velocity keeps its travel while the time is scaled.
Real slower(const StageSettings& stage)
{
  return stage.velocity ? stage.time_scale : 1;
}

/// The speed along a freedom of a drive.
Real speed_along(const StageSettings& stage, const std::optional<Real>& velocity, LoadAlong along)
{
  Real speed = velocity.value_or(0);
  for (std::size_t k = 0; k < load_columns.size(); ++k)
    if (load_columns[k].along == along && load_columns[k].quantity != LoadQuantity::force) speed += max_load(stage, k);
  return speed;
}

/// Whether all values of the load history are the same in two of its rows.
bool same_values(const StageSettings& stage, std::size_t row, std::size_t other)
{
  const auto same = [&](const std::vector<Real>& values) { return values.empty() || values[row] == values[other]; };
  return same(stage.load_factors) && std::all_of(stage.loads.columns.begin(), stage.loads.columns.end(), same);
}

}  // namespace

Real max_load_factor(const StageSettings& stage)
{
  return stage.load_factors.empty() ? 1 : max_size(stage.load_factors) / slower(stage);
}

Real max_load(const StageSettings& stage, std::size_t k)
{
  const std::vector<Real>& values = stage.loads.columns[k];
  switch (load_columns[k].quantity) {
  case LoadQuantity::force:
  case LoadQuantity::water:
  case LoadQuantity::of_line:
    return max_size(values);
  case LoadQuantity::velocity:
    return max_size(values) / stage.time_scale;
  case LoadQuantity::displacement:
    return steepest(stage, values) / stage.time_scale;
  }
  return 0;
}

Real speed_of(const StageSettings& stage)
{
  if (stage.loads.empty()) {
    if (stage.kind != StageKind::drive)
      return std::hypot(stage.velocity.value_or(0) * max_load_factor(stage), stage.vertical_velocity.value_or(0));
    return std::hypot(stage.drive.x.velocity.value_or(0), stage.drive.y.velocity.value_or(0), stage.drive.z.velocity.value_or(0));
  }
  if (stage.kind != StageKind::drive)
    return std::hypot(speed_along(stage, stage.velocity, LoadAlong::horizontal),
                      speed_along(stage, stage.vertical_velocity, LoadAlong::downwards));
  return std::hypot(speed_along(stage, stage.drive.x.velocity, LoadAlong::x), speed_along(stage, stage.drive.y.velocity, LoadAlong::y),
                    speed_along(stage, stage.drive.z.velocity, LoadAlong::z));
}

Real load_factor(const StageSettings& stage, Real since)
{
  return stage.load_factors.empty() ? 1 : along_record(stage, stage.load_factors, since).value / slower(stage);
}

Real load_of_column(const StageSettings& stage, std::size_t k, Real since)
{
  const Real value = along_record(stage, stage.loads.columns[k], since).value;
  return load_columns[k].quantity == LoadQuantity::velocity ? value / stage.time_scale : value;
}

WaterMotion water_at(const StageSettings& stage, Real since)
{
  const AlongRecord water = along_record(stage, stage.loads.of("water"), since);
  return {water.value, water.slope};
}

void repeat_load_history(StageSettings& stage)
{
  struct Row {
    Real time;
    std::size_t of_record;
  };
  const std::vector<Real> record = std::move(stage.load_times);
  for (std::size_t k = 0; k < load_columns.size(); ++k)
    if (load_columns[k].quantity == LoadQuantity::displacement)  // back to round-off is back
      for (std::size_t row = stage.loads.columns[k].size(); row-- > 0 && record[row] == record.back();) stage.loads.columns[k][row] = 0;
  std::vector<Row> rows;
  const auto add = [&](Real time, std::size_t row) {
    const std::size_t count = rows.size();
    if (count > 0 && rows.back().time == time && same_values(stage, rows.back().of_record, row)) return;
    if (count > 1 && rows[count - 2].time == time) rows.pop_back();  // between two values at one time none counts
    rows.push_back({time, row});
  };
  for (int run = 0; run < stage.load_repeat; ++run) {
    const Real begin = run * record.back(), end = (run + 1) * record.back();
    if (run > 0 && record.front() > 0) add(begin, 0);
    for (std::size_t row = 0; row < record.size(); ++row) add(record[row] == record.back() ? end : std::min(begin + record[row], end), row);
  }
  const auto write = [&](std::vector<Real>& values) {
    if (values.empty()) return;
    const std::vector<Real> once = std::move(values);
    values.clear();
    for (const Row& row : rows) values.push_back(once[row.of_record]);
  };
  stage.load_times.clear();
  for (const Row& row : rows) stage.load_times.push_back(row.time);
  write(stage.load_factors);
  for (std::vector<Real>& column : stage.loads.columns) write(column);
  stage.load_repeat = 1;
}

Real drag_direction(const StageSettings& stage)
{
  return stage.kind == StageKind::drag && stage.velocity.value_or(stage.force.value_or(0)) < 0 ? -1 : 1;
}

Real expected_time(const StageSettings& stage)
{
  if (stage.kind == StageKind::sweep && stage.velocity && *stage.velocity != 0 && stage.amplitude)
    return stage.sweeps * (*stage.amplitude / std::abs(*stage.velocity) + stage.ramp / 2) + (stage.sweeps - 1) * stage.pause;
  Real min = stage.until.time.value_or(infinity);
  if (!stage.load_times.empty()) return min < infinity ? min : 0;
  const bool lifted = stage.kind == StageKind::push && stage.velocity.value_or(0) < 0;  // from an embedment that it does not say
  if (stage.velocity && *stage.velocity != 0) {
    const Real speed = std::abs(*stage.velocity);
    if (stage.kind == StageKind::drag && stage.until.displacement) min = std::min(min, *stage.until.displacement / speed + stage.ramp / 2);
    if (stage.kind == StageKind::push && stage.until.embedment && !lifted)
      min = std::min(min, *stage.until.embedment / speed + stage.ramp / 2);
  }
  if (stage.kind == StageKind::drive && stage.until.displacement) {
    const Real speed =
        std::hypot(stage.drive.x.velocity.value_or(0), stage.drive.y.velocity.value_or(0), stage.drive.z.velocity.value_or(0));
    if (speed > 0) min = std::min(min, *stage.until.displacement / speed + stage.ramp / 2);
  }
  // A body that starts above the bed may have a negative embedment to reach.
  return 0 < min && min < infinity ? min : 0;
}

Real expected_time(const std::vector<StageSettings>& stages)
{
  Real total = 0;
  for (const StageSettings& stage : stages) total += expected_time(stage);
  return total;
}

}  // namespace berm::settings
