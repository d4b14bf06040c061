// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/fem_problem.hpp"
#include "fem/moved_cell.hpp"

#include <memory>

namespace berm::fem {

/// The part that the velocity at its end has in the movement of an increment with inertia, that at its start has the rest. 1/2 would be exact for a constant acceleration and would not damp, 1 is backward Euler.
constexpr Real weight_of_end = 0.6;

/// Loads of an increment, and the motion of the rigid body that it moves; the others are held.
template <int dim>
struct ElementLoads {
  Vec<dim> gravity = Vec<dim>::Zero();  ///< m/s2
  std::vector<Real> tractions;          ///< load factor of each; none where empty
  std::vector<Real> heads;              ///< Pa, excess pore pressure of each; none where empty
  Real initial_imbalance_factor = 0;    ///< fraction of the initial unbalanced forces that fictitious forces still balance
  Real dt = 0;                          ///< s, duration of the increment; 0: none, so that no strain rate is defined, and no water flows
  bool drained = false;                 ///< there is no excess pore pressure
  Index moved = 0;                      ///< the contact of the body that moves
  struct Direction {
    bool by_force = false;
    Real value = 0;                ///< m (rad): prescribed movement in this increment; or N/m (N m/m): force on the body
    Real mass = 0;                 ///< kg/m (kg m), that this force accelerates; 0: without inertia
    Real velocity = 0;             ///< m/s (rad/s), at the start of the increment
  } rigid[bodies::freedoms<dim>];  ///< x, y, angle of this body; in space x, y, z, and the rotations about x, y and z

  /// Of the body of any contact.
  Direction direction_of(Index contact, Index d) const { return contact == moved ? rigid[d] : Direction{}; }
};
using FemLoads = ElementLoads<2>;

/// Plastic dissipation of an increment, J/m, and what it lacks to that with the law's strength at the final stresses.
struct StrengthLag {
  Real missing = 0, dissipated = 0;
  /// missing / dissipated; 0 without plastic flow.
  Real part() const { return dissipated > 0 ? missing / dissipated : 0; }
};

/// Elements and contact points at the end of a trial increment: forces, and the derivatives of the elements.
class Assembly {
public:
  explicit Assembly(const FemModel& model);
  ~Assembly();

  /// Bytes per element here, in the model and in the state, without its part of the matrix.
  static Real bytes_of_element();

  /// Computes stresses and tractions for the change of displacement since `begin`, and from them the residual. `viscosity` is eta:
  ///
  ///   stress = (law's stress + eta elastic trial stress) / (1 + eta)   (Duvaut and Lions),
  ///
  /// so that soil at yield keeps a stiffness; what lies outside the law's surface is the overstress.
  void evaluate(const FemState& begin, const std::vector<Real>& change, const FemLoads& loads, Real viscosity);

  /// Computes the tangents of the elements at the last evaluation, from the same arguments. Where soil is elastic they have the same bits always.
  void differentiate(const FemState& begin, const std::vector<Real>& change, Real viscosity);

  /// internal - external forces by unknown, N/m, and the balance of the water (water_balance); not zeroed where the unknown is prescribed.
  const std::vector<Real>& residual() const { return residual_; }
  /// The residual without the forces of the contact points.
  const std::vector<Real>& soil_residual() const { return soil_residual_; }
  /// The tangents of the elements of the last differentiate(): their symmetric part where soil is about to open or close, elsewhere they are symmetric. Not
  /// where the model is unsymmetric.
  const CellField<CellStiffness>& stiffness() const { return stiffness_; }
  /// Derivative of the soil's residual with respect to the unknowns, as DirectSolver takes it: the sum of the tangents. Rows and columns of prescribed
  /// unknowns are those of the identity.
  std::vector<Real> matrix() const;
  const std::vector<char>& prescribed() const { return prescribed_; }
  bool prescribed(Index unknown) const { return prescribed_[unknown]; }
  /// The excess pore pressure at the end of the increment of an unknown that is prescribed, Pa: that of the water outside.
  Real outside_pressure(Index unknown) const { return outside_.empty() ? 0 : outside_[unknown - model_.pressure_unknown()]; }
  /// Derivative of the inertia force of a rigid body by its movement, N/m2 (N m/m): mass/(weight_of_end dt^2).
  Real inertia(Index rigid_unknown) const { return inertia_[static_cast<std::size_t>(rigid_unknown - model_.rigid_unknown())]; }
  /// Euclidean norm of the residual but that of prescribed unknowns and of the water's balance.
  Real norm() const;
  /// Sum over the nodes of the unbalanced forces' magnitudes, and over the contact points of the forces', N/m.
  Real unbalanced() const { return unbalanced_; }
  /// The unbalanced part of the water's volume.
  Real unbalanced_flow() const { return unbalanced_flow_; }
  Real contact_force() const { return contact_force_; }

  /// Moves the stresses whose strength the associated laws have by a part of the way to those last evaluated, for the next evaluations from the same
  /// `begin`.
  void update_strength(Real part);
  /// Undoes the last update_strength; evaluate again afterwards.
  void undo_strength_update();
  /// Resets the strength to the stresses of `begin`.
  void reset_strength();
  /// Lag of the strength behind the stresses last evaluated, from the same arguments, over the areas A_q of the integration
  /// points:
  ///
  ///   missing = sum A_q (c cos(phi) - (s1 + s3)/2 sin(phi) - (s1 - s3)/2) g,   dissipated = sum A_q (s1 - s3)/2 g,
  ///
  /// s1 >= s3 the extreme principal stresses, g the plastic shear strain of the increment; both over soil whose law defines
  /// its shear strength.
  StrengthLag strength_lag(const FemState& begin, const std::vector<Real>& change) const;

  /// Force of the soil on the rigid body of a contact, N/m, and its moment about the body's centre, N m/m.
  Vec<2> reaction(Index contact = 0) const;
  Real torque(Index contact = 0) const;
  /// Force of each support on the soil in this stage, N/m: the residual where it holds.
  std::vector<Vec<2>> support_forces(Index stage) const;

  /// Error of the energy balance of the last evaluation as an increment from `begin`, over its work and that of the contact forces between two remeshings: large where an element has gone through a shape that
  /// it cannot have.
  Real energy_error(FemState& begin, const std::vector<Real>& change, const FemLoads& loads) const;

  /// Accepts the last evaluation as the new state, and adds its work to the totals.
  void accept(FemState& state, const std::vector<Real>& change, const FemLoads& loads) const;

  /// Stores the residual of the initial state, which fictitious forces balance.
  void store_initial_imbalance(const FemState& state, const FemLoads& loads);
  /// What these forces do in a change that ends with these loads, J/m.
  Real work_of_imbalance(const FemState& begin, const std::vector<Real>& change, const FemLoads& loads) const;

private:
  void evaluate_cell(const FemState& begin, const std::vector<Real>& change, const Vec<2>& gravity, Real viscosity, Index cell);
  void differentiate_cell(const FemState& begin, const std::vector<Real>& change, Real viscosity, Index cell);
  bool is_elastic(Real viscosity, Index cell) const;
  void add_contact(const FemState& begin, const std::vector<Real>& change);
  void count_work(FemState& state, const std::vector<Real>& change, const FemLoads& loads) const;
  void prescribe_unknowns(const std::vector<Real>& change, const FemLoads& loads, Index stage);
  FlowIncrement flow_increment(const FemState& begin, const std::vector<Real>& change, Index cell) const;
  SoilPoint with_effective_stress(SoilPoint point, Index cell) const;
  std::optional<MovedCell> moved_cell(const FemState& begin, const std::vector<Real>& change, Index cell) const;
  void set_pressure(SoilPoint& point, Real pressure, Index cell) const;
  void add_flow();

  /// Of a point of integration, Pa, tension positive.
  SymTensor<2> effective_stress(const SoilPoint& point, Index cell) const;

  struct PointLaw;
  struct PointLaws;
  const PointLaw& law_of_point(const SymTensor<2>& begin, Index cell, int q);

  struct CellWork {
    std::array<Real, 12> force;
    Real work;  ///< J/m, of the stresses in the increment
  };
  const FemModel& model_;
  CellField<CellWork> cells_;
  CellField<CellStiffness> stiffness_,
      mirrored_;             ///< lower triangles; the second, of the transposed matrix, where the model is unsymmetric
  CellField<char> elastic_;  ///< the tangent of the last differentiate() is the elastic one
  CellField<CellFlow> flow_;
  CellField<std::array<Real, pressure_entries>> flow_stiffness_;
  CellField<std::array<SoilPoint, triangle_points>> points_;
  std::unique_ptr<PointLaws> laws_;
  std::vector<FemContactState> contact_;
  std::vector<Vec<2>> arms_;  ///< m, of the contact points, at the end of the increment
  std::vector<Real> soil_residual_, residual_, initial_imbalance_;
  std::vector<char> prescribed_;
  std::vector<Real> inertia_;  ///< by unknown of the rigid bodies
  std::vector<Real> outside_;  ///< Pa, by pressure; empty where there is no head
  Real unbalanced_ = 0, contact_force_ = 0, unbalanced_flow_ = 0;
  Real dt_ = 0;  ///< s, of what was evaluated last
};

}  // namespace berm::fem
