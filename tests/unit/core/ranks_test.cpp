// SPDX-License-Identifier: BSD-3-Clause
#include "core/chunks.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

/// Speaks for the second of three ranks; the others have what `of_others` says.
class SecondOfThree final : public Messenger {
public:
  std::vector<std::byte> first, third;

  int rank() const override { return 1; }
  int count() const override { return 3; }
  void exchange(std::vector<Letter>&) override { FAIL(); }
  void gather(const std::byte* own, std::byte* all, const std::vector<std::size_t>& begin) override
  {
    if (begin ==
        std::vector<std::size_t>{0, sizeof(std::size_t), 2 * sizeof(std::size_t), 3 * sizeof(std::size_t)}) {  // how many bytes each has
      const std::size_t bytes[3] = {first.size(), *reinterpret_cast<const std::size_t*>(own), third.size()};
      std::memcpy(all, bytes, sizeof(bytes));
      return;
    }
    ASSERT_EQ(begin[1] - begin[0], first.size());
    ASSERT_EQ(begin[3] - begin[2], third.size());
    std::copy(first.begin(), first.end(), all);
    std::copy_n(own, begin[2] - begin[1], all + begin[1]);
    std::copy(third.begin(), third.end(), all + begin[2]);
  }
  Real largest(Real of_rank) override { return std::max(of_rank, Real(5)); }
  const Traffic& traffic() const override { return traffic_; }
  bool meet(Real) override { return true; }
  [[noreturn]] void abort(int) override { throw std::logic_error("aborted"); }

  Traffic traffic_;

  template <class T>
  static std::vector<std::byte> bytes_of(const std::vector<T>& values)
  {
    const auto* begin = reinterpret_cast<const std::byte*>(values.data());
    return {begin, begin + values.size() * sizeof(T)};
  }
};

/// Ten chunks of four cells, of which this rank has 3, 4 and 5.
class OfThreeRanks : public ::testing::Test {
protected:
  OfThreeRanks()
  {
    auto messenger = std::make_unique<SecondOfThree>();
    others = messenger.get();
    ranks.join(std::move(messenger));
    std::vector<Index> cells, nodes;
    for (Index c = 0; c <= 10; ++c) cells.push_back(4 * c), nodes.push_back(3 * c);
    ranks.divide({0, 3, 6, 10}, cells, nodes);
  }
  ~OfThreeRanks() override
  {
    ranks.unite();
    ranks.leave();
  }

  Ranks& ranks = Ranks::of_run();
  SecondOfThree* others;
};

TEST_F(OfThreeRanks, cells_and_nodes_belong_to_the_rank_that_has_their_chunk)
{
  EXPECT_EQ(ranks.owner_of_cell(0), 0);
  EXPECT_EQ(ranks.owner_of_cell(11), 0);
  EXPECT_EQ(ranks.owner_of_cell(12), 1);
  EXPECT_EQ(ranks.owner_of_cell(39), 2);
  EXPECT_EQ(ranks.owner_of_node(8), 0);
  EXPECT_EQ(ranks.owner_of_node(9), 1);
  EXPECT_TRUE(ranks.owns_cell(12));
  EXPECT_TRUE(ranks.owns_cell(23));
  EXPECT_FALSE(ranks.owns_cell(24));
  EXPECT_TRUE(ranks.owns_node(17));
  EXPECT_FALSE(ranks.owns_node(18));
}

TEST_F(OfThreeRanks, sums_take_other_ranks_chunks_in_their_place)
{
  const std::vector<Real> first = {0x1p60, 1, -0x1p60}, third = {0, 2, 0, 4};
  others->first = SecondOfThree::bytes_of(first);
  others->third = SecondOfThree::bytes_of(third);
  Chunks chunks;
  chunks.all = 10;
  chunks.number = {2, 4, 5};  // 2 is of the first rank, and counts as it says
  chunks.begin = {0, 1, 3, 4};
  EXPECT_EQ(sum_of<Real>("test", chunks, [](Index i) { return 10. * (i + 1); }), (0x1p60 + 1) - 0x1p60 + 20 + 30 + 40 + 2 + 4);
}

TEST_F(OfThreeRanks, each_value_comes_from_its_owner)
{
  const std::vector<int> owner = {2, 0, 1, 0, 1};
  others->first = SecondOfThree::bytes_of(std::vector<Real>{10, 11});
  others->third = SecondOfThree::bytes_of(std::vector<Real>{12});
  std::vector<Real> values = {-1, -2, 3, -4, 5};
  ranks.share<Real>(
      5, [&](Index i) { return owner[i]; }, [&](Index i, Real& value) { value = values[i]; },
      [&](Index i, Real value) {
        EXPECT_NE(owner[i], 1);
        values[i] = value;
      });
  EXPECT_EQ(values, (std::vector<Real>{12, 10, 3, 11, 5}));
}

TEST_F(OfThreeRanks, lists_are_laid_end_to_end)
{
  others->first = SecondOfThree::bytes_of(std::vector<Index>{7});
  others->third = SecondOfThree::bytes_of(std::vector<Index>{1, 2, 3});
  std::vector<Index> all;
  ranks.gather(std::vector<Index>{5, 6}, all);
  EXPECT_EQ(all, (std::vector<Index>{7, 5, 6, 1, 2, 3}));
}

TEST_F(OfThreeRanks, that_are_united_have_all_each)
{
  ranks.unite();
  EXPECT_TRUE(ranks.owns_cell(0));
  EXPECT_TRUE(ranks.owns_node(29));
  EXPECT_EQ(ranks.largest(3), 3);
  std::vector<Index> all;
  ranks.gather(std::vector<Index>{5, 6}, all);
  EXPECT_EQ(all, (std::vector<Index>{5, 6}));
  EXPECT_EQ(ranks.text_of_largest(1, "its own"), "its own");
}

TEST(Ranks, of_one_process_own_everything_and_ask_nobody)
{
  Ranks& ranks = Ranks::of_run();
  EXPECT_EQ(ranks.count(), 1);
  EXPECT_TRUE(ranks.is_first());
  EXPECT_FALSE(ranks.divided());
  EXPECT_TRUE(ranks.any(true));
  EXPECT_FALSE(ranks.any(false));
}

}  // namespace
}  // namespace berm::this_file
