// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/mesh.hpp"

#include "os/error.hpp"
#include "samples/sample_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace berm::mesh::this_file {
namespace {

template <class Dim>
class MeshIn : public testing::Test {
public:
  static constexpr int space = Dim::value;
  Mesh<space> sample = shaken_box<space>();
};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(MeshIn, Dims, );

TYPED_TEST(MeshIn, shape_functions_sum_to_one)
{
  constexpr int dim = TestFixture::space;
  const auto& mesh = this->sample;
  std::mt19937 random(2);
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const Vec<dim> x = random_point<dim>(random, mesh.lower, mesh.upper);
    Real sum = 0;
    for (int k = 0; k <= dim; ++k) sum += mesh.shape(c).value(k, x);
    EXPECT_NEAR(sum, 1, 1e-12);  // values of up to 100 far outside the cell cancel
  }
}

TYPED_TEST(MeshIn, shape_functions_are_one_at_their_corner_and_zero_at_the_others)
{
  constexpr int dim = TestFixture::space;
  const auto& mesh = this->sample;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int k = 0; k <= dim; ++k)
      for (int l = 0; l <= dim; ++l) EXPECT_NEAR(mesh.shape(c).value(k, mesh.position[mesh.nodes[c][l]]), k == l ? 1 : 0, 1e-13);
}

TYPED_TEST(MeshIn, gradients_reproduce_a_linear_field)
{
  constexpr int dim = TestFixture::space;
  const auto& mesh = this->sample;
  const Vec<dim> slope = Vec<dim>::LinSpaced(-2, 3);
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    Vec<dim> gradient = Vec<dim>::Zero();
    for (int k = 0; k <= dim; ++k) gradient += mesh.shape(c).gradient(k) * (7 + slope.dot(mesh.position[mesh.nodes[c][k]]));
    EXPECT_LT((gradient - slope).norm(), 1e-11);  // field of size 10 over cells of 0.1 m and more, at 1e-16
  }
}

TYPED_TEST(MeshIn, volumes_sum_to_that_of_the_box)
{
  constexpr int dim = TestFixture::space;
  Real sum = 0;
  for (Index c = 0; c < this->sample.cell_count(); ++c) {
    EXPECT_GT(this->sample.volume(c), 0);
    sum += this->sample.volume(c);
  }
  EXPECT_NEAR(sum, dim == 2 ? 2.1 * 1.2 : 2.1 * 1.2 * 0.9, 1e-13);
}

TYPED_TEST(MeshIn, cells_keep_their_orientation_positive)
{
  constexpr int dim = TestFixture::space;
  auto mesh = this->sample;
  for (Index c = 0; c < mesh.cell_count(); c += 2) std::swap(mesh.nodes[c][0], mesh.nodes[c][1]);
  mesh.complete();
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto edge = [&](int k) { return Vec<dim>(mesh.position[mesh.nodes[c][k]] - mesh.position[mesh.nodes[c][0]]); };
    const Vec<dim> p = edge(1), q = edge(2);
    if constexpr (dim == 2) {
      EXPECT_NEAR((p[0] * q[1] - p[1] * q[0]) / 2, mesh.volume(c), 1e-14);
    } else {
      const Vec<dim> r = edge(3), cross(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]);
      EXPECT_NEAR(cross.dot(r) / 6, mesh.volume(c), 1e-14);
    }
  }
}

TYPED_TEST(MeshIn, height_is_the_smallest_distance_from_a_corner_to_its_face)
{
  constexpr int dim = TestFixture::space;
  const auto& mesh = this->sample;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    Real smallest = infinity;
    for (int k = 0; k <= dim; ++k) smallest = std::min(smallest, 1 / mesh.shape(c).gradient(k).norm());
    EXPECT_DOUBLE_EQ(mesh.height(c), smallest);
  }
  // Known answer: the halved unit square has sides 1, 1, sqrt(2) and the height 1/sqrt(2) onto the longest.
  if constexpr (dim == 2) {
    EXPECT_NEAR(make_box<2>({.lower = {}, .size = {1, 1}, .cells = {1, 1}}).height(0), std::sqrt(0.5), 1e-15);
  }
}

TYPED_TEST(MeshIn, neighbors_are_mutual_and_share_all_but_one_corner)
{
  constexpr int dim = TestFixture::space;
  const auto& mesh = this->sample;
  Index boundary_faces = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int k = 0; k <= dim; ++k) {
      const Index other = mesh.neighbor(c, k);
      if (other == none) {
        ++boundary_faces;
        continue;
      }
      int back = 0;
      for (int l = 0; l <= dim; ++l) back += mesh.neighbor(other, l) == c;
      EXPECT_EQ(back, 1);
      for (int l = 0; l <= dim; ++l) {
        const auto& there = mesh.nodes[other];
        EXPECT_EQ(std::count(there.begin(), there.end(), mesh.nodes[c][l]), l == k ? 0 : 1);
      }
    }
  EXPECT_EQ(boundary_faces, dim == 2 ? 2 * (7 + 4) : 2 * 2 * (7 * 4 + 7 * 3 + 4 * 3));
}

TYPED_TEST(MeshIn, entries_of_a_node_ascend_and_are_complete)
{
  constexpr int dim = TestFixture::space;
  const auto& mesh = this->sample;
  ASSERT_EQ(mesh.first_entry.size(), mesh.node_count() + 1);
  EXPECT_EQ(mesh.first_entry[0], 0);
  EXPECT_EQ(mesh.first_entry[mesh.node_count()], static_cast<Index>(mesh.entries.size()));
  EXPECT_EQ(static_cast<Index>(mesh.entries.size()), (dim + 1) * mesh.cell_count());
  for (Index i = 0; i < mesh.node_count(); ++i) {
    EXPECT_LT(mesh.first_entry[i], mesh.first_entry[i + 1]) << "a node of no cell";
    for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e) {
      const Index entry = mesh.entries[e];
      EXPECT_EQ(mesh.nodes[entry / (dim + 1)][entry % (dim + 1)], i);
      if (e > mesh.first_entry[i]) {
        EXPECT_LT(mesh.entries[e - 1], entry);
      }
    }
  }
}

TYPED_TEST(MeshIn, boundary_nodes_lie_on_their_boundary_and_ascend)
{
  constexpr int dim = TestFixture::space;
  const auto& mesh = this->sample;
  const std::vector<std::string> low = {"left", "bottom", "back"}, high = {"right", "top", "front"};
  for (int d = 0; d < dim; ++d)
    for (const bool at_high : {false, true}) {
      const Index boundary = mesh.find_boundary(at_high ? high[d] : low[d]);
      ASSERT_NE(boundary, none);
      std::vector<Index> expected;
      for (Index i = 0; i < mesh.node_count(); ++i)
        if (mesh.position[i][d] == (at_high ? mesh.upper[d] : mesh.lower[d])) expected.push_back(i);
      EXPECT_EQ(mesh.boundary_nodes[boundary], expected);
    }
  EXPECT_EQ(mesh.find_boundary("lid"), none);
  EXPECT_EQ(mesh.find_region("box"), 0);
  EXPECT_EQ(mesh.find_region("bed"), none);
}

TYPED_TEST(MeshIn, completing_twice_changes_nothing)
{
  auto again = this->sample;
  again.complete();
  EXPECT_TRUE(std::equal(again.nodes.begin(), again.nodes.end(), this->sample.nodes.begin()));
  EXPECT_TRUE(std::equal(again.position.begin(), again.position.end(), this->sample.position.begin()));
  EXPECT_EQ(again.boundary_nodes, this->sample.boundary_nodes);
}

TYPED_TEST(MeshIn, nodes_of_no_cell_are_left_out)
{
  constexpr int dim = TestFixture::space;
  auto mesh = this->sample;
  const Index count = mesh.node_count();
  mesh.position.push_back(Vec<dim>::Constant(99));
  mesh.boundary_nodes[0].push_back(count);
  mesh.complete();
  EXPECT_EQ(mesh.node_count(), count);
  EXPECT_EQ(mesh.boundary_nodes, this->sample.boundary_nodes);
}

TYPED_TEST(MeshIn, a_wrong_mesh_is_refused)
{
  constexpr int dim = TestFixture::space;
  const auto expect_refused = [&](const char* word, const auto& damage) {
    auto mesh = this->sample;
    damage(mesh);
    try {
      mesh.complete();
      ADD_FAILURE() << "accepted, but expected: " << word;
    } catch (const RunError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  expect_refused("no cells", [](auto& m) { m = Mesh<dim>{}; });
  expect_refused("no volume", [](auto& m) { m.nodes[3][1] = m.nodes[3][0]; });
  expect_refused("no volume", [](auto& m) { m.position[m.nodes[3][0]] = m.position[m.nodes[3][1]]; });
  expect_refused("not finite", [](auto& m) { m.position[5][1] = NAN; });
  expect_refused("has node", [](auto& m) { m.nodes[2][0] = m.node_count(); });
  expect_refused("has node", [](auto& m) { m.boundary_nodes[0][0] = -2; });
  expect_refused("regions", [](auto& m) { m.region.push_back(0); });
  expect_refused("region", [](auto& m) { m.region[0] = 1; });
  expect_refused("names", [](auto& m) { m.boundary_names.pop_back(); });
  // The same cell twice has its free faces once more too, its inner faces three times.
  expect_refused("belongs to 3 cells", [](auto& m) {
    Index c = 0;
    const auto at_boundary = [&] {
      bool any = false;
      for (int k = 0; k <= dim; ++k) any = any || m.neighbor(c, k) == none;
      return any;
    };
    while (at_boundary()) ++c;
    m.nodes.push_back(m.nodes[c]);
    m.region.push_back(0);
  });
}

TYPED_TEST(MeshIn, overlapping_cells_are_refused)
{
  constexpr int dim = TestFixture::space;
  Mesh<dim> mesh;
  mesh.region_names = {"all"};
  mesh.position.push_back(Vec<dim>::Zero());
  for (int d = 0; d < dim; ++d) mesh.position.push_back(Vec<dim>::Unit(d));
  mesh.position.push_back(Vec<dim>::Constant(0.9));
  typename Mesh<dim>::Corners corner;
  for (int k = 0; k <= dim; ++k) corner[k] = k;
  mesh.nodes.push_back(corner);
  corner[0] = dim + 1;
  mesh.nodes.push_back(corner);
  mesh.region.assign(2, 0);
  EXPECT_NO_THROW(Mesh<dim>(mesh).complete());
  mesh.position[dim + 1] = Vec<dim>::Constant(0.1);
  EXPECT_THROW(mesh.complete(), RunError);
}

}  // namespace
}  // namespace berm::mesh::this_file
