// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <cstdint>
#include <vector>

namespace berm::study {

/// A Latin hypercube: shares between 0 and 1 by parameter, then row. Those of a parameter have one in each n-th part of the way, at a random place in it, and the
/// parts are in random order:
///
///   p_k = (order_k + u_k) / n
///
/// The numbers come from std::mt19937_64, whose bits the C++ standard prescribes, parameter by parameter: first the order (each item from the last on swapped with
/// one not behind it), then the u. So the rows are the same on every machine, and a parameter that is added at the end leaves those before it as they are.
/// (McKay, Beckman and Conover, 1979.)
std::vector<std::vector<Real>> latin_hypercube(std::size_t parameters, std::size_t rows, std::uint64_t seed);

}  // namespace berm::study
