// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// The body that fills each region of the mesh, the first where several do, or none. Throws KeyError where a body fills a region that there is not.
template <int dim>
std::vector<Index> bodies_of_regions(const mesh::Mesh<dim>& mesh, const settings::Case& c);

/// The dashpots of the boundaries that absorb, of a model that has its bodies. Throws KeyError where no soil is at one.
template <int dim>
void add_dashpots(const settings::Case& c, const settings::SupportSets& sets, Model<dim>& model);

}  // namespace berm::problem
