// SPDX-License-Identifier: BSD-3-Clause
// Two pipes in one bed: one moves, the other is held where it is.
#include "fem/remesher.hpp"

#include "os/error.hpp"
#include "samples/fem_sample_bed.hpp"
#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

constexpr Real D = 0.4, strength = 2e3, speed = 0.1;

bodies::RigidSettings pipe_at_x(Real x, Real embedment)
{
  bodies::RigidSettings pipe;
  pipe.shape = bodies::CircleSettings{{x, D / 2 - embedment}, D};
  return pipe;
}

contact::ContactSettings skin_of(const std::string& rigid)
{
  contact::ContactSettings skin;
  skin.body = "soil", skin.rigid = rigid;
  return skin;
}

/// Pushes this pipe down until its lowest point is so deep.
settings::StageSettings push_of(const std::string& rigid, Real embedment)
{
  settings::StageSettings push = pushing();
  push.name = "push_" + rigid, push.rigid = rigid, push.velocity = speed, push.until.embedment = embedment;
  return push;
}

/// Clay without weight, 12 D wide and 4 D deep, with elements of D/8 at smooth pipes at these places.
settings::Case pipes_at(const std::vector<Real>& places, Real embedment)
{
  settings::Case c = bed_around(bodies::CircleSettings{});
  mesh::SeabedMesh& bed = std::get<mesh::SeabedMesh>(c.mesh);
  bed.length = 12 * D, bed.left = 6 * D, bed.depth = 4 * D;
  bed.near_left = -3 * D, bed.near_right = 3 * D, bed.near_depth = D, bed.near_size = D / 4, bed.far_size = D, bed.layer = 0;
  material::MohrCoulomb clay = plastic_soil(strength, 0, 0);
  clay.poisson_ratio = 0.45;
  c.material = {{"soft", clay}};
  c.body[0].second.regions = {"near", "bed"};
  c.fem.large_deformation = true;
  c.fem.contact_size = D / 8;
  c.rigid.clear(), c.contact.clear();
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::string name(1, static_cast<char>('a' + k));
    c.rigid.emplace_back(name, pipe_at_x(places[k], embedment));
    c.contact.emplace_back("skin_" + name, skin_of(name));
  }
  return c;
}

/// A run, to the end of a stage at a time.
class March {
public:
  explicit March(const settings::Case& c)
      : problem(build_fem(c, ".", folder_.path().string())),
        steps(problem.model, problem.state, c.fem.large_deformation ? std::optional(Remesher(c, folder_.path())) : std::nullopt)
  {
    steps.find_first_equilibrium();
  }
  void end_stage()
  {
    while (!stage_ended(problem.model.model, problem.state.state)) steps.advance();
  }
  const bodies::RigidState<2>& pipe(Index k) const { return problem.state.state.rigid_bodies[k]; }

private:
  TemporaryFolder folder_;

public:
  FemProblem problem;
  LoadSteps steps;
};

// What is left of the other pipe is its mesh: on elements of D/8 the reaction depends on where the nodes of the edge lie by some 2 %.
TEST(SeveralBodies, one_that_is_far_away_changes_nothing)
{
  settings::Case alone = pipes_at({-3 * D}, 0.1 * D), both = pipes_at({-3 * D, 3 * D}, 0.1 * D);
  alone.stage = both.stage = {push_of("a", 0.2 * D)};
  March one(alone), two(both);
  one.end_stage(), two.end_stage();
  EXPECT_NEAR(two.pipe(0).displacement[1], -0.1 * D, 1e-12);
  EXPECT_NEAR(two.pipe(0).reaction[1] / one.pipe(0).reaction[1], 1, 0.02);
  EXPECT_GT(one.pipe(0).reaction[1], 3 * strength * D);
  EXPECT_GT(two.steps.remeshings().count, 1);
}

// Gmsh's meshes are not mirror images of each other: 2 % as above, of the larger reaction.
TEST(SeveralBodies, a_mirrored_case_has_mirrored_reactions_and_a_body_stays_where_it_was_left)
{
  settings::Case c = pipes_at({-0.65 * D, 0.65 * D}, 0.1 * D);
  c.stage = {push_of("a", 0.2 * D)};
  March left(c);
  left.end_stage();
  c.stage = {push_of("b", 0.2 * D), push_of("a", 0.15 * D)};
  March right(c);
  EXPECT_EQ(right.problem.model.model.main_rigid, 1) << "that is driven first";
  right.end_stage();
  const Real scale = left.pipe(0).reaction.norm();
  EXPECT_GT(left.pipe(1).reaction[0], 0.03 * scale) << "the soil that the left one displaces pushes the right one away";
  for (Index k = 0; k < 2; ++k) {
    EXPECT_NEAR(right.pipe(1 - k).reaction[1], left.pipe(k).reaction[1], 0.02 * scale);
    EXPECT_NEAR(right.pipe(1 - k).reaction[0], -left.pipe(k).reaction[0], 0.02 * scale);
  }
  const Vec<2> there = right.pipe(1).displacement;
  ASSERT_TRUE(right.steps.next_stage());
  right.end_stage();
  EXPECT_EQ((right.pipe(1).displacement - there).norm(), 0);
  EXPECT_NEAR(right.pipe(0).displacement[1], -0.05 * D, 1e-12);
  EXPECT_GT(right.pipe(0).reaction[1], 2 * strength * D);
}

// The equilibrium is found to 1e-3 of the contact forces and a thousandth of the weight.
class BodiesInHeavySoil : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Strains, BodiesInHeavySoil, testing::Bool(), [](const auto& of) { return of.param ? "large" : "small"; });

TEST_P(BodiesInHeavySoil, have_reactions_that_carry_with_those_of_the_supports_the_weight_of_the_soil)
{
  settings::Case c = pipes_at({-0.65 * D, 0.65 * D}, 0.3 * D);
  c.gravity = {0, -10};
  c.body[0].second.k0 = 1;
  c.output.support_reactions = true;
  c.fem.large_deformation = GetParam();
  c.stage = {push_of("a", GetParam() ? 0.35 * D : 0.301 * D)};
  March march(c);
  march.end_stage();
  Vec<2> sum = Vec<2>(0, -march.problem.model.weight);
  for (const Vec<2>& force : march.problem.state.support_forces) sum += force;
  for (Index k = 0; k < 2; ++k) {
    EXPECT_GT(march.pipe(k).reaction[1], 100) << "the held one bears on the soil, too";
    sum -= march.pipe(k).reaction;
  }
  EXPECT_LT(sum.norm(), 3e-3 * march.problem.model.weight);
}

TEST(SeveralBodies, each_node_of_the_contact_is_of_the_nearest_body_and_keeps_its_shear_in_a_new_mesh)
{
  settings::Case c = pipes_at({-0.51 * D, 0.53 * D}, 0.3 * D);
  c.stage = {resting(1)};
  const TemporaryFolder folder;
  FemProblem problem = build_fem(c, ".", folder.path().string());
  FemModel& model = problem.model;
  const auto shear_of = [](Index contact) { return contact == 0 ? 300. : -500.; };
  const auto across = [](const Vec<2>& normal) { return Vec<2>(-normal[1], normal[0]); };
  for (std::size_t k = 0; k < model.contact.size(); ++k)
    if (const FemContactPoint& point = model.contact[k]; problem.state.contact[k].parted == 0)
      problem.state.contact[k].traction = point.normal + shear_of(point.contact) * across(point.normal);
  Remesher(c, folder.path()).remesh(model, problem.state);
  std::vector<char> seen(static_cast<std::size_t>(model.mesh.node_count()), 0);
  std::array<int, 2> kept = {0, 0};
  for (std::size_t k = 0; k < model.contact.size(); ++k) {
    const FemContactPoint& point = model.contact[k];
    const Vec<2>& x = model.mesh.position[point.node];
    EXPECT_EQ(std::exchange(seen[static_cast<std::size_t>(point.node)], 1), 0);
    const auto away = [&](Index contact) { return surface_now(model, contact, {}, x).distance; };
    EXPECT_LE(away(point.contact), away(1 - point.contact));
    EXPECT_GT(away(point.contact), -1e-12);
    const Real shear = problem.state.contact[k].traction.dot(across(point.normal));
    kept[static_cast<std::size_t>(point.contact)] += std::abs(away(point.contact)) < 1e-12 && std::abs(shear - shear_of(point.contact)) < 1;
  }
  for (const int count : kept) EXPECT_GT(count, 15) << "an arc of 1.16 D in sides of D/8 at most, each with its middle";
}

TEST(SeveralBodies, are_refused_where_they_meet_or_cannot_be_told_apart)
{
  settings::Case c = pipes_at({-0.6 * D, 0.6 * D}, 0.2 * D);
  c.stage = {push_of("a", 0.4 * D)};
  settings::Case other = c;
  other.contact.pop_back();
  other.stage[0].rigid = "b";
  EXPECT_NE(refusal_of([&] { fem_problem_of(other); }).find("stage[0].rigid: finite elements move rigid bodies that a contact joins"),
            std::string::npos);
  other = c;
  other.contact[1].second.rigid = "a";
  EXPECT_NE(refusal_of([&] { fem_problem_of(other); }).find("contact.skin_b.rigid"), std::string::npos);
  other = c;
  other.rigid[1].second.motion = bodies::Motion::free;
  EXPECT_NE(refusal_of([&] { fem_problem_of(other); }).find("rigid.b.motion"), std::string::npos);
  other = c;
  other.rigid[1].second = pipe_at_x(0.3 * D, 0.2 * D);
  EXPECT_NE(refusal_of([&] { fem_problem_of(other); }).find("overlap by"), std::string::npos);

  March march(c);
  for (const Real left : {0.1 * D, 0.01 * D}) {
    march.problem.state.state.rigid_bodies[0].displacement = {0.2 * D - left, 0};
    const auto check = [&] { Remesher(c, ".").refuse_bodies_that_meet(march.problem.model, march.problem.state); };
    if (left > 0.25 * D / 8)
      EXPECT_NO_THROW(check());
    else
      EXPECT_THROW(check(), RunError);
  }
}

}  // namespace
}  // namespace berm::fem::this_file
