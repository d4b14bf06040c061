// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sanity/scene.hpp"

namespace berm::sanity {

/// How the stages move the bodies that they drive, as far as the input says it. Where a free body goes in a stage that does not drive it is not known.
template <int dim>
std::vector<Way> ways_of(const problem::Model<dim>& model);

}  // namespace berm::sanity
