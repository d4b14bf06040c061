// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/gradient_strain.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace berm::run_folder {

namespace {

/// The principal stretches: the singular values of F.
Vec<2> stretches(const Matrix<2>& f)
{
  const Real turning = std::hypot(f(0, 0) + f(1, 1), f(1, 0) - f(0, 1)) / 2, rest = std::hypot(f(0, 0) - f(1, 1), f(1, 0) + f(0, 1)) / 2;
  return {turning + rest, std::abs(turning - rest)};
}
Vec<3> stretches(const Matrix<3>& f)
{
  const Eigen::Matrix3d squares = f.transpose() * f;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(squares, Eigen::EigenvaluesOnly).eigenvalues().cwiseMax(0).cwiseSqrt();
}

}  // namespace

template <int dim>
GradientStrain gradient_strain(const Matrix<dim>& deformation, Real across)
{
  constexpr Real max_stretch = 1000;
  const Vec<dim> stretch = stretches(deformation);
  SymTensor<dim> strain{};
  const auto logarithmic = [&](Real of) { return std::log(std::clamp(of, 1 / max_stretch, max_stretch)); };
  for (int d = 0; d < dim; ++d) strain[d] = logarithmic(stretch[d]);
  if constexpr (dim == 2) strain[2] = logarithmic(across);
  return {equivalent_deviatoric_strain(strain), trace(strain)};
}

template <int dim>
NodalGradient<dim>::NodalGradient(const mesh::Mesh<dim>& mesh) : mesh_(mesh),
                                                                 nodes_(NodeField<Node>::zeros(mesh.node_count()))
{
}

template <int dim>
std::array<Real, dim + 1> NodalGradient<dim>::weights(Index cell, const Vec<dim>& x)
{
  if (cell != cell_) shape_ = mesh_.shape(cell_ = cell);
  std::array<Real, dim + 1> n;
  for (int k = 0; k <= dim; ++k) n[k] = std::max(Real(0), shape_.value(k, x));
  return n;
}

template <int dim>
void NodalGradient<dim>::add(Index cell, const Vec<dim>& x, const Vec<dim>& u)
{
  const auto n = weights(cell, x);
  for (int k = 0; k <= dim; ++k) {
    const Index i = mesh_.nodes[cell][k];
    const Real w = n[k];
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
  constexpr Real min_determinant = 1e-4;
  for (Node& node : nodes_) {
    if (!(node.w > 0)) continue;
    const Matrix<dim> spread = node.wdd - node.wd * node.wd.transpose() / node.w;
    const bool all_round = spread.determinant() > min_determinant * std::pow(spread.trace() / dim, dim);
    if (all_round) node.wud = ((node.wud - node.wu * node.wd.transpose() / node.w) * spread.inverse()).eval();
    node.w = all_round ? 1 : 0;
  }
}

template <int dim>
Matrix<dim> NodalGradient<dim>::at(Index cell, const Vec<dim>& x)
{
  const auto n = weights(cell, x);
  Matrix<dim> sum = Matrix<dim>::Zero();
  Real all = 0;
  for (int k = 0; k <= dim; ++k) {
    const Node& node = nodes_[mesh_.nodes[cell][k]];
    if (!(node.w > 0)) continue;
    sum += n[k] * node.wud;
    all += n[k];
  }
  return all > 0 ? Matrix<dim>(sum / all) : Matrix<dim>(Matrix<dim>::Zero());
}

template GradientStrain gradient_strain<2>(const Matrix<2>&, Real);
template GradientStrain gradient_strain<3>(const Matrix<3>&, Real);
template class NodalGradient<2>;
template class NodalGradient<3>;

}  // namespace berm::run_folder
