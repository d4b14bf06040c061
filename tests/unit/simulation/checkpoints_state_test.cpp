// SPDX-License-Identifier: BSD-3-Clause
// A checkpoint is the state to the last bit: a run that goes on from it cannot be told from one that was never interrupted.
#include "keep_in_memory.hpp"
#include "sample_run.hpp"
#include "samples/temporary_folder.hpp"

#include "mpm/time_step.hpp"
#include "problem/archive_state.hpp"
#include "run_folder/checkpoint_file.hpp"

#include <cstring>
#include <gtest/gtest.h>

namespace berm::simulation::this_file {
namespace {

template <int dim>
test::ArchiveInMemory all_of(test::SampleRun<dim>& run)
{
  test::ArchiveInMemory all;
  archive(all, run.problem.model, run.problem.state);
  return all;
}

template <int dim>
void write(const std::filesystem::path& file, test::SampleRun<dim>& run)
{
  run_folder::write_checkpoint(file, [&](Archive& k) { archive(k, run.problem.model, run.problem.state); });
}
template <int dim>
void read(const std::filesystem::path& file, test::SampleRun<dim>& run)
{
  run_folder::read_checkpoint(file, [&](Archive& k) { archive(k, run.problem.model, run.problem.state); });
}

/// Whether all blocks, cell by cell, are the same to the last bit, lanes without a particle included.
template <int dim>
bool same_blocks(const bodies::Particles<dim>& a, const bodies::Particles<dim>& b)
{
  if (a.occupied() != b.occupied() || a.size() != b.size()) return false;
  for (const Index cell : a.occupied()) {
    if (a.count_in(cell) != b.count_in(cell)) return false;
    Index left = a.count_in(cell);
    for (Index p = a.first_block(cell), q = b.first_block(cell); left > 0; p = a.block(p).next, q = b.block(q).next, left -= lanes) {
      const std::size_t numbers = offsetof(bodies::Block<dim>, next);
      if (std::memcmp(&a.block(p), &b.block(q), numbers) != 0) return false;
      if (a.extra_size() > 0 && std::memcmp(a.state(p), b.state(q), static_cast<std::size_t>(a.extra_size()) * sizeof(Lanes)) != 0)
        return false;
      if ((a.block(p).next == none) != (b.block(q).next == none)) return false;
    }
  }
  return true;
}

template <class Dimension>
class StateCheckpoint : public testing::Test {
protected:
  TemporaryFolder folder_;
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(StateCheckpoint, Dimensions);

TYPED_TEST(StateCheckpoint, gives_the_same_bits_back)
{
  constexpr int dim = TypeParam::value;
  test::SampleRun<dim> first, second;
  first.steps(403);
  // The particles have moved between cells, yielded, and touched the disk and each other.
  const problem::State<dim>& state = first.problem.state;
  ASSERT_FALSE(same_blocks(state.particles[0], second.problem.state.particles[0]));
  ASSERT_NE(state.particles[0].occupied(), second.problem.state.particles[0].occupied());
  ASSERT_GT(state.ledger.contact_sums[0].impulse_sum, 0);
  ASSERT_GT(state.ledger.pair_impulses[1].norm(), 0);
  bool law_state = false;
  state.particles[0].visit([&](Index, Index b, int l) { law_state = law_state || state.particles[0].state(b)[0][l] != 0; });
  ASSERT_TRUE(law_state);

  const auto file = this->folder_ / "file.h5";
  write(file, first);
  read(file, second);
  EXPECT_EQ(test::differences(all_of(first), all_of(second)), "");
  for (int b = 0; b < 2; ++b) EXPECT_TRUE(same_blocks(state.particles[b], second.problem.state.particles[b])) << "body " << b;
}

TYPED_TEST(StateCheckpoint, keeps_what_an_interface_remembers)
{
  constexpr int dim = TypeParam::value;
  settings::Case c = test::two_bodies<dim>(contact::Scheme::musl_coupled);
  contact::ContactSettings& skin = c.contact[0].second;
  skin.tension = 2e3;
  skin.adhesion = 500;
  skin.adhesion_sensitivity = 3;
  skin.adhesion_ductility = 0.01;
  test::SampleRun<dim> first(c), second(c);
  first.steps(403);
  const auto [bond, slip] = first.problem.model.contacts[0].memory;
  int bonded = 0, slid = 0;
  first.problem.state.particles[0].visit([&, bond = bond, slip = slip](Index, Index b, int l) {
    bonded += static_cast<int>(first.problem.state.particles[0].extra(b)[bond][l] == static_cast<Real>(problem::Bond::bonded));
    slid += static_cast<int>(first.problem.state.particles[0].extra(b)[slip][l] > 0);
  });
  ASSERT_GT(bonded, 0);
  ASSERT_GT(slid, 0);
  const auto file = this->folder_ / "file.h5";
  write(file, first);
  read(file, second);
  first.steps(100);
  second.steps(100);
  EXPECT_EQ(test::differences(all_of(first), all_of(second)), "");
}

/// Gives each number of a struct of nothing but numbers another value.
template <class Numbers>
void fill(Numbers& numbers, Real& next)
{
  Real values[sizeof(Numbers) / sizeof(Real)];
  for (Real& value : values) value = next++;
  std::memcpy(static_cast<void*>(&numbers), values, sizeof(Numbers));
}
template <class Numbers>
bool same(const Numbers& a, const Numbers& b)
{
  return std::memcmp(static_cast<const void*>(&a), static_cast<const void*>(&b), sizeof(Numbers)) == 0;
}

// Without keep(), which would not miss what it leaves out.
TYPED_TEST(StateCheckpoint, leaves_no_number_out)
{
  constexpr int dim = TypeParam::value;
  settings::Case c = test::two_bodies<dim>(contact::Scheme::musl_coupled);
  c.output.support_reactions = true;
  test::SampleRun<dim> first(c), second(c);
  problem::State<dim>&state = first.problem.state, &found = second.problem.state;
  Real next = 1;
  fill(state.time, next);
  fill(state.dt, next);
  state.step = 123456789012;
  fill(state.rigid_bodies[0], next);
  fill(state.ledger.contact_sums[0], next);
  fill(state.listed_poses[0], next);
  fill(state.ledger.totals, next);
  for (Vec<dim>& impulse : state.ledger.pair_impulses) fill(impulse, next);
  for (Vec<dim>& impulse : state.ledger.support_impulses) fill(impulse, next);
  state.heads.resize(1), found.heads.resize(1);  // as many as a model has
  fill(state.heads[0], next);
  fill(state.stage.begin_time, next);
  fill(state.stage.begin_displacement, next);
  for (bodies::Drive& drive : state.stage.drive) {
    drive.by_force = !drive.by_force;
    fill(drive.from, next);
    fill(drive.to, next);
  }

  const auto file = this->folder_ / "file.h5";
  write(file, first);
  read(file, second);
  EXPECT_EQ(found.time, state.time);
  EXPECT_EQ(found.dt, state.dt);
  EXPECT_EQ(found.step, state.step);
  EXPECT_TRUE(same(found.rigid_bodies[0], state.rigid_bodies[0]));
  EXPECT_TRUE(same(found.ledger.contact_sums[0], state.ledger.contact_sums[0]));
  EXPECT_TRUE(same(found.listed_poses[0], state.listed_poses[0]));
  EXPECT_TRUE(same(found.ledger.totals, state.ledger.totals));
  EXPECT_EQ(found.ledger.pair_impulses, state.ledger.pair_impulses);
  EXPECT_EQ(state.ledger.support_impulses.size(), c.support.size());
  EXPECT_EQ(found.ledger.support_impulses, state.ledger.support_impulses);
  EXPECT_TRUE(same(found.heads[0], state.heads[0]));
  EXPECT_EQ(found.stage.begin_time, state.stage.begin_time);
  EXPECT_EQ(found.stage.begin_displacement, state.stage.begin_displacement);
  for (int d = 0; d < dim; ++d) {
    EXPECT_EQ(found.stage.drive[d].by_force, state.stage.drive[d].by_force) << d;
    EXPECT_EQ(found.stage.drive[d].from, state.stage.drive[d].from) << d;
    EXPECT_EQ(found.stage.drive[d].to, state.stage.drive[d].to) << d;
  }
}

TYPED_TEST(StateCheckpoint, lets_a_run_go_on_as_if_it_had_never_stopped)
{
  constexpr int dim = TypeParam::value;
  const auto file = this->folder_ / "file.h5";
  for (const contact::Scheme scheme : {contact::Scheme::musl_coupled, contact::Scheme::usf}) {
    test::SampleRun<dim> whole(scheme);
    auto parts = std::make_unique<test::SampleRun<dim>>(scheme);
    for (const int steps : {17, 38, 100, 61, 1, 230, 5}) {
      if (scheme == contact::Scheme::usf && whole.problem.state.step > 200)
        break;  // usf throws grains out of so coarse a mesh some time later
      whole.steps(steps);
      parts->steps(steps);
      ASSERT_NE(parts->problem.state.step % mpm::steps_between_time_steps, 0) << "a run is not interrupted here";
      write(file, *parts);
      parts = std::make_unique<test::SampleRun<dim>>(scheme);
      read(file, *parts);
      whole.steps(3);
      parts->steps(3);
      ASSERT_EQ(test::differences(all_of(whole), all_of(*parts)), "") << "after step " << whole.problem.state.step;
      // What a later step may do depends on these, too.
      ASSERT_EQ(whole.workspace->contact_points[0].near_cells, parts->workspace->contact_points[0].near_cells);
    }
  }
}

TYPED_TEST(StateCheckpoint, holds_tractions_and_where_their_points_are)
{
  constexpr int dim = TypeParam::value;
  settings::Case c = test::two_bodies<dim>(contact::Scheme::musl_coupled);
  c.body.resize(1);
  c.body[0].second.block.reset();
  c.body[0].second.regions = {"box"};
  c.contact.clear();
  c.rigid.clear();
  c.stage[0] = {};
  c.stage[0].until.time = 1;
  boundary::TractionSettings load;
  load.boundary = "top";
  load.pressure = 2e4;
  load.ramp = 0.05;
  c.traction = {{"load", load}};
  test::SampleRun<dim> whole(c), parts(c);
  whole.steps(23);
  ASSERT_GT((whole.problem.state.load_points[0].x - parts.problem.state.load_points[0].x).norm(), 0);
  whole.problem.state.tractions[0].begin_time = -1e-3;
  whole.problem.state.tractions[0].from = 0.1;
  const auto file = this->folder_ / "file.h5";
  write(file, whole);
  read(file, parts);
  EXPECT_EQ(test::differences(all_of(whole), all_of(parts)), "");
  whole.steps(30);
  parts.steps(30);
  EXPECT_EQ(test::differences(all_of(whole), all_of(parts)), "");
  for (std::size_t l = 0; l < whole.problem.state.load_points.size(); ++l) {
    EXPECT_EQ(whole.problem.state.load_points[l].x, parts.problem.state.load_points[l].x);
    EXPECT_EQ(whole.problem.state.load_points[l].cell, parts.problem.state.load_points[l].cell);
  }
  EXPECT_EQ(parts.problem.state.tractions[0].from, 0.1);

  whole.problem.state.load_points[0].cell = whole.problem.model.mesh.cell_count();
  write(file, whole);
  EXPECT_THROW(read(file, parts), RunError);
}

TYPED_TEST(StateCheckpoint, of_another_problem_is_refused)
{
  constexpr int dim = TypeParam::value;
  test::SampleRun<dim> run, other;
  const auto file = this->folder_ / "file.h5";
  write(file, run);
  other.problem.state.particles[1].take(other.problem.state.particles[1].occupied()[0], 0);
  try {
    read(file, other);
    FAIL() << "is taken";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("particles of this body"), std::string::npos) << error.what();
  }
}

TYPED_TEST(StateCheckpoint, of_a_step_that_no_run_comes_to_is_refused)
{
  constexpr int dim = TypeParam::value;
  test::SampleRun<dim> run, other;
  const auto file = this->folder_ / "file.h5";
  for (const BigIndex step : {BigIndex(-1), std::numeric_limits<BigIndex>::max(), std::numeric_limits<BigIndex>::min()}) {
    run.problem.state.step = step;
    write(file, run);
    EXPECT_THROW(read(file, other), RunError) << step;
  }
  run.problem.state.step = BigIndex(1) << 50;
  write(file, run);
  read(file, other);
  EXPECT_EQ(other.problem.state.step, run.problem.state.step);
}

}  // namespace
}  // namespace berm::simulation::this_file
