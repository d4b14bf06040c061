// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/spring_laws.hpp"
#include "problem/model.hpp"

#include <functional>
#include <optional>

namespace berm::slices {

/// The resistance of soil to a pipe that is dragged sideways, as a curve that springs can have.
struct DragCurve {
  beam::Backbone backbone;
  Index measured = 0;  ///< points before what follows
  Index left_out = 0;  ///< softer than a later one from zero on, where the drag begins, or without resistance
  Index lowered = 0;   ///< after a rise that was steeper than the first
};

/// Drags the pipe of a slice, in a copy of this state of a stage that may be driven otherwise (problem::drive_otherwise), along +x over the travel of `drag` (m) at its speed, under the
/// weight (N/m) and free upwards. H is the work of the soil over the travel in pieces, of a hundredth of the diameter at first and a twentieth later. Empty where stop() says so, which is
/// asked now and then. Throws RunError where the pipe does not get so far.
std::optional<DragCurve> drag_sideways(const problem::Model<2>& model, const problem::State<2>& laid, Real weight,
                                       const settings::SpringsBeside& drag, const std::function<bool()>& stop);

/// The curve through these points that springs can have: its first line is the steepest that goes from zero to a point, points before that one are left out, and where a later line is steeper
/// its point is lowered. Throws RunError where no point has a resistance.
DragCurve curve_through(const std::vector<beam::CurvePoint>& measured);

}  // namespace berm::slices
