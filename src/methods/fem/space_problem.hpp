// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/direct_solver.hpp"
#include "fem/fem_problem.hpp"

namespace berm::fem {

/// The 10-node tetrahedra of the cells in the regions of the bodies; other cells are left out. Nodes are held as those of the mesh are in this stage (supports, planes of symmetry); a
/// mid-side node where the side belongs to a face at the boundary whose corners are held by one condition. Sides along the round surface of a cylinder are curved.
/// Throws InputError as make_quadratic does.
struct SpaceMesh : QuadraticElements<3> {
  /// A face of an element at the boundary of the bodies: its corners, and the middles of the sides 01, 12 and 20.
  using Face = std::array<Index, 6>;
  std::vector<Face> boundary_faces;
};
SpaceMesh make_tetrahedra(const problem::Model<3>& model, const settings::Case& c);

/// A part that an unknown has in the displacement of a node.
struct UnknownPart {
  Index unknown;
  Real factor;
};

/// What cannot change during a run with finite elements in space. Strains are small; rigid bodies are tied to the nodes at their surface: no gap, no slip; no water flows.
struct SpaceModel {
  problem::Model<3> model;  ///< its mesh is that of the corners
  SpaceMesh mesh;
  CellField<std::array<ElementPoint<3>, element_points<3>>> shape;
  CellField<AtElementNodes<3, Vec<3>>> mean_gradient;      ///< 1/m, of the shape functions over the element: that of the volumetric strain
  CellField<std::array<Real, element_points<3>>> density;  ///< kg/m3, that gives the weight
  CellField<std::array<settings::SoilPlace, element_points<3>>> place;  ///< m, of the integration points
  NodeField<Vec<3>>
      rest_force;         ///< N, what the mean pressures of the elements lack of the forces of the stress at rest, which grows with depth
  NodeField<Index> tied;  ///< the contact whose rigid body moves the node, or none
  Real width = 1;         ///< m, of the narrowest rigid body in contact; 1 where there is none
  Real weight = 0;        ///< N, of all soil
  settings::FemSettings settings;
  SparsePattern pattern;

  // Unknowns: 3 i + d is the displacement of node i along d, which of a tied node follows from its body's; then six (x, y, z, rotations about them) of the rigid body of
  // each contact.
  Index contact_count() const { return static_cast<Index>(model.contacts.size()); }
  Index rigid_unknown(Index contact = 0) const { return 3 * mesh.node_count() + 6 * contact; }
  Index unknowns() const { return rigid_unknown(contact_count()); }
  const bodies::RigidBody<3>& rigid_of(Index contact) const { return model.rigid_bodies[model.contacts[contact].rigid]; }
  /// The contact of a rigid body with the soil, or none.
  Index contact_of(Index rigid) const
  {
    for (Index contact = 0; contact < contact_count(); ++contact)
      if (model.contacts[contact].rigid == rigid) return contact;
    return none;
  }
  /// m, of a tied node from the centre of its body.
  Vec<3> arm_of(Index node) const { return mesh.position[node] - center_of<3>(rigid_of(tied[node]).shape); }
  /// Calls visit(UnknownPart) for the unknowns that the displacement of a node along d is the sum of: of a tied node u + rotation x arm.
  template <class Visit>
  void for_parts(Index node, int d, const Visit& visit) const
  {
    if (tied[node] == none) return visit(UnknownPart{3 * node + d, 1});
    const Index first = rigid_unknown(tied[node]);
    const Vec<3> arm = arm_of(node);
    visit(UnknownPart{first + d, 1});
    visit(UnknownPart{first + 3 + (d + 1) % 3, arm[(d + 2) % 3]});
    visit(UnknownPart{first + 3 + (d + 2) % 3, -arm[(d + 1) % 3]});
  }

  const settings::BodySoil& soil_of(Index cell) const { return model.bodies[mesh.body[cell]].soil; }
  const std::string& region_of(Index cell) const { return model.mesh.region_names[mesh.region[cell]]; }
  material::Material soil_at(Index cell, int q) const
  {
    return regularised_for(soil_of(cell).at(region_of(cell), place[cell][q]), model.mesh.size(cell));
  }
};

/// Everything that changes during such a run.
struct SpaceState {
  problem::State<3> state;         ///< time, stage, rigid bodies, totals; no particles
  std::vector<Real> displacement;  ///< by unknown, m or rad
  CellField<std::array<ElementSoil<3>, element_points<3>>> points;
  Vec<3> gravity = Vec<3>::Zero();    ///< m/s2, acting
  Real initial_imbalance_factor = 0;  ///< fraction of the initial unbalanced forces that fictitious forces still balance
  Real unbalanced = 0;                ///< N, sum of the unbalanced nodal forces
  Real overstress = 0;                ///< overstress over stress: integrals of both over the soil at yield
};

struct SpaceProblem {
  SpaceModel model;
  SpaceState state;
};

/// Builds elements and initial state on this mesh. Throws InputError where the case asks for what finite elements in space do not have, or where the mesh has no face on the surface of a
/// rigid body in contact.
SpaceProblem build_in_space(const settings::Case& c, mesh::Mesh<3> mesh);

/// The whole state, bit for bit. Reading puts it into one that was built for the same case. Throws RunError where elements or unknowns are not as many.
void archive(Archive& k, const SpaceModel& model, SpaceState& state);

}  // namespace berm::fem
