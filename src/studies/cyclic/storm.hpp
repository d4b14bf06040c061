// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cyclic/contours.hpp"

namespace berm::cyclic {

/// Cycles of one height.
struct Parcel {
  Real cycles = 0;
  Real stress = 0;  ///< cyclic shear stress over s_u
};

/// A parcel on the contours: its line from `begin` cycles of its stress, that make the strain before it, to `end`.
struct ParcelPath {
  Parcel parcel;
  Real begin = 0, end = 0, strain = 0;
};

/// How a storm goes along the contours: each parcel begins at the number of cycles of its own stress that makes the strain before it.
struct StormPath {
  std::vector<ParcelPath> parcels;  ///< to the one that fails
  bool fails = false;               ///< the last of them reaches the strain of failure at `end`
  std::string outside;              ///< why the contours do not tell how it goes on; "": they do
};
StormPath follow(const Contours& contours, const std::vector<Parcel>& storm, std::size_t failure);

/// A storm, and the one whose stresses are `multiplier` times as large, which just reaches the failure contour.
struct StormStrength {
  StormPath given, failing;
  Real multiplier = 0;
  Real stress = 0;             ///< of the largest parcel of `failing`: the cyclic strength over s_u
  Real given_cycles = 0;       ///< of the largest stress that make the strain of the storm; NaN where it fails
  Real equivalent_cycles = 0;  ///< of `stress` to failure, N_eq
};

/// By bisection; `failure` is the number of the contour. Throws InputError where the contours do not reach far enough.
StormStrength strength_in(const Contours& contours, const std::vector<Parcel>& storm, std::size_t failure);

}  // namespace berm::cyclic
