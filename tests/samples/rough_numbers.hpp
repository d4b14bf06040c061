// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace berm {

/// Numbers of very different sizes, so that every change of order in a sum shows in the last bits.
inline std::vector<Real> rough_numbers(Index count)
{
  std::mt19937 random(5);
  std::vector<Real> numbers(static_cast<std::size_t>(count));
  for (Real& x : numbers) x = std::ldexp(std::uniform_real_distribution<Real>(-1, 1)(random), static_cast<int>(random() % 40));
  return numbers;
}

/// Numbers between -1 and 1.
inline std::vector<Real> small_numbers(Index count)
{
  std::mt19937 random(7);
  std::vector<Real> numbers(static_cast<std::size_t>(count));
  for (Real& x : numbers) x = std::uniform_real_distribution<Real>(-1, 1)(random);
  return numbers;
}

}  // namespace berm
