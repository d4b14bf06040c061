// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/fill.hpp"

#include "os/error.hpp"
#include "samples/sample_meshes.hpp"

#include <gtest/gtest.h>

namespace berm::bodies::this_file {
namespace {

template <int dim>
const StartState<dim> at_rest{1000, 10, 0};

/// A mesh with the regions "low" (y < 0.8), "high" and "empty", which has no cells.
template <int dim>
mesh::Mesh<dim> mesh_of_two_regions()
{
  mesh::Mesh<dim> mesh = shaken_box<dim>();
  mesh.region_names = {"low", "high", "empty"};
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) mesh.region[cell] = mesh.centroid(cell)[1] < 0.8 ? 0 : 1;
  return mesh;
}

template <int dim>
std::vector<Particle<dim>> all_of(const Particles<dim>& particles)
{
  std::vector<Particle<dim>> all(particles.size());
  particles.visit([&](Index, Index b, int l) {
    const auto p = particles.read(b, l);
    all.at(p.id) = p;
  });
  return all;
}

BodySettings in_regions(std::vector<std::string> regions, int particles_per_cell = 0)
{
  BodySettings body;
  body.regions = std::move(regions);
  body.particles_per_cell = particles_per_cell;
  return body;
}

BlockSettings block_of(std::vector<Real> center, std::vector<Real> size, Real spacing, Real angle = 0)
{
  BlockSettings block;
  block.center = std::move(center);
  block.size = std::move(size);
  block.spacing = spacing;
  block.angle = angle;
  return block;
}

template <class Dimension>
class Fill : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Fill, Dimensions);

TYPED_TEST(Fill, leaves_out_the_particles_inside_a_hole_and_changes_no_other)
{
  constexpr int dim = TypeParam::value;
  const mesh::Mesh<dim> mesh = mesh_of_two_regions<dim>();
  StartState<dim> start = at_rest<dim>;
  start.holes = {make_shape<dim>(CircleSettings{std::vector<Real>(dim, 0.5), 0.5})};
  const auto whole = fill<dim>(mesh, "bed", in_regions({"low", "high"}), at_rest<dim>);
  const auto cut = fill<dim>(mesh, "bed", in_regions({"low", "high"}), start);
  const auto particles = all_of(cut);
  std::size_t next = 0;
  for (const auto& p : all_of(whole)) {
    if (std::hypot(p.x[0] - 0.5, p.x[1] - 0.5) < 0.25) continue;
    ASSERT_LT(next, particles.size());
    EXPECT_EQ(particles[next].x, p.x);
    EXPECT_EQ(particles[next].volume, p.volume);
    ++next;
  }
  EXPECT_EQ(next, particles.size());
  EXPECT_LT(next, static_cast<std::size_t>(whole.size()));
}

TYPED_TEST(Fill, puts_the_particles_into_the_cells_of_its_regions_alone)
{
  constexpr int dim = TypeParam::value;
  const auto mesh = mesh_of_two_regions<dim>();
  auto body = in_regions({"low", "high"}, 1);
  const int special = dim == 2 ? 16 : 27;
  body.region_particles_per_cell = {{"high", special}};
  const auto particles = fill<dim>(mesh, "sand", body, at_rest<dim>);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) EXPECT_EQ(particles.count_in(cell), mesh.region[cell] == 0 ? 1 : special) << cell;

  const auto half = fill<dim>(mesh, "sand", in_regions({"low"}), at_rest<dim>);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    EXPECT_EQ(half.count_in(cell), mesh.region[cell] == 0 ? (dim == 2 ? 9 : 8) : 0) << cell;
}

TYPED_TEST(Fill, keeps_each_particle_in_the_cell_that_holds_it_and_numbers_them_from_zero)
{
  constexpr int dim = TypeParam::value;
  const auto mesh = mesh_of_two_regions<dim>();
  const auto particles = fill<dim>(mesh, "sand", in_regions({"high"}), at_rest<dim>);
  std::vector<int> seen(particles.size(), 0);
  particles.visit([&](Index cell, Index b, int l) {
    const auto p = particles.read(b, l);
    ++seen.at(p.id);
    for (int k = 0; k <= dim; ++k) EXPECT_GT(mesh.shape(cell).value(k, p.x), 0);
  });
  EXPECT_EQ(seen, std::vector<int>(particles.size(), 1));
}

TYPED_TEST(Fill, volumes_masses_and_centres_add_up_to_those_of_the_cells)
{
  constexpr int dim = TypeParam::value;
  const auto mesh = mesh_of_two_regions<dim>();
  Real volume = 0, mass = 0, region_volume = 0;
  Vec<dim> moment = Vec<dim>::Zero(), region_moment = Vec<dim>::Zero();
  for (const auto& p : all_of(fill<dim>(mesh, "sand", in_regions({"low"}), at_rest<dim>)))
    volume += p.volume, mass += p.mass, moment += p.volume * p.x;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    if (mesh.region[cell] == 0) region_volume += mesh.volume(cell), region_moment += mesh.volume(cell) * mesh.centroid(cell);
  EXPECT_NEAR(volume / region_volume, 1, 1e-13);
  EXPECT_NEAR(mass / region_volume, 1000, 1e-10);
  EXPECT_NEAR((moment - region_moment).norm(), 0, 1e-13);
}

TYPED_TEST(Fill, says_which_regions_there_are_when_one_is_unknown)
{
  constexpr int dim = TypeParam::value;
  try {
    fill<dim>(mesh_of_two_regions<dim>(), "sand", in_regions({"low", "bed"}), at_rest<dim>);
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "body.sand.regions: the mesh has no region \"bed\"; it has low, high, empty");
  }
}

TYPED_TEST(Fill, gives_no_particle_where_the_region_has_no_cell)
{
  constexpr int dim = TypeParam::value;
  EXPECT_EQ(fill<dim>(mesh_of_two_regions<dim>(), "sand", in_regions({"empty"}), at_rest<dim>).size(), 0);
}

TYPED_TEST(Fill, the_stress_of_a_flat_bed_grows_with_depth)
{
  constexpr int dim = TypeParam::value;
  const auto mesh = mesh_of_two_regions<dim>();
  auto body = in_regions({"low", "high"});
  body.k0 = 0.4;
  StartState<dim> start{1500, 20, 0.9, {{"kept", "", ""}}};  // the surface lies within the body: what is above it has no stress
  int above = 0;
  for (const auto& p : all_of(fill<dim>(mesh, "sand", body, start))) {
    const Real vertical = p.x[1] < 0.9 ? -1500. * 20 * (0.9 - p.x[1]) : 0;
    above += p.x[1] > 0.9;
    EXPECT_NEAR(p.stress[1], vertical, 1e-9);
    EXPECT_NEAR(p.stress[0], 0.4 * vertical, 1e-9);
    EXPECT_NEAR(p.stress[2], 0.4 * vertical, 1e-9);
    for (int k = 3; k < tensor_size<dim>; ++k) EXPECT_EQ(p.stress[k], 0);
  }
  EXPECT_GT(above, 0);
}

TYPED_TEST(Fill, without_k0_there_is_no_stress_and_no_motion)
{
  constexpr int dim = TypeParam::value;
  for (const auto& p : all_of(fill<dim>(mesh_of_two_regions<dim>(), "sand", in_regions({"low"}), at_rest<dim>))) {
    for (int k = 0; k < tensor_size<dim>; ++k) EXPECT_EQ(p.stress[k], 0);
    EXPECT_EQ(p.v.norm(), 0);
    EXPECT_EQ(p.deviatoric_strain, 0);
  }
}

TYPED_TEST(Fill, starts_with_a_uniform_velocity_or_a_standing_wave)
{
  constexpr int dim = TypeParam::value;
  auto body = in_regions({"low"});
  InitialVelocity motion;
  motion.amplitude = {1, -2, 3};
  motion.amplitude.resize(dim);
  body.initial_velocity = {motion};
  Vec<dim> amplitude, wave;
  for (int d = 0; d < dim; ++d) amplitude[d] = motion.amplitude[d], wave[d] = 2 + d;
  for (const auto& p : all_of(fill<dim>(mesh_of_two_regions<dim>(), "sand", body, at_rest<dim>))) EXPECT_EQ(p.v, amplitude);

  body.initial_velocity[0].wave_number.assign(wave.begin(), wave.end());
  for (const auto& p : all_of(fill<dim>(mesh_of_two_regions<dim>(), "sand", body, at_rest<dim>)))
    EXPECT_NEAR((p.v - amplitude * std::sin(wave.dot(p.x))).norm(), 0, 1e-14);
}

TYPED_TEST(Fill, adds_up_waves_with_their_phases_and_a_rotation_about_the_centre_of_mass)
{
  constexpr int dim = TypeParam::value;
  auto body = in_regions({"low"});
  const auto entries = [](std::vector<Real> v) { return v.resize(dim), v; };
  body.initial_velocity = {{entries({1, -2, 3}), {}, 0}, {entries({0.5, 1, 2}), entries({3, 4, 5}), 0.7}};
  body.initial_angular_velocity = 1.5;
  const auto all = all_of(fill<dim>(mesh_of_two_regions<dim>(), "sand", body, at_rest<dim>));
  Vec<dim> center = Vec<dim>::Zero();
  Real mass = 0;
  for (const auto& p : all) center += p.mass * p.x, mass += p.mass;
  center /= mass;
  for (const auto& p : all) {
    Real phase = 0.7;
    for (int d = 0; d < dim; ++d) phase += (3 + d) * p.x[d];
    Vec<dim> v;
    for (int d = 0; d < dim; ++d) v[d] = entries({1, -2, 3})[d] + entries({0.5, 1, 2})[d] * std::sin(phase);
    v[0] -= 1.5 * (p.x[1] - center[1]);
    v[1] += 1.5 * (p.x[0] - center[0]);
    EXPECT_NEAR((p.v - v).norm(), 0, 1e-13);
  }
}

TYPED_TEST(Fill, starts_with_the_same_stress_everywhere_where_one_is_given)
{
  constexpr int dim = TypeParam::value;
  auto body = in_regions({"low", "high"});
  body.initial_stress = {-100, -200, -50};
  for (const auto& p : all_of(fill<dim>(mesh_of_two_regions<dim>(), "sand", body, at_rest<dim>)))
    for (int k = 0; k < tensor_size<dim>; ++k) EXPECT_EQ(p.stress[k], k < 3 ? body.initial_stress[k] : 0);
}

TYPED_TEST(Fill, a_block_is_filled_with_whole_equal_parts)
{
  constexpr int dim = TypeParam::value;
  const auto mesh = mesh_of_two_regions<dim>();
  // 0.9 / 0.14 rounds to 6 and 0.5 / 0.14 to 4 parts.
  std::vector<Real> center = {0.7, 0.8, 1.4}, size = {0.9, 0.5, 0.5};
  center.resize(dim), size.resize(dim);
  BodySettings body;
  body.block = block_of(center, size, 0.14);
  const auto all = all_of(fill<dim>(mesh, "block", body, at_rest<dim>));
  ASSERT_EQ(all.size(), dim == 2 ? 24u : 96u);
  const Real part = dim == 2 ? 0.9 * 0.5 / 24 : 0.9 * 0.5 * 0.5 / 96;
  Vec<dim> mean = Vec<dim>::Zero();
  for (const auto& p : all) {
    EXPECT_NEAR(p.volume, part, 1e-15);
    EXPECT_NEAR(p.mass, 1000 * part, 1e-12);
    for (int d = 0; d < dim; ++d) EXPECT_LT(std::abs(p.x[d] - center[d]), size[d] / 2);
    mean += p.x / static_cast<Real>(all.size());
  }
  for (int d = 0; d < dim; ++d) EXPECT_NEAR(mean[d], center[d], 1e-14);
}

TYPED_TEST(Fill, a_block_that_leaves_the_mesh_is_refused_with_the_place)
{
  constexpr int dim = TypeParam::value;
  std::vector<Real> center = {0, 0.8, 1.4}, size = {0.9, 0.5, 0.5};
  center.resize(dim), size.resize(dim);
  BodySettings body;
  body.block = block_of(center, size, 0.1);
  try {
    fill<dim>(mesh_of_two_regions<dim>(), "brick", body, at_rest<dim>);
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("body.brick.block: the block leaves the mesh at (-0.4"), 0u) << error.what();
  }
}

TEST(FillDisk, has_its_exact_volume_and_lies_round_its_centre)
{
  const auto mesh = mesh_of_two_regions<2>();
  BodySettings body;
  body.disk = DiskSettings{{0.7, 0.8}, 0.8, 0.05};
  const auto all = all_of(fill<2>(mesh, "disk", body, at_rest<2>));
  Real volume = 0, second = 0;
  Vec<2> moment = Vec<2>::Zero();
  for (const auto& p : all) {
    const Vec<2> from = p.x - Vec<2>(0.7, 0.8);
    EXPECT_LT(from.norm(), 0.4);
    const Vec<2> place = from / 0.05 - Vec<2>(0.5, 0.5);
    EXPECT_NEAR((place - Vec<2>(std::round(place[0]), std::round(place[1]))).norm(), 0, 1e-10);
    volume += p.volume, moment += p.volume * from, second += p.volume * from.squaredNorm();
  }
  EXPECT_NEAR(volume, pi * 0.16, 1e-14);
  EXPECT_NEAR(moment.norm(), 0, 1e-15);
  // m R^2 / 2 but for the steps of the rim: half a spacing in 8, on one side or the other.
  EXPECT_NEAR(second / (volume * 0.16 / 2), 1, 0.5 / 8);
  EXPECT_NEAR(static_cast<Real>(all.size()), pi * 64, 8);  // no lattice point is left out
}

TEST(FillDisk, that_leaves_the_mesh_is_refused_with_the_place)
{
  BodySettings body;
  body.disk = DiskSettings{{0, 0.8}, 0.8, 0.05};
  try {
    fill<2>(mesh_of_two_regions<2>(), "ball", body, at_rest<2>);
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("body.ball.disk: the disk leaves the mesh at (-0."), 0u) << error.what();
  }
}

// Before memory is taken: a lattice so fine would need more than there is, and its counts do not fit into whole numbers.
TYPED_TEST(Fill, more_particles_than_can_be_numbered_are_refused_before_they_are_made)
{
  constexpr int dim = TypeParam::value;
  for (const Real spacing : {1e-6, 1e-12, 1e-300}) {
    BodySettings block, disk;
    block.block = block_of({0.7, 0.8, 1.5}, {0.4, 0.4, 0.4}, spacing);
    disk.disk = DiskSettings{{0.7, 0.8}, 0.8, spacing};
    for (const BodySettings& body : dim == 2 ? std::vector{block, disk} : std::vector{block}) try {
        fill<dim>(mesh_of_two_regions<dim>(), "fine", body, at_rest<dim>);
        FAIL() << "nothing was thrown";
      } catch (const InputError& error) {
        const std::string start = body.block ? "body.fine.block.spacing: " : "body.fine.disk.spacing: ";
        EXPECT_EQ(std::string(error.what()).find(start), 0u) << error.what();
      }
  }
}

TEST(FillBlock, may_be_turned)
{
  // A square turned by 45 degrees: a particle's coordinates along the diagonals stay within half a side, and the lattice lies along them.
  constexpr Real side = 0.4, half = side / 2;
  const auto mesh = mesh_of_two_regions<2>();
  BodySettings body;
  body.block = block_of({0.7, 0.8}, {side, side / 2}, 0.1, pi / 4);
  const auto all = all_of(fill<2>(mesh, "block", body, at_rest<2>));
  ASSERT_EQ(all.size(), 8u);
  const Vec<2> center(0.7, 0.8), along = Vec<2>(1, 1).normalized(), across = Vec<2>(-1, 1).normalized();
  std::vector<int> columns(4, 0);
  for (const auto& p : all) {
    const Real a = along.dot(p.x - center), b = across.dot(p.x - center);
    EXPECT_NEAR(std::abs(b), 0.05, 1e-14);
    const Real column = (a + half) / 0.1 - 0.5;
    EXPECT_NEAR(column, std::round(column), 1e-12);
    ++columns.at(std::lround(column));
  }
  EXPECT_EQ(columns, std::vector<int>(4, 2));
}

}  // namespace
}  // namespace berm::bodies::this_file
