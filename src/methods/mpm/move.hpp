// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Steps 5 and 9 to 11 on the particles of one body: velocity from the corrected acceleration (14), position from the
/// corrected velocity of the nodes (20), strain increment (21) with its volumetric part projected, Jaumann rotation of the
/// stress, constitutive law (22, 23), volume, accumulated deviatoric strain; and records the particles that have changed
/// cell. The moments of the cells are then those of the particles as they are.
template <int dim>
void move_and_strain(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body);

/// Its parts for update stress first: steps 10 and 11 (strain, stress, volume), which is the same pass without motion, and steps 5 and 9 (velocity, position),
/// which need no law. Each leaves the moments so, too. Straining throws RunError
/// where a velocity is not finite, before anything has changed: 0 times it would be none.
template <int dim>
void strain_particles(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body);
template <int dim>
void move_particles(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body);

}  // namespace berm::mpm
