// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Of all bodies, at the nodes that contacts moved in the last step; kg/m or kg.
template <int dim>
Real contact_mass(const Workspace<dim>& workspace)
{
  Real mass = 0;
  for (const BodyGrid<dim>& grid : workspace.grids)
    for (const Index node : grid.nodes)
      if (grid.contact_points[node] != 0) mass += grid.mass[node];
  return mass;
}

}  // namespace berm::mpm
