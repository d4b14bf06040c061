// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/critical_length.hpp"

#include <algorithm>
#include <random>
#include <utility>

namespace berm::mesh {
namespace {

/// One unknown for each direction of a node. Sums are plain loops: those of Eigen's long vectors depend on where their memory begins, and all runs must find the
/// same length.
template <int dim>
using Unknowns = NodeField<Vec<dim>>;

template <int dim>
Real dot(const Unknowns<dim>& a, const Unknowns<dim>& b)
{
  Real sum = 0;
  for (Index node = 0; node < a.size(); ++node) sum += a[node].dot(b[node]);
  return sum;
}

template <int dim>
void multiply(Unknowns<dim>& x, Real by)
{
  for (Vec<dim>& of_node : x) of_node *= by;
}

template <int dim>
void subtract(Unknowns<dim>& from, Real times, const Unknowns<dim>& x)
{
  for (Index node = 0; node < x.size(); ++node) from[node] -= times * x[node];
}

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
        inverse_root_(mesh.node_count(), 0),
        moved_(mesh.node_count(), Vec<dim>::Zero()),
        volume_change_(mesh.cell_count())
  {
    cells_.reserve(mesh.cell_count());
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
      cells_.push_back({mesh.shape(cell), mesh.volume(cell)});
      for (int k = 0; k <= dim; ++k) inverse_root_[mesh.nodes[cell][k]] += cells_[cell].volume * mass_share(cell, k);
    }
    for (Real& of_node : inverse_root_)
      if (of_node > 0) of_node = 1 / std::sqrt(of_node);
  }

  /// The product with x.
  void apply(const Unknowns<dim>& x, Unknowns<dim>& product)
  {
    for (Index node = 0; node < mesh_.node_count(); ++node) moved_[node] = inverse_root_[node] * x[node];
    for (Index cell = 0; cell < mesh_.cell_count(); ++cell) volume_change_[cell] = cells_[cell].volume * strain_of(cell).trace();
    share_volume_change();
    product.assign(mesh_.node_count(), Vec<dim>::Zero());
    for (Index cell = 0; cell < mesh_.cell_count(); ++cell) {
      const auto& [shape, volume] = cells_[cell];
      const Strain strain = strain_of(cell);
      const Real mean = strain.trace() / directions_;
      Matrix<dim> stress = 2 * shear_ * strain.in_plane;
      stress.diagonal().array() += bulk_ * volume_change_[cell] - 2 * shear_ * mean;
      const Real hoop = bulk_ * volume_change_[cell] + 2 * shear_ * (strain.hoop - mean);
      for (int k = 0; k <= dim; ++k) {
        Vec<dim> force = volume * (stress * shape.gradient(k));
        if (mesh_.metric == Metric::axisymmetric) force[0] += volume * hoop / radii(cell);
        product[mesh_.nodes[cell][k]] += inverse_root_[mesh_.nodes[cell][k]] * force;
      }
    }
  }

private:
  struct CellShape {
    Shape<dim> shape;
    Real volume;
  };
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
  Strain strain_of(Index cell) const
  {
    const Shape<dim>& shape = cells_[cell].shape;
    Strain strain;
    for (int k = 0; k <= dim; ++k) {
      const Vec<dim>& u = moved_[mesh_.nodes[cell][k]];
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
        volume += cells_[member].volume;
        change += volume_change_[member];
      });
      for_each_in_patch(patches_, last, [&](Index member) { volume_change_[member] = change / volume; });
    }
  }

  const Mesh<dim>& mesh_;
  const Patches& patches_;
  Real directions_;  ///< with a strain of their own
  Real shear_, bulk_;
  std::vector<CellShape> cells_;
  NodeField<Real> inverse_root_;   ///< of the nodes' masses; 0 of nodes without cells
  Unknowns<dim> moved_;            ///< displacements, m
  CellField<Real> volume_change_;  ///< m3; then that of the patch over its volume
};

/// Random numbers that are large where cells are small: there the shortest wave is.
template <int dim>
Unknowns<dim> first_guess(const Mesh<dim>& mesh)
{
  NodeField<Real> weight(mesh.node_count(), 0);
  Real smallest = infinity;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) smallest = std::min(smallest, mesh.height(cell));
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const Index node : mesh.nodes[cell]) weight[node] = std::max(weight[node], std::pow(smallest / mesh.height(cell), 4));
  std::mt19937 random;  // the same numbers each time
  Unknowns<dim> guess(mesh.node_count(), Vec<dim>::Zero());
  for (Index node = 0; node < mesh.node_count(); ++node)
    for (Real& x : guess[node]) x = weight[node] * (static_cast<Real>(random()) / std::mt19937::max() - 0.5);
  multiply<dim>(guess, 1 / std::sqrt(dot<dim>(guess, guess)));
  return guess;
}

/// An eigenvalue, and the magnitude of the last component of its vector of length 1.
struct Pair {
  Real value, last;
};

/// The largest eigenvalue of a symmetric matrix with these numbers on its diagonal and beside it, by bisection: x is above all of them where all pivots of the
/// matrix less x are negative (Sylvester's law of inertia).
Pair largest_pair(const std::vector<Real>& diagonal, const std::vector<Real>& beside)
{
  const std::size_t size = diagonal.size();
  std::vector<Real> pivots(size);
  const auto is_above = [&](Real x) {
    for (std::size_t k = 0; k < size; ++k) {
      pivots[k] = diagonal[k] - x - (k > 0 ? beside[k - 1] * beside[k - 1] / pivots[k - 1] : 0);
      if (!(pivots[k] < 0)) return false;
    }
    return true;
  };
  Real low = *std::max_element(diagonal.begin(), diagonal.end()), high = low;
  for (std::size_t k = 0; k < size; ++k) high = std::max(high, diagonal[k] + (k > 0 ? beside[k - 1] : 0) + (k + 1 < size ? beside[k] : 0));
  high *= 1 + 1e-12;
  for (Real middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2) (is_above(middle) ? high : low) = middle;
  is_above(high);
  Real component = 1, squares = 1;
  for (std::size_t k = 0; k + 1 < size; ++k) {
    component *= -pivots[k] / beside[k];
    squares += component * component;
  }
  return {high, std::abs(component) / std::sqrt(squares)};
}

}  // namespace

template <int dim>
Real critical_length(const Mesh<dim>& mesh, const Patches& patches, Real shear_ratio)
{
  constexpr std::size_t max_steps = 100;
  constexpr Real tolerance = 0.01;
  Stiffness<dim> stiffness(mesh, patches, shear_ratio);
  Unknowns<dim> here = first_guess(mesh), before(mesh.node_count(), Vec<dim>::Zero()), next = before;
  std::vector<Real> diagonal, beside;
  for (;;) {
    stiffness.apply(here, next);
    diagonal.push_back(dot<dim>(next, here));
    subtract<dim>(next, diagonal.back(), here);
    if (!beside.empty()) subtract<dim>(next, beside.back(), before);
    const Real left = std::sqrt(dot<dim>(next, next));
    const Pair largest = largest_pair(diagonal, beside);
    const Real error = left * largest.last;
    if (error <= tolerance * largest.value || diagonal.size() == max_steps) return 2 / std::sqrt(largest.value + error);
    beside.push_back(left);
    std::swap(before, here);
    std::swap(here, next);
    multiply<dim>(here, 1 / left);
  }
}

template Real critical_length(const Mesh<2>&, const Patches&, Real);
template Real critical_length(const Mesh<3>&, const Patches&, Real);

}  // namespace berm::mesh
