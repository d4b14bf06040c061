// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/tensor.hpp"

namespace berm::material {

/// What happens to soil in a step, as its law is told. Shear strains are tensor components.
template <int dim, class T>
struct Increment {
  SymTensor<dim, T> strain;
  Real dt = 0;    ///< s, that it takes; 0: in no time of the soil's, so that nothing is said of its rate
  Real time = 0;  ///< s, at its beginning
};

}  // namespace berm::material
