// SPDX-License-Identifier: BSD-3-Clause
#include "output/gradient_strain.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace berm {

template <int dim>
GradientStrain gradient_strain(const Matrix<dim>& deformation)
{
  constexpr Real most_stretch = 1000, most_square = most_stretch * most_stretch;
  using Square = Eigen::Matrix<Real, dim, dim>;
  const Square squares = deformation.transpose() * deformation;
  const Eigen::SelfAdjointEigenSolver<Square> axes(squares, Eigen::EigenvaluesOnly);
  SymTensor<dim> strain{};
  for (int d = 0; d < dim; ++d) strain[d] = std::log(std::clamp(axes.eigenvalues()[d], 1 / most_square, most_square)) / 2;
  return {equivalent_deviatoric_strain(strain), trace(strain)};
}

template <int dim>
NodalGradient<dim>::NodalGradient(const Mesh<dim>& mesh) : mesh_(mesh),
                                                           nodes_(NodeField<Node>::zeros(mesh.node_count()))
{
}

template <int dim>
void NodalGradient<dim>::add(Index cell, const Vec<dim>& x, const Vec<dim>& u)
{
  const Shape<dim> shape = mesh_.shape(cell);
  for (int k = 0; k <= dim; ++k) {
    const Index i = mesh_.nodes[cell][k];
    const Real w = std::max(Real(0), shape.value(k, x));
    const Vec<dim> d = x - mesh_.position[i];
    Node& node = nodes_[i];
    node.w += w;
    node.wd += w * d;
    node.wu += w * u;
    node.wdd += w * d * d.transpose();
    node.wud += w * u * d.transpose();
  }
}

template <int dim>
void NodalGradient<dim>::fit()
{
  // Of the determinant that points all round would have: of points almost in line, the noise across would be the gradient.
  constexpr Real least_determinant = 1e-4;
  for (Node& node : nodes_) {
    if (!(node.w > 0)) continue;
    const Matrix<dim> spread = node.wdd - node.wd * node.wd.transpose() / node.w;
    const bool all_round = spread.determinant() > least_determinant * std::pow(spread.trace() / dim, dim);
    if (all_round) node.wud = ((node.wud - node.wu * node.wd.transpose() / node.w) * spread.inverse()).eval();
    node.w = all_round ? 1 : 0;
  }
}

template <int dim>
Matrix<dim> NodalGradient<dim>::at(Index cell, const Vec<dim>& x) const
{
  const Shape<dim> shape = mesh_.shape(cell);
  Matrix<dim> sum = Matrix<dim>::Zero();
  Real weights = 0;
  for (int k = 0; k <= dim; ++k) {
    const Node& node = nodes_[mesh_.nodes[cell][k]];
    if (!(node.w > 0)) continue;
    const Real w = std::max(Real(0), shape.value(k, x));
    sum += w * node.wud;
    weights += w;
  }
  return weights > 0 ? Matrix<dim>(sum / weights) : Matrix<dim>(Matrix<dim>::Zero());
}

template GradientStrain gradient_strain<2>(const Matrix<2>&);
template GradientStrain gradient_strain<3>(const Matrix<3>&);
template class NodalGradient<2>;
template class NodalGradient<3>;

}  // namespace berm
