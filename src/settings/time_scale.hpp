// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::settings {

/// How much faster than its record a load history of forces may run in a model that has inertia.
struct TimeScale {
  enum class Reason {
    soil,  ///< density v^2 of the soil is small_inertia of its strength at a depth of D, of a body that goes a tenth of D in a half wave
    mass,  ///< to move the body so takes 3 % of the largest force
    waves  ///< a pressure wave crosses the body 20 times in a half wave
  };
  Reason reason = Reason::soil;  ///< what limits it
  Real half_wave = 0;  ///< s of the record: the shortest time between two turning points that are a fifth of a column's range apart
  Real shortest = 0;   ///< s of the run, in which a half wave is slow enough
  Real scale = 1;      ///< shortest / half_wave, 1 at most, rounded up to two digits
};

/// Half a wave is long enough where inertia of the soil and of the body is small and waves have passed:
///
///   t = max( d / sqrt(0.003 s / rho),  sqrt(4 m d / (0.03 F)),  20 D / c_P ),   d = 0.1 D
///
/// with the width D and the mass m of the body, the largest force F, and density rho, strength s at a depth of D and wave speed c_P of the soil that it touches.
/// Empty without a load history of forces, and for a body without a width or without soil.
std::optional<TimeScale> time_scale_of(const Case& c, const StageSettings& stage);

/// How a record is run, of a stage that has one: "a record of 100 s in 30 s of the run, time_scale = 0.3".
std::string time_scale_words(const StageSettings& stage);

/// What to know of a time scale below 1 where a force moves a body that breaks out.
inline constexpr const char* breakout_takes_time =
    "a body that breaks out is accelerated, and its displacement increases with the square of the duration of the wave";

/// "the inertia of the soil", ...
const char* words_of(TimeScale::Reason reason);

}  // namespace berm::settings
