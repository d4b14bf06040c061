// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/history.hpp"
#include "settings/case.hpp"

namespace berm::driven {

/// What moves the body one way: a stage of a case that pushes or drags it, or the part of one whose velocity does not turn round. A stage of kind drive whose x is
/// driven is a drag, one that drives y alone a push.
struct Stage {
  std::string name;  ///< of the stage; STAGE_1, STAGE_2, ... where its velocity turns round
  settings::StageKind kind = settings::StageKind::push;
  bool upwards = false;              ///< a push by a velocity upwards
  std::optional<Real> force{};       ///< N/m, downwards, of a push by force: the last of its load history
  Real direction = 1;                ///< of a drag: +1 along x, -1 against it
  bool by_force = false;             ///< a drag by a force
  bool varies = false;               ///< that has a load history: it may turn round
  bool holds_V = true;               ///< of a drag: whether it holds a vertical force
  Real V_ramp = 0;                   ///< s, time that the drag takes to come to that force
  std::optional<Real> held_force{};  ///< N/m, that force; empty where it is not known
  bool lays = false;                 ///< a drag that lays the pipe: what it meets is no answer
  settings::StageSettings asked{};   ///< the stage of the case
  Real from = 0, to = infinity;      ///< s since that began: the part of it
};

/// In the order in which they run; a stage that stands still (the pause of sweeps) is none.
using Stages = std::vector<Stage>;

/// A drag whose asked travel is at most this (over D), before an unloading after which a drag of more than twice as much comes, lays the pipe, unless roles are said.
constexpr Real longest_lay = 0.25;

/// The pushes and the drags of the main rigid body of a case. `held_forces`: N/m by stage of the case, NaN where none is held; empty where they are not known.
Stages stages_of(const settings::Case& c, const std::vector<Real>& held_forces = {});

/// The drag whose resistance is the answer: the first of role breakout, else the first that does not lay the pipe; the last where all do. Its number among the drags of
/// stages, or none.
std::optional<std::size_t> main_drag(const Stages& stages);

/// The way down: pushes before the first drag that load the body further, by row.
struct PushPath {
  std::vector<Index> rows;  ///< of the history
  std::vector<Real> w, V;   ///< m, N/m
};

/// One drag, by row. The row before the first of the stage is where it begins, and is its first.
struct DragPath {
  Stage stage{};
  std::vector<Index> rows{};
  Real u_begin = 0;                 ///< m, u where it began
  std::vector<Real> travel{};       ///< m, from there, along its direction
  std::vector<Real> w{}, H{}, V{};  ///< m; N/m, H against its direction (positive where the soil resists)
};

/// V of a drag by row, once it is what it shall be: without the ramp to another force, N/m. `time`: s, of all rows of the history.
std::vector<Real> settled_V(const DragPath& drag, const std::vector<Real>& time);

/// A push that is no way down: it unloads or lifts the body, or follows a drag.
struct OtherPush {
  std::string stage;
  bool upwards = false;  ///< by a velocity
  bool lifts = false;    ///< upwards, to where the soil no longer carries the body: no state of operation
  std::vector<Index> rows;
};

/// The pushes and the drags of a history.
struct Path {
  PushPath push;
  std::vector<OtherPush> other_pushes;
  std::vector<DragPath> drags;
  std::size_t main = 0;  ///< among the drags, that whose resistance is the answer; one that has not begun yet is not among them

  /// The first drag, and the main one; one without rows where there is none.
  const DragPath& drag() const;
  const DragPath& main_drag() const;
};

/// The limit of V that ended the way down, N/m; NaN where a depth or a time did, or it has come to none.
Real force_that_ended(const PushPath& push, const run_folder::History& history, const Stages& stages);

/// Takes pushes and drags out of a history. A push by a force below the V that it finds, or by a velocity upwards, unloads.
Path path_of(const run_folder::History& history, const Stages& stages);

}  // namespace berm::driven
