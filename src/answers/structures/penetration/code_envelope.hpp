// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/footing_code.hpp"
#include "structures/base/published_envelope.hpp"

namespace berm::penetration {

/// The surface of ISO 19901-4 and API RP 2GEO beside an envelope on clay: V and H without moment and where it slides, V and M without H, H and M at the levels of the sections; and its largest V, H and M.
void add_code_on_clay(const formulas::FoundationBase& base, const formulas::ClayOfFoundation& clay, base::PublishedEnvelope& published);

/// The same on the surface of sand, without sections of H and M. Angle of the interface in rad.
void add_code_on_sand(const formulas::FoundationBase& base, const formulas::SandOfFoundation& sand, Real interface_angle,
                      base::PublishedEnvelope& published);

}  // namespace berm::penetration
