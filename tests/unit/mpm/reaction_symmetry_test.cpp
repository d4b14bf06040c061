// SPDX-License-Identifier: BSD-3-Clause
#include "material/linear_elastic.hpp"
#include "mpm/step.hpp"

#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

/// A plate that presses an elastic block of 2 m x 0.5 m x 2 m between rigid walls, or a half or a quarter of it.
settings::Case plate_on_block(const std::vector<std::string>& symmetry)
{
  settings::Case c;
  c.geometry = settings::Geometry::space;
  c.symmetry = symmetry;
  mesh::BoxMesh box;
  box.lower = {-1, -0.5, -1};
  box.size = {2, 1, 2};
  box.cells = {16, 8, 16};
  for (const std::string& axis : symmetry) {
    const int d = axis == "x" ? 0 : 2;
    box.lower[d] = 0, box.size[d] = 1, box.cells[d] = 8;
  }
  c.mesh = box;
  material::LinearElastic law;
  law.density = 1000;
  law.young_modulus = 1e6;
  c.material = {{"solid", law}};
  bodies::BodySettings body;
  body.material = "solid";
  bodies::BlockSettings block;
  block.center = {box.lower[0] + box.size[0] / 2, -0.25, box.lower[2] + box.size[2] / 2};
  block.size = {box.size[0], 0.5, box.size[2]};
  block.spacing = 0.0625;
  body.block = block;
  c.body = {{"block", body}};
  bodies::RigidSettings plate;
  plate.shape = bodies::HalfPlaneSettings{{0, 0, 0}, {0, -1, 0}};
  c.rigid = {{"plate", plate}};
  contact::ContactSettings contact;
  contact.body = "block";
  contact.rigid = "plate";
  c.contact = {{"skin", contact}};
  c.support = {{"base", {"bottom", {"y"}}},
               {"left", {"left", {"x"}}},
               {"right", {"right", {"x"}}},
               {"back", {"back", {"z"}}},
               {"front", {"front", {"z"}}}};
  settings::StageSettings push;
  push.name = "push";
  push.kind = settings::StageKind::push;
  push.velocity = 1;
  push.until.time = 1;
  c.stage = {push};
  return c;
}

/// Impulse of the plate and work done until it has gone 20 mm, of the whole.
std::pair<Vec<3>, Real> impulse_and_work(const std::vector<std::string>& symmetry)
{
  problem::Problem<3> problem = problem::build<3>(plate_on_block(symmetry), ".", ".");
  Workspace<3> workspace(problem.model, problem.state);
  while (problem.state.time < 0.02) step(problem.model, problem.state, workspace);
  return {problem.model.parts * problem.state.ledger.contact_sums[0].impulse, problem.model.parts * problem.state.ledger.totals.external};
}

TEST(Symmetry, half_and_quarter_under_a_plate_take_the_impulse_and_the_work_of_the_whole)
{
  const auto [whole, work] = impulse_and_work({});
  for (const std::vector<std::string>& axes : {std::vector<std::string>{"z"}, {"x", "z"}}) {
    const auto [impulse, part_work] = impulse_and_work(axes);
    // Patches of the block's cells are other ones in a part, and with them how waves run: 0.2 % were measured.
    EXPECT_NEAR(impulse[1] / whole[1], 1, 0.01);
    EXPECT_NEAR(part_work / work, 1, 0.01);
    EXPECT_EQ(impulse[2], 0);
    if (axes.size() == 2) {
      EXPECT_EQ(impulse[0], 0);
    }
  }
}

}  // namespace
}  // namespace berm::mpm::this_file
