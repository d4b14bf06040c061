// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/body_settings.hpp"
#include "bodies/particles.hpp"
#include "bodies/rigid/rigid_body.hpp"

#include <functional>

namespace berm::bodies {

/// Barycentric coordinates of n^dim points that share a simplex equally: the centroids of the n^dim equal parts that a regular subdivision makes.
template <int dim>
std::vector<std::array<Real, dim + 1>> points_in_simplex(int n);

/// Particles of a cell where the case does not say how many.
template <int dim>
constexpr int usual_particles_per_cell = dim == 2 ? 9 : 8;

/// Whether so many particles can share a cell: n^dim, in the plane also 2 n^2.
template <int dim>
bool shares_cell(int count);

/// Points that share a cell equally: the centroids of n^dim equal parts, or of 2 n^2, which are those of n^2 cut in two across the cell's longest side.
template <int dim>
class CellPoints {
public:
  CellPoints() = default;
  explicit CellPoints(int count);

  int count() const { return static_cast<int>(points_.size()); }
  /// The place of point k in a cell.
  Vec<dim> at(const mesh::Mesh<dim>& mesh, Index cell, int k) const;

private:
  std::vector<std::array<Real, dim + 1>> points_;
  bool cuts_longest_side_ = false;  ///< corner 0 is the one opposite to it
};

/// Number of particles that fill() makes of a block or disk (estimated), and of a cell of a region, ignoring holes.
template <int dim>
Real particles_in(const BlockSettings& block);
Real particles_in(const DiskSettings& disk);
template <int dim>
int particles_per_cell(const BodySettings& body, const std::string& region);

/// The region of the mesh that the body `name` fills. Throws InputError where the mesh has none of that name.
template <int dim>
Index filled_region(const mesh::Mesh<dim>& mesh, const std::string& name, const std::string& region);

/// What a particle takes where the soil of its body varies.
struct SoilAtPoint {
  Real density;           ///< kg/m3, that gives the inertia
  Real vertical_stress;   ///< Pa, of the level bed above, compression positive
  Real depth;             ///< m below the bed's surface
  std::vector<Real> own;  ///< the extra numbers that follow the law's state variables
};

/// Initial state of a body.
template <int dim>
struct StartState {
  Real density;                             ///< kg/m3
  Real vertical_gravity;                    ///< m/s2, positive downwards
  Real surface;                             ///< m, level of the bed's surface
  std::vector<FieldInfo> extra = {};        ///< extra fields of its particles; the law's state variables come first
  int first_local = 0;                      ///< where among their numbers SoilAtPoint::own begins
  Index room = 0;                           ///< for particles that may come later
  std::vector<RigidShape<dim>> holes = {};  ///< rigid bodies in contact with it, which displace its particles
  /// Of soil that varies, at a point in a cell; replaces density and stress.
  std::function<SoilAtPoint(Index cell, const Vec<dim>& x)> soil_at = {};
};

/// Fills the body's regions, block or disk, except for the holes, with particles at their initial velocity and stress.
/// Throws InputError where a region is unknown or a block or disk leaves the mesh.
template <int dim>
Particles<dim> fill(const mesh::Mesh<dim>& mesh, const std::string& name, const BodySettings& body, const StartState<dim>& start);

}  // namespace berm::bodies
