// SPDX-License-Identifier: BSD-3-Clause
// Cases of berm new with one thing changed to what no soil, steel or sea has, or what no stage can do: berm check names the key and what to change.
#include "samples/program.hpp"
#include "samples/senseless_templates.hpp"

#include <gtest/gtest.h>

namespace berm::sanity::this_file {
namespace {

using test::SenselessTemplate;

class SenselessTemplates : public testing::TestWithParam<SenselessTemplate> {};

TEST_P(SenselessTemplates, are_doubted_or_refused_with_the_key_and_what_to_change)
{
  const SenselessTemplate& input = GetParam();
  TemporaryFolder folder;
  ASSERT_EQ(run_program(folder.path(), {"new", input.kind, "case.toml", "--size", "quick"}).status, 0);
  std::string text = text_of_file(folder / "case.toml");
  const std::size_t at = text.find(input.replaced);
  ASSERT_NE(at, std::string::npos) << "the template has no more: " << input.replaced;
  text.replace(at, std::string(input.replaced).size(), input.by);
  folder.write("case.toml", text);
  const Ended ended = run_program(folder.path(), {"check", "case.toml", "--threads", "1"});
  EXPECT_EQ(ended.status, input.refused ? 2 : 0) << ended.err;
  std::istringstream lines(ended.err);
  bool found = false;
  for (std::string line; std::getline(lines, line);)
    found = found || (line.starts_with(input.refused ? "berm: " : "berm: warning: ") &&
                      line.find(std::string(": ") + input.key + ": ") != std::string::npos && line.find(input.says) != std::string::npos);
  EXPECT_TRUE(found) << ended.err;
}

INSTANTIATE_TEST_SUITE_P(All, SenselessTemplates, testing::ValuesIn(test::senseless_templates()),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace berm::sanity::this_file
