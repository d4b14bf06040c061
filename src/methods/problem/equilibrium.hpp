// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// The greatest depth of these cells below ground that is not level, m.
template <int dim>
Real depth_below_ground(const Model<dim>& model, const std::vector<Index>& cells);

/// The longest period with which the soil of a case swings under its own weight, s: T = 4 H / c_S of a shear layer as high as all its bodies, with their slowest shear waves.
template <int dim>
Real longest_period(const Model<dim>& model, const std::vector<bodies::Particles<dim>>& particles);

/// Gives each rigid body the time in which its reaction fades: that in which the slowest pressure wave of the soils that touch it, down to its own width, goes ten times across it. What is
/// shorter is its chatter and that of the mesh. The travel is a hundredth of its width, over which key results are averaged, too; of a half-plane these are of the least side of the mesh.
template <int dim>
void set_fading(Model<dim>& model);

/// The longest period with which waves of pressure swing in soil whose water flows, s: T = 4 H / c of a layer as high as all bodies, closed at its base and open at its top, with the
/// slowest wave in which water and soil move together. 0 where no water flows.
template <int dim>
Real longest_pressure_period(const Model<dim>& model, const std::vector<bodies::Particles<dim>>& particles);

/// The time in which local damping alpha takes an out-of-balance force as large as the weight down to the accepted part of it, s. A period T leaves
/// (1 - alpha) / (1 + alpha) < exp(-2 alpha) of a swing, since the force speeds it up with its part 1 - alpha and slows it down with 1 + alpha, so that
///
///   t = margin T ln(1 / accepted) / (2 alpha),
///
/// with a margin of 4 for soil that yields on its way.
Real time_to_equilibrium(Real period, Real damping, Real accepted);

/// Gives each stage that ends at equilibrium its limit of time, where the input names none (that of gravity's ramp and time_to_equilibrium; in a trial of the factor of safety ten times as
/// long), and the model its period.
template <int dim>
void limit_equilibrium(const settings::Case& c, Model<dim>& model, const std::vector<bodies::Particles<dim>>& particles);

/// The root mean square velocity of a cell's particles up to which they are at rest, m/s: that of a swing with the model's period whose force out of balance is the
/// accepted part of the weight,
///
///   v = accepted g T / (2 pi).
template <int dim>
Real velocity_at_rest(const Model<dim>& model, const settings::StageSettings& stage);

/// Whether all of gravity acts, a wave had the time to cross the soil since the stage began, and the force out of balance over the weight is accepted.
template <int dim>
bool in_balance(const Model<dim>& model, const State<dim>& state, Real out_of_balance);

}  // namespace berm::problem
