// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/gradient_strain.hpp"

#include "mesh/box.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::run_folder::this_file {
namespace {

Matrix<2> turn(Real angle)
{
  Matrix<2> r;
  r << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return r;
}

Matrix<2> simple_shear(Real gamma)
{
  Matrix<2> f;
  f << 1, gamma, 0, 1;
  return f;
}

/// A square of 0.1 m (a cube) in 4 x 4 (x 4) squares.
template <int dim>
mesh::Mesh<dim> square()
{
  mesh::BoxMesh box{.lower = {0, 0, 0}, .size = {0.1, 0.1, 0.1}, .cells = {4, 4, 4}};
  for (auto* list : {&box.lower, &box.size, &box.cells}) list->resize(dim);
  return make_box<dim>(box);
}

// Sums of a few dozen numbers of the size of 1, and the root of a strain's square: 1e-14 is rounding, 1e-8 its root.
TEST(GradientStrain, is_zero_where_soil_only_turned)
{
  for (const Real angle : {0., 0.3, pi / 2, 2., pi}) {
    EXPECT_NEAR(gradient_strain<2>(turn(angle)).deviatoric, 0, 1e-14) << angle;
    EXPECT_NEAR(gradient_strain<2>(turn(angle)).volumetric, 0, 1e-14) << angle;
  }
  Matrix<3> about_z = Matrix<3>::Identity();
  about_z.topLeftCorner<2, 2>() = turn(pi / 2);
  EXPECT_NEAR(gradient_strain<3>(about_z).deviatoric, 0, 1e-14);
}

TEST(GradientStrain, of_a_simple_shear_is_that_of_its_principal_stretches_whatever_turn_follows)
{
  for (const Real gamma : {1e-6, 0.01, 1., 5.}) {
    const Real exact = 2 / std::sqrt(3.) * std::asinh(gamma / 2);  // stretches exp(+-asinh(gamma/2))
    for (const Real angle : {0., 1.})
      EXPECT_NEAR(gradient_strain<2>(turn(angle) * simple_shear(gamma)).deviatoric, exact, 1e-13) << gamma << " " << angle;
    EXPECT_NEAR(gradient_strain<2>(simple_shear(gamma)).volumetric, 0, 1e-13) << gamma;
  }
}

TEST(GradientStrain, has_the_measure_of_the_accumulated_one_where_it_is_small)
{
  Matrix<2> gradient;
  gradient << 3e-7, -2e-7, 8e-7, -1e-7;
  const SymTensor<2> strain{{3e-7, -1e-7, 0, 3e-7}};
  const GradientStrain found = gradient_strain<2>(Matrix<2>::Identity() + gradient);
  EXPECT_NEAR(found.deviatoric, equivalent_deviatoric_strain(strain), 1e-12);  // the square of the gradient
  EXPECT_NEAR(found.volumetric, 2e-7, 1e-12);
}

TEST(GradientStrain, of_a_volume_change_in_plane_strain_keeps_the_strain_along_z_at_zero)
{
  const GradientStrain found = gradient_strain<2>(std::exp(0.1) * Matrix<2>::Identity());
  EXPECT_NEAR(found.volumetric, 0.2, 1e-14);
  EXPECT_NEAR(found.deviatoric, equivalent_deviatoric_strain(SymTensor<2>{{0.1, 0.1, 0, 0}}), 1e-14);
  const GradientStrain in_space = gradient_strain<3>(std::exp(0.1) * Matrix<3>::Identity());
  EXPECT_NEAR(in_space.volumetric, 0.3, 1e-14);
  EXPECT_NEAR(in_space.deviatoric, 0, 1e-14);
}

TEST(GradientStrain, is_finite_where_soil_is_torn_or_turned_inside_out)
{
  const Real max = 2 / std::sqrt(3.) * std::log(1000.);
  Matrix<2> flat, torn, inside_out;
  flat << 1, 1, 1, 1;
  torn << 1e9, 0, 0, 1e-9;
  inside_out << -1, 0, 0, 1;
  EXPECT_LE(gradient_strain<2>(flat).deviatoric, max);
  EXPECT_NEAR(gradient_strain<2>(torn).deviatoric, max, 1e-12);
  EXPECT_NEAR(gradient_strain<2>(Matrix<2>::Zero()).volumetric, -2 * std::log(1000.), 1e-12);
  EXPECT_TRUE(std::isfinite(gradient_strain<2>(inside_out).deviatoric));
}

template <class T>
class NodalGradientIn : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(NodalGradientIn, Dimensions);

TYPED_TEST(NodalGradientIn, is_exact_for_a_linear_displacement_of_points_anywhere)
{
  constexpr int dim = TypeParam::value;
  const mesh::Mesh<dim> mesh = square<dim>();
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> anywhere(0, 0.1), number(-1, 1);
  Matrix<dim> gradient;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) gradient(i, j) = number(random);
  const Vec<dim> shift = Vec<dim>::Constant(7);
  NodalGradient<dim> nodal(mesh);
  std::vector<std::pair<Index, Vec<dim>>> points;
  for (int k = 0; k < 2000; ++k) {
    Vec<dim> x;
    for (int d = 0; d < dim; ++d) x[d] = anywhere(random);
    points.emplace_back(locate(mesh, x, 0).cell, x);
    nodal.add(points.back().first, x, shift + gradient * x);
  }
  nodal.fit();
  // An error of 1e-15 in numbers of the size of 7, over distances of 0.025 m, and up to 1e4 times that where points are almost in line.
  for (const auto& [cell, x] : points) ASSERT_LT((nodal.at(cell, x) - gradient).norm(), 1e-15 / 0.025 * 1e4);
}

TYPED_TEST(NodalGradientIn, is_zero_where_points_do_not_tell_one)
{
  constexpr int dim = TypeParam::value;
  const mesh::Mesh<dim> mesh = square<dim>();
  NodalGradient<dim> nodal(mesh);
  const Vec<dim> x = mesh.centroid(0);
  for (int k = 0; k < 5; ++k) nodal.add(0, x + Vec<dim>::Unit(0) * 1e-4 * k, Vec<dim>::Constant(k * k));  // in line
  nodal.fit();
  EXPECT_EQ(nodal.at(0, x), (Matrix<dim>::Zero()));
  EXPECT_EQ(nodal.at(mesh.cell_count() - 1, mesh.centroid(mesh.cell_count() - 1)), (Matrix<dim>::Zero()));
}

}  // namespace
}  // namespace berm::run_folder::this_file
