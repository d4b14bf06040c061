// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "problem/model.hpp"

namespace berm::problem {

/// The whole state, bit for bit. Reading puts it into one that was built for the same case: bodies, particles, rigid bodies and contacts
/// must be as many. Throws RunError where they are not, or where what is read cannot be a state of this model.
template <int dim>
void archive(Archive& k, const Model<dim>& model, State<dim>& state);

/// Where a rigid body is.
template <int dim>
void archive(Archive& k, bodies::Pose<dim>& pose);

}  // namespace berm::problem
