// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Fractions of the mass of all bodies that can yield; 0 without such bodies.
struct SoilCondition {
  Real at_min_volume = 0;  ///< in particles at their minimum volume
  Real at_max_volume = 0;  ///< in particles at their maximum volume
  Real in_the_air = 0;     ///< in cells at none of whose nodes a quarter of the surrounding cells' volume is filled: ejected particles
};
template <int dim>
SoilCondition soil_condition(const problem::Model<dim>& model, const problem::State<dim>& state);

/// Pressure of the velocity fluctuations that the mesh does not resolve, over the mean of the pressure that gives the soil its strength, within half a
/// width of the main rigid body:
///
///   rho c_P v' / (p + c cot(phi)),   v'^2 = mean over particles and directions of the square of v_p - (mean velocity of the cell) - grad v_i (x_p - mean position).
///
/// At 1, sand has lost its strength. NaN where there is no such body or no pressure, or where the strength of the soil does not depend on the pressure.
template <int dim>
Real shaking(const problem::Model<dim>& model, const problem::State<dim>& state, const Workspace<dim>& workspace);

}  // namespace berm::mpm
