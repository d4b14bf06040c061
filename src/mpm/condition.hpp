// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Parts of the mass of all bodies that can yield; 0 without such bodies.
struct SoilCondition {
  Real at_min_volume = 0;  ///< in particles at the smallest volume that they may have
  Real at_max_volume = 0;  ///< in particles at the largest
  Real in_the_air = 0;     ///< in cells around none of whose nodes particles fill a quarter of the cells: grains thrown off
};
template <int dim>
SoilCondition soil_condition(const problem::Model<dim>& model, const problem::State<dim>& state);

/// The pressure of motion that the mesh does not resolve, over the mean pressure, in the soil within half a width of the main rigid body:
///
///   rho c_P v' / p,   v'^2 = mean over particles and directions of the square of v_p - (mean velocity of the cell) - grad v_i (x_p - mean place).
///
/// Sand whose pressure waves are as large as its pressure has lost its strength. NaN where there is no such body or soil, or no pressure.
template <int dim>
Real shaking(const problem::Model<dim>& model, const problem::State<dim>& state, const Work<dim>& work);

}  // namespace berm::mpm
