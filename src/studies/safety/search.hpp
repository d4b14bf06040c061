// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <optional>
#include <string>
#include <vector>

namespace berm::safety {

/// How a trial ended: the soil stands or fails with its strength over the factor, or neither is known.
enum class TrialEnd { stands, fails, undecided };
const char* word_of(TrialEnd end);

/// A run of the case with its strength over a factor.
struct Trial {
  Real factor = 1;
  TrialEnd end = TrialEnd::undecided;
  Real movement = nan, limit = nan;  ///< m, of the soil, and that from which on it has failed
  Real wall_s = nan;
  std::string why{};       ///< of a trial that is undecided
  Real time_factor = nan;  ///< c_v T / H^2 of its last stage, of soil whose water flows
};

/// Where a factor of safety is looked for.
struct SearchSettings {
  Real low = 1, high = 2;  ///< of the first trials
  Real tolerance = 0.01;   ///< between the largest factor at which the soil stands and the smallest at which it fails
  int at_once = 3;         ///< trials of a round: the same on every machine, so that the answer does not depend on how many run at a time
};

constexpr Real min_factor = 0.1, max_factor = 10, smallest_tolerance = 1e-3;

/// Between what the factor of safety lies.
struct Bracket {
  std::optional<Real> stands, fails;  ///< the smallest factor at which the soil fails, and the largest below it at which it stands
  std::vector<Real> undecided;        ///< factors between them
  std::vector<Real> stands_above;     ///< factors above `fails` at which it stands all the same
};
Bracket bracket_of(const std::vector<Trial>& trials);

/// The factors of the trials that are to be made next, ascending, at most at_once; none where the search is over: the bracket is no wider than the tolerance, but for trials that are undecided, or the
/// soil fails at min_factor or stands at max_factor; or three trials are undecided and no other says anything. The first lie between low and high; while all fail or all stand the next are smaller or larger by 1.5. Then they divide the bracket equally; on
/// both sides of trials that are undecided. Factors have four decimals.
std::vector<Real> next_factors(const std::vector<Trial>& trials, const SearchSettings& settings);

}  // namespace berm::safety
