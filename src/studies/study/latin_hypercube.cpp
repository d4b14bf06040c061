// SPDX-License-Identifier: BSD-3-Clause
#include "study/latin_hypercube.hpp"

#include <numeric>
#include <random>
#include <utility>

namespace berm::study {
namespace {

/// One of 0, 1, ..., count - 1, all as likely: what is left beyond a whole number of rounds is drawn again. std::uniform_int_distribution differs from library to library.
std::uint64_t draw_below(std::uint64_t count, std::mt19937_64& random)
{
  const std::uint64_t end = std::mt19937_64::max() - std::mt19937_64::max() % count;
  std::uint64_t bits = random();
  while (bits >= end) bits = random();
  return bits % count;
}

/// Between 0 and 1, neither of them: the middle of one of 2^52 parts, which a double holds exactly.
Real draw_share(std::mt19937_64& random)
{
  return (static_cast<Real>(random() >> 12) + 0.5) * 0x1p-52;
}

}  // namespace

std::vector<std::vector<Real>> latin_hypercube(std::size_t parameters, std::size_t rows, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::vector<std::vector<Real>> shares(parameters, std::vector<Real>(rows));
  std::vector<std::size_t> order(rows);
  for (std::vector<Real>& share : shares) {
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = rows; k-- > 1;) std::swap(order[k], order[draw_below(k + 1, random)]);
    for (std::size_t k = 0; k < rows; ++k) share[k] = (static_cast<Real>(order[k]) + draw_share(random)) / static_cast<Real>(rows);
  }
  return shares;
}

}  // namespace berm::study
