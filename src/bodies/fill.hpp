// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/body_settings.hpp"
#include "bodies/particles.hpp"
#include "bodies/rigid.hpp"

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
  int state_size;                           ///< numbers that the law keeps for a particle
  std::vector<RigidShape<dim>> holes = {};  ///< rigid bodies that it has a contact with: they take the place of its particles
};

/// The stress of a body at the start, Pa: initial_stress, or that of a flat bed where k0 is given: sigma_yy = -unit_weight depth, not above the bed's
/// surface, and sigma_xx = sigma_zz = k0 sigma_yy. unit_weight in N/m3, depth in m.
template <int dim>
SymTensor<dim> first_stress(const BodySettings& body, Real unit_weight, Real depth);

/// Fills the body's regions, block or disk, but for the holes, with particles at rest or with its first velocity, and with its first stress.
/// Throws InputError where a region is unknown or a block or disk leaves the mesh.
template <int dim>
Particles<dim> fill(const mesh::Mesh<dim>& mesh, const std::string& name, const BodySettings& body, const StartState<dim>& start);

}  // namespace berm::bodies
