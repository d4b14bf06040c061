// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <array>

namespace berm::boundary {

/// Velocity of a boundary in some stages: of the soil that a support holds there, or of the wave that comes in through one that absorbs.
struct MotionSettings {
  std::string table;                          ///< a CSV file of times and velocities; empty once a case is read
  std::vector<Real> times;                    ///< s since a stage of `stages` began, ascending from 0
  std::array<std::vector<Real>, 3> velocity;  ///< m/s along x, y, z at these times, linear between them, constant after; empty: none
  std::vector<std::string> stages;            ///< in which it counts; in others the boundary stands still
};

void describe(Describe& d, MotionSettings& motion);

/// What the columns of its table are called, and their unit.
constexpr const char* motion_axes[] = {"x", "y", "z"};
constexpr const char* unit_of_motion = "m/s";

/// The velocity along an axis at a time since the stage began, m/s.
Real velocity_at(const MotionSettings& motion, int axis, Real since);

/// What a record along an axis does within a time, s.
struct MotionMeasures {
  Real speed = 0;      ///< m/s, the largest
  Real excursion = 0;  ///< m, the largest displacement from where it began, to either side
  Real residual = 0;   ///< m, the displacement in the end
  Real half_wave =
      infinity;  ///< s, the shortest change of velocity of a tenth of the largest speed or more, from one turning point or level part to the next
  Real last = 0;  ///< m/s, the velocity in the end
};
MotionMeasures measures_of(const MotionSettings& motion, int axis, Real time);

/// What is wrong with a row of the table beside the rows before it, or with the whole; "" where nothing is.
std::string fault_of_row(const std::vector<Real>& times, std::size_t row);
std::string fault_of_table(const MotionSettings& motion);

}  // namespace berm::boundary
