// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/trust_measure.hpp"

namespace berm::pipe {

/// What is looked at in a run of a case, in the order of the page.
base::TrustMeasures pipe_measures(const problem::Case& c, const base::Limit* of_cells = nullptr);

}  // namespace berm::pipe
