// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/tensor.hpp"
#include "fem/element.hpp"

namespace berm::fem {

/// A rotation of the soil, counter-clockwise: cosine and sine of twice its angle, by which the components of a stress turn.
struct Rotation {
  Real cosine = 1, sine = 0;
};

/// An element in an increment of large deformations (updated Lagrange): strain and spin are those of the displacement over the configuration in the middle of
/// the increment, so that a rotation gives no strain (Hughes and Winget 1980); forces act in that at its end.
struct MovedCell {
  std::array<ShapeAtPoint, triangle_points> middle, end;
  std::array<Rotation, triangle_points> rotation;
  bool inverted = false;  ///< an integration point has no area left; the rest is then not set
};

/// `nodes` (m) at the start of the increment, `change` their displacement in it.
MovedCell move_cell(const AtSixNodes<Vec<2>>& nodes, const AtSixNodes<Vec<2>>& change, mesh::Metric metric);

/// A stress that rotates with the soil.
SymTensor<2> rotated(const SymTensor<2>& stress, const Rotation& rotation);

}  // namespace berm::fem
