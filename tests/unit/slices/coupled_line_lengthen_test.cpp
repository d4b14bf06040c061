// SPDX-License-Identifier: BSD-3-Clause
// Soil that is carried to a longer mesh: what is kept, where parts of particles lie, and what the added length holds.
#include "problem/lengthen.hpp"

#include "bodies/fill.hpp"
#include "samples/pipeline_case.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

struct Sums {
  Real mass = 0, volume = 0, kinetic = 0;
  Vec<2> momentum = Vec<2>::Zero(), moment = Vec<2>::Zero();
  SymTensor<2> stress{}, magnitude{};
};

Sums sums_within(const State<2>& state, Real left, Real right)
{
  Sums sums;
  state.particles[0].visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = state.particles[0].read(b, l);
    if (p.x[0] < left || p.x[0] > right) return;
    sums.mass += p.mass;
    sums.volume += p.volume;
    sums.kinetic += p.mass * p.v.squaredNorm() / 2;
    sums.momentum += p.mass * p.v;
    sums.moment += p.mass * p.x;
    for (int c = 0; c < tensor_size<2>; ++c) {
      sums.stress.c[c] += p.volume * p.stress.c[c];
      sums.magnitude.c[c] += p.volume * std::abs(p.stress.c[c]);
    }
  });
  return sums;
}

class Lengthen : public testing::Test {
protected:
  Problem<2> problem_of(const settings::Case& c) const { return build<2>(c, ".", folder_.path().string()); }

  /// With a velocity and a stress that vary from place to place.
  static void stir(State<2>& state)
  {
    bodies::Particles<2>& particles = state.particles[0];
    for (const Index cell : particles.occupied())
      for (const auto& [block, b, count] : particles.blocks_in(cell))
        for (int l = 0; l < count; ++l) {
          block.v[0][l] = std::sin(3 * block.x[0][l]);
          block.v[1][l] = std::cos(5 * block.x[1][l]);
          block.stress[3][l] = 100 * std::sin(7 * block.x[0][l]);
        }
  }

  TemporaryFolder folder_;
};

const std::vector<std::string> lattice = {"mesh.pattern=\"lattice\""};
const std::vector<std::string> longer = {"mesh.pattern=\"lattice\"", "mesh.near_right=\"1.4 m\"", "mesh.near_left=\"-0.5 m\"",
                                         "mesh.left=\"1 m\"", "mesh.length=\"3 m\""};

TEST_F(Lengthen, keeps_mass_momentum_energy_and_stress_and_lays_the_added_length)
{
  const settings::Case c = test::line_case(longer);
  Problem<2> before = problem_of(test::line_case(lattice));
  stir(before.state);
  const Problem<2> after = problem_of(c);
  const LengthenedBed<2> bed = lengthen(c, before.model, before.state, after.model, after.state);
  const Real left = before.model.mesh.lower[0], right = before.model.mesh.upper[0], rounding = 1e-13;
  const Sums was = sums_within(before.state, left, right), is = sums_within(bed.state, left, right);
  EXPECT_NEAR(is.mass / was.mass, 1, rounding);
  EXPECT_NEAR(is.volume / was.volume, 1, rounding);
  EXPECT_NEAR(is.kinetic / was.kinetic, 1, rounding);
  EXPECT_NEAR((is.momentum - was.momentum).norm() / was.momentum.norm(), 0, rounding);
  constexpr Real coarse = 0.2;  // m, the largest cell: parts lie within it around their particle, on no side more than on others
  EXPECT_LT((is.moment - was.moment).norm() / was.mass, 0.02 * coarse);
  for (int k = 0; k < tensor_size<2>; ++k) EXPECT_NEAR((is.stress.c[k] - was.stress.c[k]) / was.magnitude.c[k], 0, rounding);
  const auto beyond = [&](const State<2>& state) {
    return sums_within(state, -infinity, std::nextafter(left, -infinity)).mass +
           sums_within(state, std::nextafter(right, infinity), infinity).mass;
  };
  EXPECT_EQ(beyond(bed.state), beyond(after.state)) << "the added length is that of a new run";
  // A particle whose middle lies beyond the end belongs to the added length: half a particle at most is there twice, or not at all.
  EXPECT_NEAR(sums_within(bed.state, -infinity, infinity).mass / sums_within(after.state, -infinity, infinity).mass, 1, 0.03);
}

TEST_F(Lengthen, makes_particles_of_the_size_of_their_cells_and_numbers_each_once)
{
  const settings::Case c = test::line_case(longer);
  const Problem<2> before = problem_of(test::line_case(lattice)), after = problem_of(c);
  const LengthenedBed<2> bed = lengthen(c, before.model, before.state, after.model, after.state);
  const bodies::Particles<2>& particles = bed.state.particles[0];
  EXPECT_GT(particles.size(), before.state.particles[0].size());
  std::vector<int> times(static_cast<std::size_t>(bed.state.numbered[0]), 0);
  int large = 0;
  particles.visit([&](Index cell, Index b, int l) {
    const bodies::Particle<2> p = particles.read(b, l);
    ++times.at(static_cast<std::size_t>(p.id));
    EXPECT_EQ(locate(after.model.mesh, p.x, cell).cell, cell);
    const std::string& region = after.model.mesh.region_names[after.model.mesh.region[cell]];
    EXPECT_NE(region, "space");
    const Real usual = after.model.mesh.volume(cell) / bodies::particles_per_cell<2>(c.body[0].second, region);
    if (p.volume > 2 * usual) ++large;  // a part that lies in a smaller cell than its particle did
  });
  EXPECT_TRUE(std::ranges::all_of(times, [](int n) { return n <= 1; }));
  EXPECT_LT(large, particles.size() / 20);
}

TEST_F(Lengthen, changes_nothing_on_the_mesh_that_it_has)
{
  const settings::Case c = test::line_case(lattice);
  const Problem<2> problem = problem_of(c);
  const State<2> same = lengthen(c, problem.model, problem.state, problem.model, problem.state).state;
  const auto all_of = [](const State<2>& state) {
    std::vector<Real> numbers;
    state.particles[0].visit([&](Index cell, Index b, int l) {
      const bodies::Particle<2> p = state.particles[0].read(b, l);
      numbers.insert(numbers.end(), {Real(cell), Real(p.id), p.x[0], p.x[1], p.mass, p.volume, p.stress.c[0], p.stress.c[1]});
    });
    return numbers;
  };
  EXPECT_EQ(all_of(same), all_of(problem.state));
}

TEST_F(Lengthen, is_not_of_soil_that_has_what_belongs_to_its_mesh)
{
  const settings::Case c = test::line_case({"watch.deep={body=\"clay\", point=[0, -0.3]}"});
  EXPECT_EQ(not_to_lengthen(problem_of(c).model), "watch: its points");
  EXPECT_EQ(not_to_lengthen(problem_of(test::line_case()).model), "");
}

TEST_F(Lengthen, finds_the_fine_triangles_where_they_were)
{
  const mesh::Mesh<2> before = problem_of(test::line_case(lattice)).model.mesh, after = problem_of(test::line_case(longer)).model.mesh;
  Index cell = 0;
  for (Index near = 0; near < before.cell_count(); ++near) {
    if (before.region_names[before.region[near]] != "near") continue;
    Vec<2> middle = Vec<2>::Zero();
    for (const Index node : before.nodes[near]) middle += before.position[node] / 3;
    cell = locate(after, middle, cell).cell;
    for (const Index node : before.nodes[near])
      EXPECT_TRUE(std::ranges::any_of(after.nodes[cell], [&](Index other) { return after.position[other] == before.position[node]; }));
  }
}

}  // namespace
}  // namespace berm::problem::this_file
