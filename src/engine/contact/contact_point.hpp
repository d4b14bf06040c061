// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rigid_body.hpp"
#include "contact/contact_law.hpp"
#include "core/fields.hpp"
#include "mesh/mesh.hpp"

#include <array>

namespace berm::contact {

/// A point at which a deformable body may touch a rigid or another deformable one: a node, or a particle.
template <int dim>
struct ContactPoint {
  std::array<Index, dim + 1> nodes{};    ///< whose velocity is that of the body at the point: one, or all of the particle's cell
  std::array<Real, dim + 1> weights{};   ///< their shape functions at the point
  int node_count = 1;                    ///< 1 or dim + 1
  Vec<dim> normal = Vec<dim>::Zero();    ///< unit vector towards the body: out of the rigid or of the other body
  Vec<dim> position = Vec<dim>::Zero();  ///< on the rigid surface, nearest to the body
  Real gap = 0;                          ///< m between the two; at most 0 where they touch
  Real distance = 0;                     ///< m between the rigid surface (the other body's particle) and the nearest particle's centre
  Real half_width = 0;                   ///< m, half the width of the particle that the point is
  bool touching = false;                 ///< the gap of a whole rim is less than half a particle's width
  Real area = 0;                         ///< m2 (per metre run: m), share of the body's surface; 0 where it is not needed
  int face = 0;                          ///< of the rigid body, where each has its own points (ContactPoints::faces)
  Index block = none;                    ///< of the particle that the point is, among those of its body on this rank, and
  int lane = 0;                          ///< its lane
  bool bonded = false;                   ///< carries tension
  Real adhesion = 0;                     ///< Pa; where it differs from point to point
  Real friction = 0;                     ///< tan of the friction angle; where it differs from point to point
  Real pore_pressure = 0;                ///< Pa, excess, of the particle that the point is, where its soil is undrained
  Real soil_pressure = 0;                ///< Pa, total normal stress on the surface in that particle, compression positive
  Real water_fraction = 0;               ///< what the water carries of the force along the normal (find_water_fractions)
  EffectiveMass mass;                    ///< 1 / sum of N^2 / M over all that the point moves; 0 where supports fix it
  /// 1/kg, a column a node: its velocity over the impulse of the point, by direction; 0 where supports fix it.
  Eigen::Matrix<Real, dim, dim + 1, Eigen::DontAlign> response = Eigen::Matrix<Real, dim, dim + 1, Eigen::DontAlign>::Zero();
  Vec<dim> response_of_other = Vec<dim>::Zero();  ///< the same of the other body's node, against the impulse
  Vec<dim> surface_velocity = Vec<dim>::Zero();   ///< m/s, of the rigid body in this step
  Vec<dim> impulse = Vec<dim>::Zero();            ///< on the body, in the present correction
  ContactStatus status = ContactStatus::open;     ///< in step 4
};

/// A part of the surface in contact, and the nodes that it belongs to.
template <int dim>
struct Footprint {
  std::array<Index, dim + 1> nodes{};   ///< of the cell of the particle that covers it, or the one node around which it lies
  std::array<Real, dim + 1> weights{};  ///< their shape functions there
  int node_count = 1;                   ///< 1 or dim + 1
  Real area = 0;                        ///< m2 (per metre run: m; in axisymmetry m2 per radian)
  int face = 0;                         ///< of the rigid body, as of the points

  // Of a particle at a rigid surface in the plane:
  int side = 0;              ///< of the rigid body
  Real along = 0;            ///< m, position on the side, whose ends are
  Real begin = 0, end = 0;   ///< m
  Real width = 0;            ///< m, of the particle
  Real left = 0, right = 0;  ///< m, extent against and along the side
  Real x = 0, x_slope = 0;   ///< m, x of the side there, and how it grows along the side
};

/// The points of one contact, detected anew in each step, and the work arrays of the detection; memory is reused.
template <int dim>
struct ContactPoints {
  /// Strip by strip, strips of a colour together (contact/strips.hpp): points of different strips of one colour share no node. Sums follow this order, which
  /// depends on the mesh and the rigid body's way alone.
  std::vector<ContactPoint<dim>> list;
  std::vector<Index> strip_begin = {0};     ///< in list, of each strip; then the end
  std::vector<Index> color_begin = {0, 0};  ///< in the strips, of each colour; then the end
  std::vector<int> owner;                   ///< where there are several ranks and points are particles: the rank of each
  Real nearest_particle = infinity;         ///< m, distance of the nearest particle from the rigid surface, negative inside

  // At a rigid body:
  std::vector<Index> near_cells;                            ///< cells that the surface can reach until it has moved `reach`
  std::vector<Index> first_near_cell;                       ///< where points are particles: of each strip, in near_cells; then the end
  std::vector<Index> near_nodes;                            ///< where points are nodes: those of near_cells, ascending
  CellField<Index> near_index;                              ///< 1 + index in near_cells (before they are strips) of a cell; 0 for others
  bodies::Pose<dim> listed = bodies::Pose<dim>::nowhere();  ///< of the rigid body, that near_cells is of
  Real reach = 0;                                           ///< m, the smallest height of all cells; 0 before the first step
  struct CellContact {
    Real gap = infinity, distance = infinity, half_width = 0;  ///< the gap of whole rims
    Vec<dim> normal = Vec<dim>::Zero();                        ///< at the particle with the smallest gap
    bool cut = false;                                          ///< the rigid body intersects the cell
    Index points = 0;                                          ///< particles whose gap is less than their width
    Index first_point = 0;                                     ///< in list, where points are particles
  };
  std::vector<CellContact> cells;  ///< of near_cells

  // Where there is adhesion:
  std::vector<Footprint<dim>> footprints;  ///< the surface in contact
  NodeField<Real> node_area, node_weight;  ///< m2 (per metre run: m), and sum of N, over the closed points
  int faces = 1;                           ///< each of so many shares its surface out among its own points (face_of)
  bool shared_out = false;                 ///< in this step already, over the points that
  std::vector<char> closed;                ///< were closed then

  // Where points are nodes:
  std::vector<Index> candidate_nodes;         ///< of two deformable bodies: those that particles of both contribute to
  std::vector<ContactPoint<dim>> candidates;  ///< one for each of them, or of near_nodes
  std::vector<Index> kept;                    ///< those of the candidates that are points

  struct SweepSums {
    Real changed = 0, carried = 0;  ///< N s: sum of the changes of impulses, and of the impulses
  };
  std::vector<std::array<SweepSums, 2>> sweep_sums;  ///< of each strip, in even and in odd sweeps
};

}  // namespace berm::contact
