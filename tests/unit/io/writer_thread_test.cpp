// SPDX-License-Identifier: BSD-3-Clause
#include "io/writer_thread.hpp"

#include "os/error.hpp"
#include "os/threads.hpp"

#include <future>
#include <gtest/gtest.h>
#include <omp.h>
#include <vector>

namespace berm::io::this_file {
namespace {

std::string thrown_by(const std::function<void()>& act)
{
  try {
    act();
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

TEST(WriterThread, does_pieces_in_order_and_beside_the_one_that_hands_them_over)
{
  std::vector<int> done;
  std::promise<void> go_on;
  WriterThread thread;
  thread.hand_over([&, wait = go_on.get_future().share()] { wait.wait(), done.push_back(1); });
  const BigIndex second = thread.hand_over([&] { done.push_back(2); });
  go_on.set_value();  // reached while the first piece waits for it
  thread.wait_for(second);
  EXPECT_EQ(done, (std::vector{1, 2}));
}

TEST(WriterThread, does_at_its_end_what_is_left)
{
  int done = 0;
  {
    WriterThread thread;
    for (int k = 0; k < 100; ++k) thread.hand_over([&] { ++done; });
  }
  EXPECT_EQ(done, 100);
}

TEST(WriterThread, tells_once_of_a_piece_that_threw_and_leaves_out_what_is_behind_it)
{
  bool done = false;
  WriterThread thread;
  EXPECT_NO_THROW(thread.check());
  thread.hand_over([] { throw RunError("cannot write it"); });
  thread.come_to_rest();
  EXPECT_EQ(thrown_by([&] { thread.check(); }), "cannot write it");
  EXPECT_NO_THROW(thread.finish());
  thread.hand_over([&] { done = true; });
  thread.finish();
  EXPECT_FALSE(done);
  for (const auto& ask :
       std::vector<std::function<void(WriterThread&)>>{[](WriterThread& t) { t.finish(); }, [](WriterThread& t) { t.wait_for(1); },
                                                       [](WriterThread& t) { t.come_to_rest(), t.hand_over([] {}); }}) {
    WriterThread another;
    another.hand_over([] { throw RunError("cannot write it"); });
    EXPECT_EQ(thrown_by([&] { ask(another); }), "cannot write it");
  }
}

TEST(WriterThread, is_alone_in_its_loops_may_use_all_processors_and_counts_as_its_starter_does)
{
  const Threads two(2);
  volatile Real tiny = 1e-300;
  ASSERT_EQ(tiny * 1e-10, 0) << "numbers below 2e-308 count as zero";
  int threads = 0;
  cpu_set_t allowed;
  Real product = 1;
  WriterThread thread;
  thread.hand_over([&] {
    threads = omp_get_max_threads();
    sched_getaffinity(0, sizeof allowed, &allowed);
    product = tiny * 1e-10;
  });
  thread.finish();
  EXPECT_EQ(threads, 1);
  EXPECT_GE(CPU_COUNT(&allowed), processor_count());
  EXPECT_EQ(product, 0);
  EXPECT_EQ(omp_get_max_threads(), 2);
}

}  // namespace
}  // namespace berm::io::this_file
