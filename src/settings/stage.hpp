// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "settings/loads.hpp"
#include "settings/water_loads.hpp"

namespace berm::settings {

/// What a stage does with the rigid body that it drives.
enum class StageKind {
  geostatic,  ///< all rigid bodies rest; the soil reaches equilibrium, which is checked at the end
  push,       ///< down, by velocity or force; no horizontal motion
  drag,       ///< along x, by velocity or force
  free,       ///< time passes; rigid bodies rest, but for free ones
  drive,      ///< each degree of freedom as [stage.drive] says; what it leaves out is fixed
  sweep,      ///< drags out and back: short for that many drags (settings/sweeps.hpp), and none of them once a case is read
  pipeline    ///< the pipeline of the case drives its slices, under the loads that the stage names
};

/// What the vertical direction does while the body is dragged.
enum class Vertical {
  hold,  ///< the vertical force that drove the body when the stage began stays; after a drive by velocity the soil's reaction at that moment
  fixed  ///< no vertical motion
};

/// What a stage is in the life of a pipe. The pipe is called by it where the stage ends: touched down, laid, flooded, emptied, in operation.
enum class StageRole {
  automatic,  ///< found from the stages (structures/driven/states.hpp)
  touchdown,
  lay,  ///< the small drags of a pipe that is laid, and all else before it lies
  flooded,
  emptied,
  operation,
  breakout,  ///< the travel whose resistance is the answer
  sweep
};

/// A stage ends when the first of the limits that are given is reached.
struct Until {
  std::optional<Real> time;           ///< s since the start of the stage
  std::optional<Real> displacement;   ///< m, |u - u at the stage's begin|; of a drive the distance from there
  std::optional<Real> embedment;      ///< m, w: that or more, of a body that is lifted that or less
  std::optional<Real> force;          ///< N per metre: H of a drag, V of a push, in one upwards that or less
  std::optional<Real> consolidation;  ///< degree of consolidation
  bool equilibrium = false;           ///< geostatic: as soon as the soil is at rest and in balance
  std::optional<Real> real_time;      ///< s that the soil which is modelled consolidates for; `time` follows once a case is read
};

/// How a displacement of the driven body goes; nothing: it is fixed.
struct FreedomSettings {
  std::optional<Real> velocity;  ///< m/s along the axis
  std::optional<Real> force;     ///< N/m (in space: N) along the axis
  bool hold = false;             ///< the force that was there when the stage began
  bool free = false;             ///< nothing but the contacts
  std::optional<Real> spring;    ///< N/m2 (in space: N/m), to where it was when the stage began; besides a force or hold
};

/// How a rotation of the driven body goes; nothing: as the body's own `rotation` says.
struct TurnSettings {
  std::optional<Real> velocity;  ///< rad/s
  std::optional<Real> moment;    ///< N (in space: N m)
  bool fixed = false, free = false;
  std::optional<Real> spring;  ///< N/rad (in space: N m/rad), to the orientation when the stage began; besides a moment
};

/// The degrees of freedom of a rigid body.
struct DriveSettings {
  FreedomSettings x, y, z;
  TurnSettings rotation, rotation_x, rotation_y, rotation_z;  ///< about z in the plane; in space about the three axes
  std::vector<Real>
      point;  ///< m, where x, y and z act: a point that moves with the body, by its position before the first stage; empty: its centre
};

/// Loads of the pipeline when the stage's ramp is over; what is absent stays as it was.
struct PipelineLoads {
  std::optional<Real> temperature;      ///< K, rise since it was laid
  std::optional<Real> far_temperature;  ///< K, the same at the far end, linear between; absent: that of `temperature`
  std::optional<Real> pressure;         ///< Pa, rise of the internal pressure since it was laid
  std::optional<Real> weight;           ///< N/m, submerged
  std::optional<Real> lateral;          ///< N/m along the slices' x, such as that of a current
  std::optional<Real> pull;             ///< N, effective tension at the far end
};

/// One stage of a run.
struct StageSettings {
  std::string name;
  StageKind kind = StageKind::free;
  StageRole role = StageRole::automatic;
  std::string rigid;             ///< which rigid body; empty = the only one
  std::optional<Real> velocity;  ///< m/s; push: down, drag: along +x
  std::optional<Real> force;     ///< N/m, instead of velocity
  Vertical vertical = Vertical::hold;
  std::optional<Real> vertical_force;     ///< N/m downwards in a drag, instead of the one held
  std::optional<Real> vertical_velocity;  ///< m/s downwards in a drag, instead of holding a force
  /// s, time in which the drive goes from what it was to its value; 0 = at once. What a push or a drive does not name stands still at once.
  Real ramp = 0;
  DriveSettings drive;            ///< of a stage of kind drive
  PipelineLoads pipeline;         ///< of a stage of kind pipeline
  int repeat = 1;                 ///< how often the stages from `repeat_from` to this one run; 1 once a case is read
  std::string repeat_from;        ///< an earlier stage, or this one
  std::optional<Real> amplitude;  ///< m, of a sweep: the travel of each drag
  int sweeps = 0;                 ///< of a sweep: how many drags, out and back in turn
  Real pause = 0;                 ///< s, of a sweep: how long the body rests between two of them, its vertical force held
  std::string load_history;       ///< a file of times and factors, or of times and columns, as below
  /// s of the record, which begins with the stage, ascending; the drive's value goes with the factors, linear between them, constant after. The same time twice is
  /// a jump: before it the first value, from it on the second.
  std::vector<Real> load_times;
  std::vector<Real> load_factors;
  LoadSettings loads;                  ///< instead of factors: forces, velocities or displacements at these times
  std::optional<WaterSettings> water;  ///< of a column of water
  int load_repeat = 1;                 ///< how often the record runs, one run behind the other; 1 once a case is read
  Real time_scale = 1;                 ///< s of the run for each s of the record; automatic_time_scale until a case is read
  Real strength_recovery = 0;          ///< share of the strength lost by remoulding that the soil has regained when the stage begins
  std::optional<Real> damping;         ///< local damping of all bodies in this stage, instead of their own
  bool zero_displacements = false;     ///< displacements that are written count from where the stage begins
  Until until;
  Real equilibrium = 0.01;  ///< geostatic: largest out-of-balance force over the weight that is accepted
};

/// Stands for the scale that berm finds (settings/time_scale.hpp).
constexpr Real automatic_time_scale = 0;

/// Whether the stage drives a rigid body.
inline bool drives(StageKind kind)
{
  return kind == StageKind::push || kind == StageKind::drag || kind == StageKind::drive || kind == StageKind::sweep ||
         kind == StageKind::pipeline;
}

/// Whether the stage ends at equilibrium: a geostatic one that says so, or names no end.
inline bool ends_at_equilibrium(const StageSettings& stage)
{
  return stage.kind == StageKind::geostatic && (stage.until.equilibrium || !stage.until.time);
}

/// Since when displacements count, for people: the stages that say so; "" where none does, and all count from the start.
std::string displacements_since(const std::vector<StageSettings>& stages);

/// Whether a load history drives the stage, of factors or of columns.
inline bool has_load_history(const StageSettings& stage)
{
  return !stage.load_history.empty() || !stage.load_times.empty();
}

/// The factor of the load history at a time since the stage began, s; 1 without one. That of a velocity grows as the time is shortened.
Real load_factor(const StageSettings& stage, Real since);

/// The value of column k (of load_columns) of the load history at a time since the stage began, s: a force, a velocity or a displacement. A velocity grows as the
/// time is shortened, so that the travel stays that of the record.
Real load_of_column(const StageSettings& stage, std::size_t k, Real since);

/// What the water of its load history does at a time since the stage began, s; the acceleration is the slope of the record.
WaterMotion water_at(const StageSettings& stage, Real since);

/// The largest factor of its load history, by size; 1 without one.
Real max_load_factor(const StageSettings& stage);

/// The largest value of a column of its load history, by size; of a column of displacements the speed where it is steepest. 0 where it is empty.
Real max_load(const StageSettings& stage, std::size_t k);

/// Writes the record of a stage behind itself as often as it is repeated. Where one run ends and the next begins the values jump if they differ.
void repeat_load_history(StageSettings& stage);

/// The largest speed of its drive, m/s; 0 where a force drives.
Real speed_of(const StageSettings& stage);

void describe(Describe& d, FreedomSettings& freedom);
void describe(Describe& d, TurnSettings& turn);
void describe(Describe& d, DriveSettings& drive);
void describe(Describe& d, PipelineLoads& loads);
void describe(Describe& d, Until& until);
void describe(Describe& d, StageSettings& stage);

/// +1, or -1 in a drag along -x: H = -direction times the horizontal force of the soil on the body.
Real drag_direction(const StageSettings& stage);

/// The time that a stage is expected to take, s; 0 where its input does not determine it.
Real expected_time(const StageSettings& stage);
/// The sum over stages.
Real expected_time(const std::vector<StageSettings>& stages);

}  // namespace berm::settings
