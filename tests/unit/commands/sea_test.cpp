// SPDX-License-Identifier: BSD-3-Clause
#include "samples/program.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::commands::this_file {
namespace {

TEST(SeaCommand, gives_loads_and_a_stage_that_a_case_takes)
{
  TemporaryFolder folder;
  folder.write(
      "sea.toml",
      "[sea]\nspectrum = \"jonswap\"\nsignificant_height = \"4.5 m\"\npeak_period = \"10 s\"\ndepth = \"30 m\"\nduration = \"600 s\"\n"
      "[pipe]\ndiameter = \"0.25 m\"\nsubmerged_weight = \"400 N/m\"\ndrag = 0.9\ninertia = 3.29\nlift = 0.5\n"
      "[bed]\nfriction = 0.6\nsubmerged_unit_weight = \"9 kN/m^3\"\n[record]\nseeds = 1\nwaves = 2\nstep = \"1 s\"\n");
  const Ended ended = run_program(folder.path(), {"sea", "sea.toml", "-o", "sea"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("peak horizontal load (DNV-RP-F109)"), std::string::npos) << ended.out;
  ASSERT_EQ(run_program(folder.path(), {"new", "storm-on-a-cable", "case.toml", "--size", "quick"}).status, 0);
  std::string text = folder.read("case.toml");
  const std::size_t storm = text.find("[[stage]]\nname = \"storm\""), output = text.find("[output]");
  ASSERT_TRUE(storm != std::string::npos && output != std::string::npos);
  text.replace(storm, output - storm, folder.read("sea/stage.toml") + "\n");
  folder.write("sea/cable.toml", text);
  const Ended checked = run_program(folder.path(), {"check", "sea/cable.toml", "--threads", "1"});
  EXPECT_EQ(checked.status, 0) << checked.err;
}

}  // namespace
}  // namespace berm::commands::this_file
