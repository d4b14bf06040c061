// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/history.hpp"

namespace berm::report {

/// What the history tells of a moment; NaN and "" where it tells nothing.
struct FilmMoment {
  std::string stage;    ///< of the row nearest in time
  Real u = nan, w = u;  ///< m, between two rows on the straight line
  Real H = nan, V = H;  ///< N/m, around an axis and in space N; of the row nearest in time
};

/// The moment of a time, s; before the first row or behind the last one, that row's.
FilmMoment moment_at(const run_folder::History& history, Real time);

/// The length of the driven body's way (u, w) between two times, m; NaN where the history does not tell it.
Real way_between(const run_folder::History& history, Real from, Real to);

}  // namespace berm::report
