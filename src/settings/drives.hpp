// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/dynamics.hpp"
#include "core/axes.hpp"
#include "settings/stage.hpp"

namespace berm::settings {

/// What a stage prescribes to a degree of freedom of the body that it drives.
struct FreedomDrive {
  enum class By {
    velocity,  ///< a given velocity; 0: it is fixed
    force,     ///< a given force of the drive on the body (of a rotation: a moment)
    hold,      ///< the force that balances the soil when the stage begins
    free       ///< nothing but the contacts (a rotation that may turn)
  };
  By by = By::velocity;
  Real value = 0;      ///< m/s, rad/s, N/m (in space: N), N (in space: N m), along the axis
  Real spring = 0;     ///< stiffness of a spring to where the body was when the stage began, which a force goes with
  bool named = false;  ///< by the stage: with its ramp; else it stands still from the stage's begin on
};

template <int dim>
using StageDrives = std::array<FreedomDrive, bodies::freedoms<dim>>;

/// The freedom that a column of a load history drives; sign: -1 where the column counts against its axis. The freedom of one that the geometry has not is none.
struct LoadedFreedom {
  int freedom;
  Real sign;
};
template <int dim>
LoadedFreedom freedom_of(LoadAlong along, const Axes<dim>& axes);

/// The column (of load_columns) of the stage's load history that drives a freedom; none where no one does.
template <int dim>
int load_column_of(const StageSettings& stage, const Axes<dim>& axes, int freedom);

/// The drives of a stage: those of [stage.drive] and of the columns of its load history, whose value is +-1 and which a column multiplies; or what a push or a
/// drag is short for. `turns`: whether the body may turn where no drive says.
template <int dim>
StageDrives<dim> drives_of(const StageSettings& stage, const Axes<dim>& axes, bool turns);

/// Whether a force moves it along an axis; whether a moment turns it.
template <int dim>
bool has_force(const StageDrives<dim>& drives);
template <int dim>
bool has_moment(const StageDrives<dim>& drives);

}  // namespace berm::settings
