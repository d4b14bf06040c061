// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/body_settings.hpp"
#include "bodies/particles.hpp"
#include "bodies/rigid/rigid_body.hpp"

namespace berm::bodies {

/// Barycentric coordinates of n^dim points that share a simplex equally: the centroids of the n^dim equal parts that a regular subdivision makes.
template <int dim>
std::vector<std::array<Real, dim + 1>> points_in_simplex(int n);

/// How many particles fill() makes of a block or disk (about), and of a cell of a region, holes not counted.
template <int dim>
Real particles_in(const BlockSettings& block);
Real particles_in(const DiskSettings& disk);
template <int dim>
Real particles_per_cell(const BodySettings& body, const std::string& region);

/// The region of the mesh that the body `name` fills. Throws InputError where the mesh has none of that name.
template <int dim>
Index filled_region(const mesh::Mesh<dim>& mesh, const std::string& name, const std::string& region);

/// The state of the body at the start.
template <int dim>
struct StartState {
  Real density;                             ///< kg/m3
  Real vertical_gravity;                    ///< m/s2, positive downwards
  Real surface;                             ///< m, level of the bed's surface
  std::vector<FieldInfo> extra = {};        ///< fields of a particle beside those that every one has; what the law keeps comes first
  std::vector<RigidShape<dim>> holes = {};  ///< rigid bodies that it has a contact with: they take the place of its particles
};

/// Fills the body's regions, block or disk, but for the holes, with particles at rest or with its first velocity, and with its first stress.
/// Throws InputError where a region is unknown or a block or disk leaves the mesh.
template <int dim>
Particles<dim> fill(const mesh::Mesh<dim>& mesh, const std::string& name, const BodySettings& body, const StartState<dim>& start);

}  // namespace berm::bodies
