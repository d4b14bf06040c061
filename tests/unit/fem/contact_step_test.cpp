// SPDX-License-Identifier: BSD-3-Clause
#include "fem/contact_step.hpp"

#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

/// A plate on a block of soil that has moved a little at random: what the contact's step solves, with the whole matrix beside.
struct Block {
  FemProblem problem;
  FemLoads loads;
  std::vector<Real> change;
  Assembly assembly;
  ContactStep contact;
  DirectSolver solver;

  explicit Block(Real friction, bool sticks = false, bool free = false, Real width = 0.5)
      : problem(problem_of(friction, sticks, width)),
        change(random_numbers(problem.model.unknowns(), 1e-5)),
        assembly(problem.model),
        contact(problem.model),
        solver(problem.model.pattern, contact.unknowns())
  {
    if (free)
      for (FemLoads::Direction& direction : loads.rigid) direction.by_force = true;
    const NodeField<std::uint8_t>& fixed = problem.model.mesh.fixed[0];
    for (Index node = 0; node < fixed.size(); ++node)
      for (int d = 0; d < 2; ++d)
        if (fixed[node] >> d & 1) change[2 * node + d] = 0;
  }
  static FemProblem problem_of(Real friction, bool sticks, Real width)
  {
    settings::Case c = plate_on_block(elastic_soil(), width);
    c.contact[0].second.friction_angle = std::atan(friction);
    if (sticks) c.contact[0].second.scheme = contact::Scheme::tied;
    return fem_problem_of(c);
  }

  /// The step of all unknowns; the given ones of the plate go where the loads say.
  bool find(std::vector<Real>& step)
  {
    const FemModel& model = problem.model;
    assembly.evaluate(problem.state, change, loads, 0);
    assembly.differentiate(problem.state, change, 0);
    EXPECT_TRUE(solver.factorize(assembly.matrix()));
    step.assign(model.unknowns(), 0.);
    for (Index k = 0; k < model.unknowns(); ++k) {
      const bool rigid = k >= model.rigid_unknown();
      if (assembly.prescribed(k))
        step[k] = rigid ? loads.rigid[k - model.rigid_unknown()].value - change[k] : 0;
      else
        step[k] = -assembly.soil_residual()[k];
    }
    const bool settled = contact.find(problem.state, change, assembly, solver.kept_matrix(), solver.condense(step));
    solver.expand(step);
    return settled;
  }

  /// What is out of balance after the step: the soil's forces by its matrix, those of the contact by its law.
  void expect_balance(const std::vector<Real>& step)
  {
    const FemModel& model = problem.model;
    const Index n = model.unknowns();
    const std::vector<Real> entries = assembly.matrix();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    for (Index row = 0; row < n; ++row)
      for (Index k = model.pattern.first[row]; k < model.pattern.first[row + 1]; ++k)
        matrix(row, model.pattern.column[k]) = matrix(model.pattern.column[k], row) = entries[k];
    Eigen::VectorXd out = matrix * Eigen::Map<const Eigen::VectorXd>(step.data(), n);
    for (Index k = 0; k < n; ++k) out[k] += assembly.soil_residual()[k];
    std::vector<Real> moved = change;
    for (Index k = 0; k < n; ++k) moved[k] += step[k];
    Assembly after(model);
    after.evaluate(problem.state, moved, loads, 0);
    Real size = 0;
    for (Index k = 0; k < n; ++k) {
      out[k] += after.residual()[k] - after.soil_residual()[k];
      size += std::abs(after.residual()[k] - after.soil_residual()[k]);
    }
    EXPECT_GT(size, 10);
    for (Index k = 0; k < n; ++k) {
      if (!assembly.prescribed(k)) {
        EXPECT_NEAR(out[k], 0, 1e-9 * size) << k;
      } else {
        EXPECT_EQ(step[k], k < model.rigid_unknown() ? 0 : loads.rigid[k - model.rigid_unknown()].value - change[k]) << k;
      }
    }
    after.accept(problem.state, moved, loads);
  }

  int open() const
  {
    const auto& points = problem.state.contact;
    return static_cast<int>(std::count_if(points.begin(), points.end(), [](const auto& point) { return point.gap > 0; }));
  }
  int sliding(Real friction) const
  {
    int count = 0;
    for (std::size_t k = 0; k < problem.model.contact.size(); ++k) {
      const Vec<2>&n = problem.model.contact[k].normal, &t = problem.state.contact[k].traction;
      const Real pressure = t.dot(n);
      count += pressure > 0 && std::abs(t.dot(Vec<2>(-n[1], n[0]))) > friction * pressure * (1 - 1e-9);
    }
    return count;
  }
};

TEST(ContactStep, points_that_stick_make_newtons_step)
{
  Block block(0, true);
  block.loads.rigid[0].value = 2e-3;
  block.loads.rigid[1].value = 1e-3;  // upwards: it sticks all the same
  std::vector<Real> step;
  EXPECT_TRUE(block.find(step));
  block.expect_balance(step);
  EXPECT_GT(block.open(), 0);
}

TEST(ContactStep, settles_points_that_stick_and_slide)
{
  Block block(0.2);
  block.loads.rigid[0].value = 3e-4;
  block.loads.rigid[1].value = -1e-3;
  std::vector<Real> step;
  EXPECT_TRUE(block.find(step));
  block.expect_balance(step);
  EXPECT_EQ(block.open(), 0);
  EXPECT_GT(block.sliding(0.2), 0);
  EXPECT_LT(block.sliding(0.2), static_cast<int>(block.problem.model.contact.size()));
}

TEST(ContactStep, settles_points_that_open_under_a_plate_that_turns)
{
  Block block(0.4);
  block.loads.rigid[0].value = 1e-3;
  block.loads.rigid[1].value = -1e-3;
  block.loads.rigid[2].value = 0.02;
  std::vector<Real> step;
  EXPECT_TRUE(block.find(step));
  block.expect_balance(step);
  EXPECT_GT(block.open(), 0);
  EXPECT_LT(block.open(), static_cast<int>(block.problem.model.contact.size()) - 1);
}

TEST(ContactStep, moves_a_plate_that_is_driven_by_force)
{
  Block block(0.5, false, true);
  block.change[block.problem.model.rigid_unknown() + 1] = -1e-4;  // it presses
  block.loads.rigid[0].value = 100;
  block.loads.rigid[1].value = -1000;
  std::vector<Real> step;
  EXPECT_TRUE(block.find(step));
  block.expect_balance(step);
  EXPECT_LT(step[block.problem.model.rigid_unknown() + 1], -1e-5);
}

TEST(ContactStep, leaves_held_nodes_where_they_are_to_the_last_bit)
{
  // The plate's ends touch nodes that rollers hold.
  Block block(0, true, true, 1);
  block.loads.rigid[0].value = 100;
  block.loads.rigid[1].value = -1000;
  std::vector<Real> step;
  EXPECT_TRUE(block.find(step));
  block.expect_balance(step);
}

TEST(ContactStep, says_that_nothing_holds_a_plate_that_is_pulled_off)
{
  Block block(0.5, false, true);
  block.change.assign(block.change.size(), 0.);
  block.loads.rigid[1].value = 100;
  std::vector<Real> step;
  EXPECT_FALSE(block.find(step));
}

TEST(ContactStep, has_no_unknowns_where_nothing_touches)
{
  EXPECT_TRUE(ContactStep(fem_problem_of(block_of(elastic_soil())).model).unknowns().empty());
}

}  // namespace
}  // namespace berm::fem::this_file
