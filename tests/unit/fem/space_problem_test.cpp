// SPDX-License-Identifier: BSD-3-Clause
#include "fem/space_problem.hpp"

#include "samples/space_footing.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

TEST(SpaceMesh, has_one_node_for_each_edge_and_all_of_the_volume)
{
  const SpaceProblem p = space_problem_of(block_in_space(elastic_soil()));
  // Kuhn's tetrahedra of 8 cubes have all the nodes of a lattice of half the spacing.
  EXPECT_EQ(p.model.mesh.cell_count(), 48);
  EXPECT_EQ(p.model.mesh.node_count(), 5 * 5 * 5);
  EXPECT_EQ(p.model.mesh.boundary_faces.size(), 6u * 4 * 2);
  Real volume = 0;
  for (const auto& of_cell : p.model.shape)
    for (const ElementPoint<3>& shape : of_cell) volume += shape.area;
  EXPECT_NEAR(volume, 1, 1e-13);
  EXPECT_NEAR(p.model.weight, 0, 1e-13);  // no gravity
}

TEST(SpaceMesh, is_held_at_the_middles_of_sides_too_and_nowhere_within)
{
  const SpaceProblem p = space_problem_of(block_in_space(elastic_soil()));
  for (Index node = 0; node < p.model.mesh.node_count(); ++node) {
    const Vec<3>& x = p.model.mesh.position[node];
    const bool base = x[1] == -1;
    const int expected = base ? 7 : ((x[0] == 0 || x[0] == 1 ? 1 : 0) | (x[2] == 0 || x[2] == 1 ? 4 : 0));
    EXPECT_EQ(p.model.mesh.fixed[0][node], expected) << x.transpose();
  }
}

TEST(SpaceMesh, follows_the_edge_of_a_disk)
{
  const SpaceFooting footing{.cells = 2, .soil = elastic_soil()};
  const SpaceProblem p = footing.problem();
  Index at_edge = 0;
  for (Index node = 0; node < p.model.mesh.node_count(); ++node) {
    const Vec<3>& x = p.model.mesh.position[node];
    const Real radius = std::hypot(x[0], x[2]);
    const bool on_top = x[1] > -1e-9;
    EXPECT_EQ(p.model.tied[node], on_top && radius < 1 + 1e-6 ? 0 : none) << x.transpose();
    if (on_top && std::abs(radius - 1) < 1e-9) ++at_edge;
  }
  EXPECT_EQ(at_edge, 9);  // four sides of a quarter, curved
}

TEST(SpaceProblem, refuses_what_it_has_not_with_the_key)
{
  const auto message_of = [](const settings::Case& c, const mesh::Mesh<3>& mesh) -> std::string {
    try {
      build_in_space(c, mesh);
    } catch (const KeyError& error) {
      return error.what();
    }
    return "";
  };
  const SpaceFooting footing{.cells = 2, .soil = elastic_soil()};
  settings::Case c = footing.settings();
  c.contact[0].second.scheme = contact::ContactSettings().scheme;
  EXPECT_NE(message_of(c, footing.mesh()).find("contact.base.scheme: finite elements in space have no gap"), std::string::npos);
  c = footing.settings();
  c.fem.large_deformation = true;
  EXPECT_NE(message_of(c, footing.mesh()).find("fem.large_deformation"), std::string::npos);
  c = footing.settings();
  std::get<bodies::CylinderSettings>(c.rigid[0].second.shape).center[1] = 1;
  EXPECT_NE(message_of(c, footing.mesh()).find("contact.base: the mesh has no face on the surface of rigid.footing"), std::string::npos);
}

}  // namespace
}  // namespace berm::fem::this_file
