// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/penetration_run.hpp"

namespace berm::penetration {

/// A body that is pushed down and read as a site investigation reads it: resistance over an area against depth, a factor of it, and whether it is steady.
base::Reading reading(const Penetrometer& how);

/// What such a body has in common with any driven body: ends of pushes, drags, charts; where it keeps its push, all of its drags.
base::Reading travels_of(const Penetrometer& how);

/// A structure that is read by both.
base::Structure pushed_down(const Penetrometer& how);

}  // namespace berm::penetration
