// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/element.hpp"
#include "fem/quadratic_mesh.hpp"
#include "material/material.hpp"

#include <vector>

namespace berm::fem {

/// The water at an integration point of soil through which it flows; no permeability: none flows there.
struct PointWater {
  Real compressibility = 0;  ///< n / K_w, 1/Pa
  Real min_pressure = 0;     ///< Pa, at which it cavitates
  material::Hydraulics hydraulics;
};

/// Entries of the lower triangle of an element's matrix in the rows of its three pressures, row by row: 12 of displacements, then 1, 2, 3 of pressures.
constexpr int pressure_entries = 3 * 12 + 6;

/// Excess pore pressures at the corners of elements through which water flows: they are linear within an element, where displacements are quadratic
/// (Taylor and Hood 1973), so that the pressure has no checkerboard in the undrained limit.
struct FlowModel {
  Index count = 0;                                           ///< of pressures; 0: no water flows
  NodeField<Index> unknown;                                  ///< of each node's pressure, or none
  CellField<std::array<PointWater, triangle_points>> water;  ///< by cell and integration point
  CellField<std::array<Index, pressure_entries>> entries;    ///< in the pattern
  std::vector<NodeField<char>> open;             ///< by set of supports: whether water leaves the soil at the node, at no excess pressure
  std::vector<std::vector<Index>> at_head;       ///< by boundary::Head of the model: the unknowns of the nodes that feel it
  std::vector<std::array<Index, 2>> at_contact;  ///< by contact point: the unknowns whose mean is the pressure there
  Real first_dt = 0;                             ///< s, h^2 / (6 c_v) of the element where it is smallest (Vermeer and Verruijt 1981)

  /// Whether it flows in this cell.
  bool in(Index cell) const { return count > 0 && water[cell][0].hydraulics.permeability > 0; }
};

/// The linear functions of the corners at an integration point.
struct CornerShape {
  std::array<Real, 3> value;
  std::array<Vec<2>, 3> gradient;  ///< 1/m
};
CornerShape corner_shape(const ShapeAtPoint& shape);

/// The volume strain per displacement of the nodes (x, y, x, y, ...), 1/m.
using VolumeStrain = Eigen::Matrix<Real, 12, 1>;
VolumeStrain volume_strain(const ShapeAtPoint& shape);

/// Darcy's flux at an integration point, m/s: -(k / gamma_w) grad p, with the permeability of the porosity that the displacement of the nodes (m) has made, and the
/// pressures at the corners, Pa.
Vec<2> water_flux(const ShapeAtPoint& shape, const PointWater& water, const VolumeStrain& displacement,
                  const std::array<Real, 3>& pressure);

/// The water of an element in an increment.
struct CellFlow {
  std::array<Real, 3> residual{};  ///< m3 per metre run (around an axis per radian), by corner
  Real volume = 0;                 ///< m3: sum of the magnitudes that balance each other
};

/// An element in an increment of dt (s): the values at its nodes and corners before it, and their change.
struct FlowIncrement {
  VolumeStrain moved_before, moved;            ///< m
  std::array<Real, 3> pressure_before, added;  ///< Pa
  Real dt = 0;
};

/// Excess pore pressure at the integration point at the end, Pa.
Real pressure_at_end(const CornerShape& corners, const FlowIncrement& increment);

/// Balance of the water, integrated by backward Euler over the increment; with the functions L_i of the corners
///
///   r_i = -integral of L_i (d tr(e) + (n / K_w) dp) + dt (k / gamma_w) grad L_i . grad p,
///
/// so that the matrix with the equilibrium of forces is symmetric. k is that of the porosity before.
CellFlow water_balance(const std::array<ShapeAtPoint, triangle_points>& shapes, const std::array<PointWater, triangle_points>& water,
                       const FlowIncrement& increment);

/// Its derivatives, in the order of `pressure_entries`.
std::array<Real, pressure_entries> balance_derivatives(const std::array<ShapeAtPoint, triangle_points>& shapes,
                                                       const std::array<PointWater, triangle_points>& water,
                                                       const FlowIncrement& increment);

}  // namespace berm::fem
