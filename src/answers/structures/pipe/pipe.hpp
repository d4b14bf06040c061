// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/structure.hpp"

namespace berm::pipe {

/// A pipe on or in the bed. Bodies of other shapes that nothing else is known of are read by the same numbers, without the formulas, which are those of a circle.
base::Structure pipe();

}  // namespace berm::pipe
