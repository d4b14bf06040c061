// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/contact_points.hpp"
#include "fem/direct_solver.hpp"
#include "fem/element.hpp"
#include "fem/quadratic_mesh.hpp"
#include "fem/side_loads.hpp"
#include "problem/model.hpp"

namespace berm::fem {

/// A place of the soil whose motion and stress are written to the history: the node and the point of integration nearest to it.
struct FemWatch {
  std::string name;
  Index node, cell;
  int point;
};

/// What cannot change during a finite element run: the same model as for the material point method, and the elements.
struct FemModel {
  problem::Model<2> model;  ///< its mesh is that of the corners
  QuadraticMesh mesh;
  CellField<std::array<ShapeAtPoint, triangle_points>> shape;
  CellField<std::array<Real, triangle_points>> depth;  ///< m, of the points of integration below the bed's surface at the start
  Index rigid = none;                                  ///< the rigid body in contact with the soil
  std::vector<FemContactPoint> contact;
  FemInterface interface;
  Real width = 1;                             ///< m, of the rigid body, which increments of travel are measured with; 1 where there is none
  Real weight = 0;                            ///< N/m, of all soil
  std::vector<std::vector<NodalLoad>> loads;  ///< by traction
  problem::FemSettings settings;
  bool non_associated = false;  ///< some soil's flow is not associated
  std::vector<FemWatch> watches;

  // Unknowns: node i moves by 2 i and 2 i + 1 (x, y); the rigid body, where there is one, by the last three (x, y, angle).
  SparsePattern pattern;                         ///< of the soil alone
  CellField<std::array<Index, 78>> cell_places;  ///< of the lower triangle of each element's 12 x 12 entries, row by row
  Index unknowns() const { return 2 * mesh.position.size() + (rigid == none ? 0 : 3); }
  Index rigid_unknown() const { return 2 * mesh.position.size(); }
};

/// The soil at a point of integration.
struct SoilPoint {
  SymTensor<2> stress;                                      ///< Pa, tension positive
  std::array<Real, material::Laws::max_state> law_state{};  ///< what the law keeps: material::state_fields
  Real deviatoric_strain = 0;                               ///< accumulated
  Real overstress = 0;  ///< Pa, how far the stress lies outside the law's surface, in the norm of a tensor
};

/// Everything that changes during a finite element run.
struct FemState {
  problem::State<2> state;         ///< time, stage, rigid bodies, totals; no particles
  std::vector<Real> displacement;  ///< by unknown: m, and rad for the angle
  CellField<std::array<SoilPoint, triangle_points>> points;
  std::vector<FemContactState> contact;
  Vec<2> gravity = Vec<2>::Zero();    ///< m/s2, that acts
  std::vector<Real> tractions;        ///< part of each that acts
  Real initial_imbalance_factor = 0;  ///< part of the first state's unbalanced forces that is held back
  Real unbalanced = 0;                ///< N/m, sum of the unbalanced nodal forces
  Real overstress = 0;                ///< part of the stress that is beyond the law's surface: integral of both over the soil at yield
};

struct FemProblem {
  FemModel model;
  FemState state;
};

/// Builds mesh, elements and the first state. Throws InputError where the case does not fit the method.
FemProblem build_fem(const problem::Case& c, const std::string& case_folder, const std::string& work_folder);

}  // namespace berm::fem
