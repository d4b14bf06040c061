// SPDX-License-Identifier: BSD-3-Clause
// What the list of runs says of each, and what it changes of their folders.
#include "io/folder_lock.hpp"
#include "samples/desk_client.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>

namespace berm::desk::this_file {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A folder with the folder of a run that has no more than a desk reads, beside a secret one.
class DeskRuns : public testing::Test {
protected:
  DeskRuns()
  {
    for (const char* run : {"served/out/storm", "served/out/other", "secret/run"}) {
      fs::create_directories(place_ / run);
      std::ofstream(place_ / run / "resolved.toml") << "x = 1\n";
    }
    summary({{"w_end_of_push", 0.01, "m"}, {"u_largest", 0.223, "m"}, {"H_max", 100, "N m-1"}}, "u_largest");
    desk_.emplace(served());
  }

  struct Number {
    const char* name;
    double value;
    const char* unit;
  };
  void summary(const std::vector<Number>& numbers, const std::string& key_number) const
  {
    Json quantities = Json::object();
    for (const auto& [name, value, unit] : numbers)
      quantities[name] = {{"value", value}, {"unit", unit}, {"kind", "answer"}, {"meaning", name}};
    std::ofstream(served() / "out/storm/summary.json")
        << Json{{"quantities", quantities}, {"checks", {{"finished", true}}}, {"text", {{"title", "Storm"}, {"key_number", key_number}}}};
  }
  Json listed(const std::string& path) const
  {
    for (const Json& run : desk_->get("/api/runs").json())
      if (run.at("path") == path) return run;
    return nullptr;
  }
  int rename(const Json& path, const Json& name) const { return desk_->post("/api/runs/rename", {{"path", path}, {"name", name}}).status; }
  int note(const std::string& path, const std::string& text) const
  {
    return desk_->post("/api/runs/notes", {{"path", path}, {"text", text}}).status;
  }
  fs::path served() const { return place_ / "served"; }

  TemporaryFolder place_;
  std::optional<DeskClient> desk_;
};

TEST_F(DeskRuns, the_key_number_is_the_one_that_the_summary_names_else_the_first_answer)
{
  EXPECT_EQ(listed("out/storm").at("answer"), Json({{"name", "u_largest"}, {"value", 0.223}, {"unit", "m"}}));
  summary({{"w_end_of_push", 0.01, "m"}, {"heat.y", 2.7, "m"}, {"heat.P", 100, "N"}}, "heat.y");
  EXPECT_EQ(listed("out/storm").at("answer").at("name"), "heat.y");
  summary({{"friction_gain", 2, "1"}}, "");
  EXPECT_EQ(listed("out/storm").at("answer").at("name"), "friction_gain") << "of an earlier version the first";
}

TEST_F(DeskRuns, the_size_is_that_of_all_files)
{
  const auto before = listed("out/other").at("bytes").get<std::uintmax_t>();
  fs::create_directories(served() / "out/other/frames");
  std::ofstream(served() / "out/other/frames/0.vtu") << std::string(5000, 'x');
  std::ofstream(served() / "out/other/run.log") << "begins\n";
  EXPECT_EQ(listed("out/other").at("bytes").get<std::uintmax_t>(), before + 5007);
}

TEST_F(DeskRuns, a_run_is_renamed_in_its_place)
{
  EXPECT_EQ(rename("out/storm", "storm of the 3rd"), 200);
  EXPECT_TRUE(listed("out/storm").is_null());
  EXPECT_EQ(listed("out/storm of the 3rd").value("title", ""), "Storm");
  EXPECT_FALSE(fs::exists(served() / "out/storm of the 3rd/lock"));

  EXPECT_EQ(rename("out/other", "storm of the 3rd"), 409) << "another run has that name";
  for (const char* name : {"../other", "a/b", ".", "", "/tmp/berm_run"}) EXPECT_EQ(rename("out/other", name), 400) << name;
  for (const char* name : {"..", ".hidden", "-option", "a\nb"}) EXPECT_NE(rename("out/other", name), 200) << name;
  EXPECT_EQ(rename("out/other", 1), 400);
  EXPECT_EQ(rename("../secret/run", "x"), 403);
  EXPECT_EQ(rename("out", "x"), 404) << "it holds no run";
  fs::create_directory_symlink(place_ / "secret/run", served() / "alias");
  EXPECT_EQ(rename("alias", "x"), 403);
  const io::FolderLock lock(served() / "out/other");
  EXPECT_EQ(rename("out/other", "x"), 409) << "somebody is at work on it";
  EXPECT_TRUE(fs::exists(served() / "out/other/resolved.toml"));
  EXPECT_TRUE(fs::exists(place_ / "secret/run/resolved.toml"));
}

TEST_F(DeskRuns, notes_are_a_text_in_the_folder_of_the_run)
{
  EXPECT_FALSE(listed("out/storm").contains("notes"));
  EXPECT_EQ(note("out/storm", "too coarse\n"), 200);
  EXPECT_EQ(listed("out/storm").value("notes", ""), "too coarse\n");
  EXPECT_EQ(text_of_file(served() / "out/storm/notes.txt"), "too coarse\n");
  EXPECT_EQ(note("out/storm", ""), 200);
  EXPECT_FALSE(fs::exists(served() / "out/storm/notes.txt"));

  EXPECT_EQ(note("out/storm", std::string(10001, 'x')), 413);
  EXPECT_EQ(note("out", "x"), 404) << "it holds no run";
  EXPECT_EQ(note("../secret/run", "x"), 403);
  std::ofstream(place_ / "secret/notes") << "secret";
  fs::create_symlink(place_ / "secret/notes", served() / "out/storm/notes.txt");
  EXPECT_EQ(note("out/storm", "x"), 403);
  EXPECT_EQ(text_of_file(place_ / "secret/notes"), "secret");
  EXPECT_EQ(desk_->get("/api/runs").body.find("secret"), std::string::npos);
}

TEST_F(DeskRuns, changes_ask_for_token_host_origin_and_type)
{
  const std::string host = fmt::format("127.0.0.1:{}", desk_->port), body = R"({"path":"out/storm","name":"x","text":"x"})";
  const std::string length = fmt::format("Content-Length: {}\r\n\r\n{}", body.size(), body), json = "Content-Type: application/json\r\n";
  const auto replaced = [](std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
  };
  for (const char* target : {"/api/runs/remove", "/api/runs/rename", "/api/runs/notes"}) {
    const std::string head = desk_->head("POST", target);
    EXPECT_EQ(desk_->raw(replaced(head, desk_->token, std::string(64, 'a')) + json + length).status, 401) << target;
    EXPECT_EQ(desk_->raw(replaced(head, host, "evil.example") + json + length).status, 403) << target;
    EXPECT_EQ(desk_->raw(head + json + "Origin: http://evil.example\r\n" + length).status, 403) << target;
    EXPECT_EQ(desk_->raw(head + "Content-Type: text/plain\r\n" + length).status, 415) << target;
    EXPECT_EQ(desk_->get(target).status, 404) << target;
  }
  EXPECT_TRUE(fs::exists(served() / "out/storm/summary.json"));
  EXPECT_FALSE(fs::exists(served() / "out/storm/notes.txt"));
}

// A run says "berm: warning: ..." in a terminal, a command that answers at once "warning: ...".
TEST_F(DeskRuns, a_warning_is_not_why_a_run_ended)
{
  const auto why = [&](const std::string& messages) {
    std::ofstream(served() / "out/other.messages") << messages;
    return desk_->get("/api/run?path=out/other").json().value("why", "");
  };
  EXPECT_EQ(why("berm: no space left\n"), "berm: no space left");
  for (const char* warning : {"berm: warning: V is doubtful\n", "warning: V is doubtful\n"})
    EXPECT_NE(why(warning).find("killed"), std::string::npos) << warning;
}

TEST_F(DeskRuns, one_that_failed_before_it_had_a_folder_leaves_the_list)
{
  std::ofstream(served() / "wrong.toml") << test::small_case << "\n[nonsense]\n";
  const std::string run = desk_->post("/api/runs", {{"case", "wrong.toml"}}).json().value("path", "");
  wait_until([&] { return listed(run).value("status", "") == "failed"; });
  EXPECT_EQ(desk_->post("/api/runs/remove", {{"path", run}}).status, 200);
  EXPECT_TRUE(listed(run).is_null());
}

}  // namespace
}  // namespace berm::desk::this_file
