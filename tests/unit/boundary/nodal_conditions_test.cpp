// SPDX-License-Identifier: BSD-3-Clause
#include "boundary/nodal_conditions.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::boundary::this_file {
namespace {

constexpr std::uint8_t x = 1, y = 2;

NodalCondition<2> row(decltype(NodalCondition<2>::kind) kind, std::uint8_t directions, std::vector<char> acts, std::vector<Index> nodes)
{
  return {.name = "", .kind = std::move(kind), .directions = directions, .acts = std::move(acts), .nodes = std::move(nodes)};
}

NodalConditions<2> tables_of(std::vector<NodalCondition<2>> rows, std::size_t stages = 1, bool water_flows = false)
{
  NodalConditions<2> conditions;
  conditions.rows = std::move(rows);
  make_tables(3, stages, water_flows, conditions);
  return conditions;
}

TEST(NodalConditions, hold_the_directions_of_all_that_act_in_the_stage)
{
  const NodalConditions<2> c = tables_of({row(Hold{}, x, {1, 1}, {0, 1}), row(Hold{}, y, {0, 1}, {1, 2})}, 2);
  EXPECT_EQ(c.in_stage(0).held[1], x);
  EXPECT_EQ(c.in_stage(1).held[1], x | y);
  EXPECT_EQ(c.in_stage(0).held[2], 0);
}

TEST(NodalConditions, of_stages_with_the_same_rows_share_a_table)
{
  const NodalConditions<2> c = tables_of({row(Hold{}, x, {1, 0, 1}, {0}), row(Head<2>{1}, y, {0, 0, 1}, {1})}, 3);
  EXPECT_EQ(c.table_of_stage, (std::vector<Index>{0, 1, 0})) << "the pressure of a head is no matter of nodes";
}

TEST(NodalConditions, close_what_is_not_drained_and_open_planes_of_symmetry_by_drained_ones_whatever_their_order)
{
  for (const bool reversed : {false, true}) {
    std::vector<NodalCondition<2>> rows = {row(Hold{Flux::symmetric}, x, {1}, {0, 1, 2}), row(Hold{Flux::open}, x, {1}, {1, 2}),
                                           row(Hold{Flux::closed}, x, {1}, {2}), row(Hold{Flux::unchanged}, y, {1}, {0})};
    if (reversed) std::reverse(rows.begin(), rows.end());
    const NodalConditions<2> c = tables_of(rows, 1, true);
    EXPECT_EQ(c.tables[0].closed[0], x);
    EXPECT_EQ(c.tables[0].closed[1], 0);
    EXPECT_EQ(c.tables[0].closed[2], x);
    EXPECT_EQ(c.tables[0].held[0], x | y);
  }
}

TEST(NodalConditions, give_a_node_the_velocity_of_the_first_row_and_none_of_a_wave_that_comes_in)
{
  const NodalConditions<2> c =
      tables_of({row(Motion{{}, true}, x, {1}, {0}), row(Motion{{}, false}, x, {1}, {0, 1}), row(Motion{{}, false}, x | y, {1}, {1})});
  EXPECT_EQ(c.tables[0].moved[0], (Holders<2>{1, none}));
  EXPECT_EQ(c.tables[0].moved[1], (Holders<2>{1, 2}));
  EXPECT_EQ(c.tables[0].moved[2], (Holders<2>{none, none}));
}

TEST(NodalConditions, give_a_reaction_to_the_first_support_also_where_it_absorbs)
{
  NodalConditions<2> c;
  c.rows = {row(Hold{}, x, {1}, {0, 1}), row(Absorb{}, x | y, {1}, {0})};
  c.rows[0].reaction = 1, c.rows[1].reaction = 0;
  c.reported = {"first", "second"};
  make_tables(3, 1, false, c);
  EXPECT_EQ(c.tables[0].reactions[0], (Holders<2>{0, 0}));
  EXPECT_EQ(c.tables[0].reactions[1], (Holders<2>{1, none}));
  EXPECT_EQ(c.tables[0].held[0], x);
}

TEST(NodalConditions, cost_nothing_where_nothing_moves_flows_or_is_reported)
{
  const NodalConditions<2> c = tables_of({row(Hold{}, x, {1}, {0})});
  EXPECT_TRUE(c.tables[0].moved.empty() && c.tables[0].closed.empty() && c.tables[0].reactions.empty());
  EXPECT_EQ(tables_of({}).tables[0].held.size(), 3) << "without any condition there is a table, too";
}

}  // namespace
}  // namespace berm::boundary::this_file
