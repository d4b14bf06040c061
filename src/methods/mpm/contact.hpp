// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Detects the contact points of all contacts and marks the nodes that are exempt from damping.
template <int dim>
void find_contacts(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace);

/// Step 4: corrects the accelerations of contact nodes so that the predicted velocities v + dt a satisfy the contact law
/// (equations 8-14). The impulses of these corrections are the reactions: the rigid or the other body gets the opposite.
template <int dim>
void correct_accelerations(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace);

/// Step 8: corrects the velocities that move and strain the particles, as the scheme of each contact says. Where it
/// completes the impulse of step 4 (musl_coupled at particles) its impulse is part of the reaction; elsewhere it is no
/// force, is only reported (second_impulse), and does not change the particles' own velocities.
template <int dim>
void correct_velocities(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace);

}  // namespace berm::mpm
