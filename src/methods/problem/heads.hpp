// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// The heads of the water outside of supports, and the nodes that feel them, of a model that has its mesh. Throws KeyError where no soil is at the boundary, and
/// where the support does not hold it along its normal.
template <int dim>
void add_heads(const settings::Case& c, Model<dim>& model);

/// The part of the boundary of a head that each of its nodes has, m (per metre run) or m2, along the normal into the soil.
template <int dim>
std::vector<Vec<dim>> areas_of_head(const settings::Case& c, const Model<dim>& model, const boundary::NodalCondition<dim>& head);

}  // namespace berm::problem
