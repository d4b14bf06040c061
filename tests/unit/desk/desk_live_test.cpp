// SPDX-License-Identifier: BSD-3-Clause
#include "desk/live.hpp"

#include "samples/temporary_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>

namespace berm::desk::this_file {
namespace {

TEST(DeskLive, gives_the_rows_that_were_written_since)
{
  const TemporaryFolder run;
  std::ofstream(run / "history.schema.json") << R"({"columns":[{"name":"time_s","unit":"s"},{"name":"stage"}]})";
  std::ofstream(run / "resolved.toml") << "x = 1";
  std::ofstream history(run / "history.csv");
  history << "time_s,stage\n0,rest\n1,\"push, slow\"\n2,pu" << std::flush;
  const Folder folder(run.path());
  Live live(folder);
  EXPECT_EQ(live.rows(run.path(), 0).at("rows"), Json::parse(R"([[0.0,"rest"],[1.0,"push, slow"]])"));
  EXPECT_EQ(live.rows(run.path(), 2).at("rows"), Json::array());
  history << "sh\nnan,push\n" << std::flush;
  EXPECT_EQ(live.rows(run.path(), 2).at("rows"), Json::parse(R"([[2.0,"push"],[null,"push"]])"));
  EXPECT_EQ(live.rows(run.path(), 1).at("rows").size(), 3u);
}

TEST(DeskLive, gives_long_histories_in_parts)
{
  const TemporaryFolder run;
  std::ofstream(run / "history.schema.json") << R"({"columns":[{"name":"time_s","unit":"s"}]})";
  {
    std::ofstream history(run / "history.csv");
    history << "time_s\n";
    for (int k = 0; k < 300000; ++k) history << k << '\n';
  }
  const Folder folder(run.path());
  Live live(folder);
  std::size_t count = 0;
  for (bool more = true; more;) {
    const Json part = live.rows(run.path(), count);
    ASSERT_EQ(part.at("rows")[0][0], static_cast<double>(count));
    count += part.at("rows").size();
    more = part.at("more");
  }
  EXPECT_EQ(count, 300000u);
}

TEST(DeskLive, reads_how_far_a_run_is_from_its_log)
{
  const auto last = advance_in("2026-11-27 09:29:15 roll  0 %  7 min 10 s left  w 1 mm\n2026-11-27 09:29:16 50 %  hard  12 %  1 h 02 min "
                               "left  w -0.00 mm\ntime by loop    s     part\n");
  ASSERT_TRUE(last);
  EXPECT_DOUBLE_EQ(last->done, 0.12);
  EXPECT_DOUBLE_EQ(last->left_s, 3720);
  EXPECT_FALSE(advance_in("change cells                          1.191    11.4%\n"));
}

}  // namespace
}  // namespace berm::desk::this_file
