// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/trust_measure.hpp"

namespace berm::base {

/// The largest cell below the flat base of the main rigid body, m, where the mesh is a seabed in the plane whose fine zone does not reach below all of it; NaN elsewhere.
Real largest_cell_below(const settings::Case& c);

/// Judges those cells, in soil whose strength grows by a quarter or more within a quarter of the body's width below it: there the soil below the middle of the body carries as much as that at its edge.
TrustMeasure cells_below(const std::string& body);

}  // namespace berm::base
