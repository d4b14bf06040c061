// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rounding.hpp"
#include "core/archive.hpp"
#include "fem/contact_points.hpp"
#include "fem/direct_solver.hpp"
#include "fem/element.hpp"
#include "fem/flow.hpp"
#include "fem/quadratic_mesh.hpp"
#include "fem/side_loads.hpp"
#include "problem/model.hpp"

namespace berm::fem {

/// A point of the soil whose motion and stress are written to the history: its element, and the part that each node of it has in the displacement and
/// each integration point in the stress, which is linear in an element.
struct FemWatch {
  std::string name;
  Index cell = none;
  AtSixNodes<Real> of_nodes = {};
  std::array<Real, triangle_points> of_points = {};
};

/// What cannot change during a finite element run: the same model as for the material point method, and the elements; but in large deformations the elements and
/// what follows from them are made anew now and then (fit_to_mesh).
struct FemModel {
  problem::Model<2> model;  ///< its mesh is that of the corners
  QuadraticMesh mesh;
  CellField<std::array<ShapeAtPoint, triangle_points>> shape;
  CellField<Real> cell_size;                                          ///< m, root of the element's area
  CellField<std::array<Real, triangle_points>> density;               ///< kg/m3, at the integration points, that gives the weight
  CellField<std::array<settings::SoilPlace, triangle_points>> place;  ///< m, of the integration points at the start
  std::vector<FemContactPoint> contact;     ///< contact by contact; in large deformations where they are at the start of the increment
  std::vector<BoundarySide> contact_sides;  ///< in large deformations: those that may come into contact before the next remeshing
  std::vector<std::vector<bodies::Fillet>>
      fillets;  ///< by rigid body: in large deformations the arcs of its re-entrant corners, where it is at the start
  std::vector<FemInterface> interfaces;  ///< by contact, but for friction and adhesion, which are those of the point
  Real width = 1;   ///< m, of the narrowest rigid body in contact, unit of the increments of travel; 1 where there is none
  Real weight = 0;  ///< N/m, of all soil
  std::vector<std::vector<NodalLoad>> loads;  ///< by traction
  settings::FemSettings settings;
  bool non_associated = false;  ///< the flow of some soil is non-associated
  bool unsymmetric = false;     ///< so is the matrix of some soil
  Real patience = 1;            ///< relaxation times that a stage without motion lasts, over the usual number
  std::vector<FemWatch> watches;
  FlowModel flow;

  // Unknowns: 2 i and 2 i + 1 are the displacements (x, y) of node i; then three (x, y, angle) of the rigid body of each contact; then the excess pore
  // pressures, where water flows.
  SparsePattern pattern;                          ///< of the soil alone, its lower triangle
  CellField<std::array<Index, 78>> cell_entries;  ///< in the pattern, of the lower triangle of each element's 12 x 12 entries, row by row
  /// The material at an integration point of a cell, with its strength and stiffness there and the friction of such cells.
  material::Material soil_at(Index cell, int q) const
  {
    return regularised_for(soil_of(cell).at(region_of(cell), place[cell][q]), model.mesh.size(cell));
  }
  const settings::BodySoil& soil_of(Index cell) const { return model.bodies[mesh.body[cell]].soil; }
  const std::string& region_of(Index cell) const { return model.mesh.region_names[mesh.region[cell]]; }

  Index unknowns() const { return pressure_unknown() + flow.count; }
  Index rigid_unknown(Index contact = 0) const { return 2 * mesh.position.size() + 3 * contact; }
  Index pressure_unknown() const { return rigid_unknown(contact_count()); }
  /// Those that a contact point joins: of its node and of its rigid body.
  std::array<Index, 5> unknowns_of(const FemContactPoint& point) const
  {
    const Index first = rigid_unknown(point.contact);
    return {2 * point.node, 2 * point.node + 1, first, first + 1, first + 2};
  }

  Index contact_count() const { return static_cast<Index>(model.contacts.size()); }
  /// The rigid body of a contact, of which each has another.
  const bodies::RigidBody<2>& rigid_of(Index contact) const { return model.rigid_bodies[model.contacts[contact].rigid]; }
  /// The contact of a rigid body with the soil, or none.
  Index contact_of(Index rigid) const
  {
    for (Index contact = 0; contact < contact_count(); ++contact)
      if (model.contacts[contact].rigid == rigid) return contact;
    return none;
  }
  /// Pa/m, of the stiffest interface; 0 without contact.
  Real contact_stiffness() const
  {
    Real stiffest = 0;
    for (const FemInterface& interface : interfaces) stiffest = std::max(stiffest, interface.stiffness);
    return stiffest;
  }
};

/// State of the soil at an integration point.
template <int dim>
struct ElementSoil {
  SymTensor<dim> stress;                              ///< Pa, tension positive
  std::array<Real, material::max_state> law_state{};  ///< state variables of the law: material::state_fields
  Real deviatoric_strain = 0;                         ///< accumulated
  Real overstress = 0;                                ///< Pa, distance of the stress from the yield surface, in the norm of a tensor
};
using SoilPoint = ElementSoil<2>;

/// Moments at which places of the soil are kept in large deformations: the start, the last frame, and that from which displacements count.
enum class Moment { start, last_frame, zero };
constexpr int moments = 3;

/// Everything that changes during a finite element run.
struct FemState {
  problem::State<2> state;  ///< time, stage, rigid bodies, totals; no particles
  std::vector<Real>
      displacement;  ///< by unknown: m, of nodes since their mesh was made; rad for the angle, and Pa for excess pore pressures
  CellField<std::array<SoilPoint, triangle_points>> points;
  std::vector<FemContactState> contact;
  std::vector<Vec<2>> support_forces;  ///< N/m, on the soil, by support that is reported
  Vec<2> gravity = Vec<2>::Zero();     ///< m/s2, acting
  std::vector<Real> tractions;         ///< load factor of each
  Real initial_imbalance_factor = 0;   ///< fraction of the initial unbalanced forces that fictitious forces still balance
  Real unbalanced = 0;                 ///< N/m, sum of the unbalanced nodal forces
  Real overstress = 0;                 ///< overstress over stress: integrals of both over the soil at yield
  /// In large deformations, by moment: where the soil that is now at each node was then, m.
  std::array<NodeField<Vec<2>>, moments> was_at;
  std::vector<bodies::Pose<2>> meshed_at;  ///< in large deformations: those of the rigid bodies when the mesh was made

  NodeField<Vec<2>>& place_at(Moment moment) { return was_at[static_cast<std::size_t>(moment)]; }
  const NodeField<Vec<2>>& place_at(Moment moment) const { return was_at[static_cast<std::size_t>(moment)]; }
};

/// Where a node is, m.
inline Vec<2> position_now(const FemModel& model, const FemState& state, Index node)
{
  return model.mesh.position[node] + Vec<2>(state.displacement[2 * node], state.displacement[2 * node + 1]);
}

/// Where the nodes of an element are, m.
inline AtSixNodes<Vec<2>> positions_now(const FemModel& model, const FemState& state, Index cell)
{
  AtSixNodes<Vec<2>> positions;
  for (int k = 0; k < 6; ++k) positions[k] = position_now(model, state, model.mesh.nodes[cell][k]);
  return positions;
}

/// Where all nodes are with these displacements since their mesh was made, by unknown, m.
NodeField<Vec<2>> positions_with(const FemModel& model, const std::vector<Real>& displacement);

/// In large deformations: the places of the soil at this moment are those with these displacements since the mesh was made, by unknown.
void note_places(const FemModel& model, Moment moment, const std::vector<Real>& displacement, FemState& state);

/// Where the rigid body is when its three unknowns have these values.
inline bodies::Pose<2> pose_of(const Vec<3>& unknowns)
{
  bodies::Pose<2> pose;
  pose.displacement = unknowns.head<2>();
  pose.orientation.angle = unknowns[2];
  return pose;
}

/// The point of the surface of the rigid body of a contact that is nearest to x, where the body is now.
bodies::SurfacePoint<2> surface_now(const FemModel& model, Index contact, const bodies::Pose<2>& pose, const Vec<2>& x);

/// Where the rigid bodies are.
inline std::vector<bodies::Pose<2>> poses_of(const FemState& state)
{
  return {state.state.rigid_bodies.begin(), state.state.rigid_bodies.end()};
}

/// The point of the surfaces of all rigid bodies in contact that is nearest to x, and whose contact it is: none, at an infinite distance, without contact.
struct NearestSurface : bodies::SurfacePoint<2> {
  Index contact = none;
};
NearestSurface nearest_surface(const FemModel& model, const std::vector<bodies::Pose<2>>& poses, const Vec<2>& x);

/// The rigid bodies in contact where they are, by contact.
std::vector<bodies::RigidShape<2>> shapes_in_contact(const FemModel& model, const FemState& state);

/// The interface at a contact point in an increment that begins with this state.
FemInterface interface_at(const FemModel& model, std::size_t point, const FemState& begin);

struct FemProblem {
  FemModel model;
  FemState state;
};

/// Makes what follows from `model.mesh`: contact points, loads, shapes, water, unknowns and their pattern. `was_at`: where the soil at each node was at the start, by which it has its
/// strength; `poses`: of the rigid bodies. Throws InputError where the case does not fit the method.
void fit_to_mesh(const settings::Case& c, const NodeField<Vec<2>>& was_at, const std::vector<bodies::Pose<2>>& poses, FemModel& model);

/// In large deformations: puts the contact points where the nodes and the rigid bodies are.
void place_contact(FemModel& model, const FemState& state);

/// Builds mesh, elements and initial state. Throws InputError where the case does not fit the method.
FemProblem build_fem(const settings::Case& c, const std::string& case_folder, const std::string& work_folder);

/// The point in the elements of a body that is nearest to this one: itself where it lies in the body.
FemWatch make_watch(const QuadraticMesh& mesh, const std::string& name, const Vec<2>& point, Index body);

/// Gives the corners of elements whose water flows their unknowns, and finds where it leaves the soil: at sides of the boundary that are
/// neither at a rigid body that is not drained, nor on the axis, nor held across by a support that is not drained, and beside drained soil.
/// The porosity is that which the soil has by now.
void make_flow(const NodeField<Vec<2>>& was_at, const std::vector<bodies::Pose<2>>& poses, FemModel& model);

/// Initial stress by gravity loading (InitialState::gravity_loading) on 6-node triangles: the integration points get the
/// stress in equilibrium with gravity and the supports of the first stage for the elasticity GroundElasticity. Holes are
/// empty, the strength is ignored. Throws InputError where the supports do not hold the soil.
void load_by_gravity(const settings::Case& c, const FemModel& model, FemState& state);

/// In large deformations: the mesh that a state is of, bit for bit; reading it also makes what follows from it (fit_to_mesh). To be called before the state. Throws RunError where what is read is no mesh.
void archive_mesh(Archive& k, const settings::Case& c, FemModel& model, FemState& state);

/// The whole state, bit for bit. Reading puts it into one that was built for the same case. Throws RunError where elements, contact points or unknowns are
/// not as many, or where what is read cannot be a state of this model.
void archive(Archive& k, const FemModel& model, FemState& state);

}  // namespace berm::fem
