// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sanity/scene.hpp"

namespace berm::sanity {

/// Gives a scene what tells where rigid bodies are thin, and in which cells and soil; cells: those that each body takes at the start.
template <int dim>
void look_for_thin_places(const problem::Model<dim>& model, const std::vector<std::vector<Index>>& cells, Scene& scene);

}  // namespace berm::sanity
