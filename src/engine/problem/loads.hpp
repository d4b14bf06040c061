// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <array>

namespace berm::problem {

/// The freedom of the driven body that a column of a load history is of.
enum class LoadAlong {
  horizontal,  ///< along the drag
  downwards,
  x,
  y,
  z,
  rotation,
  rotation_x,
  rotation_y,
  rotation_z
};

/// A kind of column of a load history.
struct LoadColumn {
  const char* key;   ///< in [stage.loads]
  const char* name;  ///< in the header of a file, where its unit follows
  const char* unit;  ///< SI, of a run in the plane
  bool by_force;     ///< a force or a moment; else a velocity
  LoadAlong along;
  const char* meaning;
};

constexpr std::array<LoadColumn, 18> load_columns = {{
    {"H", "H", "N/m", true, LoadAlong::horizontal, "in a drag: force along x"},
    {"V", "V", "N/m", true, LoadAlong::downwards, "in a push or a drag: downward force"},
    {"u", "u", "m/s", false, LoadAlong::horizontal, "in a drag: velocity along x"},
    {"w", "w", "m/s", false, LoadAlong::downwards, "in a push or a drag: downward speed"},
    {"x_force", "x", "N/m", true, LoadAlong::x, "in a drive: force on the body along x"},
    {"x_velocity", "x", "m/s", false, LoadAlong::x, "in a drive: velocity along x"},
    {"y_force", "y", "N/m", true, LoadAlong::y, "in a drive: force on the body along y"},
    {"y_velocity", "y", "m/s", false, LoadAlong::y, "in a drive: velocity along y"},
    {"z_force", "z", "N/m", true, LoadAlong::z, "in a drive in space: force on the body along z"},
    {"z_velocity", "z", "m/s", false, LoadAlong::z, "in a drive in space: velocity along z"},
    {"rotation_moment", "rotation", "N", true, LoadAlong::rotation, "in a drive in the plane: moment on the body, counter-clockwise"},
    {"rotation_velocity", "rotation", "rad/s", false, LoadAlong::rotation, "in a drive in the plane: angular velocity, counter-clockwise"},
    {"rotation_x_moment", "rotation_x", "N", true, LoadAlong::rotation_x, "in a drive in space: moment on the body about x"},
    {"rotation_x_velocity", "rotation_x", "rad/s", false, LoadAlong::rotation_x, "in a drive in space: angular velocity about x"},
    {"rotation_y_moment", "rotation_y", "N", true, LoadAlong::rotation_y, "in a drive in space: moment on the body about y"},
    {"rotation_y_velocity", "rotation_y", "rad/s", false, LoadAlong::rotation_y, "in a drive in space: angular velocity about y"},
    {"rotation_z_moment", "rotation_z", "N", true, LoadAlong::rotation_z, "in a drive in space: moment on the body about z"},
    {"rotation_z_velocity", "rotation_z", "rad/s", false, LoadAlong::rotation_z, "in a drive in space: angular velocity about z"},
}};

/// Forces and velocities of a driven body that vary together: a value at each of the stage's load_times, linear between them, constant after.
struct LoadSettings {
  std::array<std::vector<Real>, load_columns.size()> columns;  ///< by load_columns, SI; an empty one drives nothing

  bool empty() const;
  /// Whether a column is of forces or moments.
  bool has_force() const;
  /// The column of this key. Throws std::out_of_range for a key that is none.
  const std::vector<Real>& of(const char* key) const;
  std::vector<Real>& of(const char* key);
};

void describe(Describe& d, LoadSettings& loads);

}  // namespace berm::problem
