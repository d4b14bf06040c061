// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/origin.hpp"

#include "io/revision.hpp"
#include "io/sha256.hpp"
#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <regex>

namespace berm::run_folder::this_file {
namespace {

TEST(origin, holds_the_digests_of_the_input_that_is_there_and_the_program)
{
  const TemporaryFolder run;
  run.write("case.toml", "abc");
  run.write("resolved.toml", "title = \"x\"\n");
  run.write("history.csv", "no input");
  note_origin(run.path(), "a.toml", {"title=\"b\""});
  const std::optional<Origin> origin = read_origin(run.path());
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->case_file, "a.toml");
  EXPECT_EQ(origin->set, (std::vector<std::string>{"title=\"b\""}));
  ASSERT_EQ(origin->input.size(), 2u);
  EXPECT_EQ(origin->input[0], (std::pair<std::string, std::string>("case.toml", io::sha256_of_file(run / "case.toml"))));
  EXPECT_EQ(origin->input[1].first, "resolved.toml");
  ASSERT_EQ(origin->sessions.size(), 1u);
  const RunSession& session = origin->sessions.front();
  EXPECT_TRUE(std::regex_match(session.begun, std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)"))) << session.begun;
  EXPECT_EQ(session.version, io::version_words());
  EXPECT_NE(session.build.find("vector unit"), std::string::npos);
  ASSERT_GE(session.program.size(), 2u) << "the program and its engine";
  EXPECT_EQ(session.program[0], (std::pair<std::string, std::string>("test_run_folder", io::sha256_of_file("/proc/self/exe"))));
  EXPECT_TRUE(session.program[1].first.starts_with("libberm_engine")) << session.program[1].first;
}

TEST(origin, of_a_resumed_run_has_a_session_more_and_the_same_input)
{
  const TemporaryFolder run;
  run.write("case.toml", "abc");
  note_origin(run.path(), "case.toml", {});
  const FileHashes input = read_origin(run.path())->input;
  run.write("case.toml", "changed since");
  note_resumption(run.path());
  const std::optional<Origin> origin = read_origin(run.path());
  ASSERT_EQ(origin->sessions.size(), 2u);
  EXPECT_FALSE(origin->sessions[0].resumption);
  EXPECT_TRUE(origin->sessions[1].resumption);
  EXPECT_TRUE(origin->begins());
  EXPECT_EQ(origin->input, input);
}

TEST(origin, of_a_resumed_run_that_had_none_or_a_damaged_one_does_not_begin_it)
{
  for (const char* damaged : {"", "{\"input_sha256\": 3}", static_cast<const char*>(nullptr)}) {
    const TemporaryFolder run;
    if (damaged != nullptr) run.write("origin.json", damaged);
    ASSERT_NO_THROW(note_resumption(run.path()));
    const std::optional<Origin> origin = read_origin(run.path());
    ASSERT_EQ(origin->sessions.size(), 1u);
    EXPECT_TRUE(origin->sessions[0].resumption);
    EXPECT_FALSE(origin->begins());
    EXPECT_TRUE(origin->input.empty());
    note_resumption(run.path());
    EXPECT_EQ(read_origin(run.path())->sessions.size(), 2u);
  }
}

TEST(origin, of_an_earlier_version_is_unknown_and_a_damaged_one_is_refused)
{
  const TemporaryFolder run;
  EXPECT_FALSE(read_origin(run.path()));
  for (const char* damaged : {"", "{", "{\"input_sha256\": {}}", "{\"input_sha256\": {\"case.toml\": 3}, \"sessions\": []}", "[]",
                              R"({"input_sha256": {}, "sessions": [], "case": "a\nb"})"}) {
    run.write("origin.json", damaged);
    EXPECT_THROW(read_origin(run.path()), RunError) << damaged;
  }
}

}  // namespace
}  // namespace berm::run_folder::this_file
