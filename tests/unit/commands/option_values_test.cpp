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
      {{"new", "--size"}, "--size: needs a value; allowed: {quick,normal,fine}"},
      {{"run", "--threads"}, "--threads: needs a value; allowed: a whole number from 1 to 1024"},
      {{"run", "case.toml", "--set"}, "--set: needs a value\n"},
      {{"new", "slope", "--size", "fine", "--size", "quick"}, "--size: is given more than once"},
      {{"run", "case.toml", "--force=perhaps"}, "--force: \"perhaps\" is not allowed"},
      {{"run", "case.toml", "--resume", "out"}, ": cannot be combined with "},
      {{"export", "run", "--ocr-exponent", "1"}, "--ocr-exponent: needs --strength-ratio"},
      {{"cpt"}, "FILE is missing"},
      {{"cpt", "a.csv", "b.csv"}, "unexpected argument: b.csv"},
  };
  for (const auto& [arguments, said] : wrong) {
    const Ended ended = run_program(folder.path(), arguments);
    EXPECT_EQ(ended.status, 2) << ended.out;
    EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
  }
}

TEST(OptionValues, are_in_the_help_as_they_are_allowed)
{
  const TemporaryFolder folder;
  const auto help = [&](const char* command) { return run_program(folder.path(), {command, "--help"}).out; };
  for (const char* words : {"--n-kt <a number from 5 to 30>", "--phi {kulhawy-mayne,robertson-campanella}", "--soil TEXT"})
    EXPECT_NE(help("new").find(words), std::string::npos) << help("new");
  for (const char* words :
       {"--threads <a whole number from 1 to 1024>", "--force (not with --resume)", "CASE TEXT ... (not with --resume)"})
    EXPECT_NE(help("run").find(words), std::string::npos) << help("run");
  EXPECT_NE(help("export").find("--ocr-exponent <a number from 0 to 2> (with --strength-ratio)"), std::string::npos) << help("export");
}

}  // namespace
}  // namespace berm::commands::this_file
