// SPDX-License-Identifier: BSD-3-Clause
// Supports that move what their mesh does not let them move, and heads at boundaries that give way.

#include "mesh/box.hpp"
#include "os/error.hpp"
#include "problem/heads.hpp"
#include "samples/sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

/// An elastic box on a base that moves along an axis.
settings::Case box_on_moving_base(std::size_t axis)
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::free, "quake")});
  c.rigid.clear();
  boundary::SupportSettings base{"bottom", {"x", "y"}};
  base.motion.emplace();
  base.motion->stages = {"quake"};
  base.motion->times = {0, 1};
  base.motion->velocity[axis] = {0, 1};
  c.support = {{"base", base}};
  return c;
}

Model<2> model_of(const settings::Case& c)
{
  return make_model<2>(c, mesh::make_box<2>(std::get<mesh::BoxMesh>(c.mesh)));
}

/// The support whose motion a node has in a stage; "" without one.
std::string mover_of(const Model<2>& model, Index stage, Index node, int axis)
{
  const NodeField<boundary::Holders<2>>& moved = model.conditions.in_stage(stage).moved;
  const Index row = moved.empty() ? none : moved[node][axis];
  return row == none ? "" : model.conditions.rows[row].name;
}

std::string refusal_of(const settings::Case& c)
{
  try {
    model_of(c);
  } catch (const KeyError& error) {
    return error.what();
  }
  return "";
}

TEST(Motions, move_the_nodes_of_their_boundary_along_their_axis_alone)
{
  const Model<2> model = model_of(box_on_moving_base(0));
  for (Index node = 0; node < model.mesh.node_count(); ++node) {
    const bool at_base = model.mesh.position[node][1] == 0;
    EXPECT_EQ(mover_of(model, 0, node, 0), at_base ? "base" : "");
    EXPECT_EQ(mover_of(model, 0, node, 1), "");
  }
}

TEST(Motions, cost_nothing_where_there_are_none)
{
  settings::Case c = box_on_moving_base(0);
  c.support[0].second.motion.reset();
  EXPECT_TRUE(model_of(c).conditions.in_stage(0).moved.empty());
}

TEST(Motions, around_an_axis_are_not_along_the_radius_at_the_axis)
{
  settings::Case c = box_on_moving_base(0);
  c.geometry = settings::Geometry::axisymmetric;
  EXPECT_NE(refusal_of(c).find("support.base.motion.x: is along the radius, and the boundary touches the axis"), std::string::npos);
  c = box_on_moving_base(1);
  c.geometry = settings::Geometry::axisymmetric;
  EXPECT_EQ(refusal_of(c), "");
}

TEST(Motions, of_two_supports_at_one_boundary_in_one_stage_are_refused)
{
  settings::Case c = box_on_moving_base(0);
  c.support.emplace_back("again", c.support[0].second);
  EXPECT_NE(refusal_of(c).find("support.again.motion: [support.base] moves the same boundary"), std::string::npos);
}

TEST(Motions, of_two_supports_at_one_boundary_take_turns)
{
  settings::Case c = box_on_moving_base(0);
  c.stage.push_back(stage_of(settings::StageKind::free, "aftershock"));
  c.support.emplace_back("again", c.support[0].second);
  c.support[1].second.motion->stages = {"aftershock"};
  const Model<2> model = model_of(c);
  const Index node = model.mesh.boundary_nodes[model.mesh.find_boundary("bottom")].front();
  EXPECT_EQ(mover_of(model, 0, node, 0), "base");
  EXPECT_EQ(mover_of(model, 1, node, 0), "again");
}

TEST(Heads, of_boundaries_that_go_on_in_one_line_are_refused)
{
  settings::Case c = box_on_moving_base(0);
  c.support[0].second.motion.reset();
  c.support[0].second.drained = true;
  c.support[0].second.head = 1;
  c.support.emplace_back("side", c.support[0].second);
  c.support[1].second.boundary = "left";
  EXPECT_EQ(refusal_of(c), "") << "they meet at a corner";
  mesh::Mesh<2> mesh = mesh::make_box<2>(std::get<mesh::BoxMesh>(c.mesh));
  std::vector<Index>& left = mesh.boundary_nodes[mesh.find_boundary("left")];
  left = mesh.boundary_nodes[mesh.find_boundary("bottom")];
  try {
    make_model<2>(c, std::move(mesh));
    ADD_FAILURE() << "they share all nodes";
  } catch (const KeyError& error) {
    EXPECT_NE(std::string(error.what()).find("support.side.head: its boundary and that of [support.base]"), std::string::npos)
        << error.what();
  }
}

TEST(Heads, need_a_support_that_holds_the_soil_along_the_normal)
{
  settings::Case c = box_on_moving_base(0);
  c.support[0].second.motion.reset();
  c.support[0].second.drained = true;
  c.support[0].second.head = 1;
  EXPECT_EQ(refusal_of(c), "");
  c.support[0].second.fixed = {"x"};
  EXPECT_NE(refusal_of(c).find("support.base.head: the water outside presses along the normal"), std::string::npos);
  c.support[0].second.fixed = {"y"};
  const Model<2> model = model_of(c);
  Vec<2> sum = Vec<2>::Zero();
  for (const Vec<2>& area : areas_of_head(c, model, model.conditions.rows.back())) sum += area;
  EXPECT_NEAR(sum[1], 2, 1e-12) << "all of the base, into the soil";
  EXPECT_NEAR(sum[0], 0, 1e-12);
}

}  // namespace
}  // namespace berm::problem::this_file
