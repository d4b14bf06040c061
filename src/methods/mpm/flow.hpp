// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

// Soil whose water flows: velocity v of the soil and flux w of the water against it (Darcy) at the nodes, excess pore pressure p in the particles. With the
// density rho of the saturated soil, rho_w and gamma_w of the water, porosity n and permeability k (Zienkiewicz, Chang and Bettess 1980):
//
//   rho dv/dt + rho_w dw/dt = div(sigma) + rho b,   rho_w dv/dt + (rho_w / n) dw/dt = -grad p - (gamma_w / k) w,   dp/dt = -(K_w / n) (div v + div w).
//
// The drag is taken at the end of the step, so that no permeability limits it: each node solves two equations in two unknowns. Open surfaces have p = 0, the
// natural condition. Nothing happens in bodies whose water does not flow.

/// Means of the pore pressure, of rho_w / n and of gamma_w / k over the particles of each cell, as they are at the start of a step.
template <int dim>
void average_water(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, Index body, BodyGrid<dim>& grid);

/// Rate, 1/(Pa s), at which water levels the pressures of the particles of one cell, over K_w / n: by Darcy's law a wave of pressure as long as two cells decays
/// with pi^2 / (drag h^2) K_w / n in soil that is strained uniformly; h^2 the section of the cell, m2 (in space its volume, to the power 2/3).
template <int dim>
Real leveling_rate(const WaterCell& water, Real section)
{
  const Real square = dim == 2 ? section : std::cbrt(section * section);
  return pi * pi / (water.drag * square);
}

/// What the cells give the water at their corners: its mass, drag and the force of its pressure. With the volumetric projection the pressure is the average over
/// the patch.
template <int dim>
void spread_water_forces(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid);

/// The nodes gather that from their cells, for solve_momentum_balance.
template <int dim>
void gather_water(const problem::Model<dim>& model, Real dt, BodyGrid<dim>& grid);

/// Adds the pressure of the water outside of drained supports that have a head: per area p_out along the normal n into the soil, on the area that the cells at the
/// node have there,
///
///   F = p_out A n,   A = -n . sum V grad N,
///
/// so that an excess pressure that is the same inside and outside moves no water.
template <int dim>
void apply_heads(const problem::Model<dim>& model, const problem::State<dim>& state, BodyGrid<dim>& grid);

/// Marks the nodes of points that touch a rigid body which is not drained by its normal, for advance_flux. Drained ones are as open as a free surface. At the nodes
/// of contact points the soil takes the whole force, so that contact, which changes its velocity twice in a step, keeps its momentum: soil and water do not feel
/// each other's inertia there.
template <int dim>
void mark_impermeable_surfaces(const problem::Model<dim>& model, Workspace<dim>& workspace);

/// The flux at the end of the step, from the change of the nodal velocity that the particles carry; that of the accelerations would give soil and water energy that
/// neither has lost. None through supports. Along the normal of a impermeable body only the difference between the pressures on both sides of a node moves water, and
/// it goes from the cells on the one side to those on the other: none goes into the body, where it lies between the nodes, too. What the change of the flux takes
/// of the soil's momentum and energy goes to the totals.
template <int dim>
void advance_flux(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body);

/// Takes note of the largest excess pore pressure that acts, averaged over a patch, as it was when the step began: of cells at least half of which is soil. Adds the pressures
/// to their window of time (problem/pressure_means.hpp), and takes the largest mean where it ends.
template <int dim>
void note_pressures(const problem::Model<dim>& model, problem::State<dim>& state, const Workspace<dim>& workspace);

/// The volume of water that leaves each cell in this step.
template <int dim>
void sum_outflows(const problem::Model<dim>& model, const problem::State<dim>& state, BodyGrid<dim>& grid, Index body);

}  // namespace berm::mpm
