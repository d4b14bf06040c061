// SPDX-License-Identifier: BSD-3-Clause
#include "core/lane_parts.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace berm::this_file {
namespace {

/// A chain of blocks 1, 2, 3, ... of numbers 0, 1, 2, ..., one for each lane.
struct Chain {
  std::vector<Lanes> blocks;

  explicit Chain(Index count)
  {
    for (Index b = 0; b <= count / lanes + 1; ++b) {
      Lanes block{};
      for (int l = 0; l < lanes; ++l) block[l] = (b - 1) * lanes + l;
      blocks.push_back(block);
    }
  }
  template <class Visit>
  void parts(Index count, const Visit& visit)
  {
    for_each_part(
        1, count, [](Index b) { return b + 1; }, visit);
  }
};

TEST(LaneParts, hold_every_particle_once_in_order)
{
  for (Index count = 0; count <= 4 * lanes + 1; ++count) {
    Chain chain(count);
    std::vector<Real> seen;
    chain.parts(count, [&](const auto& part) {
      EXPECT_EQ(part.index, static_cast<Index>(seen.size()));
      EXPECT_EQ(part.left, count - part.index);
      const auto numbers = part.get(chain.blocks[part.block], chain.blocks[part.other]);
      const auto alive = part.alive();
      for (int l = 0; l < part.size; ++l)
        if (alive[l]) seen.push_back(numbers[l]);
    });
    ASSERT_EQ(static_cast<Index>(seen.size()), count);
    for (Index n = 0; n < count; ++n) EXPECT_EQ(seen[n], n);
  }
}

TEST(LaneParts, write_where_they_read)
{
  for (Index count = 1; count <= 4 * lanes + 1; ++count) {
    Chain chain(count);
    chain.parts(count, [&](const auto& part) {
      Lanes &low = chain.blocks[part.block], &high = chain.blocks[part.other];
      part.set(low, high, part.get(low, high) + 100.);
      part.template change<1>(&low, &high, 1, [](auto* numbers) { numbers[0] *= 2.; });
      part.template change<0>(&low, &high, 0, [](auto*) {});
    });
    for (Index n = 0; n < count; ++n) EXPECT_EQ(chain.blocks[1 + n / lanes][n % lanes], 2. * (100 + n));
    for (int l = 0; l < lanes; ++l) EXPECT_EQ(chain.blocks[0][l], l - lanes);  // a block before the chain
  }
}

}  // namespace
}  // namespace berm::this_file
