// SPDX-License-Identifier: BSD-3-Clause
// Links inside of a run folder that lead out of what a desk serves: nothing behind them is shown, and no command goes there.
#include "io/folder_lock.hpp"
#include "samples/desk_client.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>

namespace berm::desk::this_file {
namespace {

namespace fs = std::filesystem;

/// A finished run in a folder that is served, and a copy of it that is not, in which all numbers are a secret.
class DeskLinks : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    place_ = new TemporaryFolder;
    fs::create_directories(served());
    std::ofstream(served() / "case.toml") << test::small_case;
    EXPECT_EQ(run_program(served(), {"run", "case.toml", "-o", "run"}).status, 0);
    EXPECT_EQ(run_program(served(), {"report", "run"}).status, 0);
    fs::copy(served() / "run", secret(), fs::copy_options::recursive);
    fs::create_directories(secret() / "checkpoint");
    std::ofstream(secret() / "summary.json") << R"({"secret": "of another folder"})";
    std::ofstream(secret() / "history.schema.json") << R"({"columns": [{"name": "secret"}]})";
    std::ofstream(secret() / "origin.json") << R"({"case": "secret"})";
    std::ofstream(secret() / "run.log") << "secret\n";
    std::ofstream(secret() / "report.html") << "secret";
    desk_ = new DeskClient(served());
  }
  static void TearDownTestSuite()
  {
    delete desk_;
    delete place_;
  }
  /// A run with one of its names a link to that of the secret one.
  static std::string run_with_link(const std::string& name)
  {
    const fs::path run = served() / "linked";
    fs::remove_all(run);
    fs::copy(served() / "run", run, fs::copy_options::recursive);
    fs::remove_all(run / name);
    fs::create_symlink(secret() / name, run / name);
    return "linked";
  }
  static fs::path served() { return place_->path() / "served"; }
  static fs::path secret() { return place_->path() / "secret"; }

  static TemporaryFolder* place_;
  static DeskClient* desk_;
};
TemporaryFolder* DeskLinks::place_ = nullptr;
DeskClient* DeskLinks::desk_ = nullptr;

TEST_F(DeskLinks, nothing_behind_them_is_shown)
{
  for (const char* name :
       {"summary.json", "history.schema.json", "history.csv", "origin.json", "run.log", "report.html", "plots", "frames", "checkpoint"}) {
    const std::string run = run_with_link(name);
    for (const std::string& address : {"/api/run?path=" + run, "/api/run/soil?path=" + run, fmt::format("/api/file?path={}/{}", run, name),
                                       std::string("/api/runs"), "/api/folder?path=" + run}) {
      const Response response = desk_->get(address);
      EXPECT_NE(response.status, 0) << address;
      EXPECT_EQ(response.body.find("secret"), std::string::npos) << name << " by " << address << ": " << response.body.substr(0, 300);
    }
    EXPECT_EQ(desk_->post("/api/show", {{"path", fmt::format("{}/{}", run, name)}}).status, 403) << name;
  }
}

TEST_F(DeskLinks, are_refused_with_their_name)
{
  const auto refused = [&](const std::string& address, const std::string& link) {
    const Response response = desk_->get(address);
    EXPECT_EQ(response.status, 403) << address << " " << response.body.substr(0, 300);
    EXPECT_EQ(response.json().value("error", ""), "the link " + link + " leads out of the folder");
  };
  for (const char* name : {"summary.json", "history.schema.json"})
    refused("/api/run?path=" + run_with_link(name), fmt::format("linked/{}", name));
  refused("/api/run/soil?path=" + run_with_link("frames"), "linked/frames");
  std::string soil;
  for (const auto& file : fs::directory_iterator(served() / "run/frames"))
    if (const std::string name = file.path().filename().string(); name.ends_with(".vtu") && name > soil && !name.starts_with("rigid"))
      soil = name;
  refused("/api/run/soil?path=" + run_with_link("frames/" + soil), "linked/frames/" + soil);
}

TEST_F(DeskLinks, no_command_reads_through_them)
{
  for (const char* name : {"summary.json", "resolved.toml", "history.csv", "frames", "checkpoint"}) {
    const std::string run = run_with_link(name);
    EXPECT_EQ(desk_->post("/api/report", {{"runs", {run}}}).status, 403) << name;
    EXPECT_EQ(desk_->post("/api/export", {{"runs", {run}}, {"to", "csv"}}).status, 403) << name;
    EXPECT_EQ(desk_->post("/api/runs", {{"resume", run}}).status, 403) << name;
    EXPECT_EQ(desk_->post("/api/uncertainty", {{"path", run}}).status, 403) << name;
  }
}

TEST_F(DeskLinks, are_not_followed_when_a_run_is_removed)
{
  const auto status = [&](const std::string& path) { return desk_->post("/api/runs/remove", {{"path", path}}).status; };
  const std::string run = run_with_link("frames");
  EXPECT_EQ(status(run), 200);
  EXPECT_FALSE(fs::exists(served() / run));
  EXPECT_TRUE(fs::exists(secret() / "frames"));

  fs::create_directory_symlink(secret(), served() / "alias");
  EXPECT_EQ(status("alias"), 403);
  EXPECT_EQ(status("../secret"), 403);
  EXPECT_EQ(status("case.toml"), 404);
  EXPECT_EQ(status("run/frames"), 404) << "it is no run";
  fs::remove(served() / "alias");
  EXPECT_TRUE(fs::exists(secret() / "resolved.toml"));

  fs::copy(served() / "run/resolved.toml", served() / "resolved.toml");
  EXPECT_EQ(status(""), 403) << "the folder of the desk";
  fs::remove(served() / "resolved.toml");

  (void)run_with_link("plots");
  const auto lock = std::make_unique<io::FolderLock>(served() / "linked");
  EXPECT_EQ(status("linked"), 409) << "somebody is at work on it";
  EXPECT_TRUE(fs::exists(served() / "linked"));
}

TEST_F(DeskLinks, within_the_folder_are_followed)
{
  fs::remove_all(served() / "inner");
  fs::create_directories(served() / "inner");
  fs::create_symlink("../run/resolved.toml", served() / "inner/resolved.toml");
  fs::create_symlink("../run/summary.json", served() / "inner/summary.json");
  EXPECT_EQ(desk_->get("/api/run?path=inner").json().value("status", ""), "finished");
}

}  // namespace
}  // namespace berm::desk::this_file
