// SPDX-License-Identifier: BSD-3-Clause
#include "problem/absorbing.hpp"

#include "mesh/box.hpp"
#include "os/error.hpp"
#include "samples/sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

/// An elastic bed 1 m high in a box of 2 m x 2 m whose right side absorbs in the second of two stages.
settings::Case bed_beside_open_side()
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::geostatic, "rest"), stage_of(settings::StageKind::free, "wave")});
  c.rigid.clear();
  c.support = {{"right", {"right", {"x"}}}};
  c.support[0].second.absorbs = true;
  return c;
}

Model<2> model_of(const settings::Case& c)
{
  mesh::Mesh<2> mesh = mesh::make_box<2>(std::get<mesh::BoxMesh>(c.mesh));
  mesh.region_names = {"box", "air"};
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) mesh.region[cell] = mesh.centroid(cell)[1] < 1 ? 0 : 1;
  return make_model<2>(c, std::move(mesh));
}

TEST(Absorbing, boundary_absorbs_beside_soil_and_holds_above_it)
{
  const Model<2> model = model_of(bed_beside_open_side());
  const mesh::Mesh<2>& mesh = model.mesh;
  for (const Index node : mesh.boundary_nodes[mesh.find_boundary("right")]) {
    const bool beside_soil = mesh.position[node][1] <= 1;
    EXPECT_EQ(model.conditions.in_stage(0).held[node], 1) << "at rest all of it holds";
    EXPECT_EQ(model.conditions.in_stage(1).held[node], beside_soil ? 0 : 1);
    EXPECT_EQ(model.conditions.dashpots[0].of_node[node] != none, beside_soil);
  }
}

TEST(Absorbing, dashpots_have_the_impedance_of_the_soil_over_the_boundary_in_its_directions)
{
  const Model<2> model = model_of(bed_beside_open_side());
  const material::Material& soil = model.bodies[0].soil.materials.front();
  Matrix<2> sum = Matrix<2>::Zero();
  for (const Matrix<2>& resistance : model.conditions.dashpots[0].resistance) sum += resistance;
  const Real impedance = std::sqrt(inertia_density(soil) * p_wave_modulus(soil));  // over 1 m
  EXPECT_NEAR(sum(0, 0), impedance, 1e-12 * impedance);
  EXPECT_EQ(sum(1, 1), 0) << "y is free";
}

TEST(Absorbing, costs_nothing_where_no_boundary_does)
{
  settings::Case c = bed_beside_open_side();
  c.support[0].second.absorbs = false;
  EXPECT_TRUE(model_of(c).conditions.dashpots.empty());
}

TEST(Absorbing, boundary_without_soil_is_refused)
{
  settings::Case c = bed_beside_open_side();
  c.support[0].second.boundary = "top";
  EXPECT_THROW(model_of(c), KeyError);
}

}  // namespace
}  // namespace berm::problem::this_file
