// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"
#include "run_folder/history.hpp"

namespace berm::driven {

/// A stage of a case that pushes or drags the pipe.
struct Stage {
  std::string name;
  problem::StageKind kind = problem::StageKind::push;
  bool upwards = false;              ///< a push by a velocity upwards
  std::optional<Real> force{};       ///< N/m, downwards, of a push by force: the last of its load history
  Real direction = 1;                ///< of a drag: +1 along x, -1 against it
  bool holds_V = true;               ///< of a drag: whether it holds a vertical force
  Real V_ramp = 0;                   ///< s, time that the drag takes to come to that force
  std::optional<Real> held_force{};  ///< N/m, that force; empty where it is not known
};

/// In the order in which they run; a drag that stands still (the pause of sweeps) is none.
using Stages = std::vector<Stage>;

/// The pushes and the drags of a case. `held_forces`: N/m by stage of the case, NaN where none is held; empty where they are not known.
Stages stages_of(const problem::Case& c, const std::vector<Real>& held_forces = {});

/// The way down: pushes before the first drag that load the pipe further, by row.
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

/// A push that is no way down: it unloads or lifts the pipe, or follows a drag.
struct OtherPush {
  std::string stage;
  std::vector<Index> rows;
};

/// The pushes and the drags of a history.
struct Path {
  PushPath push;
  std::vector<OtherPush> other_pushes;
  std::vector<DragPath> drags;

  /// The first drag; one without rows where there is none.
  const DragPath& drag() const;
};

/// Takes pushes and drags out of a history. A push by a force below the V that it finds, or by a velocity upwards, unloads.
Path path_of(const run_folder::History& history, const Stages& stages);

}  // namespace berm::driven
