// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/detect.hpp"
#include "problem/model.hpp"

namespace berm::mpm {

/// Sums over the particles of one body in one cell. Shape functions are linear, so these are all that the nodes need.
template <int dim>
struct Moments {
  static constexpr int pairs = dim * (dim + 1) / 2;

  Real m = 0;               ///< sum m, kg
  Real mx[dim] = {};        ///< sum m x
  Real mxx[pairs] = {};     ///< sum m x_a x_b, place pair(a, b)
  Real mv[dim] = {};        ///< sum m v
  Real mvx[dim][dim] = {};  ///< [d][a]: sum m v_d x_a
  Real volume = 0;          ///< sum V; in a full cell, the volume that the cell stands for (mpm/quadrature.hpp)
  Real stress[pairs] = {};  ///< sum V sigma_ab, place pair(a, b), N m; scaled with the volume

  static constexpr int pair(int a, int b)
  {
    if (a == b) return a;
    return dim == 2 ? 2 : a + b == 1 ? 3 : a + b == 3 ? 4 : 5;
  }
};

/// What one cell gives to one of its corners.
template <int dim>
struct CornerSums {
  Real sum[dim];  ///< its momentum in step 1, kg m/s; then the internal force, N; then its momentum after step 5
  Real mass;      ///< sum m N_k, kg
  Real volume;    ///< sum V of the whole cell, the same for all its corners
};

/// The nodal fields of one body and the sums that make them; no sum outlives a step. Those of cells are zero where a cell has no particles. All
/// are untouched, and so without memory, where the body never was.
template <int dim>
struct BodyGrid {
  CellField<Moments<dim>> moments;
  CellField<std::array<CornerSums<dim>, dim + 1>> corners;
  CellField<Real> volume_change;   ///< sum V times div(v) dt of the cell
  CellField<Real> viscous_stress;  ///< Pa, tension positive; 0 where the body has no bulk viscosity
  Real bulk_viscosity = 0;         ///< Pa s/m: viscous stress over a cell's height and its rate of volume change
  Real filter_rate = 0;            ///< 1/s, at which the filter pulls particle velocities towards the smooth ones; 0 without it
  Real whole_mass = infinity;      ///< of the body, kg

  CellField<mesh::Gradients<dim>> gradients;  ///< of the shape functions, for cells that have or had particles
  CellField<Real> height;                     ///< m, of the same cells where the body has a bulk viscosity
  CellField<Real> volume;                     ///< m2 (per metre run) or m3, of the cell
  CellField<Real> weight;                     ///< volume that the cell stands for over sum V, of cells with particles
  bool full_cells = false;                    ///< cells within the body stand for their own volume

  NodeField<Real> mass;
  NodeField<Real> volume_around;           ///< m2 (per metre run) or m3: of all cells around a node that has or had particles in one
  NodeField<Real> fill;                    ///< part of it that particles fill
  NodeField<Vec<dim>> velocity;            ///< v^t
  NodeField<Vec<dim>> smooth_velocity;     ///< v^t of second order in the particles', towards which the filter pulls them; 0 without it
  NodeField<Vec<dim>> acceleration;        ///< corrected, step 4
  NodeField<Vec<dim>> mapped_velocity;     ///< v^(t+1) of steps 7 and 8: moves and strains the particles
  NodeField<Vec<dim>> traction;            ///< N, of the load points; zero where there are none
  NodeField<std::uint8_t> touching;        ///< 1: near a contact; damping leaves it alone
  NodeField<std::uint8_t> contact_points;  ///< 1: a contact point of this step moves the node

  Index fixed = 0;  ///< the set of supports that hold in this step, an index into Model::fixed

  std::vector<Index> nodes;  ///< that have a cell with particles, ascending

  BodyGrid() = default;
  explicit BodyGrid(const mesh::Mesh<dim>& mesh);

  /// Works out gradients and height of a cell that gets particles.
  void enter(const mesh::Mesh<dim>& mesh, Index cell);
  /// The shape functions of a cell that has been entered; of others gradients are 0.
  [[gnu::always_inline]] mesh::Shape<dim> shape(const mesh::Mesh<dim>& mesh, Index cell) const
  {
    return {mesh.position[mesh.nodes[cell][0]], gradients[cell]};
  }
  /// The part of what a particle's velocity has beyond the smooth one that the filter takes out in a step: the same everywhere, or momentum would
  /// not be kept.
  [[gnu::always_inline]] Real filtered_part(Real dt) const { return std::min(Real(1), dt * filter_rate); }
  /// What a particle at the node would gain in step 5 where the filter takes out `part`, besides losing that part of its velocity, m/s.
  [[gnu::always_inline]] Real gain(Index node, int d, Real dt, Real part) const
  {
    return dt * acceleration[node][d] + part * smooth_velocity[node][d];
  }
  /// What the cell of an entry of the mesh gives to the node.
  const CornerSums<dim>& at(mesh::CornerEntry e) const { return corners.data()->data()[e]; }
};

/// Lists the nodes that have a cell with particles.
template <int dim>
void find_nodes(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid);

/// A particle on its way to another cell.
struct CellChange {
  Index from, place, to;
};

/// All memory that a step needs beside Model and State; made once.
template <int dim>
struct Work {
  std::vector<BodyGrid<dim>> grids;                         ///< by body
  std::vector<contact::ContactPoints<dim>> contact_points;  ///< by contact
  bool contacts_share_nodes = false;                        ///< some node is moved by more than one contact point
  std::vector<std::vector<CellChange>> cell_changes;        ///< by thread
  std::vector<bodies::Particle<dim>> in_transit;
  std::vector<material::PreparedMaterial> laws;  ///< by body
  std::vector<material::PreparedMaterial>
      laws_without_dilation;  ///< by body: the same without dilation, for particles at their largest volume
  Real unbalanced = 0,
       weight = 0;  ///< N, sums over the nodes of |unbalanced force| (away from contacts); of m g and of tractions, last step

  Work(const problem::Model<dim>& model, const problem::State<dim>& state);
};

}  // namespace berm::mpm
