// SPDX-License-Identifier: BSD-3-Clause
#include "beam/line.hpp"

#include "os/error.hpp"

#include <gtest/gtest.h>
#include <numeric>

namespace berm::beam::this_file {
namespace {

Line sample_line()
{
  return straight_line({0, 1, 3, 4}, {1, 1, 1, 1, 1, 1}, {Plane::lateral, Plane::vertical});
}

TEST(Line, numbers_the_freedoms_of_its_planes)
{
  const Line both = sample_line(), flat = straight_line({0, 1, 3}, {}, {Plane::vertical});
  EXPECT_EQ(both.freedoms(), 20);
  EXPECT_EQ(both.across(Plane::vertical, 1), 8);
  EXPECT_EQ(flat.freedoms(), 9) << "a line that moves in one plane has no freedoms in the other";
  EXPECT_EQ(flat.across(Plane::vertical, 1), 4);
  EXPECT_TRUE(flat.moves(Plane::vertical));
  EXPECT_FALSE(flat.moves(Plane::lateral));
}

TEST(Line, shares_its_length_among_its_nodes)
{
  const Line line = sample_line();
  EXPECT_EQ(lengths_of_nodes(line), (std::vector<Real>{0.5, 1.5, 1.5, 0.5}));
  EXPECT_EQ(lengths_of_nodes(line, 1, 3.75), (std::vector<Real>{0, 1, 1.5, 0.25}));
}

TEST(Line, has_springs_only_where_it_has_a_length_and_they_begin_at_its_shape_or_a_level)
{
  Line line = sample_line();
  set_shape(
      line, Plane::lateral, [](Real x) { return x / 10; }, [](Real) { return 0.1; });
  add_springs(line, Direction::lateral, friction(1, 1), lengths_of_nodes(line, 1, 4));
  ASSERT_EQ(line.springs.size(), 3u);
  EXPECT_EQ(line.springs[0].node, 1);
  EXPECT_EQ(line.springs[0].freedom, line.across(Plane::lateral, 1));
  EXPECT_EQ(line.springs[1].origin, 0.3);
  add_springs(line, Direction::vertical, OneSidedSpring{1}, lengths_of_nodes(line), -2);
  EXPECT_EQ(line.springs[3].origin, -2);
  EXPECT_EQ(line.springs[3].law, 1);
}

TEST(Line, is_held_at_its_ends_as_its_other_half_asks)
{
  Line line = sample_line();
  hold(line, 0, EndCondition::symmetric);
  EXPECT_EQ(std::vector<std::uint8_t>(line.held.begin(), line.held.begin() + 5), (std::vector<std::uint8_t>{1, 0, 1, 0, 1}));
  hold(line, 0, EndCondition::antisymmetric);
  EXPECT_EQ(std::vector<std::uint8_t>(line.held.begin(), line.held.begin() + 5), (std::vector<std::uint8_t>{1, 1, 0, 0, 1}));
  hold(line, 3, EndCondition::pinned);
  EXPECT_EQ(std::vector<std::uint8_t>(line.held.end() - 5, line.held.end()), (std::vector<std::uint8_t>{1, 1, 0, 1, 0}));
  hold(line, 3, EndCondition::clamped);
  EXPECT_EQ(std::accumulate(line.held.end() - 5, line.held.end(), 0), 5);
}

TEST(Line, has_nodes_that_are_fine_first_and_reach_its_end)
{
  const std::vector<Real> x = graded_nodes(1, 10, 1.5, 4, 30);
  EXPECT_EQ(x[10], 10);
  EXPECT_EQ(x[11], 11.5);
  EXPECT_GE(x.back(), 30);
  for (std::size_t i = 1; i < x.size(); ++i) EXPECT_LE(x[i] - x[i - 1], 4);
}

TEST(Line, refuses_nodes_that_do_not_ascend)
{
  EXPECT_THROW(straight_line({0}, {}, {Plane::lateral}), InputError);
  EXPECT_THROW(straight_line({0, 1, 1}, {}, {Plane::lateral}), InputError);
  EXPECT_THROW(straight_line({0, nan}, {}, {Plane::lateral}), InputError);
}

}  // namespace
}  // namespace berm::beam::this_file
