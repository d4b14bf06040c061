// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/fem_problem.hpp"

namespace berm::fem {

/// What acts in an increment, and how the rigid body moves.
struct FemLoads {
  Vec<2> gravity = Vec<2>::Zero();    ///< m/s2
  std::vector<Real> tractions;        ///< part of each that acts; none where empty
  Real initial_imbalance_factor = 0;  ///< part of the first state's unbalanced forces that is still held back by fictitious ones
  Real dt = 0;                        ///< s, that the increment takes; 0 where it takes none of the soil's time
  struct Direction {
    bool by_force = false;
    Real value = 0;  ///< m (rad): movement in this increment; or N/m (N m/m): force on the body
  } rigid[3];        ///< x, y, angle
};

/// What the soil's plastic flow dissipates in an increment, J/m, and by how much less than the law's strength would at the stresses of its end.
struct StrengthLag {
  Real missing = 0, dissipated = 0;
  /// Over what is dissipated; 0 where nothing flows.
  Real part() const { return dissipated > 0 ? missing / dissipated : 0; }
};

/// The elements and contact points at the end of an increment that is tried: forces, and the elements' derivatives.
class Assembly {
public:
  explicit Assembly(const FemModel& model);

  /// Bytes that an element takes here, in the model and in the state, without its part of the matrix.
  static Real bytes_of_element();

  /// Computes stresses and tractions for the change of displacement since `begin`, and from them the residual. `viscosity` is eta:
  ///
  ///   stress = (law's stress + eta elastic trial stress) / (1 + eta)   (Duvaut and Lions),
  ///
  /// so that soil at yield keeps a stiffness; what lies outside the law's surface is the overstress.
  void evaluate(const FemState& begin, const std::vector<Real>& change, const FemLoads& loads, Real viscosity);

  /// Computes the soil's matrix for what was evaluated last, from the same arguments.
  void differentiate(const FemState& begin, const std::vector<Real>& change, Real viscosity);

  /// internal - external forces by unknown, N/m; not zeroed where the unknown is given.
  const std::vector<Real>& residual() const { return residual_; }
  /// The residual without the forces of the contact points.
  const std::vector<Real>& soil_residual() const { return soil_residual_; }
  /// Derivative of the soil's residual by the unknowns, in the model's pattern, of the last differentiate(); its symmetric part where soil is about to
  /// open or close, elsewhere it is symmetric. Rows and columns of given unknowns are those of the identity.
  const std::vector<Real>& matrix() const { return matrix_; }
  bool given(Index unknown) const { return given_[unknown]; }
  /// Sum over the nodes of the unbalanced forces' magnitudes, and over the contact points of the forces', N/m.
  Real unbalanced() const { return unbalanced_; }
  Real contact_force() const { return contact_force_; }

  /// Takes the strength of the associated stand-ins from the stresses that were evaluated last, for what is evaluated from the same `begin` next.
  void follow_strength();
  /// Takes back the last follow_strength; what was evaluated since is to be evaluated again.
  void follow_no_further() { laws_ = laws_before_; }
  /// Takes it from the stresses of `begin` again, as it is at first.
  void forget_strength();
  /// How far the strength in what was evaluated last, from the same arguments, is behind its stresses: over the area A_q of the points of integration,
  ///
  ///   missing = sum A_q (c cos(phi) - (s1 + s3)/2 sin(phi) - (s1 - s3)/2) g,   dissipated = sum A_q (s1 - s3)/2 g,
  ///
  /// s1 >= s3 the extreme principal stresses, g the plastic shear strain of the increment; both over soil whose law can say its shear strength only.
  StrengthLag strength_lag(const FemState& begin, const std::vector<Real>& change) const;

  /// Force of the soil on the rigid body, N/m, and its moment about the body's centre, N m/m.
  Vec<2> reaction() const;
  Real torque() const;

  /// Makes what was evaluated last the state, and counts its work.
  void accept(FemState& state, const std::vector<Real>& change, const FemLoads& loads) const;

  /// The forces that are held back where nothing has moved yet: residual of the state as it is.
  void store_initial_imbalance(const FemState& state, const FemLoads& loads);

private:
  void evaluate_cell(const FemState& begin, const std::vector<Real>& change, const Vec<2>& gravity, Real viscosity, Index cell);
  void differentiate_cell(const FemState& begin, const std::vector<Real>& change, Real viscosity, Index cell);
  void add_contact(const FemState& begin, const std::vector<Real>& change);
  void count_work(FemState& state, const std::vector<Real>& change, const FemLoads& loads) const;
  void give_unknowns(const FemLoads& loads, Index stage);

  /// The law of a point of integration for the increments that begin with this stress: expensive to build, and the same in all iterations. It may stand for
  /// the strength of another stress (follow_strength).
  struct PointLaw {
    SymTensor<2> begin{{std::numeric_limits<Real>::quiet_NaN()}};  ///< Pa
    material::PreparedMaterial law;
  };
  material::PreparedMaterial law_from(const SymTensor<2>& stress, Index cell, int q) const;
  const PointLaw& law_of_point(const SymTensor<2>& begin, Index cell, int q);

  struct CellWork {
    std::array<Real, 12> force;
    Real work;  ///< J/m, of the stresses in the increment
  };
  const FemModel& model_;
  CellField<CellWork> cells_;
  CellField<std::array<Real, 78>> stiffness_;  ///< of each element: its lower triangle, row by row
  CellField<std::array<SoilPoint, triangle_points>> points_;
  CellField<std::array<PointLaw, triangle_points>> laws_, laws_before_;
  std::vector<FemContactState> contact_;
  std::vector<Real> soil_residual_, residual_, matrix_, initial_imbalance_;
  std::vector<char> given_;
  Real unbalanced_ = 0, contact_force_ = 0;
  Real dt_ = 0;  ///< s, of what was evaluated last
};

}  // namespace berm::fem
