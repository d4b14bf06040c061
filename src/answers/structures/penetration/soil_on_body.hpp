// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/frame_reader.hpp"
#include "structures/penetration/penetration_run.hpp"

namespace berm::penetration {

/// What the soil that lies on a body in the frame at the end of its push weighs over its area, Pa: that above the level z within the area, as unit weight there. NaN
/// where no frame tells it, and in space.
Real backflow_pressure(const PenetrationRun& run);

/// How much of the soil's place above a body is filled: of the squares of width/12 within width/4 of its axis at `x`, up to half a width above its `top` (m), the part in
/// which a point of the soil lies. 0 under an open cavity, 1 where the soil has closed.
Real soil_above(const run_folder::SavedSoil& soil, Real x, Real top, Real width);

/// The same in the frame at the end of the push; NaN where no frame tells it, in space, and in the finite element method.
Real soil_above_at_end(const PenetrationRun& run);

/// The part of that place which is filled where soil flows around a body in full.
constexpr Real closed_soil = 0.75;

}  // namespace berm::penetration
