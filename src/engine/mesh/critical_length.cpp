// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/critical_length.hpp"

#include <Eigen/Eigenvalues>

#include <random>

namespace berm::mesh {
namespace {

using VectorX = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// M^-1/2 K M^-1/2 of a mesh of full cells of elastic material, 1/m2: modulus of pressure waves and density are 1.
template <int dim>
class Stiffness {
public:
  Stiffness(const Mesh<dim>& mesh, const Patches& patches, Real shear)
      : mesh_(mesh),
        patches_(patches),
        directions_(mesh.metric == Metric::axisymmetric ? 3 : dim),
        shear_(shear),
        bulk_(1 - 2 * shear * (1 - 1 / directions_)),
        inverse_root_(VectorX::Zero(mesh.node_count())),
        moved_(VectorX::Zero(unknowns())),
        volume_change_(mesh.cell_count())
  {
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      for (int k = 0; k <= dim; ++k) inverse_root_[mesh.nodes[cell][k]] += mesh.volume(cell) * mass_share(cell, k);
    for (Real& of_node : inverse_root_)
      if (of_node > 0) of_node = 1 / std::sqrt(of_node);
  }

  Index unknowns() const { return dim * mesh_.node_count(); }

  /// The product with x.
  void multiply(const VectorX& x, VectorX& product)
  {
    for (Index node = 0; node < mesh_.node_count(); ++node)
      moved_.template segment<dim>(dim * node) = inverse_root_[node] * x.template segment<dim>(dim * node);
    for (Index cell = 0; cell < mesh_.cell_count(); ++cell)
      volume_change_[cell] = mesh_.volume(cell) * strain_of(cell, mesh_.shape(cell)).trace();
    share_volume_change();
    product.setZero();
    for (Index cell = 0; cell < mesh_.cell_count(); ++cell) {
      const Shape<dim> shape = mesh_.shape(cell);
      const Strain strain = strain_of(cell, shape);
      const Real volume = mesh_.volume(cell), mean = strain.trace() / directions_;
      Matrix<dim> stress = 2 * shear_ * strain.in_plane;
      stress.diagonal().array() += bulk_ * volume_change_[cell] - 2 * shear_ * mean;
      const Real hoop = bulk_ * volume_change_[cell] + 2 * shear_ * (strain.hoop - mean);
      for (int k = 0; k <= dim; ++k) {
        Vec<dim> force = volume * (stress * shape.gradient(k));
        if (mesh_.metric == Metric::axisymmetric) force[0] += volume * hoop / radii(cell);
        product.template segment<dim>(dim * mesh_.nodes[cell][k]) += inverse_root_[mesh_.nodes[cell][k]] * force;
      }
    }
  }

private:
  struct Strain {
    Matrix<dim> in_plane = Matrix<dim>::Zero();
    Real hoop = 0;

    Real trace() const { return in_plane.trace() + hoop; }
  };

  Real radii(Index cell) const
  {
    Real sum = 0;
    for (const Index node : mesh_.nodes[cell]) sum += mesh_.position[node][0];
    return sum;
  }
  /// The part of a cell's mass that a corner has: the integral of its shape function.
  Real mass_share(Index cell, int corner) const
  {
    if (mesh_.metric != Metric::axisymmetric) return Real(1) / (dim + 1);
    return (1 + mesh_.position[mesh_.nodes[cell][corner]][0] / radii(cell)) / 4;
  }
  Strain strain_of(Index cell, const Shape<dim>& shape) const
  {
    Strain strain;
    for (int k = 0; k <= dim; ++k) {
      const Vec<dim> u = moved_.template segment<dim>(dim * mesh_.nodes[cell][k]);
      strain.in_plane += u * shape.gradient(k).transpose();
      if (mesh_.metric == Metric::axisymmetric) strain.hoop += u[0] / radii(cell);
    }
    strain.in_plane = (strain.in_plane + strain.in_plane.transpose().eval()) / 2;
    return strain;
  }
  /// From the changes of the cells' volumes to the relative ones of their patches.
  void share_volume_change()
  {
    for (Index last = 0; last < mesh_.cell_count(); ++last) {
      if (patches_[last] > last) continue;  // each patch once, at the last of its cells
      Real volume = 0, change = 0;
      for_each_in_patch(patches_, last, [&](Index member) {
        volume += mesh_.volume(member);
        change += volume_change_[member];
      });
      for_each_in_patch(patches_, last, [&](Index member) { volume_change_[member] = change / volume; });
    }
  }

  const Mesh<dim>& mesh_;
  const Patches& patches_;
  Real directions_;  ///< with a strain of their own
  Real shear_, bulk_;
  VectorX inverse_root_;  ///< of the nodes' masses; 0 of nodes without cells
  VectorX moved_;         ///< displacements, m
  std::vector<Real> volume_change_;
};

/// Random numbers that are large where cells are small: there the shortest wave is.
template <int dim>
VectorX first_guess(const Mesh<dim>& mesh)
{
  NodeField<Real> weight(mesh.node_count(), 0);
  Real smallest = infinity;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) smallest = std::min(smallest, mesh.height(cell));
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const Index node : mesh.nodes[cell]) weight[node] = std::max(weight[node], std::pow(smallest / mesh.height(cell), 4));
  std::mt19937 random;  // the same numbers each time
  VectorX guess(dim * mesh.node_count());
  for (Index k = 0; k < guess.size(); ++k) guess[k] = weight[k / dim] * (static_cast<Real>(random()) / std::mt19937::max() - 0.5);
  return guess.normalized();
}

}  // namespace

template <int dim>
Real critical_length(const Mesh<dim>& mesh, const Patches& patches, Real shear_ratio)
{
  constexpr int max_steps = 100;
  constexpr Real tolerance = 0.01;
  Stiffness<dim> stiffness(mesh, patches, shear_ratio);
  VectorX here = first_guess<dim>(mesh), before = VectorX::Zero(here.size()), next(here.size());
  VectorX diagonal(max_steps), beside(max_steps);
  for (int n = 0;; ++n) {
    stiffness.multiply(here, next);
    diagonal[n] = next.dot(here);
    next -= diagonal[n] * here;
    if (n > 0) next -= beside[n - 1] * before;
    beside[n] = next.norm();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>> ritz;
    ritz.computeFromTridiagonal(diagonal.head(n + 1), beside.head(n));
    const Real largest = ritz.eigenvalues()[n], error = beside[n] * std::abs(ritz.eigenvectors()(n, n));
    if (error <= tolerance * largest || n + 1 == max_steps) return 2 / std::sqrt(largest + error);
    before = here;
    here = next / beside[n];
  }
}

template Real critical_length(const Mesh<2>&, const Patches&, Real);
template Real critical_length(const Mesh<3>&, const Patches&, Real);

}  // namespace berm::mesh
