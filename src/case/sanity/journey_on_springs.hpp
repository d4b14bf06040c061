// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sanity/scene.hpp"

namespace berm::sanity {

/// A line has buckled where it has gone farther than this from where it was laid, over its diameter.
constexpr Real buckled = 0.5;

/// The line of a pipeline at the end of a stage that heats it.
struct LineThen {
  Real y = nan,
       moment = nan;  ///< largest, m from its axis and N m; NaN of another stage, or one that the journey did not come to
  Real gone = 0;      ///< m, farthest from where it was laid
};

/// Where the line of a pipeline goes on the springs of its far soil, without slices.
struct Journey {
  std::vector<LineThen> ends;  ///< by stage
  std::vector<Real> places;    ///< m, of the slices
  std::vector<Span> sideways;  ///< by slice, m since it was laid, until the largest compression of all stages is there for the first time
  Real lobe = nan;             ///< m, length of the lobe around the crown then; NaN where it has none or has not buckled
};

/// Whether a journey goes on after a stage, with the line at its end.
using GoesOn = std::function<bool(std::size_t stage, const LineThen& then)>;

/// The stages that load the line, each so many times slower (slices::go_through_stages). Empty where nothing resists sideways.
std::optional<Journey> journey_on_springs(const settings::Case& c, Real slower, const GoesOn& goes_on);

}  // namespace berm::sanity
