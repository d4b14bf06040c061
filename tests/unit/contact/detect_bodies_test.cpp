// SPDX-License-Identifier: BSD-3-Clause
#include "contact/detect.hpp"

#include "bodies/fill.hpp"
#include "samples/sample_meshes.hpp"

#include <gtest/gtest.h>

namespace berm::contact::this_file {
namespace {

constexpr Real spacing = 0.05;

/// Two blocks in a mesh without two equal cells (-0.3 ... 1.8 m, 0.2 ... 1.4 m (, 1 ... 1.9 m)); each with the mass of its particles' cells.
template <int dim>
struct TwoBlocks {
  mesh::Mesh<dim> mesh = shaken_box<dim>();
  bodies::Particles<dim> lower, upper;
  NodeField<Real> lower_mass, upper_mass;
  std::vector<Index> nodes;

  TwoBlocks(const bodies::BlockSettings& below, const bodies::BlockSettings& above)
      : lower(filled(below)),
        upper(filled(above)),
        lower_mass(mass_of(lower)),
        upper_mass(mass_of(upper))
  {
    for (Index node = 0; node < mesh.node_count(); ++node) nodes.push_back(node);
  }

  ContactPoints<dim> found(Detection detection, bool swapped = false) const
  {
    ContactPoints<dim> points;
    const BodyView<dim> a{lower, lower_mass, nodes}, b{upper, upper_mass, nodes};
    swapped ? detect<dim>(mesh, a, b, detection, points) : detect<dim>(mesh, b, a, detection, points);
    return points;
  }

private:
  bodies::Particles<dim> filled(const bodies::BlockSettings& block) const
  {
    bodies::BodySettings body;
    body.block = block;
    return fill<dim>(mesh, "block", body, bodies::StartState<dim>{1000, 0, 0});
  }
  NodeField<Real> mass_of(const bodies::Particles<dim>& particles) const
  {
    NodeField<Real> mass(mesh.node_count(), 0);
    for (Index cell : particles.occupied())
      for (Index node : mesh.nodes[cell]) mass[node] = 1;
    return mass;
  }
};

bodies::BlockSettings block(std::vector<Real> center, std::vector<Real> size, int dim, Real angle = 0)
{
  center.resize(dim);
  size.resize(dim);
  bodies::BlockSettings settings;
  settings.center = center;
  settings.size = size;
  settings.angle = angle;
  settings.spacing = spacing;
  return settings;
}

/// Blocks whose flat sides are `gap` apart, at y = 0.7 m.
template <int dim>
TwoBlocks<dim> stacked(Real gap)
{
  return {block({0.75, 0.5, 1.45}, {1.6, 0.4, 0.6}, dim), block({0.75, 0.9 + gap, 1.45}, {0.8, 0.4, 0.4}, dim)};
}

template <class Dimension>
class DetectBodies : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(DetectBodies, Dimensions);

TYPED_TEST(DetectBodies, share_the_normal_and_the_gap_of_flat_sides_wherever_the_nodes_are)
{
  constexpr int dim = TypeParam::value;
  for (const Real gap : {0., 0.01, 0.03}) {
    const auto found = stacked<dim>(gap).found(Detection::gap);
    int compared = 0;
    for (const auto& point : found.list) {
      // At the rim of the upper block a node may see nothing of what lies straight below it.
      if (dim == 3 && (std::abs(point.position[0] - 0.75) > 0.3 || std::abs(point.position[2] - 1.45) > 0.2)) continue;
      ++compared;
      EXPECT_NEAR(point.normal[1], 1, 2e-5) << "at "
                                            << point.position.transpose();  // the search ends within 1e-3 rad: 5e-7, four angles in space
      EXPECT_NEAR(point.normal.norm(), 1, 1e-14);
      EXPECT_NEAR(point.gap, gap, 2e-3 * 0.6) << "at " << point.position.transpose();  // 1e-3 rad over the width of a node's cells
      EXPECT_NEAR(point.distance, gap + spacing, 2e-3 * 0.6);
      EXPECT_EQ(point.touching, point.gap < spacing / 2);
    }
    EXPECT_GT(compared, 3);
  }
}

TYPED_TEST(DetectBodies, swapped_see_the_opposite_normal_and_the_same_gap)
{
  constexpr int dim = TypeParam::value;
  const auto blocks = stacked<dim>(0.01);
  const auto one = blocks.found(Detection::gap), other = blocks.found(Detection::gap, true);
  ASSERT_EQ(one.list.size(), other.list.size());
  for (std::size_t k = 0; k < one.list.size(); ++k) {
    EXPECT_EQ(one.list[k].nodes[0], other.list[k].nodes[0]);
    EXPECT_NEAR((one.list[k].normal + other.list[k].normal).norm(), 0, 4e-3);
    EXPECT_NEAR(one.list[k].gap, other.list[k].gap, 2e-3 * 0.6);
  }
}

TYPED_TEST(DetectBodies, distance_leaves_out_open_gaps_and_overlap_knows_none)
{
  constexpr int dim = TypeParam::value;
  EXPECT_TRUE(stacked<dim>(0.03).found(Detection::distance).list.empty());
  const auto pressed = stacked<dim>(-0.01).found(Detection::distance);
  EXPECT_GT(pressed.list.size(), 5u);
  const auto open = stacked<dim>(0.03);
  EXPECT_EQ(open.found(Detection::overlap).list.size(), open.found(Detection::gap).list.size());
  for (const auto& point : open.found(Detection::overlap).list) {
    EXPECT_EQ(point.gap, 0);
    EXPECT_TRUE(point.touching);
  }
}

TEST(DetectTurnedBodies, share_the_normal_of_an_interface_that_lies_at_any_angle)
{
  for (const Real angle : {0.2, 0.7, 1.3, -0.5}) {
    const Vec<2> along(std::cos(angle), std::sin(angle)), normal(-std::sin(angle), std::cos(angle)), middle(0.75, 0.8);
    const auto center = [&](Real offset) { return std::vector<Real>{middle[0] + offset * normal[0], middle[1] + offset * normal[1]}; };
    const TwoBlocks<2> blocks(block(center(-0.15), {0.8, 0.3}, 2, angle), block(center(0.15), {0.5, 0.3}, 2, angle));
    const auto found = blocks.found(Detection::gap);
    int beside_the_interface = 0;
    for (const auto& point : found.list) {
      if (std::abs((point.position - middle).dot(along)) > 0.2) continue;
      EXPECT_NEAR(point.normal.dot(normal), 1, 2e-5);
      EXPECT_NEAR(point.gap, 0, 2e-3);
      ++beside_the_interface;
    }
    EXPECT_GT(beside_the_interface, 0);
  }
}

TEST(DetectBodies2, far_apart_share_no_node)
{
  const TwoBlocks<2> blocks(block({0.1, 0.6}, {0.4, 0.4}, 2), block({1.4, 0.6}, {0.4, 0.4}, 2));
  EXPECT_TRUE(blocks.found(Detection::gap).list.empty());
}

}  // namespace
}  // namespace berm::contact::this_file
