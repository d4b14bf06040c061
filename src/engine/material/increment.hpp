// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/tensor.hpp"

namespace berm::material {

/// Strain increment of a time step, as the constitutive law receives it. Shear strains are tensor components.
template <int dim, class T>
struct Increment {
  SymTensor<dim, T> strain;
  Real dt = 0;         ///< s, duration; 0: none, so that no strain rate is defined
  Real time = 0;       ///< s, at the beginning
  Real cell_size = 0;  ///< m, root of the cell's area (in space: cube root of its volume); 0 where strain is uniform or no law asks for it
  Real outflow = 0;    ///< volume of water that leaves the pores, over that of the soil: div(w) dt
  Real exchange = 0;   ///< 1/Pa: times K_w / n, how far the water in a cell's pores levels its pressure in the step
  Real level = 0;      ///< Pa, mean excess pore pressure of the cell
  /// Lanes that hold a particle of the law; the others may hold any finite number, and what the law makes of them is not used.
  decltype(T() < T()) active = T() <= T();
};

}  // namespace berm::material
