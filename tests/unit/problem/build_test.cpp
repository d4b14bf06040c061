// SPDX-License-Identifier: BSD-3-Clause
#include "os/error.hpp"
#include "samples/sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

settings::StageSettings rest()
{
  return stage_of(settings::StageKind::free);
}
settings::StageSettings push_of(const char* rigid)
{
  settings::StageSettings stage = stage_of(settings::StageKind::push, rigid);
  stage.rigid = rigid;
  stage.velocity = 1;
  return stage;
}

std::string message_of(const settings::Case& c)
{
  try {
    build<2>(c, ".", ".");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Build, names_the_regions_there_are_when_one_is_unknown)
{
  settings::Case c = pipe_over_box({rest()});
  c.body[0].second.regions = {"bed"};
  EXPECT_EQ(message_of(c), "body.bed.regions: the mesh has no region \"bed\"; it has box");
}

TEST(Build, names_the_region_of_a_damping_that_the_mesh_lacks)
{
  settings::Case c = pipe_over_box({rest()});
  c.body[0].second.region_damping = {{"layer", 0.1}};
  EXPECT_EQ(message_of(c), "body.bed.regions: the mesh has no region \"layer\"; it has box");
}

TEST(Build, names_the_boundaries_there_are_when_one_is_unknown)
{
  settings::Case c = pipe_over_box({rest()});
  c.support = {{"base", {"base", {"x"}}}};
  EXPECT_EQ(message_of(c), "support.base.boundary: the mesh has no boundary \"base\"; it has left, right, bottom, top");
}

TEST(Build, refuses_a_block_that_leaves_the_mesh)
{
  settings::Case c = pipe_over_box({rest()});
  bodies::BlockSettings block;
  block.center = {0, 0};
  block.size = {1, 1};
  block.spacing = 0.5;
  c.body[0].second.regions.clear();
  c.body[0].second.block = block;
  EXPECT_EQ(message_of(c).find("body.bed.block: the block leaves the mesh"), 0u) << message_of(c);
}

TEST(Build, fills_no_body_where_a_rigid_body_is_that_it_has_a_contact_with)
{
  settings::Case c = pipe_over_box({rest()});
  std::get<bodies::CircleSettings>(c.rigid[0].second.shape).center[1] = 1;
  const auto min_distance = [&] {
    const auto problem = build<2>(c, ".", ".");
    Real min = infinity;
    problem.state.particles[0].visit([&](Index, Index b, int l) {
      const bodies::Block<2>& p = problem.state.particles[0].block(b);
      min = std::min(min, surface_at<2>(problem.model.rigid_bodies[0].shape, Vec<2>(p.x[0][l], p.x[1][l])).distance);
    });
    return min;
  };
  EXPECT_LT(min_distance(), 0);
  contact::ContactSettings skin;
  skin.body = "bed";
  skin.rigid = "pipe";
  c.contact = {{"skin", skin}};
  EXPECT_GE(min_distance(), 0);
  std::get<bodies::CircleSettings>(c.rigid[0].second.shape).diameter = 10;
  EXPECT_EQ(message_of(c),
            "body.bed: has no particles: all cells of its regions lie within the rigid bodies; check their position and size, "
            "or fill other regions");
}

TEST(Build, gives_a_rigid_body_that_turns_the_inertia_of_a_solid_or_its_own)
{
  settings::Case c = pipe_over_box({rest()});
  c.rigid[0].second.rotation = bodies::Rotation::free;
  const auto inertia = [&] { return build<2>(c, ".", ".").model.rigid_bodies[0].inertia; };
  EXPECT_NEAR(inertia(), 2 * 0.2 * 0.2 / 2, 1e-15);  // m R^2 / 2
  c.rigid[0].second.moment_of_inertia = 3;
  EXPECT_EQ(inertia(), 3);
}

TEST(Build, holds_the_nodes_of_a_boundary_in_the_directions_named)
{
  settings::Case c = pipe_over_box({rest()});
  c.support = {{"left", {"left", {"x"}}}, {"base", {"bottom", {"x", "y"}}}};
  const auto model = build<2>(c, ".", ".").model;
  for (Index i = 0; i < model.mesh.node_count(); ++i) {
    const Vec<2>& x = model.mesh.position[i];
    EXPECT_EQ(model.conditions.tables[0].held[i], x[1] == 0 ? 3 : x[0] == 0 ? 1 : 0) << x.transpose();
  }
}

TEST(Build, starts_at_rest_with_the_momentum_of_the_particles)
{
  settings::Case c = pipe_over_box({rest()});
  bodies::InitialVelocity motion;
  motion.amplitude = {0.5, -0.25};
  c.body[0].second.initial_velocity = {motion};
  const auto state = build<2>(c, ".", ".").state;
  EXPECT_NEAR((state.ledger.totals.first_momentum - 4000 * Vec<2>(0.5, -0.25)).norm(), 0, 1e-9);
  EXPECT_EQ(state.time, 0);
  EXPECT_EQ(state.step, 0);
  EXPECT_EQ(state.particles[0].size(), 32 * 9);
}

TEST(Build, looks_contacts_and_watched_points_up)
{
  settings::Case c = pipe_over_box({rest()});
  c.body.push_back({"second", c.body[0].second});
  contact::ContactSettings contact;
  contact.body = "second";
  contact.rigid = "pipe";
  contact.friction_angle = pi / 6;
  contact.adhesion = 30;
  c.contact = {{"skin", contact}};
  c.watch = {{"tip", {"second", {1.98, 1.97}}}};
  const auto problem = build<2>(c, ".", ".");
  ASSERT_EQ(problem.model.contacts.size(), 1u);
  EXPECT_EQ(problem.model.contacts[0].body, 1);
  EXPECT_EQ(problem.model.contacts[0].rigid, 0);
  EXPECT_NEAR(problem.model.contacts[0].friction, 1 / std::sqrt(3.), 1e-15);
  EXPECT_EQ(problem.model.contacts[0].adhesion, 30);

  const Watch& watch = problem.model.watches.at(0);
  EXPECT_EQ(watch.body, 1);
  Real min = infinity, of_watched = infinity;
  problem.state.particles[1].visit([&](Index, Index b, int l) {
    const auto p = problem.state.particles[1].read(b, l);
    const Real distance = (p.x - Vec<2>(1.98, 1.97)).norm();
    min = std::min(min, distance);
    if (p.id == watch.id) of_watched = distance;
  });
  EXPECT_EQ(of_watched, min);
}

TEST(Build, damps_a_node_as_the_most_damped_of_its_regions)
{
  settings::Case c = pipe_over_box({rest()});
  c.body[0].second.damping = 0.1;
  c.body[0].second.region_damping = {{"box", 0.3}};
  const auto model = build<2>(c, ".", ".").model;
  for (const Real damping : model.bodies[0].damping) EXPECT_EQ(damping, 0.3);
}

TEST(MainRigid, is_the_first_that_a_stage_names_else_the_first_there_is)
{
  settings::Case c = pipe_over_box({rest()});
  EXPECT_EQ(main_rigid(c), 0);
  c.rigid.push_back({"floor", c.rigid[0].second});
  c.rigid.push_back({"wall", c.rigid[0].second});
  EXPECT_EQ(main_rigid(c), 0);
  c.stage = {rest(), push_of("wall"), push_of("floor")};
  EXPECT_EQ(main_rigid(c), 2);
  c.stage = {rest()};
  c.rigid.clear();
  EXPECT_EQ(main_rigid(c), none);
}

}  // namespace
}  // namespace berm::problem::this_file
