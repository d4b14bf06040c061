// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"
#include "structures/base/published_envelope.hpp"

namespace berm::penetration {

/// rad: sand whose angles of friction and dilation differ by less has associated flow.
inline constexpr Real associated = 1e-3;

/// The footing that the case drives. Throws InputError around an axis, where a plane of symmetry forbids to drag and turn it, where its base is not flat, or lies above the bed
/// or beyond the walls.
base::EmbeddedBody embedded_footing(const settings::Case& c);

/// For a footing on uniform clay: of a strip Green's V and H, and the moments on its effective width; of a round one its V; the H at which any slides. For associated sand V. The surface of ISO 19901-4 of
/// all, on a level bed: in clay whose strength may grow, to a depth of a width; on the surface of sand.
base::PublishedEnvelope footing_envelope(const settings::Case& c);

}  // namespace berm::penetration
