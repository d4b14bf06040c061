// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/assembly.hpp"
#include "fem/space_problem.hpp"

#include <memory>
#include <span>

namespace berm::fem {

/// Forces and tangents of the elements in space at the end of a trial increment. Their volumetric strain is its mean over the element (B-bar; Hughes 1980):
///
///   e = sum_k sym(g_k u_k) + 1/3 (gbar_k - g_k) . u_k I,
///
/// g_k the gradients of the shape functions and gbar_k their means.
class SpaceAssembly {
public:
  explicit SpaceAssembly(const SpaceModel& model);
  ~SpaceAssembly();

  /// Bytes per element here, in the model and in the state, without its part of the matrix.
  static Real bytes_of_element();

  /// Stresses and the residual after this change of the unknowns since `begin`; viscosity as Assembly::evaluate.
  void evaluate(const SpaceState& begin, const std::vector<Real>& change, const ElementLoads<3>& loads, Real viscosity);

  /// The symmetric part of the derivative of the residual at the last evaluation, from the same arguments, in the order of the model's pattern. Rows and columns of prescribed unknowns are
  /// those of the identity; `right`, which holds their steps and minus the residual of the others, gets what these steps do to the others.
  void differentiate(const SpaceState& begin, const std::vector<Real>& change, Real viscosity, std::span<Real> entries,
                     std::span<Real> right);

  /// Internal - external forces by unknown, N or N m; not zeroed where it is prescribed; 0 of a tied node, whose force its body has.
  const std::vector<Real>& residual() const { return residual_; }
  bool prescribed(Index unknown) const { return prescribed_[unknown] != 0; }
  /// Gives tied nodes the displacements that their bodies have in `change`.
  void carry_tied_nodes(std::vector<Real>& change) const;
  /// Sum over the nodes of the unbalanced forces' magnitudes, and over the tied nodes of the forces', N.
  Real unbalanced() const { return unbalanced_; }
  Real contact_force() const { return contact_force_; }

  /// Force of the soil on the rigid body of a contact, N, and its moment about the body's centre, N m; without what its mirror image balances.
  Vec<3> reaction(Index contact) const;
  Vec<3> torque(Index contact) const;

  /// Accepts the last evaluation as the new state, and adds its work to the totals.
  void accept(SpaceState& state, const std::vector<Real>& change, const ElementLoads<3>& loads) const;

  /// Stores the residual of the initial state, which fictitious forces balance.
  void store_initial_imbalance(const SpaceState& state, const ElementLoads<3>& loads);

private:
  void evaluate_cell(const SpaceState& begin, const std::vector<Real>& change, const Vec<3>& gravity, Real viscosity, Index cell);
  void prescribe(const ElementLoads<3>& loads, Index stage);

  struct CellWork {
    AtElementNodes<3, Vec<3>> force;
    Real work;  ///< J, of the stresses in the increment
  };
  struct Laws;
  const SpaceModel& model_;
  std::unique_ptr<Laws> laws_;  ///< of each integration point, prepared once because that is expensive
  CellField<CellWork> cells_;
  CellField<std::array<ElementSoil<3>, element_points<3>>> points_;
  std::vector<Real> soil_force_;  ///< N, by unknown: internal less gravity and fictitious forces
  std::vector<Real> residual_, initial_imbalance_;
  std::vector<char> prescribed_;
  Real unbalanced_ = 0, contact_force_ = 0;
  Real dt_ = 0;  ///< s, of what was evaluated last
};

}  // namespace berm::fem
