// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// Refuses motions of supports that make no sense by themselves.
void check_motions(Describe& d, const Case& c);

/// What is wrong with the motion of a support, of which no file is left to read: "KEY: MESSAGE" with the key below the motion; "" where nothing is.
std::string fault_of_motion(const Case& c, const boundary::SupportSettings& support);

/// The motions of the supports, and the nodes that follow them, of a model that has its mesh. A node that several supports hold in one direction follows the first
/// of the case that moves. Throws KeyError where the axis or a plane of symmetry holds a node that is to move.
template <int dim>
void add_motions(const Case& c, Model<dim>& model);

}  // namespace berm::problem
