// SPDX-License-Identifier: BSD-3-Clause
#include "soil_plot/particle_shapes.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <functional>
#include <gtest/gtest.h>

namespace berm::soil_plot::this_file {
namespace {

constexpr Real spacing = 0.01;

/// A lattice of 11 by 11 particles after a motion; the middle one is number 60.
run_folder::Frame<2> lattice(const std::function<Vec<2>(const Vec<2>&)>& motion)
{
  run_folder::Frame<2> frame;
  frame.allocate(121, run_folder::common_fields<2>());
  run_folder::FieldValues<Real>& displacement = frame.field("displacement");
  for (int k = 0; k < 121; ++k) {
    const Vec<2> X = spacing * Vec<2>(k % 11 - 5, k / 11 - 5);
    frame.points[k] = motion(X);
    frame.volume[k] = spacing * spacing;
    for (int d = 0; d < 2; ++d) displacement.at(k, d) = frame.points[k][d] - X[d];
  }
  return frame;
}

Matrix<2> shape_after(const std::function<Vec<2>(const Vec<2>&)>& motion)
{
  return particle_shapes(lattice(motion), {60})[0];
}

// Axes 1.5 and 1/1.5 along directions that are turned by 0.3; a tenth of the volume holds against eight neighbours within 6 volumes: 1 % of the stretch.
TEST(ParticleShapes, are_those_of_a_stretch_whatever_the_rotation)
{
  const Matrix<2> turn = Eigen::Rotation2D<Real>(0.3).toRotationMatrix();
  const Matrix<2> stretch = turn * Vec<2>(1.5, 1 / 1.5).asDiagonal() * turn.transpose();
  const Matrix<2> rotation = Eigen::Rotation2D<Real>(1).toRotationMatrix();
  EXPECT_LT((shape_after([&](const Vec<2>& X) -> Vec<2> { return stretch * rotation * X + Vec<2>(7, 8); }) - stretch).norm(), 0.03);
}

TEST(ParticleShapes, are_circles_where_soil_moves_as_a_whole)
{
  const Matrix<2> rotation = Eigen::Rotation2D<Real>(2).toRotationMatrix();
  EXPECT_LT((shape_after([&](const Vec<2>& X) -> Vec<2> { return rotation * X; }) - Matrix<2>::Identity()).norm(), 0.05);
}

TEST(ParticleShapes, have_the_area_of_the_circle_and_an_axis_of_two_and_a_half_at_most)
{
  for (const Real gamma : {0.5, 2., 50.}) {
    const Matrix<2> A = shape_after([&](const Vec<2>& X) -> Vec<2> { return {X[0] + gamma * X[1], X[1]}; });
    EXPECT_NEAR(A.determinant(), 1, 1e-9);
    EXPECT_LT(Matrix<2>(A * A.transpose()).trace(), 2.5 * 2.5 + 0.4 * 0.4 + 1e-9);
  }
}

TEST(ParticleShapes, leave_out_neighbours_that_were_torn_off)
{
  EXPECT_LT(
      (shape_after([&](const Vec<2>& X) -> Vec<2> { return X[1] > 0.5 * spacing ? Vec<2>(X[0] + 1, X[1]) : X; }) - Matrix<2>::Identity())
          .norm(),
      1e-6);
}

TEST(ParticleShapes, are_circles_in_frames_without_displacements)
{
  run_folder::Frame<2> frame = lattice([](const Vec<2>& X) -> Vec<2> { return {2 * X[0], X[1] / 2}; });
  std::erase_if(frame.fields, [](const auto& field) { return field.info.name == "displacement"; });
  EXPECT_EQ(particle_shapes(frame, {60})[0], (Matrix<2>::Identity()));
}

}  // namespace
}  // namespace berm::soil_plot::this_file
