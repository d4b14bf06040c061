// SPDX-License-Identifier: BSD-3-Clause
#include "jobs/thread_shares.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::jobs::this_file {
namespace {

/// The threads of so many jobs, begun one after the other as long as a processor is free.
std::vector<int> threads_of(ThreadShares& shares, std::size_t jobs)
{
  std::vector<int> threads;
  for (; threads.size() < jobs && shares.any_free();) {
    threads.push_back(shares.for_next(jobs - threads.size()));
    shares.begin(threads.size() - 1, threads.back());
  }
  return threads;
}

TEST(ThreadShares, are_one_each_while_as_many_jobs_wait_and_more_for_the_last_ones)
{
  const auto of = [](int processors, std::size_t jobs) {
    ThreadShares shares(processors, std::vector<int>(static_cast<std::size_t>(processors)));
    return threads_of(shares, jobs);
  };
  EXPECT_EQ(of(4, 50), (std::vector{1, 1, 1, 1}));
  EXPECT_EQ(of(4, 4), (std::vector{1, 1, 1, 1}));
  EXPECT_EQ(of(4, 3), (std::vector{2, 1, 1})) << "the longest comes first";
  EXPECT_EQ(of(16, 3), (std::vector{6, 5, 5}));
  EXPECT_EQ(of(2, 1), (std::vector{2}));
  EXPECT_EQ(of(1, 2), (std::vector{1}));
}

TEST(ThreadShares, are_never_more_than_the_processors_that_there_are)
{
  ThreadShares shares(8, {0, 1});
  EXPECT_EQ(threads_of(shares, 1), (std::vector{2})) << "where more jobs at a time are asked for";
  ThreadShares unknown(8, {});
  EXPECT_EQ(threads_of(unknown, 1), (std::vector{1}));
}

TEST(ThreadShares, of_several_threads_have_processors_of_their_own)
{
  ThreadShares shares(4, {3, 5, 7, 9});
  std::vector<int> both = shares.begin(0, 2), second = shares.begin(1, 2);
  EXPECT_FALSE(shares.any_free());
  both.insert(both.end(), second.begin(), second.end());
  std::sort(both.begin(), both.end());
  EXPECT_EQ(both, (std::vector{3, 5, 7, 9}));
  shares.end(0);
  EXPECT_EQ(shares.for_next(1), 2);
  EXPECT_TRUE(shares.begin(2, 1).empty()) << "a single thread goes where the system puts it";
  EXPECT_TRUE(shares.any_free());
}

settings::Case box_of(Real squares_along_a_side)
{
  settings::Case c;
  mesh::BoxMesh box;
  box.size = {1, 1};
  box.cells = {squares_along_a_side, squares_along_a_side};
  c.mesh = box;
  bodies::BodySettings body;
  body.regions = {"soil"};
  body.particles_per_cell = 9;
  c.body = {{"sand", body}};
  return c;
}

TEST(ThreadShares, are_worth_it_where_each_thread_has_particles_enough)
{
  EXPECT_EQ(threads_worth(box_of(10)), 1) << "1800 particles";
  EXPECT_EQ(threads_worth(box_of(100)), 18);
  settings::Case by_fem = box_of(100);
  by_fem.method = settings::Method::fem;
  EXPECT_EQ(threads_worth(by_fem), 1);
  settings::Case from_file = box_of(100);
  from_file.mesh = mesh::GmshFile{"mesh.msh"};
  EXPECT_EQ(threads_worth(from_file), 1) << "which is not read before the run";
}

}  // namespace
}  // namespace berm::jobs::this_file
