// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/shape.hpp"
#include "mesh/ground_line.hpp"
#include "mesh/mesh.hpp"
#include "settings/case.hpp"

namespace berm::problem {

/// The surface of a bed that is not level in the plane x-y, up being +y; level() where it is, and in space on meshes of other kinds than "seabed".
struct Ground {
  mesh::GroundLine line;                 ///< at the start, m
  mesh::GroundLine laid_down;            ///< from which depth in the soil counts: without a trench; level: from `surface`
  bool embedment_counts_from_it = true;  ///< unless the input names the level `surface`

  /// The level from which the embedment of a body with its axis at x counts, m; `surface`: that of a level bed.
  Real level_at(Real x, Real surface) const { return line.level() || !embedment_counts_from_it ? surface : line.height(x); }
  /// Depth in the soil of a point at x that lies w below that level, m: in a trench w and the depth of the trench.
  Real soil_depth_at(Real x, Real w, Real surface) const
  {
    return (laid_down.level() ? surface : laid_down.height(x)) - level_at(x, surface) + w;
  }
  /// Takes the surface of a mesh that does not say how its soil was laid down: depth in the soil counts from where embedment does.
  void take_found(mesh::GroundLine found);
};

/// The first surface of a bed, level or not.
struct BedSurface {
  BedSurface(Real y, mesh::GroundLine uneven = {}) : level(y), line(std::move(uneven)) {}  // NOLINT: a level is a surface

  Real level;             ///< m
  mesh::GroundLine line;  ///< where it is not level

  Real at(Real x) const { return line.level() ? level : line.height(x); }
};

/// As far as the input says it: that of a mesh that berm makes.
Ground ground_of(const settings::Case& c);

/// Also that of a mesh of Gmsh: the upper boundary of the regions that bodies fill. Corners on the surface of a rigid body, around which the mesh was shaped,
/// are left out.
Ground ground_in(const settings::Case& c, const mesh::Mesh<2>& mesh, const std::vector<bodies::RigidShape<2>>& rigid_bodies);

/// Whether the stress at the start is that of gravity loading.
bool loads_by_gravity(const settings::Case& c, const Ground& ground);

}  // namespace berm::problem
