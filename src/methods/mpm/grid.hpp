// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/detect.hpp"
#include "core/components.hpp"
#include "mesh/cell_part.hpp"
#include "mpm/halo.hpp"
#include "problem/model.hpp"

#include <memory>

namespace berm::mpm {

/// Sums over the particles of one body in one cell; sufficient for the nodes, because shape functions are linear.
template <int dim>
struct Moments {
  static constexpr int corners = dim + 1, pairs = dim * (dim + 1) / 2, corner_pairs = corners * (corners + 1) / 2;

  Real mass[corner_pairs] = {};      ///< sum m N_k N_l, kg, at corner_pair(k, l)
  Real momentum[corners][dim] = {};  ///< sum m N_k v, kg m/s
  Real volume = 0;                   ///< sum V; in a full cell, the volume that it is integrated over (mpm/quadrature.hpp)
  Real stress[pairs] = {};           ///< sum V sigma_ab, at pair(a, b), N m; scaled with the volume

  static constexpr int pair(int a, int b)
  {
    if (a == b) return a;
    return dim == 2 ? 2 : a + b == 1 ? 3 : a + b == 3 ? 4 : 5;
  }
  static constexpr int corner_pair(int k, int l) { return k > l ? corner_pair(l, k) : k * corners - k * (k - 1) / 2 + l - k; }

  /// Whether the cell has active particles; true also if their volume is not a number.
  bool any() const { return volume != 0; }
  /// sum m, kg.
  Real total_mass() const
  {
    Real sum = 0;
    for (int k = 0; k < corners; ++k)
      for (int l = k; l < corners; ++l) sum += (k == l ? 1 : 2) * mass[corner_pair(k, l)];
    return sum;
  }
  /// sum m v, kg m/s.
  [[gnu::always_inline]] Components<dim> total_momentum() const
  {
    Components<dim> sum = components<dim>(momentum[0]);
    for (int k = 1; k < corners; ++k) sum += components<dim>(momentum[k]);
    return sum;
  }
};

/// Components of a vector at each corner of a cell.
template <int dim>
using AtCorners = std::array<Components<dim>, dim + 1>;

/// What the corners of a cell get of the momentum that its particles have if they move with the velocity sum_k N_k v_k, kg m/s.
template <int dim>
[[gnu::always_inline]] inline AtCorners<dim> momentum_with(const Moments<dim>& t, const AtCorners<dim>& v)
{
  AtCorners<dim> momentum;
#pragma GCC unroll 4
  for (int k = 0; k <= dim; ++k) {
    momentum[k] = t.mass[Moments<dim>::corner_pair(k, 0)] * v[0];
#pragma GCC unroll 4
    for (int l = 1; l <= dim; ++l) momentum[k] += t.mass[Moments<dim>::corner_pair(k, l)] * v[l];
  }
  return momentum;
}

/// Contribution of a cell to one of its corners.
template <int dim>
struct CornerSums {
  Real sum[dim];  ///< its momentum in step 1, kg m/s; then the internal force, N; then its momentum after step 5
  Real mass;      ///< sum m N_k, kg
  Real volume;    ///< sum V of the whole cell; then, but at corner 0, a component of the filter's shift (BodyGrid::filter_of)
};

/// What the direction around the axis adds to the moments of a cell in axisymmetry. With A = V / x the area of a particle, a_k = sum A N_k follows from
/// sum A, sum A x = sum V and sum A y.
struct HoopMoments {
  Real area = 0;    ///< sum A, m2; in a full cell, of what it is integrated over
  Real area_y = 0;  ///< sum A y, with y from the cell's corner 0
  Real stress = 0;  ///< sum V sigma_zz, N m per radian; scaled with the volume
};

/// What the velocity filter does to the particles of a cell in a step.
template <int dim>
struct FilterOfCell {
  Real fraction = 0;                  ///< of the difference between their velocities and the smooth one that is taken out
  Vec<dim> shift = Vec<dim>::Zero();  ///< m/s, what they get back, so that the patch keeps its momentum
};

/// How the particles of a cell swell in a step. Apart from the moments, which other cells' particles have summed again while those of this one still move.
struct VolumeChange {
  Real volume;  ///< sum V before the step, as in Moments
  Real change;  ///< that times div(v) dt
};

/// Means over the particles of a cell of soil whose water flows.
struct WaterCell {
  Real pressure = 0;  ///< p, Pa, compression positive
  Real inertia = 0;   ///< rho_w / n, kg/m3
  Real drag = 0;      ///< gamma_w / k, N s/m4
};

/// What a cell gives the water at one of its corners.
template <int dim>
struct WaterAtCorner {
  Vec<dim> force = Vec<dim>::Zero();  ///< V p grad N, N
  Real mass = 0;                      ///< rho_w V, kg, of an equal part of the volume, and at most that of the shape function
  Vec<dim> share = Vec<dim>::Zero();  ///< by direction, the volume whose drag lets a linear pressure drive Darcy's flux; may be negative
};

/// The water at a node; by flux, which is the velocity times the porosity.
template <int dim>
struct WaterAtNode {
  Vec<dim> force = Vec<dim>::Zero();  ///< sum V p grad N, N
  Real mass = 0;                      ///< sum rho_w V, kg: of the part that moves with the soil
  Real inertia = 0;                   ///< sum rho_w V / n, kg; of a node with the drag over the step
  Real drag = 0;                      ///< sum gamma_w V / k, kg/s
};

/// What the flux along the normal of an impermeable body changes of the outflow of the cells around a node, m/s: times the force of 1 Pa along the normal, of cells on
/// the side of the body and of those on the side of the soil.
struct ImpermeableFlux {
  Real at_body = 0, at_soil = 0;
};

/// What soil adds whose water flows (mpm/flow.hpp); without memory where none does.
template <int dim>
struct WaterGrid {
  struct Soil {
    material::Hydraulics water;
    Real density;  ///< kg/m3, of the saturated soil at the start
  };
  std::vector<Soil> soils;  ///< by material
  CellField<WaterCell> cells;
  CellField<Real> pressure;  ///< Pa, that acts: averaged over the patch of the cell
  CellField<std::array<WaterAtCorner<dim>, dim + 1>> corners;
  CellField<VolumeChange> outflow;  ///< as the volume change, by div(w) dt
  NodeField<WaterAtNode<dim>> nodes;
  NodeField<Vec<dim>> soil_inertia;        ///< kg, what accelerates with the soil where the water gives way
  NodeField<Vec<dim>> normal;              ///< of the impermeable rigid body that touches the soil there; else zero
  NodeField<ImpermeableFlux> impermeable;  ///< of the nodes with a normal; else zero

  bool flows() const { return !cells.empty(); }
  void make_room(const mesh::Mesh<dim>& mesh, const settings::BodySoil& soil);
};

/// What the rigid bodies that touch a body leave of the cells which their surfaces cut (mpm/cut_cells.hpp); without memory where cells count as whole.
template <int dim>
struct CutCells {
  std::vector<bodies::Pose<dim>> poses;  ///< that this is of, by contact
  NodeField<Real> distance;              ///< m, from the nearest of the rigid bodies; negative inside
  CellField<mesh::CellPart<dim>> parts;  ///< outside of them
  NodeField<Real> volume_around;         ///< m2 (per metre run) or m3: what is left of all cells around a node; infinite where none is cut

  bool used() const { return !parts.empty(); }
};

/// Nodal fields of one body and the cell sums behind them, valid within a step; moments and corners also between steps. Cell sums are zero where a cell has
/// no particles. Memory is committed only where the body has been.
template <int dim>
struct BodyGrid {
  /// Between steps, with their contributions to the corners, of the particles as they are: what changes a particle's x, v, mass, volume or stress sums its cell
  /// again (mpm/moments.hpp). In cells of other ranks as they were at the last exchange.
  CellField<Moments<dim>> moments;
  CellField<std::array<CornerSums<dim>, dim + 1>> corners;
  CellField<HoopMoments> hoop;  ///< as the moments; empty but in axisymmetry
  CellField<Real> kinetic;      ///< sum m v.v, twice the kinetic energy, J; as the moments; empty without the filter
  CellField<VolumeChange> volume_change;
  WaterGrid<dim> water;
  CellField<Real> viscous_stress;  ///< Pa, tension positive; 0 where the body has no bulk viscosity
  CellField<Real>
      pressure_shift;  ///< Pa, mean stress of the patch less that of the cell, in the directions that are strained; empty unless soil dilates
  Real shift_across = 1;    ///< what the third normal stress gets of it: 2 nu in plane strain, as of an elastic strain in the plane
  Real bulk_viscosity = 0;  ///< Pa s/m: viscous stress over a cell's height and its rate of volume change
  Real filter_speed = 0;    ///< m/s, height of a cell times the rate at which the filter relaxes its particles' velocities; 0: no filter
  /// m2/s2, largest stiffness over density in this step (mpm/small_mass_nodes.hpp), 0: no limit; empty without the filter or full_cells and where water flows.
  CellField<Real> stiffness_limit;
  Real total_mass = infinity;  ///< of the body, kg

  CellField<mesh::Gradients<dim>> gradients;  ///< of the shape functions, for cells that have or had particles
  CellField<Real> height;                     ///< m, of the same cells where the body has a bulk viscosity or a filter
  CellField<Real> volume;                     ///< m2 (per metre run) or m3, of the cell
  bool full_cells = false;                    ///< cells within the body are integrated over their own volume

  CutCells<dim> cut;

  NodeField<Real> mass;
  NodeField<Real> volume_around;           ///< m2 (per metre run) or m3: of all cells around a node that has or had particles in one
  NodeField<Real> fill;                    ///< fraction of it that particles fill
  NodeField<Vec<dim>> velocity;            ///< v^t
  NodeField<Vec<dim>> smooth_velocity;     ///< v^t of second order in the particles', target of the filter; 0 without it
  NodeField<Vec<dim>> acceleration;        ///< corrected, step 4
  NodeField<Vec<dim>> mapped_velocity;     ///< v^(t+1) of steps 7 and 8: moves and strains the particles
  NodeField<Vec<dim>> traction;            ///< N, of the load points; zero where there are none
  NodeField<Vec<dim>> support_force;       ///< N, of the supports before contact; empty where no reactions are reported
  NodeField<std::uint8_t> touching;        ///< 1: near a contact, exempt from damping
  NodeField<std::uint8_t> contact_points;  ///< 1: a contact point of this step moves the node

  Index table = 0;               ///< what the conditions at nodes make of them in this step, an index into NodalConditions::tables
  NodeField<std::uint8_t> held;  ///< as there and, in all directions, the nodes of inactive cells (mpm/inactive.hpp); empty where none is
  Index held_with = none;        ///< the table that `held` was made with

  std::vector<Index> nodes;  ///< that have an active cell with particles (of them those that are complete, Halo), ascending
  Chunks chunks;             ///< of `nodes`

  Halo halo;                         ///< of the cells that other ranks have
  std::vector<Index> contact_nodes;  ///< that contact points move, where there are other ranks

  BodyGrid() = default;
  explicit BodyGrid(const mesh::Mesh<dim>& mesh);

  /// Computes gradients and height of a cell that receives particles.
  void enter(const mesh::Mesh<dim>& mesh, Index cell);
  /// Sets the sums of a cell to zero that has no particles any more.
  void leave(Index cell)
  {
    moments[cell] = {};
    corners[cell] = {};
    volume_change[cell] = {};
    if (!hoop.empty()) hoop[cell] = {};
    if (!kinetic.empty()) kinetic[cell] = 0;
    if (water.flows()) water.cells[cell] = {}, water.corners[cell] = {}, water.outflow[cell] = {};
    if (bulk_viscosity > 0) viscous_stress[cell] = 0;
  }
  /// Leaves of the sums of an inactive cell the volume of its particles, by which its neighbours know that they lie within the body.
  void deactivate(Index cell)
  {
    std::array<CornerSums<dim>, dim + 1> sums{};
    for (int k = 0; k <= dim; ++k) sums[k].volume = corners[cell][k].volume;
    leave(cell);
    corners[cell] = sums;
  }
  const boundary::NodeTable<dim>& conditions(const problem::Model<dim>& model) const
  {
    return model.conditions.tables[static_cast<std::size_t>(table)];
  }
  /// The directions that are held at each node.
  const NodeField<std::uint8_t>& held_directions(const problem::Model<dim>& model) const
  {
    return !held.empty() ? held : conditions(model).held;
  }
  /// Shape functions of a cell that has been entered; the gradients of others are 0.
  [[gnu::always_inline]] mesh::Shape<dim> shape(const mesh::Mesh<dim>& mesh, Index cell) const
  {
    mesh::Shape<dim> shape;  // number by number, so that they are kept in registers
#pragma GCC unroll 3
    for (int d = 0; d < dim; ++d) {
      shape.origin[d] = mesh.position[mesh.nodes[cell][0]][d];
#pragma GCC unroll 3
      for (int k = 0; k < dim; ++k) shape.gradients[k][d] = gradients[cell][k][d];
    }
    return shape;
  }
  bool filters() const
  {
    return filter_speed > 0;
  }
  /// The part of the difference between the velocities of a cell's particles and the smooth one that the filter takes out in a step of dt (s).
  [[gnu::always_inline]] Real filter_fraction(Index cell, Real dt) const
  {
    return std::min(Real(1), dt * filter_speed / height[cell]);
  }
  /// Keeps the filter's shift of a cell until its particles have moved, where their volume is not needed any more.
  [[gnu::always_inline]] void keep_shift(Index cell, const Components<dim>& shift)
  {
    for (int d = 0; d < dim; ++d) corners[cell][d + 1].volume = shift[d];
  }
  /// From keep_shift until the particles have moved.
  [[gnu::always_inline]] FilterOfCell<dim> filter_of(Index cell, Real dt) const
  {
    FilterOfCell<dim> filter;
    if (!filters()) return filter;
    filter.fraction = filter_fraction(cell, dt);
    for (int d = 0; d < dim; ++d) filter.shift[d] = corners[cell][d + 1].volume;
    return filter;
  }
  /// The volume that a cell with active particles is integrated over, over that of the particles: from prepare_cells until they have moved.
  Real weight(Index cell) const
  {
    return full_cells ? moments[cell].volume / corners[cell][0].volume : 1;
  }
  /// Contribution of the cell of a mesh entry to the node.
  const CornerSums<dim>& at(mesh::CornerEntry e) const
  {
    return corners.data()->data()[e];
  }
};

/// Lists the nodes of cells with particles; of those of other ranks, the nodes whose cells are all known. A node that no longer has one has no velocity.
template <int dim>
void find_nodes(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid);

/// What a material of a body whose particles keep their own soil sets for them.
struct VolumeRule {
  Real min_volume, max_volume;  ///< over mass, m3/kg
  bool dilates;
};

/// The prepared laws of a body (mpm/body_laws.hpp, which only what looks into laws includes).
struct BodyLaws;
template <int dim>
std::shared_ptr<const BodyLaws> laws_of(const settings::BodySoil& soil, const settings::MpmSettings& settings, const mesh::Mesh<dim>& mesh);

/// Workspace of a step beside Model and State; allocated once, with the sums of the particles as they are then.
template <int dim>
struct Workspace {
  std::vector<BodyGrid<dim>> grids;                           ///< by body
  std::vector<contact::ContactPoints<dim>> contact_points;    ///< by contact
  bool contacts_share_nodes = false;                          ///< some node is moved by more than one contact point
  std::vector<std::vector<bodies::CellChange>> cell_changes;  ///< by thread
  bodies::Transit<dim> transit;
  std::vector<Index> changed_cells;                    ///< that particles left or entered
  std::vector<std::array<Real, dim + 1>> load_shares;  ///< of each load point: what the corners of its cell get
  std::vector<int> load_owner;                         ///< of each load point: the rank that has its cell
  std::vector<std::shared_ptr<const BodyLaws>> laws;   ///< by body
  std::vector<Vec<dim>> motion_before,
      motion_after;  ///< m/s, by row of Model::conditions: what it prescribes when the step begins and when it ends
  Real
      unbalanced = 0,
      weight =
          nan;  ///< N, sums over the nodes of |unbalanced force| (away from contacts); of m g and of tractions, last step; NaN before a step

  Workspace(const problem::Model<dim>& model, const problem::State<dim>& state);
};

}  // namespace berm::mpm
