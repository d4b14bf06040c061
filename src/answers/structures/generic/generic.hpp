// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/structure.hpp"

namespace berm::generic {

/// What is looked at in any run, whatever it is of.
base::TrustMeasures measures_of_any_run(const settings::Case& c);

}  // namespace berm::generic
