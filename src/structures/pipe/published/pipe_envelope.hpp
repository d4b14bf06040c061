// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"
#include "structures/base/published_envelope.hpp"

namespace berm::pipe {

/// The pipe that the case drives. Throws InputError where the case is not plane, drives no circle, or the pipe lies above the bed or beyond the walls.
base::EmbeddedBody embedded_pipe(const problem::Case& c);

/// For clay (Mohr-Coulomb without friction) the fits for a pipe wished in place, the buoyancy gamma' A of the clay that it takes the place of added
/// to V. For sand (without cohesion) the tabulated V_max, and a parabola (YieldSurface) fitted to the probes' ends with their own V_max. Formulas
/// that are only recalled are not among them.
base::PublishedEnvelope pipe_envelope(const problem::Case& c, const base::EnvelopeEnds& ends);

}  // namespace berm::pipe
