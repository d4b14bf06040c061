// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/penetration.hpp"

namespace berm::footing {

/// A footing or plate, strip or round: q = V over its area, N_c = (q - sigma_v0)/s_u on clay, N_gamma = 2 (q - sigma_v0)/(gamma' D) on sand; beside what any push and drag have.
const penetration::Reading& reading();

class Footing : public penetration::Penetration {
public:
  Footing() : Penetration(reading()) {}

  base::EmbeddedBody embedded(const problem::Case& c) const override;
  base::PublishedEnvelope published_envelope(const problem::Case& c, const base::EnvelopeEnds& ends) const override;
};

}  // namespace berm::footing
