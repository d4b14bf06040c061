// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

// Inactive cells (MpmSettings::active_distance): while a stage drives a rigid body, cells farther than that from every bounded rigid body are left out of the
// steps. Their particles neither move nor strain, and keep their stress; their nodes are held in all directions, so that active soil ends at a fixed boundary.
// Cells of one patch are inactive together. Nodes have the mass of active cells only: what is held balances what is active, and impulses of supports stay those of the
// momentum balance.

/// Makes the cells inactive that state.active_soil says: at the start, and of a run that is resumed.
template <int dim>
void set_inactive_cells(const problem::Model<dim>& model, problem::State<dim>& state);

/// Finds anew which soil is active, where a rigid body has gone a tenth of the active distance since, or a stage begins or ends that drives one. Soil that becomes
/// inactive loses its velocity: its kinetic energy goes to what damping takes, its momentum to the supports. Nothing happens without an active distance.
template <int dim>
void update_inactive_cells(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace);

/// Adds the nodes of inactive cells to the supports of this step.
template <int dim>
void hold_inactive_cells(const problem::Model<dim>& model, const problem::State<dim>& state, Workspace<dim>& workspace);

}  // namespace berm::mpm
