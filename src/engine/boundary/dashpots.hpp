// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/fields.hpp"
#include "core/types.hpp"

#include <Eigen/LU>
#include <vector>

namespace berm::boundary {

/// Nodes of a boundary that takes up the waves which come to it. The boundary pulls at a node with
///
///   F = F_rest - C v,   C = sum A rho (c_p n n^T + c_s (I - n n^T)),
///
/// A the node's part of the boundary, n its normal, rho, c_p and c_s density and wave speeds of the soil there: a plane wave that comes along n leaves without
/// reflection (Lysmer and Kuhlemeyer 1969). F_rest is what held the node when the boundary last did.
template <int dim>
struct Dashpots {
  NodeField<Index> of_node;              ///< into `resistance`, or none; empty where no boundary absorbs
  std::vector<Matrix<dim>> resistance;   ///< C, N s/m, of the directions that the supports name
  std::vector<std::uint8_t> directions;  ///< bit d: direction d is one of these

  bool any() const { return of_node.size() > 0; }
};

/// The acceleration, m/s2, of a node with this inertia by direction (kg) under a force (N) and F_rest, with F at the middle of the step.
template <int dim>
Vec<dim> acceleration_with(const Matrix<dim>& resistance, const Vec<dim>& inertia, const Vec<dim>& force, const Vec<dim>& v, Real dt)
{
  const Matrix<dim> whole = Matrix<dim>(inertia.asDiagonal()) + 0.5 * dt * resistance;
  return whole.inverse() * (force - resistance * v);
}

}  // namespace berm::boundary
