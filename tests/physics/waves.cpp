// SPDX-License-Identifier: BSD-3-Clause
// Order of convergence, for motions of an elastic square and cube that are known everywhere and at all times.
#include "pipe_in_sand.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real density = 1000, young_modulus = 1e6, poisson_ratio = 0.3;
constexpr Real shear_modulus = young_modulus / (2 * (1 + poisson_ratio));
constexpr Real oedometer_modulus = young_modulus * (1 - poisson_ratio) / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));

/// Modes of the square and cube of 1 m on rollers, u = A sin(omega t) shape(x): on the sides neither normal displacement nor shear stress
/// arises, and no force drives them.
enum class Mode {
  shear,    ///< (sin pi x cos pi y, -cos pi x sin pi y): keeps all volumes
  pressure  ///< the gradient of -cos pi x cos pi y (cos pi z) / pi: turns nothing
};

template <int dim>
Vec<dim> shape(Mode mode, const Vec<dim>& x)
{
  Vec<dim> u;
  for (int d = 0; d < dim; ++d) {
    u[d] = 1;
    for (int e = 0; e < dim; ++e) u[d] *= e == d ? std::sin(pi * x[e]) : std::cos(pi * x[e]);
  }
  if (mode == Mode::shear) u[1] *= -1;
  return u;
}

template <int dim>
Real frequency(Mode mode)
{
  return pi * std::sqrt(dim * (mode == Mode::shear ? shear_modulus : oedometer_modulus) / density);
}

/// sqrt(int |u - exact|^2 / int |exact|^2) over the particles, after 0.3 of a period; the strain is 1e-5, so that no particle leaves its cell.
template <int dim>
Real error_of(Mode mode, int cells, mesh::BoxPattern pattern = mesh::BoxPattern::diagonal, bool projection = true)
{
  const Real omega = frequency<dim>(mode), speed = 1e-5 * omega / pi;
  settings::Case c = elastic_box(dim, std::vector<Real>(dim, 1), std::vector<Real>(dim, cells), young_modulus, poisson_ratio, density);
  std::get<mesh::BoxMesh>(c.mesh).pattern = pattern;
  c.body[0].second.particles_per_cell = dim == 2 ? 4 : 1;
  c.mpm.volumetric_projection = projection;
  c.support = {{"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}, {"bottom", {"bottom", {"y"}}}, {"top", {"top", {"y"}}}};
  if (dim == 3) c.support.push_back({"back", {"back", {"z"}}}), c.support.push_back({"front", {"front", {"z"}}});
  Simulation<dim> run(c);
  run.set_velocities([&](const Vec<dim>& x, const Vec<dim>&) { return Vec<dim>(speed * shape<dim>(mode, x)); });
  const auto before = all_particles(run.state());
  run.run_until(0.3 * 2 * pi / omega);
  const auto after = all_particles(run.state());
  Real error = 0, size = 0;
  for (std::size_t k = 0; k < after.size(); ++k) {
    const Vec<dim> exact = speed / omega * std::sin(omega * run.state().time) * shape<dim>(mode, before[k].x);
    error += after[k].volume * (after[k].x - before[k].x - exact).squaredNorm();
    size += after[k].volume * exact.squaredNorm();
  }
  return std::sqrt(error / size);
}

/// The order over two halvings of the cells, and the error on the finest: dispersion makes single steps of the pressure mode scatter by 0.5.
template <int dim>
void expect_order(Real min, Real largest_error, Mode mode, int cells, mesh::BoxPattern pattern = mesh::BoxPattern::diagonal,
                  bool projection = true)
{
  const Real coarse = error_of<dim>(mode, cells, pattern, projection), fine = error_of<dim>(mode, 4 * cells, pattern, projection);
  EXPECT_GT(std::log2(coarse / fine) / 2, min) << coarse << " -> " << fine;
  EXPECT_LT(fine, largest_error);
}

// Linear shape functions give order 2 in displacements. The errors allowed on the finest mesh are 1.5 times those measured.
TEST(Waves, of_shear_converge_with_order_two)
{
  for (const bool projection : {true, false}) {
    expect_order<2>(1.9, 0.0045, Mode::shear, 8, mesh::BoxPattern::diagonal, projection);
    expect_order<2>(1.9, 0.00075, Mode::shear, 8, mesh::BoxPattern::criss_cross, projection);
  }
}
TEST(Waves, of_pressure_converge_with_order_two)
{
  for (const bool projection : {true, false}) {
    expect_order<2>(1.7, 0.0035, Mode::pressure, 8, mesh::BoxPattern::diagonal, projection);
    expect_order<2>(1.7, 0.0029, Mode::pressure, 8, mesh::BoxPattern::criss_cross, projection);
  }
}
// Cells of 1/4 to 1/16 only: from 18 % of error to 2 %.
TEST(Waves, of_pressure_converge_in_tetrahedra)
{
  expect_order<3>(1.5, 0.027, Mode::pressure, 4);
}

}  // namespace
}  // namespace berm::this_file
