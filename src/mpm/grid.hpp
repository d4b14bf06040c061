// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/detect.hpp"
#include "problem/model.hpp"

namespace berm {

/// The laws with their constants worked out.
using PreparedMaterial = std::variant<PreparedLinearElastic, PreparedMohrCoulomb>;

/// Sums over the particles of one body in one cell. Shape functions are linear, so these are all that the nodes need.
template <int dim>
struct Moments {
  static constexpr int pairs = dim * (dim + 1) / 2;

  Real m = 0;               ///< sum m, kg
  Real mx[dim] = {};        ///< sum m x
  Real mxx[pairs] = {};     ///< sum m x_a x_b, place pair(a, b)
  Real mv[dim] = {};        ///< sum m v
  Real mvx[dim][dim] = {};  ///< [d][a]: sum m v_d x_a
  Real volume = 0;          ///< sum V
  Real stress[pairs] = {};  ///< sum V sigma_ab, place pair(a, b), N m

  static constexpr int pair(int a, int b)
  {
    if (a == b) return a;
    return dim == 2 ? 2 : a + b == 1 ? 3 : a + b == 3 ? 4 : 5;
  }
};

/// What one cell gives to one of its corners in steps 1 and 6.
template <int dim>
struct CornerSums {
  Real mass;
  Real momentum[dim];
  Real volume;           ///< of the particles in the whole cell
  Real volume_pressure;  ///< sum V p, p the mean of the stress components in the mesh's directions
};

/// The nodal fields of one body and the sums that make them; nothing here outlives a step.
template <int dim>
struct BodyGrid {
  CellField<Moments<dim>> moments;
  std::vector<CornerSums<dim>> corner_sums;  ///< by corner entry; zero where a cell has no particles
  std::vector<Vec<dim>> corner_force;        ///< internal force, N
  std::vector<Vec<dim>> corner_momentum;     ///< after step 5, kg m/s
  CellField<Real> volume_change;             ///< sum V times div(v) dt of the cell
  CellField<Real> viscous_stress;            ///< Pa, tension positive; 0 where the body does not dilate
  Real bulk_viscosity = 0;                   ///< Pa s/m: viscous stress over a cell's height and its rate of volume change

  NodeField<Real> mass;
  NodeField<Vec<dim>> velocity;            ///< v^t
  NodeField<Vec<dim>> acceleration;        ///< corrected, step 4
  NodeField<Vec<dim>> moved_velocity;      ///< v^(t+1) of steps 7 and 8: moves and strains the particles
  NodeField<std::uint8_t> touching;        ///< 1: near a contact; damping leaves it alone
  NodeField<std::uint8_t> contact_points;  ///< 1: a contact point of this step moves the node

  std::vector<Index> nodes;  ///< that have a cell with particles, ascending

  BodyGrid() = default;
  explicit BodyGrid(const Mesh<dim>& mesh);
};

/// Lists the nodes that have a cell with particles.
template <int dim>
void find_nodes(const Mesh<dim>& mesh, const Particles<dim>& particles, BodyGrid<dim>& grid);

/// A particle on its way to another cell.
struct Mover {
  Index from, place, to;
};

/// All memory that a step needs beside Model and State; made once.
template <int dim>
struct Work {
  std::vector<BodyGrid<dim>> grids;                ///< by body
  std::vector<ContactPoints<dim>> contact_points;  ///< by contact
  bool contacts_share_nodes = false;               ///< some node is moved by more than one contact point
  std::vector<std::vector<Mover>> movers;          ///< by thread
  std::vector<Particle<dim>> moving;
  std::vector<PreparedMaterial> laws;        ///< by body
  std::vector<PreparedMaterial> spent_laws;  ///< by body: the same without dilation, for particles at their largest volume
  Real unbalanced = 0, weight = 0;           ///< N, sums over the nodes of |unbalanced force| (away from contacts) and of m g, last step

  Work(const Model<dim>& model, const State<dim>& state);
};

}  // namespace berm
