// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"

namespace berm::run_folder {

/// Strain from a deformation gradient.
struct GradientStrain {
  Real deviatoric = 0;  ///< equivalent_deviatoric_strain of the logarithmic strain: 2/sqrt(3) asinh(gamma/2) in a simple shear of gamma
  Real volumetric = 0;  ///< ln det F, expansion positive
};

/// Of the logarithmic (Hencky) strain 1/2 ln(F^T F) of F = dx/dX; in the plane `across` is the stretch along z: 1 in plane strain, the radius over the first
/// one around an axis. Zero where F is a rotation, the same for F and
/// R F with any rotation R. Principal stretches count as no more than 1000 and no less than 1/1000, so that any F has a strain, one that is
/// singular or turned inside out too.
template <int dim>
GradientStrain gradient_strain(const Matrix<dim>& deformation, Real across = 1);

/// The gradient of a displacement that is known at points of a mesh. Each node fits a linear field to the points of its cells, by least squares with N_i as
/// weights; a place has the mean of its cell's nodes, with N_i as weights: exact where the displacement is linear. A node whose points do
/// not tell a gradient (too few, or in line) does not count. Sums are made in the order in which points are added. Points of one cell that follow each
/// other are faster.
template <int dim>
class NodalGradient {
public:
  explicit NodalGradient(const mesh::Mesh<dim>& mesh);

  /// A point at x (m) in `cell` that is displaced by u (m).
  void add(Index cell, const Vec<dim>& x, const Vec<dim>& u);
  /// To be called once, after the last point.
  void fit();
  /// du/dx at x in `cell`; zero where no node of the cell has a gradient.
  Matrix<dim> at(Index cell, const Vec<dim>& x);

private:
  /// Sums over points with weights w, d = x - x_i; once fitted wud is the gradient and w is 1, or 0 where there is none.
  struct Node {
    Real w;
    Vec<dim> wd, wu;
    Matrix<dim> wdd, wud;
  };

  /// N_k(x) of the cell's corners, at least 0: a particle may be outside of its cell by rounding.
  std::array<Real, dim + 1> weights(Index cell, const Vec<dim>& x);

  const mesh::Mesh<dim>& mesh_;
  NodeField<Node> nodes_;
  Index cell_ = none;
  mesh::Shape<dim> shape_;  ///< of cell_
};

}  // namespace berm::run_folder
