// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sea/sea_settings.hpp"

namespace berm::sea {

/// What the water does at the pipe, and what the pipe gets of it, at equal times.
struct LoadRecord {
  Real step = 0;                             ///< s
  std::vector<Real> velocity, acceleration;  ///< m/s, m/s2, across the pipe, with the current
  std::vector<Real> H, V;                    ///< N/m: horizontal; submerged weight less lift

  Real time(std::size_t row) const { return static_cast<Real>(row) * step; }
};

/// Factors of a sea on a pipe.
struct RecordFactors {
  Real direction = 1;  ///< on the velocity of the waves
  Real current = 0;    ///< m/s
  Real embedment = 0;  ///< m, of the pipe
};

/// One realisation: Gaussian, from components that are multiples of 1/duration, with the forces on a pipe at rest (settings::water_force).
/// The same seed gives the same numbers on every machine.
LoadRecord realisation(const SeaCase& c, const RecordFactors& factors, unsigned seed);

/// A wave from one upward crossing of the mean velocity to the next.
struct LoadWave {
  std::size_t begin = 0, end = 0;  ///< rows
  Real crest = 0, trough = 0;      ///< N/m, of H on a pipe at rest
  Real size() const { return std::max(crest, -trough); }
};
std::vector<LoadWave> waves_of(const LoadRecord& record);

/// Those of the largest |H|, at most so many, one after the other in the order in which they occur.
std::vector<LoadWave> largest_waves(std::vector<LoadWave> waves, std::size_t count);

}  // namespace berm::sea
