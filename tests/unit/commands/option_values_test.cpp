// SPDX-License-Identifier: BSD-3-Clause
// Options with a value that they do not take: the message says which they do, in the words of the input files.
#include "samples/program.hpp"

#include <gtest/gtest.h>

namespace berm::commands::this_file {
namespace {

TEST(OptionValues, that_are_not_allowed_are_refused_with_what_is)
{
  const TemporaryFolder folder;
  const std::pair<std::vector<std::string>, const char*> wrong[] = {
      {{"new", "pipe-in-clay", "--n-kt", "50"}, "--n-kt: \"50\" is not allowed; allowed: a number from 5 to 30"},
      {{"new", "pipe-in-clay", "--n-kt", "twelve"}, "--n-kt: \"twelve\" is not allowed; allowed: a number from 5 to 30"},
      {{"new", "pipe-in-clay", "--n-kt", "12,5"}, "--n-kt: \"12,5\" has a decimal comma: write 12.5; allowed: a number from 5 to 30"},
      {{"new", "pipe-in-sand", "--phi", "kulhawy"},
       "--phi: \"kulhawy\" is not allowed; did you mean \"kulhawy-mayne\"? (allowed: kulhawy-mayne, robertson-campanella)"},
      {{"run", "case.toml", "--threads", "0"}, "--threads: \"0\" is not allowed; allowed: a whole number from 1 to 1024"},
      {{"run", "case.toml", "--threads", "1.5"}, "--threads: \"1.5\" is not allowed; allowed: a whole number from 1 to 1024"},
      {{"safety", "case.toml", "--tolerance", "2"}, "--tolerance: \"2\" is not allowed; allowed: a number from "},
      {{"macro-element", "run", "--axial-friction", "-1"}, "--axial-friction: \"-1\" is not allowed; allowed: a number at least 0"},
      {{"export", "run", "--to", "orcaflx"}, "did you mean \"orcaflex\"?"},
      {{"completion", "csh"}, "SHELL: \"csh\" is not allowed"},
  };
  for (const auto& [arguments, said] : wrong) {
    const Ended ended = run_program(folder.path(), arguments);
    EXPECT_EQ(ended.status, 2) << ended.out;
    EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
  }
}

}  // namespace
}  // namespace berm::commands::this_file
