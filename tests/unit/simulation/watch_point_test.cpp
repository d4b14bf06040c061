// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/watch_point.hpp"

#include "material/linear_elastic.hpp"

#include <gtest/gtest.h>

namespace berm::simulation::this_file {
namespace {

Real linear(const Vec<2>& x)
{
  return 3000 - 500 * x[0] + 700 * x[1];
}
Real linear(const Vec<3>& x)
{
  return 3000 - 500 * x[0] + 700 * x[1] + 200 * x[2];
}

/// Elastic soil in a box of squares or cubes of 0.5 m, so many along each axis, and a watched point in it.
template <int dim>
struct Box {
  problem::Problem<dim> problem;
  std::vector<Real> point;

  Box(const std::vector<int>& cells, const Vec<dim>& watched, mesh::Metric metric = mesh::Metric::cartesian)
      : point(watched.data(), watched.data() + dim)
  {
    settings::Case c;
    mesh::BoxMesh box;
    for (const int count : cells) box.size.push_back(0.5 * count), box.cells.push_back(count);
    c.mesh = box;
    if (metric == mesh::Metric::axisymmetric) c.geometry = settings::Geometry::axisymmetric;
    if (dim == 3) c.geometry = settings::Geometry::space;
    material::LinearElastic law;
    law.density = 1000;
    law.young_modulus = 1e6;
    c.material = {{"solid", law}};
    bodies::BodySettings body;
    body.material = "solid";
    body.regions = {"box"};
    c.body = {{"bed", body}};
    c.gravity = std::vector<Real>(dim, 0.);
    c.watch = {{"tip", {"bed", point}}};
    settings::StageSettings rest;
    rest.name = "rest";
    rest.until.time = 1;
    c.stage = {rest};
    problem = problem::build<dim>(c, ".", ".");
  }
  bodies::Particles<dim>& particles() { return problem.state.particles[0]; }
  WatchPoint<dim> watch() { return {problem.model, particles(), problem.model.watches[0], point}; }
  Watched<dim> read(const WatchPoint<dim>& watch) { return watch.read(problem.model, particles()); }
  Vec<dim> asked() const { return Eigen::Map<const Vec<dim>>(point.data()); }

  /// Calls visit(cell, place, block, lane) for each particle.
  template <class Visit>
  void each(const Visit& visit)
  {
    particles().visit([&](Index cell, Index b, int l) {
      bodies::Block<dim>& block = particles().block(b);
      Vec<dim> x;
      for (int d = 0; d < dim; ++d) x[d] = block.x[d][l];
      visit(cell, x, block, l);
    });
  }
};

/// The displacement of the whole box: a stretch, a shear and a translation, some millimetres.
template <int dim>
Vec<dim> moved(const Vec<dim>& x)
{
  Vec<dim> u = Vec<dim>::Constant(0.002) + 0.003 * x;
  u[0] += 0.001 * x[1];
  return u;
}

template <int dim>
void expect_linear(const std::vector<int>& cells, const Vec<dim>& point, mesh::Metric metric = mesh::Metric::cartesian)
{
  Box<dim> box(cells, point, metric);
  const WatchPoint<dim> watch = box.watch();
  box.each([](Index, const Vec<dim>& x, bodies::Block<dim>& block, int l) {
    const Vec<dim> now = x + moved(x);
    for (int d = 0; d < dim; ++d) block.x[d][l] = now[d], block.v[d][l] = 0.1 * linear(x) + d;
    for (int k = 0; k < tensor_size<dim>; ++k) block.stress[k][l] = linear(now) * (k + 1);
  });
  const Watched<dim> now = box.read(watch);
  EXPECT_NEAR((now.displacement - moved(point)).norm(), 0, 1e-14) << point.transpose();
  for (int d = 0; d < dim; ++d) EXPECT_NEAR(now.velocity[d], 0.1 * linear(point) + d, 1e-10) << point.transpose();
  for (int k = 0; k < tensor_size<dim>; ++k)
    EXPECT_NEAR(now.stress.c[k], linear(Vec<dim>(point + moved(point))) * (k + 1), 1e-7) << point.transpose();
}

}  // namespace

// Round-off: some 1e-14 of numbers of 1e4, with coefficients of order one.
TEST(WatchPoint, is_exact_in_a_linear_field)
{
  for (const Vec<2>& point : {Vec<2>(0.9, 1.1), Vec<2>(1, 1), Vec<2>(0.25, 0.25), Vec<2>(0, 0), Vec<2>(2, 1.3), Vec<2>(0.61, 2)})
    expect_linear<2>({4, 4}, point), expect_linear<2>({4, 4}, point, mesh::Metric::axisymmetric);
  for (const Vec<3>& point : {Vec<3>(0.6, 0.7, 0.8), Vec<3>(0, 0, 0), Vec<3>(0.5, 0.5, 1), Vec<3>(1.5, 1.2, 0.1)})
    expect_linear<3>({3, 3, 3}, point);
}

// As strains make it: one number for a patch, here that of a linear field at the centre of its particles. 1e-7: round-off, as above.
TEST(WatchPoint, is_exact_where_the_stress_is_one_for_a_patch)
{
  for (const Vec<2>& point : {Vec<2>(0.9, 1.1), Vec<2>(1, 1), Vec<2>(0, 0), Vec<2>(0.61, 2)}) {
    Box<2> box({4, 4}, point);
    const WatchPoint<2> watch = box.watch();
    const mesh::Patches& patches = box.problem.model.patches;
    CellField<Vec<2>> moments(patches.size(), Vec<2>::Zero());
    CellField<Real> volumes(patches.size(), 0.);
    box.each([&](Index cell, const Vec<2>& x, bodies::Block<2>& block, int l) {
      mesh::for_each_in_patch(patches, cell, [&](Index c) { moments[c] += block.volume[l] * x, volumes[c] += block.volume[l]; });
    });
    box.each([&](Index cell, const Vec<2>&, bodies::Block<2>& block, int l) {
      for (int k = 0; k < 4; ++k) block.stress[k][l] = linear(Vec<2>(moments[cell] / volumes[cell])) * (k + 1);
    });
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(box.read(watch).stress.c[k], linear(point) * (k + 1), 1e-7) << point.transpose();
  }
}

// Across a row of single squares nothing says how a field varies: it is constant there, and noise is not drawn out. 1e-7: round-off, as above.
TEST(WatchPoint, is_exact_along_a_column_one_square_wide)
{
  for (const Real y : {0., 0.2, 0.5, 1.1, 2.}) {
    Box<2> box({1, 4}, {0.1, y});
    const WatchPoint<2> watch = box.watch();
    box.each([&](Index, const Vec<2>& x, bodies::Block<2>& block, int l) { block.stress[1][l] = linear(Vec<2>(0, x[1])); });
    EXPECT_NEAR(box.read(watch).stress.c[1], linear(Vec<2>(0, y)), 1e-7);
  }
}

TEST(WatchPoint, of_a_place_without_soil_is_the_nearest_particle)
{
  Box<2> box({4, 4}, {1, 2.5});
  const WatchPoint<2> watch = box.watch();
  Vec<2> nearest(infinity, infinity);
  box.each([&](Index, const Vec<2>& x, bodies::Block<2>& block, int l) {
    if ((x - box.asked()).norm() < (nearest - box.asked()).norm()) nearest = x;
    block.stress[0][l] = linear(x);
  });
  EXPECT_NEAR(box.read(watch).stress.c[0], linear(nearest), 1e-7);  // round-off, as above
}

}  // namespace berm::simulation::this_file
