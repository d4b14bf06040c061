// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// The nodal velocity that one correction makes satisfy the contact law, and where its change is stored.
template <int dim>
struct Predicted {  ///< step 4: v + dt a
  static constexpr bool is_force = true;
  Real dt;
  Vec<dim> velocity(const BodyGrid<dim>& grid, Index node) const { return grid.velocity[node] + dt * grid.acceleration[node]; }
  void change(BodyGrid<dim>& grid, Index node, const Vec<dim>& by) const { grid.acceleration[node] += by / dt; }
};
template <int dim>
struct Moved {  ///< step 8: the velocity that moves the particles
  static constexpr bool is_force = false;
  Vec<dim> velocity(const BodyGrid<dim>& grid, Index node) const { return grid.mapped_velocity[node]; }
  void change(BodyGrid<dim>& grid, Index node, const Vec<dim>& by) const { grid.mapped_velocity[node] += by; }
};
template <int dim>
struct MovedWithParticles {  ///< step 8: the same, and the velocity that the particles carry
  static constexpr bool is_force = true;
  Real dt;
  Vec<dim> velocity(const BodyGrid<dim>& grid, Index node) const { return grid.mapped_velocity[node]; }
  void change(BodyGrid<dim>& grid, Index node, const Vec<dim>& by) const
  {
    grid.mapped_velocity[node] += by;
    grid.acceleration[node] += by / dt;
  }
};

/// The velocity of the body at a point relative to the other side.
template <int dim, class Field>
Vec<dim> relative_velocity(const Workspace<dim>& workspace, const problem::Contact& contact, const contact::ContactPoint<dim>& point,
                           const Field& field)
{
  Vec<dim> relative = contact.rigid != none ? Vec<dim>(-point.surface_velocity)
                                            : Vec<dim>(-field.velocity(workspace.grids[contact.other_body], point.nodes[0]));
  for (int n = 0; n < point.node_count; ++n) relative += point.weights[n] * field.velocity(workspace.grids[contact.body], point.nodes[n]);
  return relative;
}

}  // namespace berm::mpm
