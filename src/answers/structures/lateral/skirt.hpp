// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/lateral/shaft.hpp"

namespace berm::lateral {

/// A body that is open below: the skirt of a footing, a caisson, a pipe pile. q_b = V over the area of its tip, the ring, without the friction of both faces; factors as of a pile.
const penetration::Reading& skirt_reading();

class Skirt : public lateral::Shaft {
public:
  Skirt() : Shaft(skirt_reading()) {}

  std::string in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const override;
  base::TrustMeasures measures(const problem::Case& c) const override;
};

}  // namespace berm::lateral
