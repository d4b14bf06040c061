// SPDX-License-Identifier: BSD-3-Clause
#include "contact/detect.hpp"

#include "bodies/fill.hpp"
#include "samples/sample_meshes.hpp"

#include <gtest/gtest.h>
#include <map>

namespace berm::contact::this_file {
namespace {

/// Particles fill the cells below y = 0.8 m of a mesh without two equal cells, 0.2 m ... 1.4 m high.
template <int dim>
struct Bed {
  mesh::Mesh<dim> mesh = shaken_box<dim>();
  bodies::Particles<dim> particles;
  NodeField<Real> mass;

  Bed() : mass(mesh.node_count(), 0)
  {
    mesh.region_names = {"low", "high"};
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) mesh.region[cell] = mesh.centroid(cell)[1] < 0.8 ? 0 : 1;
    bodies::BodySettings body;
    body.regions = {"low"};
    particles = fill<dim>(mesh, "bed", body, bodies::StartState<dim>{1000, 0, 0});
    for (Index cell : particles.occupied())
      for (Index node : mesh.nodes[cell]) mass[node] = 1;
  }

  ContactPoints<dim> found(const bodies::RigidBody<dim>& rigid, const Vec<dim>& displacement, Detection detection) const
  {
    ContactPoints<dim> result;
    find_again(rigid, displacement, detection, result);
    return result;
  }
  void find_again(const bodies::RigidBody<dim>& rigid, const Vec<dim>& displacement, Detection detection, ContactPoints<dim>& result) const
  {
    bodies::Pose<dim> listed = bodies::Pose<dim>::nowhere();
    NodeField<Real> masses = mass;
    detect<dim>(mesh, particles, rigid, {displacement, {}}, listed, detection, ParticleRim::whole, masses, result);
  }

  Real min_height() const
  {
    Real min = infinity;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) min = std::min(min, mesh.height(cell));
    return min;
  }
};

template <int dim>
Vec<dim> at(Real x, Real y)
{
  Vec<dim> v = Vec<dim>::Zero();
  v[0] = x;
  v[1] = y;
  return v;
}

template <int dim>
std::vector<bodies::RigidBody<dim>> rigid_bodies()
{
  const auto vec = [](std::vector<Real> v) {
    v.resize(dim);
    return v;
  };
  return {{"circle", make_shape<dim>(bodies::CircleSettings{vec({0.8, 1.05, 1.4}), 0.5}), 0},
          {"plane", make_shape<dim>(bodies::HalfPlaneSettings{vec({0.8, 0.85, 1.4}), vec({-0.2, -1, 0})}), 0},
          {"box", make_shape<dim>(bodies::BoxSettings{vec({0.8, 1, 1.4}), vec({0.5, 0.4, 0.6}), 0}), 0}};
}

/// The gap and the distance that a node should have by looking at all particles of all its cells.
struct Brute {
  Real gap = infinity, distance = infinity;
  bool touching = false;
};

template <int dim>
std::vector<Brute> brute_force(const Bed<dim>& bed, const bodies::RigidShape<dim>& shape)
{
  std::vector<Brute> nodes(bed.mesh.node_count());
  bed.particles.visit([&](Index cell, Index b, int l) {
    const bodies::Particle<dim> p = bed.particles.read(b, l);
    const Real half = std::pow(p.volume, 1. / dim) / 2, distance = surface_at<dim>(shape, p.x).distance;
    for (Index node : bed.mesh.nodes[cell]) {
      nodes[node].gap = std::min(nodes[node].gap, distance - half);
      nodes[node].distance = std::min(nodes[node].distance, distance);
      nodes[node].touching = nodes[node].touching || distance - half < half;
    }
  });
  return nodes;
}

template <int dim>
std::map<Index, ContactPoint<dim>> by_node(const ContactPoints<dim>& found)
{
  std::map<Index, ContactPoint<dim>> nodes;
  for (const auto& contact : found.list) EXPECT_TRUE(nodes.emplace(contact.nodes[0], contact).second) << "a node is listed twice";
  return nodes;
}

template <int dim>
void expect_gaps(const Bed<dim>& bed, const bodies::RigidBody<dim>& rigid, const Vec<dim>& displacement, const ContactPoints<dim>& found)
{
  const auto shape = placed<dim>(rigid, {displacement, {}});
  const auto expected = brute_force(bed, shape);
  const auto nodes = by_node(found);
  Real nearest = infinity, min = infinity;
  int compared = 0;
  for (Index node = 0; node < bed.mesh.node_count(); ++node) {
    const Brute& brute = expected[node];
    nearest = std::min(nearest, brute.distance);
    min = std::min(min, brute.gap);
    // Cells far from the surface may be left out, so a large gap may be missed or found too large, never too small.
    const auto it = nodes.find(node);
    if (it != nodes.end()) {
      EXPECT_GE(it->second.gap, brute.gap - 1e-14);
      EXPECT_NEAR(it->second.normal.norm(), 1, 1e-14);
    }
    if (brute.gap > bed.min_height()) continue;
    ASSERT_TRUE(it != nodes.end()) << rigid.name << ": node " << node << " with gap " << brute.gap << " is missing";
    EXPECT_NEAR(it->second.gap, brute.gap, 1e-14);
    EXPECT_NEAR(it->second.distance, brute.distance, 1e-14);
    EXPECT_EQ(it->second.touching, brute.touching);
    if (!std::holds_alternative<bodies::Box<dim>>(shape)) {
      EXPECT_NEAR((it->second.normal - surface_at<dim>(shape, bed.mesh.position[node]).normal).norm(), 0, 1e-14);
    }
    ++compared;
  }
  EXPECT_GT(compared, 5) << rigid.name;
  EXPECT_NEAR(found.nearest_particle, nearest, 1e-14);
  Real min_of_nodes = infinity;
  for (const auto& c : found.list) min_of_nodes = std::min(min_of_nodes, c.gap);
  EXPECT_NEAR(min_of_nodes, min, 1e-14);
}

template <class Dimension>
class Detect : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Detect, Dimensions);

TYPED_TEST(Detect, a_nodes_gap_is_the_least_of_all_particles_in_its_cells)
{
  constexpr int dim = TypeParam::value;
  const Bed<dim> bed;
  for (const auto& rigid : rigid_bodies<dim>())
    for (const Real down : {0., -0.02, -0.2}) {
      const Vec<dim> displacement = at<dim>(0.01, down);
      expect_gaps(bed, rigid, displacement, bed.found(rigid, displacement, Detection::gap));
    }
}

TYPED_TEST(Detect, the_gaps_follow_the_body_as_it_moves)
{
  // Small steps, in which the list of near cells is kept for a while, over most of the bed, and a leap.
  constexpr int dim = TypeParam::value;
  const Bed<dim> bed;
  for (const auto& rigid : rigid_bodies<dim>()) {
    ContactPoints<dim> found;
    for (int n = 0; n <= 60; ++n) {
      const Vec<dim> displacement = at<dim>(0.02 * n - 0.6, -0.001 * n);
      bed.find_again(rigid, displacement, Detection::gap, found);
      expect_gaps(bed, rigid, displacement, found);
    }
    bed.find_again(rigid, at<dim>(-0.3, -0.05), Detection::gap, found);
    expect_gaps(bed, rigid, at<dim>(-0.3, -0.05), found);
  }
}

TYPED_TEST(Detect, nothing_is_listed_far_from_the_body)
{
  constexpr int dim = TypeParam::value;
  const Bed<dim> bed;
  const auto found = bed.found(rigid_bodies<dim>()[0], at<dim>(0, 10), Detection::gap);
  EXPECT_TRUE(found.list.empty());
  EXPECT_EQ(found.nearest_particle, infinity);
}

/// Whether the body reaches into a cell, tried at many points inside it and along its edges.
template <int dim>
bool reached(const mesh::Mesh<dim>& mesh, Index cell, const bodies::RigidShape<dim>& shape)
{
  const auto& nodes = mesh.nodes[cell];
  for (int a = 0; a <= dim; ++a)
    for (int b = 0; b < a; ++b)
      for (int n = 0; n <= 16; ++n)
        if (surface_at<dim>(shape, mesh.position[nodes[a]] * (n / 16.) + mesh.position[nodes[b]] * (1 - n / 16.)).distance < 0) return true;
  for (const auto& point : bodies::points_in_simplex<dim>(4)) {
    Vec<dim> x = Vec<dim>::Zero();
    for (int k = 0; k <= dim; ++k) x += point[k] * mesh.position[nodes[k]];
    if (surface_at<dim>(shape, x).distance < 0) return true;
  }
  return false;
}

TYPED_TEST(Detect, overlap_lists_the_nodes_with_mass_of_all_cells_that_the_body_reaches_into)
{
  constexpr int dim = TypeParam::value;
  const Bed<dim> bed;
  for (const auto& rigid : rigid_bodies<dim>()) {
    ContactPoints<dim> found;
    for (int n = 0; n <= 10; ++n) {
      const Vec<dim> displacement = at<dim>(0.02 * n, -0.02 * n);
      bed.find_again(rigid, displacement, Detection::overlap, found);
      const auto shape = placed<dim>(rigid, {displacement, {}});
      // Certainly in: a corner lies in the body. Certainly out: none of many points does.
      std::vector<bool> surely(bed.mesh.node_count(), false), perhaps(bed.mesh.node_count(), false);
      for (Index cell = 0; cell < bed.mesh.cell_count(); ++cell) {
        bool corner = false;
        for (Index node : bed.mesh.nodes[cell]) corner = corner || surface_at<dim>(shape, bed.mesh.position[node]).distance < 0;
        const bool any_part = corner || reached(bed.mesh, cell, shape);
        for (Index node : bed.mesh.nodes[cell]) {
          surely[node] = surely[node] || corner;
          perhaps[node] = perhaps[node] || any_part;
        }
      }
      const auto nodes = by_node(found);
      for (Index node = 0; node < bed.mesh.node_count(); ++node) {
        const bool has_mass = bed.mass[node] > 0;
        EXPECT_TRUE(nodes.contains(node) || !(surely[node] && has_mass)) << rigid.name << " " << n;
        EXPECT_TRUE(!nodes.contains(node) || (perhaps[node] && has_mass)) << rigid.name << " " << n;
      }
      for (const auto& [node, contact] : nodes) {
        EXPECT_EQ(contact.gap, 0);
        EXPECT_TRUE(contact.touching);
      }
      const auto fresh = by_node(bed.found(rigid, displacement, Detection::overlap));
      EXPECT_EQ(fresh.size(), nodes.size());
      for (const auto& [node, contact] : fresh) EXPECT_TRUE(nodes.contains(node));
    }
  }
}

TYPED_TEST(Detect, distance_lists_the_nodes_of_gap_whose_gap_is_closed)
{
  constexpr int dim = TypeParam::value;
  const Bed<dim> bed;
  int closed = 0;
  for (const auto& rigid : rigid_bodies<dim>()) {
    const Vec<dim> displacement = at<dim>(0.01, -0.1);
    const auto all = by_node(bed.found(rigid, displacement, Detection::gap));
    const auto found = by_node(bed.found(rigid, displacement, Detection::distance));
    for (const auto& [node, point] : all) EXPECT_EQ(found.contains(node), point.gap <= 0) << rigid.name;
    for (const auto& [node, point] : found) {
      ASSERT_TRUE(all.contains(node));
      EXPECT_EQ(point.gap, all.at(node).gap);
    }
    closed += static_cast<int>(found.size());
  }
  EXPECT_GT(closed, 5);
}

TYPED_TEST(Detect, particle_lists_each_particle_whose_gap_is_less_than_its_width)
{
  constexpr int dim = TypeParam::value;
  const Bed<dim> bed;
  for (const auto& rigid : rigid_bodies<dim>()) {
    const Vec<dim> displacement = at<dim>(0.01, -0.05);
    const auto found = bed.found(rigid, displacement, Detection::particle);
    const auto shape = placed<dim>(rigid, {displacement, {}});
    std::size_t expected = 0;
    bed.particles.visit([&](Index, Index b, int l) {
      const bodies::Particle<dim> p = bed.particles.read(b, l);
      const Real width = std::pow(p.volume, 1. / dim);
      expected += surface_at<dim>(shape, p.x).distance - width / 2 < width;
    });
    EXPECT_EQ(found.list.size(), expected) << rigid.name;
    EXPECT_GT(expected, 5u) << rigid.name;
    for (const auto& point : found.list) {
      // The shape functions at a particle give back its place: `distance` out of the surface along the normal.
      ASSERT_EQ(point.node_count, dim + 1);
      Vec<dim> x = Vec<dim>::Zero();
      Real total = 0;
      for (int n = 0; n <= dim; ++n) x += point.weights[n] * bed.mesh.position[point.nodes[n]], total += point.weights[n];
      EXPECT_NEAR(total, 1, 1e-13);
      EXPECT_NEAR((x - point.position - point.distance * point.normal).norm(), 0, 1e-13);
      EXPECT_NEAR(surface_at<dim>(shape, point.position).distance, 0, 1e-13);
    }
  }
}

TYPED_TEST(Detect, rims_wear_as_the_soil_of_their_particles_is_sheared)
{
  constexpr int dim = TypeParam::value;
  Bed<dim> bed;
  const auto rigid = rigid_bodies<dim>().front();
  bodies::Pose<dim> listed = bodies::Pose<dim>::nowhere();
  NodeField<Real> masses = bed.mass;
  ContactPoints<dim> whole, worn;
  // Strains of 0, 0.05, 0.1 ... by number.
  bed.particles.visit(
      [&](Index, Index b, int l) { bed.particles.block(b).deviatoric_strain[l] = 0.05 * (bed.particles.block(b).id[l] % 9); });
  detect(bed.mesh, bed.particles, rigid, {at<dim>(0.01, -0.05), {}}, listed, Detection::particle, ParticleRim::whole, masses, whole);
  detect(bed.mesh, bed.particles, rigid, {at<dim>(0.01, -0.05), {}}, listed, Detection::particle, ParticleRim::worn, masses, worn);
  ASSERT_EQ(worn.list.size(), whole.list.size());
  ASSERT_GT(worn.list.size(), 9u);
  for (std::size_t k = 0; k < worn.list.size(); ++k) {
    const bodies::Particle<dim> p = bed.particles.read(worn.list[k].block, worn.list[k].lane);
    const Real half = std::pow(p.volume, 1. / dim) / 2;
    EXPECT_NEAR(worn.list[k].half_width, half, 1e-13);
    EXPECT_NEAR(whole.list[k].gap, whole.list[k].distance - half, 1e-13);
    EXPECT_NEAR(worn.list[k].gap, whole.list[k].distance - half * (0.05 + 0.95 * std::exp(-10 * p.deviatoric_strain)), 1e-13);
    EXPECT_EQ(worn.list[k].touching, whole.list[k].touching);
  }
}

TEST(DetectBox, nodes_beside_a_corner_take_the_normal_of_the_side_that_the_soil_touches)
{
  // The box stands 0.3 m deep in the bed. A node inside it, nearer to its wall than to its base, still gets the base's normal where its nearest
  // particle lies below the base.
  const Bed<2> bed;
  const bodies::RigidBody<2> rigid{"box", make_shape<2>(bodies::BoxSettings{{0.8, 1.0}, {0.9, 0.6}, 0}), 0};
  const auto shape = rigid.shape;
  const auto found = bed.found(rigid, Vec<2>::Zero(), Detection::gap);
  ASSERT_GT(found.list.size(), 10u);
  for (const auto& contact : found.list) {
    Real min = infinity;
    Vec<2> normal = Vec<2>::Zero();
    bed.particles.visit([&](Index cell, Index b, int l) {
      const auto& corners = bed.mesh.nodes[cell];
      if (std::find(corners.begin(), corners.end(), contact.nodes[0]) == corners.end()) return;
      const auto p = bed.particles.read(b, l);
      const auto surface = surface_at<2>(shape, p.x);
      const Real gap = surface.distance - std::sqrt(p.volume) / 2;
      if (gap < min) min = gap, normal = surface.normal;
    });
    if (contact.gap > min + 1e-12) continue;  // found by a cell that is not near
    EXPECT_NEAR((contact.normal - normal).norm(), 0, 1e-14);
  }
}

TEST(DetectInSpace, all_particles_near_a_solid_are_points_while_it_turns_and_moves)
{
  // Long bodies that turn a little each step, about an axis askew: the list of near cells is kept for some of them.
  using namespace bodies;
  const Bed<3> bed;
  const std::pair<const char*, RigidShapeSettings> solids[] = {
      {"cylinder", CylinderSettings{{0.8, 1, 0.8}, {1, 0, 1}, 0.3, 1.2}},
      {"cylinder with round ends", CylinderSettings{{0.8, 1, 0.8}, {1, 0.2, 0}, 0.3, 1.2, CylinderEnds::round}},
      {"plate", BoxSettings{{0.8, 1, 0.8}, {1, 0.1, 0.6}, 0, {0.1, 0.2, 0.3}}},
      {"box with round edges", BoxSettings{{0.8, 1, 0.8}, {0.8, 0.5, 0.6}, 0, {0.1, 0.2, 0.3}, 0.1}},
      {"cone", ProfileSettings{{0, 0.3, 0.3, 0}, {-0.3, 0, 0.6, 0.6}, 0, {0.8, 0.9, 0.8}, {0.3, 1, 0}}},
      {"ring", ProfileSettings{{0.4, 0.5, 0.5, 0.4}, {-0.3, -0.3, 0.3, 0.3}, 0, {0.8, 1, 0.8}, {0, 1, 0.2}}}};
  for (const auto& [name, settings] : solids) {
    const RigidBody<3> rigid{name, make_shape<3>(settings)};
    Pose<3> pose, last_listed = Pose<3>::nowhere();
    ContactPoints<3> found;
    Index listed = 0;
    for (int n = 0; n < 60; ++n) {
      pose.displacement += Vec<3>(0.002, -0.004, 0.001);
      pose.orientation.turn_by(Vec<3>(0.03, 0.05, -0.04));
      NodeField<Real> masses = bed.mass;
      detect(bed.mesh, bed.particles, rigid, pose, last_listed, Detection::particle, ParticleRim::whole, masses, found);
      const auto shape = placed(rigid, pose);
      Index near = 0;
      bed.particles.visit([&](Index, Index b, int l) {
        const Particle<3> p = bed.particles.read(b, l);
        near += surface_at<3>(shape, p.x).distance < 1.5 * std::cbrt(p.volume);
      });
      ASSERT_EQ(static_cast<Index>(found.list.size()), near) << name << ", step " << n;
      for (const auto& point : found.list) {
        EXPECT_NEAR(surface_at<3>(shape, point.position).distance, 0, 1e-12) << name;
        EXPECT_NEAR(point.normal.norm(), 1, 1e-13) << name;
      }
      listed += near;
    }
    EXPECT_GT(listed, 600) << name;
  }
}

}  // namespace
}  // namespace berm::contact::this_file
