// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"
#include "structures/base/published_envelope.hpp"
#include "structures/penetration/penetration.hpp"

namespace berm::penetration {

/// A footing or plate, strip or round: q = V over its area, N_c = (q - sigma_v0)/s_u on clay, N_gamma = 2 (q - sigma_v0)/(gamma' D) on sand; beside what any push and drag have.
const penetration::Reading& footing_reading();

class Footing : public penetration::Penetration {
public:
  Footing() : Penetration(footing_reading()) {}

  base::EmbeddedBody embedded(const problem::Case& c) const override;
  base::PublishedEnvelope published_envelope(const problem::Case& c, const base::EnvelopeEnds& ends) const override;
};

/// rad: sand whose angles of friction and dilation differ by less has associated flow.
inline constexpr Real associated = 1e-3;

/// The footing that the case drives. Throws InputError around an axis, where a plane of symmetry forbids to drag and turn it, where its base is not flat, or lies above the bed
/// or beyond the walls.
base::EmbeddedBody embedded_footing(const problem::Case& c);

/// For a footing on uniform clay: of a strip Green's V and H, and the moments on its effective width; of a round one its V; the H at which any slides. For associated sand V alone.
base::PublishedEnvelope footing_envelope(const problem::Case& c);

}  // namespace berm::penetration
