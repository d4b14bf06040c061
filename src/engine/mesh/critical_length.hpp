// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/patches.hpp"

namespace berm::mesh {

/// How far a pressure wave goes in the longest time step for which explicit steps on this mesh are stable, m: 2 / omega, with omega the highest natural frequency
/// of the mesh where pressure waves have the speed 1 m/s. Cells are full, of one elastic material with this ratio of its shear modulus to its modulus of pressure
/// waves (0 to 0.75), have equal parts of their mass at their corners and share their volume change in patches. Cells that are smaller than those around them
/// have help from these, so it is longer than the smallest height, by which each cell would be stable by itself. Found by Lanczos' method and on the safe side
/// by what the last step leaves, 1 % at most.
template <int dim>
Real critical_length(const Mesh<dim>& mesh, const Patches& patches, Real shear_ratio);

}  // namespace berm::mesh
