// SPDX-License-Identifier: BSD-3-Clause
// The same case at the origin and at survey coordinates: eastings of 500 km, northings of 6500 km, a seabed at -1500 m.
#include "pipe_in_sand.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

/// The case moved: its mesh, blocks, shapes and the level of its surface.
settings::Case moved(settings::Case c, const std::vector<Real>& by)
{
  const auto move = [&](std::vector<Real>& x) {
    x.resize(by.size());
    for (std::size_t d = 0; d < by.size(); ++d) x[d] += by[d];
  };
  move(std::get<mesh::BoxMesh>(c.mesh).lower);
  for (auto& [name, body] : c.body)
    if (body.block) move(body.block->center);
  for (auto& [name, rigid] : c.rigid)
    std::visit(
        [&](auto& shape) {
          if constexpr (requires { shape.center; }) move(shape.center);
        },
        rigid.shape);
  c.surface += by[1];
  return c;
}

/// What a run has come to.
template <int dim>
struct Answer {
  Vec<dim> contact = Vec<dim>::Zero();  ///< N s, of the soil on bodies
  Real internal = 0, external = 0, kinetic = 0, unbalanced_energy = 0;
  std::vector<Vec<dim>> begin, displacement;  ///< m, of the particles
};

template <int dim>
Answer<dim> answer_of(const settings::Case& c, const std::vector<int>& steps)
{
  Simulation<dim> run(c);
  std::vector<Vec<dim>> begin;
  for (std::size_t b = 0; b < c.body.size(); ++b)
    for (const auto& p : all_particles(run.state(), static_cast<Index>(b))) begin.push_back(p.x);
  for (std::size_t stage = 0; stage < steps.size(); ++stage) {
    if (stage > 0) next_stage(run);
    take_steps(run, steps[stage]);
  }
  const problem::Totals<dim>& t = run.state().ledger.totals;
  Answer<dim> answer{t.contact_impulse, t.internal, t.external, 0, 0, begin, {}};
  for (const Vec<dim>& impulse : run.state().ledger.pair_impulses) answer.contact += impulse;
  for (std::size_t b = 0; b < c.body.size(); ++b) {
    answer.kinetic += mpm::sums_over(run.state().particles[b]).kinetic;
    for (const auto& p : all_particles(run.state(), static_cast<Index>(b)))
      answer.displacement.push_back(p.x - begin[answer.displacement.size()]);
  }
  answer.unbalanced_energy = answer.kinetic + t.internal + t.damping + t.filter + t.friction - t.external;
  return answer;
}

/// Where a case is moved to, and how large a cell is.
struct Place {
  std::vector<Real> by;
  Real cell;

  /// How far answers may differ. Coordinates are rounded by half of their resolution u = 2^-52 |x|, which is u / 2h of a cell's height h. Positions are rounded once at the start, which
  /// makes strains wrong by u / h of themselves for good, and once in each step, which moves shape functions by as much: n u / 2h after n steps where it is always to the same side. Masses,
  /// velocities and strains of nodes are sums of shape functions, so all that follows from them differs by some n u / h. About the origin second moments would lose (x / h)^2 2^-52,
  /// which is more than all of it for 500 km and cells of 4 mm.
  Real rounding(int steps) const
  {
    constexpr Real some = 10;
    Real farthest = 0;
    for (const Real x : by) farthest = std::max(farthest, std::abs(x));
    return some * steps * std::numeric_limits<Real>::epsilon() * farthest / cell;
  }
};

/// Contact points that share nodes are solved until a sweep changes less than a thousandth; rounding decides which sweep is the last. Later steps make up for it.
constexpr Real by_sweeps = 1e-4;

/// Where sand slides: a particle beside a point whose last sweep was left out there feels all of that thousandth.
constexpr Real by_sweeps_of_a_particle = 1e-3;

/// Compares what happens here and there: sums to `by_contact` and rounding, the displacement of each particle to `of_particle` (empty: the same) and rounding.
template <int dim>
void expect_same(const settings::Case& c, const Place& place, const std::vector<int>& steps, Real by_contact = by_sweeps,
                 std::optional<Real> of_particle = {})
{
  int all_steps = 0;
  for (const int n : steps) all_steps += n;
  const Real tolerance = place.rounding(all_steps) + by_contact, by_particle = of_particle.value_or(by_contact);
  const Answer<dim> here = answer_of<dim>(c, steps), there = answer_of<dim>(moved(c, place.by), steps);
  const auto near = [&](Real a, Real b, Real size, const char* what) {
    EXPECT_LT(std::abs(a - b), tolerance * size) << what << ": " << a << " and " << b;
  };
  const Real energy = std::abs(here.external) + here.kinetic;
  if (by_contact > 0) near((there.contact - here.contact).norm(), 0, here.contact.norm(), "contact");
  near(there.internal, here.internal, energy, "internal");
  near(there.external, here.external, energy, "external");
  near(there.kinetic, here.kinetic, energy, "kinetic");
  near(there.unbalanced_energy, here.unbalanced_energy, energy, "balance of energy");
  ASSERT_EQ(there.begin.size(), here.begin.size());
  for (std::size_t p = 0; p < here.begin.size(); ++p)
    for (int d = 0; d < dim; ++d)
      ASSERT_NEAR(there.begin[p][d] - place.by[static_cast<std::size_t>(d)], here.begin[p][d], 1e-8) << "another particle";
  Real size = 0, largest = 0, squares = 0;
  for (std::size_t p = 0; p < here.displacement.size(); ++p) {
    const Real difference = (there.displacement[p] - here.displacement[p]).norm();
    size = std::max(size, here.displacement[p].norm());
    largest = std::max(largest, difference);
    squares += difference * difference;
  }
  size = std::max(size, place.cell);
  near(std::sqrt(squares / static_cast<Real>(here.displacement.size())), 0, size, "displacement, root mean square");
  EXPECT_LT(largest, (place.rounding(all_steps) + by_particle) * size) << "displacement of one particle";
  EXPECT_GT(size, 0);
}

// An elastic plate that turns and rings in free flight: nothing but rounding.
TEST(FarFromOrigin, a_plate_in_free_flight_moves_alike_to_rounding)
{
  settings::Case c = elastic_box(2, {2, 1}, {20, 10}, 1e6, 0.3, 1000);
  c.body[0].second.regions.clear();
  bodies::BlockSettings block;
  block.center = {0.903, 0.5041};
  block.size = {0.8, 0.4};
  block.spacing = 0.025;
  c.body[0].second.block = block;
  bodies::InitialVelocity along;
  along.amplitude = {0.5, 0.1};
  c.body[0].second.initial_velocity = {along};
  c.body[0].second.initial_angular_velocity = 3;
  expect_same<2>(c, {{499'876.543, -1500}, 0.1}, {150}, 0);
  expect_same<2>(c, {{499'876.543, 6'543'210.987}, 0.1}, {150}, 0);
}

/// No particle lies on a side of a cell, where rounding would decide which of two cells it strains with.
settings::Case pipe_in_bed()
{
  settings::Case c = pipe_in_sand();
  bodies::BlockSettings& block = *c.body[0].second.block;
  block.center = {0.06003, 0.0199137};
  block.size = {0.1198, 0.0398};
  c.surface = 0.0398137;
  return c;
}

TEST(FarFromOrigin, a_pipe_in_sand_feels_the_same_soil)
{
  for (const std::vector<Real>& by : {std::vector<Real>{20e3, 0}, {0, -1500}, {500e3, -1500}, {499'876.543, 6'543'210.987}}) {
    SCOPED_TRACE(testing::Message() << by[0] << " " << by[1]);
    expect_same<2>(pipe_in_bed(), {by, 0.004}, {200, 100}, by_sweeps, by_sweeps_of_a_particle);
  }
}

settings::Case pipe_in_clay()
{
  settings::Case c = pipe_in_bed();
  material::MohrCoulomb clay = loose_sand();
  clay.friction_angle = 0;
  clay.cohesion = 2e3;
  clay.poisson_ratio = 0.45;
  c.material[0].second = clay;
  c.contact[0].second.friction_angle = 0;
  c.contact[0].second.adhesion = 1e3;
  return c;
}

TEST(FarFromOrigin, a_pipe_in_clay_feels_the_same_soil_at_particles_and_at_nodes)
{
  for (const contact::Detection detection : {contact::Detection::particle, contact::Detection::gap}) {
    SCOPED_TRACE(static_cast<int>(detection));
    settings::Case c = pipe_in_clay();
    c.mpm.courant = 0.5;
    c.contact[0].second.detection = detection;
    expect_same<2>(c, {{499'876.543, -1500}, 0.004}, {200, 100});
  }
}

TEST(FarFromOrigin, update_stress_first_gives_the_same)
{
  settings::Case c = pipe_in_clay();
  c.contact[0].second.scheme = contact::Scheme::usf;
  expect_same<2>(c, {{499'876.543, -1500}, 0.004}, {200, 100});
}

// Along the axis, to a deep seabed and to a height that none has.
TEST(FarFromOrigin, a_ball_around_an_axis_feels_the_same_soil)
{
  settings::Case c = pipe_in_bed();
  c.geometry = settings::Geometry::axisymmetric;
  c.rigid[0].second.shape = bodies::CircleSettings{{0, 0.05}, 0.02};
  c.stage.resize(1);
  for (const Real height : {-1500.25, 499'876.543}) expect_same<2>(c, {{0, height}, 0.004}, {300});
}

TEST(FarFromOrigin, a_ball_in_space_feels_the_same_soil)
{
  settings::Case c = pipe_in_clay();
  c.geometry = settings::Geometry::space;
  c.gravity = {0, -50 * standard_gravity, 0};
  mesh::BoxMesh mesh;
  mesh.size = {0.06, 0.06, 0.06};
  mesh.cells = {8, 8, 8};
  c.mesh = mesh;
  bodies::BlockSettings& block = *c.body[0].second.block;
  block.center = {0.030017, 0.0199137, 0.0302291};
  block.size = {0.0598, 0.0398, 0.0592};
  block.spacing = 0.0043;
  c.rigid[0].second.shape = bodies::SphereSettings{{0.03, 0.05, 0.03}, 0.02};
  c.support = {{"base", {"bottom", {"x", "y", "z"}}},
               {"left", {"left", {"x"}}},
               {"right", {"right", {"x"}}},
               {"back", {"back", {"z"}}},
               {"front", {"front", {"z"}}}};
  c.stage[1].vertical = settings::Vertical::fixed;
  expect_same<3>(c, {{499'876.543, -1500, 6'543'210.987}, 0.0075}, {100, 50});
}

// Elastic blocks of 0.4 m that fall on each other: contact between deformable bodies, and free flight before.
TEST(FarFromOrigin, blocks_that_fall_and_meet_do_so_alike)
{
  settings::Case c = elastic_box(2, {2, 1}, {20, 10}, 1e6, 0.3, 1000);
  c.gravity = {0, -standard_gravity};
  const auto block_at = [](Real x, Real y, Real speed) {
    bodies::BodySettings body;
    body.material = "solid";
    bodies::BlockSettings block;
    block.center = {x, y};
    block.size = {0.4, 0.3};
    block.spacing = 0.025;
    body.block = block;
    bodies::InitialVelocity motion;
    motion.amplitude = {0, speed};
    body.initial_velocity = {motion};
    return body;
  };
  c.body = {{"lower", block_at(0.903, 0.3041, 0)}, {"upper", block_at(1.057, 0.7013, -2)}};
  contact::ContactSettings contact;
  contact.body = "lower";
  contact.other_body = "upper";
  contact.friction_angle = 0.3;
  c.contact = {{"meeting", contact}};
  expect_same<2>(c, {{499'876.543, -1500}, 0.1}, {100});
}

}  // namespace
}  // namespace berm::this_file
