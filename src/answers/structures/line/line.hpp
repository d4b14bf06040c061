// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/structure.hpp"

namespace berm::line {

/// A pipeline on slices of soil: what its line does under each of its loads.
base::Structure pipeline();

}  // namespace berm::line
