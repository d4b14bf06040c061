// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/travel_curve.hpp"
#include "structures/driven/driven_run.hpp"

#include <optional>

namespace berm::driven {

/// How the soil resists a drag: how much at most, where it gives way, and what is left.
struct Resistance {
  struct Point {
    Real u, H;  ///< m, N/m
  };
  Real travel = 0;  ///< m, how far the drag came; NaN where it is not known
  /// The largest H, over the curve averaged to its very end: no point of the drag is told with more.
  std::optional<Point> largest;
  Real V_at_largest = 0;  ///< N/m, averaged as well; NaN where it is not known
  /// The first peak of H that H falls from by at least 5 % before it grows beyond it. H is averaged as all forces are (averaging_half), the ends of the drag
  /// are left out by half of that window. The fall must also be four times what averaged H swings about its mean over +-0.1 D elsewhere: from its highest to its lowest
  /// wiggle noise falls as much. H must stay below the peak over the next 0.25 D, which shorter waves of a dynamic method do not. Without noise the way over which it
  /// stays below is 0.1 D, or a third of the drag where it is shorter, and the mean of H over as long a way must be lower by 5 % as well, which an increment that relaxes does not make.
  /// A peak beyond 1 D is none: the body has left its bed by then, and H is that of the soil heaped up before it.
  std::optional<Point> breakout;
  /// N/m, without a breakout: the H at which the body begins to slide. The straight line through the means of H over u = 0.1 to 0.3 D and 0.3 to 0.5 D, at u = 0; where
  /// H does not grow between them, the first mean. Empty in a drag shorter than 0.5 D, and where it is less than a tenth of the first mean.
  std::optional<Real> onset;
  bool peak_beyond = false;    ///< there is no breakout, but such a peak beyond 1 D
  bool peak_in_noise = false;  ///< there is no breakout, but where H swings less there would be one
  /// N/m, the plateau of H: the mean over the last tenth of the drag, at least its last 0.1 D but a third of it at most, where the straight line fitted to H there changes
  /// by less than 5 % of it. Where H rises beyond an earlier such stretch by more than min_berm it has met a berm: then the plateau is the lowest of those after the
  /// breakout; without one it is a quarter of the travel long, after H has first come to half of its mean at the end.
  /// Against the berm of an earlier drag (Ahead::berm) the mean at the end is no residual: it is then the lowest plateau, from which H has risen by min_berm or which
  /// lies farther than near_a_berm before the end.
  std::optional<Real> residual;
  std::optional<Real> residual_at;  ///< m, the travel in the middle of that plateau
  /// N/m: the mean of H over the end of a drag against a berm: of one that has risen from its plateau, that has no residual and ends at the berm of an earlier one
  /// (Ahead::berm), or that grows over swept ground to its end without a plateau.
  std::optional<Real> berm;
  /// m, of a drag that breaks out: from where H, averaged, first is as near to the residual as it must stay to be called so (max_residual_change).
  std::optional<Real> residual_from;
  Real last_change = 0;  ///< how much that line changes, over the mean; NaN without a drag
};

/// The fall after a peak that makes it the breakout, and the change at the end of the drag below which H is called residual.
constexpr Real min_fall = 0.05, max_residual_change = 0.05;
/// The same fall over how much averaged H swings (a standard deviation).
constexpr Real min_fall_over_swing = 4;
/// The rise from the plateau to the end that makes the end the resistance of a berm, and the travel (over D) that a drag must have to meet one.
constexpr Real min_berm = 0.15, min_travel_to_a_berm = 1;
/// How near (over D) to where an earlier drag in its direction ended a drag ends at the berm that this has left, and how far before that place it must have begun: a
/// drag from there on goes on with the earlier one.
constexpr Real near_a_berm = 1, least_way_to_a_berm = 0.25;
/// The travel (over D) over which H must stay below the breakout, the longest way (over D) to it, and half of the window about which H swings.
constexpr Real breakout_stays = 0.25, breakout_stays_without_noise = 0.1, longest_breakout = 1, swing_half = 0.1;
/// The end of the drag over which H must not change to be residual: over the travel of the drag, at least over D, but no more than a
/// third of the travel.
constexpr Real residual_part = 0.1, min_residual_travel = 0.1, max_residual_part = 1. / 3;

/// The travel (m) of that end, of a drag of this travel.
Real residual_travel(Real travel, const BodyScale& scale);

/// What a drag comes to.
enum class Ahead {
  fresh,  ///< ground that no drag has swept but those that lay the pipe
  swept,  ///< ground that an earlier drag has swept
  berm    ///< the berm of an earlier drag: it ends near_a_berm
};

/// What a drag of a path comes to; drags by a force, and those that lay the pipe, leave no berm.
Ahead ahead_of(const Path& path, std::size_t drag, const BodyScale& scale);

/// Of H (N/m) over u (m), without V.
Resistance resistance_to(const record::TravelCurve& H, const BodyScale& scale, Ahead ahead = Ahead::fresh);

/// Of a drag of a path, the same.
Resistance resistance_in(const Path& path, std::size_t drag, const BodyScale& scale);

/// Of a run's main drag, none of one by a force that varies; where its history is lost, of what its quantities tell.
Resistance resistance_of(const DrivenRun& run);

/// What to say of a drag whose H has no peak: "no peak: H grows to the end of the drag", whose `end` may be another.
std::string no_peak_words(const Resistance& resistance, const std::string& end);

}  // namespace berm::driven
