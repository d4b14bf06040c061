// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/particles.hpp"

namespace berm::bodies {

/// The position of one particle of a block, m.
template <int dim>
Vec<dim> position_of(const Block<dim>& block, int lane)
{
  Vec<dim> x;
  for (int d = 0; d < dim; ++d) x[d] = block.x[d][lane];
  return x;
}

}  // namespace berm::bodies
