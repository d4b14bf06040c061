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
/// reflection (Lysmer and Kuhlemeyer 1969). F_rest is what held the node when the boundary last did. A wave of velocity v_in that comes in from outside along n
/// adds 2 C v_in (Joyner and Chen 1975).
template <int dim>
struct Dashpots {
  NodeField<Index> of_node;              ///< into `resistance`, or none; empty where no boundary absorbs
  std::vector<Matrix<dim>> resistance;   ///< C, N s/m, of the directions that the supports name
  std::vector<std::uint8_t> directions;  ///< bit d: direction d is one of these
  /// By motion of the model: the part of C that the supports have through which its wave comes in; none where that does not absorb here.
  std::vector<std::vector<Matrix<dim>>> incoming;

  bool any() const { return of_node.size() > 0; }
  /// 2 C v_in at the index of a node, N, of these velocities of the motions, m/s.
  Vec<dim> incoming_force(Index index, const std::vector<Vec<dim>>& velocity) const
  {
    Vec<dim> force = Vec<dim>::Zero();
    for (std::size_t m = 0; m < incoming.size(); ++m)
      if (!incoming[m].empty()) force += 2 * incoming[m][static_cast<std::size_t>(index)] * velocity[m];
    return force;
  }
};

/// The acceleration, m/s2, of a node with this inertia by direction (kg) under a force (N) and F_rest, with F at the middle of the step.
template <int dim>
Vec<dim> acceleration_with(const Matrix<dim>& resistance, const Vec<dim>& inertia, const Vec<dim>& force, const Vec<dim>& v, Real dt)
{
  const Matrix<dim> whole = Matrix<dim>(inertia.asDiagonal()) + 0.5 * dt * resistance;
  return whole.inverse() * (force - resistance * v);
}

}  // namespace berm::boundary
