// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/box.hpp"

#include "os/error.hpp"
#include "samples/sample_meshes.hpp"

#include <gtest/gtest.h>

namespace berm::mesh::this_file {
namespace {

TEST(BoxMesh, has_the_cells_its_pattern_promises)
{
  EXPECT_EQ(make_box<2>(sample_box<2>()).cell_count(), 2 * 7 * 4);
  EXPECT_EQ(make_box<2>(sample_box<2>(BoxPattern::criss_cross)).cell_count(), 4 * 7 * 4);
  EXPECT_EQ(make_box<3>(sample_box<3>()).cell_count(), 6 * 7 * 4 * 3);
  EXPECT_EQ(make_box<2>(sample_box<2>()).node_count(), 8 * 5);
  EXPECT_EQ(make_box<2>(sample_box<2>(BoxPattern::criss_cross)).node_count(), 8 * 5 + 7 * 4);
}

TEST(BoxMesh, criss_cross_cells_have_equal_volumes_that_fill_the_box)
{
  const auto mesh = make_box<2>(sample_box<2>(BoxPattern::criss_cross));
  for (Index c = 0; c < mesh.cell_count(); ++c) EXPECT_NEAR(mesh.volume(c), 0.3 * 0.3 / 4, 1e-15);
}

TEST(BoxMesh, spans_from_its_lower_corner_over_its_size)
{
  const auto mesh = make_box<3>(sample_box<3>());
  EXPECT_EQ(mesh.lower, Vec<3>(-0.3, 0.2, 1));
  EXPECT_LT((mesh.upper - Vec<3>(1.8, 1.4, 1.9)).norm(), 1e-15);
  EXPECT_EQ(make_box<2>({.lower = {}, .size = {1, 1}, .cells = {2, 2}}).lower, Vec<2>(0, 0));
}

TEST(BoxMesh, every_inner_face_joins_two_cells)
{
  // Kuhn's tetrahedra conform from cube to cube: the free faces are the boundary's two triangles a square, no more.
  const auto mesh = make_box<3>(sample_box<3>());
  Index free_faces = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int k = 0; k < 4; ++k) free_faces += mesh.neighbor(c, k) == none;
  EXPECT_EQ(free_faces, 2 * 2 * (7 * 4 + 7 * 3 + 4 * 3));
}

TEST(BoxMesh, cells_next_to_each_other_in_memory_are_near_each_other)
{
  const auto mesh = make_box<2>({.lower = {}, .size = {1, 1}, .cells = {64, 64}});
  Real sum = 0;
  for (Index c = 1; c < mesh.cell_count(); ++c) sum += (mesh.centroid(c) - mesh.centroid(c - 1)).norm();
  // Row by row the mean would be about the same, but the node numbers of a cell would span 65; along the curve most span little.
  EXPECT_LT(sum / (mesh.cell_count() - 1), 1.5 / 64);
  Index span = 0;
  for (const auto& corner : mesh.nodes) {
    const auto [min, max] = std::minmax_element(corner.begin(), corner.end());
    span += *max - *min < 32;
  }
  EXPECT_GT(span, mesh.cell_count() * 3 / 4);
}

TEST(BoxMesh, entries_that_do_not_fit_are_refused)
{
  const auto refused = [](const BoxMesh& box) { EXPECT_THROW(make_box<2>(box), InputError); };
  refused({.lower = {0}, .size = {1, 1}, .cells = {2, 2}});
  refused({.lower = {}, .size = {1, 1, 1}, .cells = {2, 2}});
  refused({.lower = {}, .size = {1, 1}, .cells = {2}});
  refused({.lower = {}, .size = {1, 1}, .cells = {2, 2.5}});
  refused({.lower = {}, .size = {1, 1}, .cells = {2, 0}});
  refused({.lower = {}, .size = {1, 1}, .cells = {2, NAN}});
  refused({.lower = {}, .size = {1, 0}, .cells = {2, 2}});
  refused({.lower = {}, .size = {1, infinity}, .cells = {2, 2}});
  refused({.lower = {NAN, 0}, .size = {1, 1}, .cells = {2, 2}});
  refused({.lower = {}, .size = {1, 1}, .cells = {1e5, 1e5}});
  EXPECT_THROW(make_box<3>(sample_box<3>(BoxPattern::criss_cross)), InputError);
}

}  // namespace
}  // namespace berm::mesh::this_file
