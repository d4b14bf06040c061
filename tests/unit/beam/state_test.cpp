// SPDX-License-Identifier: BSD-3-Clause
#include "beam/state.hpp"

#include "beam/step.hpp"
#include "macro_element/under_force.hpp"
#include "samples/buckling_pipe.hpp"
#include "samples/macro_element_parameters.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <map>

namespace berm::beam::this_file {
namespace {

/// Keeps what is written, and gives it back.
class Kept : public Archive {
public:
  bool reads() const override { return reading; }
  void refuse(const std::string& why) const override { throw RunError(why); }
  bool reading = false;

protected:
  void list(const std::string& path, std::vector<Real>& numbers) override { keep(reals_, path, numbers); }
  void list(const std::string& path, std::vector<Index>& numbers) override { keep(indices_, path, numbers); }
  void list(const std::string&, std::vector<BigIndex>&) override { FAIL() << "the state has none"; }
  void list(const std::string&, std::string&) override { FAIL() << "the state has none"; }

private:
  template <class Values>
  void keep(std::map<std::string, Values>& kept, const std::string& path, Values& values)
  {
    if (reading)
      values = kept.at(path);
    else
      EXPECT_TRUE(kept.emplace(path, values).second) << path << " is kept twice";
  }
  std::map<std::string, std::vector<Real>> reals_;
  std::map<std::string, std::vector<Index>> indices_;
};

Line hot_line()
{
  const test::HotPipe pipe;
  Line line = test::bent_line(pipe, false, 0.4, 60, graded_nodes(1, 60, 1.1, 4, 300));
  add_springs(line, Direction::axial, friction(pipe.resistance(), 1e-3), lengths_of_nodes(line));
  add_springs(line, Direction::lateral, PlasticSpring{{{{0.005, 700}, {0.3, 1000}}}}, lengths_of_nodes(line));
  line.axial_where_sideways = false;
  line.damping[0] = 0.1;
  return line;
}

void heat(const Line& line, int from, int to, State& state)
{
  Work work(line);
  Loads loads = no_loads(line);
  for (int i = from; i < to; ++i) {
    // up and down, so that springs have been to both sides
    std::fill(loads.constrained_force.begin(), loads.constrained_force.end(), 1.4e6 * std::sin(pi * i / 600));
    loads.force[line.across(Plane::lateral, 3)] = 10 * i;
    step(line, loads, 0.02, state, work);
  }
}

void expect_same_bits(const std::vector<Real>& a, const std::vector<Real>& b)
{
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Real)), 0);
}

// In the middle of a buckle, kept, put into a new state and gone on with new memory.
TEST(State, that_was_kept_goes_on_with_the_same_bits)
{
  const Line line = hot_line();
  State whole = state_of(line);
  heat(line, 0, 300, whole);
  Kept kept;
  archive(kept, whole);
  State again = state_of(line);
  kept.reading = true;
  archive(kept, again);
  heat(line, 300, 600, whole);
  heat(line, 300, 600, again);
  EXPECT_GT(whole.displacement[line.across(Plane::lateral, 0)], 0.6);
  expect_same_bits(whole.displacement, again.displacement);
  expect_same_bits(whole.velocity, again.velocity);
  expect_same_bits(whole.acceleration, again.acceleration);
  expect_same_bits({whole.time, whole.totals.work_of_loads, whole.totals.work_of_heat, whole.totals.work_on_springs, whole.totals.damped},
                   {again.time, again.totals.work_of_loads, again.totals.work_of_heat, again.totals.work_on_springs, again.totals.damped});
  EXPECT_EQ(whole.sideways, again.sideways);
  expect_same_bits(whole.mean_axial, again.mean_axial);
}

TEST(State, of_macro_elements_that_was_kept_goes_on_with_the_same_bits)
{
  const test::HotPipe pipe;
  Line line = straight_line(graded_nodes(1, 10, 1.1, 4, 40), pipe.section(), {Plane::lateral, Plane::vertical});
  const berm_macro_element_parameters p = macro_element::sample_parameters();
  add_macro_elements(line, p, lengths_of_nodes(line), macro_element::laid(p, 2500, pipe.weight));
  Work work(line);
  Loads loads = no_loads(line);
  add_weight(line, loads);
  const auto pull = [&](int from, int to, State& state) {
    for (int i = from; i < to; ++i) {
      loads.force[line.across(Plane::lateral, 0)] = 8e3 * std::sin(pi * i / 60), loads.force[line.axial(0)] = 3e3 * std::sin(pi * i / 40);
      step(line, loads, 0.02, state, work);
    }
  };
  State whole = state_of(line), again = whole;
  pull(0, 100, whole);
  Kept kept;
  archive(kept, whole);
  kept.reading = true;
  archive(kept, again);
  pull(100, 200, whole);
  pull(100, 200, again);
  EXPECT_NE(whole.macro_elements[0].u_p, 0);
  expect_same_bits(whole.displacement, again.displacement);
  for (std::size_t i = 0; i < whole.macro_elements.size(); ++i) {
    const berm_macro_element_state &a = whole.macro_elements[i], &b = again.macro_elements[i];
    expect_same_bits({a.T, a.H, a.V, a.disturbed, a.berm[1].left_R}, {b.T, b.H, b.V, b.disturbed, b.berm[1].left_R});
  }
}

TEST(State, of_another_line_is_refused)
{
  const Line line = hot_line();
  State state = state_of(line), shorter = state_of(straight_line({0, 1}, {}, {Plane::lateral}));
  Kept kept;
  archive(kept, shorter);
  kept.reading = true;
  EXPECT_THROW(archive(kept, state), RunError);
}

}  // namespace
}  // namespace berm::beam::this_file
