// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <array>

namespace berm::settings {

/// The freedom of the driven body, or the load of the line, that a column of a load history is of.
enum class LoadAlong {
  horizontal,  ///< along the drag
  downwards,
  x,
  y,
  z,
  rotation,
  rotation_x,
  rotation_y,
  rotation_z,
  water,        ///< across and up: the water moves
  temperature,  ///< from here on loads of the line (PipelineLoads)
  far_temperature,
  pressure,
  weight,
  lateral,
  pull
};

/// What the values of a column of a load history are: forces or moments, velocities, or displacements and angles since the stage began; the velocity of water, which makes forces; or loads of the line.
enum class LoadQuantity { force, velocity, displacement, water, of_line };

/// A kind of column of a load history.
struct LoadColumn {
  const char* key;   ///< in [stage.loads]
  const char* name;  ///< in the header of a file, where its unit follows
  const char* unit;  ///< SI, of a run in the plane
  LoadQuantity quantity;
  LoadAlong along;
  const char* meaning;
};

constexpr std::array<LoadColumn, 34> load_columns = {{
    {"H", "H", "N/m", LoadQuantity::force, LoadAlong::horizontal, "in a drag: force along x"},
    {"V", "V", "N/m", LoadQuantity::force, LoadAlong::downwards, "in a push or a drag: downward force"},
    {"u", "u", "m/s", LoadQuantity::velocity, LoadAlong::horizontal, "in a drag: velocity along x"},
    {"w", "w", "m/s", LoadQuantity::velocity, LoadAlong::downwards, "in a push or a drag: downward speed"},
    {"u_displacement", "u", "m", LoadQuantity::displacement, LoadAlong::horizontal,
     "in a drag: displacement along x since the start of the stage"},
    {"w_displacement", "w", "m", LoadQuantity::displacement, LoadAlong::downwards,
     "in a push or a drag: displacement downwards since the start of the stage"},
    {"x_force", "x", "N/m", LoadQuantity::force, LoadAlong::x, "in a drive: force on the body along x"},
    {"x_velocity", "x", "m/s", LoadQuantity::velocity, LoadAlong::x, "in a drive: velocity along x"},
    {"x_displacement", "x", "m", LoadQuantity::displacement, LoadAlong::x, "in a drive: displacement along x since the start of the stage"},
    {"y_force", "y", "N/m", LoadQuantity::force, LoadAlong::y, "in a drive: force on the body along y"},
    {"y_velocity", "y", "m/s", LoadQuantity::velocity, LoadAlong::y, "in a drive: velocity along y"},
    {"y_displacement", "y", "m", LoadQuantity::displacement, LoadAlong::y, "in a drive: displacement along y since the start of the stage"},
    {"z_force", "z", "N/m", LoadQuantity::force, LoadAlong::z, "in a drive in space: force on the body along z"},
    {"z_velocity", "z", "m/s", LoadQuantity::velocity, LoadAlong::z, "in a drive in space: velocity along z"},
    {"z_displacement", "z", "m", LoadQuantity::displacement, LoadAlong::z,
     "in a drive in space: displacement along z since the start of the stage"},
    {"rotation_moment", "rotation", "N", LoadQuantity::force, LoadAlong::rotation,
     "in a drive in the plane: moment on the body, counter-clockwise"},
    {"rotation_velocity", "rotation", "rad/s", LoadQuantity::velocity, LoadAlong::rotation,
     "in a drive in the plane: angular velocity, counter-clockwise"},
    {"rotation_angle", "rotation", "rad", LoadQuantity::displacement, LoadAlong::rotation,
     "in a drive in the plane: angle since the start of the stage, counter-clockwise"},
    {"rotation_x_moment", "rotation_x", "N", LoadQuantity::force, LoadAlong::rotation_x, "in a drive in space: moment on the body about x"},
    {"rotation_x_velocity", "rotation_x", "rad/s", LoadQuantity::velocity, LoadAlong::rotation_x,
     "in a drive in space: angular velocity about x"},
    {"rotation_x_angle", "rotation_x", "rad", LoadQuantity::displacement, LoadAlong::rotation_x,
     "in a drive in space: angle about x since the start of the stage, the integral of the angular velocity"},
    {"rotation_y_moment", "rotation_y", "N", LoadQuantity::force, LoadAlong::rotation_y, "in a drive in space: moment on the body about y"},
    {"rotation_y_velocity", "rotation_y", "rad/s", LoadQuantity::velocity, LoadAlong::rotation_y,
     "in a drive in space: angular velocity about y"},
    {"rotation_y_angle", "rotation_y", "rad", LoadQuantity::displacement, LoadAlong::rotation_y,
     "in a drive in space: angle about y since the start of the stage, the integral of the angular velocity"},
    {"rotation_z_moment", "rotation_z", "N", LoadQuantity::force, LoadAlong::rotation_z, "in a drive in space: moment on the body about z"},
    {"rotation_z_velocity", "rotation_z", "rad/s", LoadQuantity::velocity, LoadAlong::rotation_z,
     "in a drive in space: angular velocity about z"},
    {"rotation_z_angle", "rotation_z", "rad", LoadQuantity::displacement, LoadAlong::rotation_z,
     "in a drive in space: angle about z since the start of the stage, the integral of the angular velocity"},
    {"water", "water", "m/s", LoadQuantity::water, LoadAlong::water,
     "in a drag of a pipe: velocity of the water across it; [stage.water] has the coefficients of its forces"},
    {"temperature", "temperature", "K", LoadQuantity::of_line, LoadAlong::temperature,
     "in a stage of kind pipeline: rise of temperature since the line was laid"},
    {"far_temperature", "far_temperature", "K", LoadQuantity::of_line, LoadAlong::far_temperature,
     "in a stage of kind pipeline: the same at the far end of the line; left out: as at x = 0"},
    {"pressure", "pressure", "Pa", LoadQuantity::of_line, LoadAlong::pressure,
     "in a stage of kind pipeline: rise of internal pressure since the line was laid"},
    {"weight", "weight", "N/m", LoadQuantity::of_line, LoadAlong::weight, "in a stage of kind pipeline: submerged weight"},
    {"lateral", "lateral", "N/m", LoadQuantity::of_line, LoadAlong::lateral, "in a stage of kind pipeline: lateral load"},
    {"pull", "pull", "N", LoadQuantity::of_line, LoadAlong::pull, "in a stage of kind pipeline: effective tension at the far end"},
}};

/// Whether a column of the second drives the first: water drives a drag along and downwards.
bool is_driven_by(LoadAlong along, LoadAlong column);

/// Forces, velocities and displacements of a driven body, or loads of the line, that vary together: a value at each of the stage's load_times, linear between them, constant after.
struct LoadSettings {
  std::array<std::vector<Real>, load_columns.size()> columns;  ///< by load_columns, SI; an empty one drives nothing

  bool empty() const;
  /// Whether a column is of forces or moments, or of water that makes forces.
  bool has_force() const;
  /// Whether a column drives this freedom.
  bool drives(LoadAlong along) const;
  /// The column of this key. Throws std::out_of_range for a key that is none.
  const std::vector<Real>& of(const char* key) const;
  std::vector<Real>& of(const char* key);
};

void describe(Describe& d, LoadSettings& loads);

}  // namespace berm::settings
