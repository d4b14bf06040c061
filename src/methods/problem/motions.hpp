// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// The motions of the supports, and the nodes that follow them, of a model that has its mesh. A node that several supports hold in one direction follows the first
/// of the case that moves. Throws KeyError where the axis or a plane of symmetry holds a node that is to move.
template <int dim>
void add_motions(const settings::Case& c, Model<dim>& model);

}  // namespace berm::problem
