// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// The depth of soil whose cells have these corners, m: the greatest below ground that is not level, else from the highest to the lowest.
template <int dim>
Real depth_of_soil(const Model<dim>& model, const std::vector<Vec<dim>>& corners);

/// safety.movement, or by default the displacement of soil that has failed, m:
///
///   L / 100 + 2 int_0^l (density g z + q) / E dz,
///
/// L the height that can slide: the relief of ground that is not level, or the width of the rigid body on level ground, at most the depth of the soil; l = L, or the whole depth where some soil begins
/// without stress and is compressed by its weight; q the pressure of the largest load. Of several bodies the largest. A slide that began with F too large by x stops after about x L, so that L / 100 is an error of about 1 %.
template <int dim>
Real movement_at_failure(const settings::Case& c, const Model<dim>& model, Real depth);

}  // namespace berm::problem
