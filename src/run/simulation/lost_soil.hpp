// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/quadratic_mesh.hpp"
#include "os/error.hpp"

#include <fmt/format.h>

namespace berm::simulation {

/// Strains are small: soil of which a tenth has moved by more than the model is large is not held by anything. Single nodes may: sand without cohesion beside the edge of a footing flows
/// away, and carries nothing. `displacement` by unknown, of which those of the nodes are the first. Throws RunError.
template <int dim>
void refuse_lost_soil(const fem::QuadraticElements<dim>& elements, const mesh::Mesh<dim>& mesh, const std::vector<Real>& displacement,
                      Real time)
{
  constexpr Index tenth = 10;
  const Vec<dim> size = mesh.upper - mesh.lower;
  Index lost = 0;
  for (Index node = 0; node < elements.node_count(); ++node) {
    const Real moved = Eigen::Map<const Vec<dim>>(&displacement[dim * node]).norm();
    if (std::isfinite(moved) && (moved <= size.norm() || tenth * ++lost <= elements.node_count())) continue;
    const Vec<dim>& x = elements.position[node];
    throw RunError(
        fmt::format("t = {:.6g} s: the soil at ({:.4g}, {:.4g}) m has moved by {:.3g} m, and the mesh is {:.3g} m wide and {:.3g} m "
                    "high: it is too soft or too weak for its loads, or not supported",
                    time, x[0], x[1], moved, size[0], size[1]));
  }
}

}  // namespace berm::simulation
