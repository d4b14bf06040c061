// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/outline.hpp"
#include "os/gmsh_program.hpp"

#include <filesystem>
#include <memory>

namespace berm::fem {

/// Large deformations by small ones: after each travel of a rigid body the soil that it has deformed is meshed anew, and what its points carry is mapped (remeshing and interpolation with small
/// strain, RITSS, of Hu and Randolph 1998; here the increments are those of updated Lagrange).
class Remesher {
public:
  /// Meshes are made in `folder`. Throws InputError where the method does not take the case.
  Remesher(const settings::Case& c, std::filesystem::path folder);

  const settings::Case& settings() const { return case_; }

  /// Whether a body has travelled far enough, soil that no contact point stands for has come to it, soil has gone beyond a wall, or an element is about to fold.
  bool is_due(const FemModel& model, const FemState& state) const;

  /// The largest travel of a body since the mesh was made, m.
  static Real travel_since_mesh(const FemModel& model, const FemState& state);

  /// Throws RunError where two rigid bodies have come so near to each other that no elements fit between them.
  void refuse_bodies_that_meet(const FemModel& model, const FemState& state) const;

  /// Puts a new mesh in the place of the old one. The state is then out of equilibrium by the error of the mapping. Throws RunError where no mesh can be made. Gives the
  /// number of places at which soil has folded onto soil or come to a wall.
  int remesh(FemModel& model, FemState& state) const;

private:
  mesh::Mesh<2> make_mesh(const FemModel& model, const FemState& state, const std::vector<OutlineLoop>& outline) const;
  ElementSizes sizes_for(const FemModel& model) const;

  settings::Case case_;
  std::filesystem::path folder_;
  std::unique_ptr<WaitingGmsh> gmsh_;
};

/// Gives the new state what the old one has. Stress is linear between its means at the corners of the old mesh, variables of the law are linear in each old element; both are put back onto the surface of the
/// law. Shear stress of the contact goes by the means of its sides; pore pressures and places where the soil was by the shape functions. `outline`: of the new mesh, by node; null inside.
void map_state(const FemModel& old_model, const FemState& old_state, const std::vector<const OutlinePoint*>& outline,
               const settings::Case& c, FemModel& model, FemState& state);

/// What a mapping should keep: the elastic energy of the soil by its effective stress and the moduli there (J/m), and its area (m2); around an axis both per radian, of its volume.
struct Content {
  Real energy = 0, area = 0;
};
Content content_of(const FemModel& model, const FemState& state);

}  // namespace berm::fem
