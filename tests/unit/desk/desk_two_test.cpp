// SPDX-License-Identifier: BSD-3-Clause
// Two desks on one folder, and what lies in the way of their messages.
#include "desk/folder.hpp"
#include "desk/queue.hpp"
#include "samples/desk_client.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace berm::desk::this_file {
namespace {

namespace fs = std::filesystem;
using Reply = nlohmann::json;

class TwoDesks : public testing::Test {
protected:
  TwoDesks()
  {
    std::ofstream(folder_ / "case.toml") << test::small_case;
    const std::string velocity = "velocity = \"1 m/s\"";
    std::string text = test::small_case;
    std::ofstream(folder_ / "long.toml") << text.replace(text.rfind(velocity), velocity.size(), "velocity = \"1 mm/s\"");
  }
  static std::string status_of(const DeskClient& desk, const std::string& run)
  {
    return desk.get("/api/run?path=" + run).json().value("status", "");
  }

  TemporaryFolder folder_;
};

TEST_F(TwoDesks, give_two_runs_of_a_case_two_places)
{
  const DeskClient one(folder_.path(), {"--threads", "1"}), other(folder_.path(), {"--threads", "1"});
  // The first desk's queue is full: its second run waits, and has a place without a folder.
  const std::string at_work = one.post("/api/runs", {{"case", "long.toml"}}).json().value("path", "");
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder_ / at_work / "history.csv"); }));
  const std::string first = one.post("/api/runs", {{"case", "case.toml"}}).json().value("path", "");
  EXPECT_EQ(status_of(one, first), "queued");
  const std::string second = other.post("/api/runs", {{"case", "case.toml"}}).json().value("path", "");
  EXPECT_EQ(second, first + "_2");
  EXPECT_EQ(other.post("/api/runs", {{"case", "case.toml"}, {"out", first}}).status, 409);
  EXPECT_TRUE(wait_until([&] { return status_of(other, second) == "finished"; }));
  EXPECT_EQ(one.post("/api/runs/stop", {{"path", first}}).status, 200);
  EXPECT_FALSE(fs::exists(folder_ / (first + ".messages"))) << "what never began leaves nothing";
  EXPECT_EQ(one.post("/api/runs/stop", {{"path", at_work}}).status, 200);
  ASSERT_TRUE(wait_until([&] { return status_of(one, at_work) == "stopped"; }));

  // Both resume it: the second is refused, and says what became of the run.
  EXPECT_EQ(one.post("/api/runs", {{"resume", at_work}}).status, 200);
  EXPECT_EQ(other.post("/api/runs", {{"resume", at_work}}).status, 409);
  ASSERT_TRUE(wait_until([&] { return status_of(other, at_work) == "running"; }));
  EXPECT_EQ(other.post("/api/runs/stop", {{"path", at_work}}).status, 200);
  EXPECT_TRUE(wait_until([&] { return status_of(one, at_work) == "stopped" && status_of(other, at_work) == "stopped"; }));
}

// A desk whose command came too late does not say "failed" of what another finished.
TEST_F(TwoDesks, say_how_a_run_is_after_others_were_at_work_there)
{
  const DeskClient desk(folder_.path(), {"--threads", "1"});
  fs::create_directories(folder_ / "out");
  std::ofstream(folder_ / "wrong.toml") << "x = 1";
  const std::string run = desk.post("/api/runs", {{"case", "wrong.toml"}}).json().value("path", "");
  ASSERT_TRUE(wait_until([&] { return status_of(desk, run) == "failed"; }));
  ASSERT_EQ(run_program(folder_.path(), {"run", "case.toml", "-o", run}).status, 0);
  EXPECT_EQ(status_of(desk, run), "finished");
}

TEST_F(TwoDesks, messages_are_of_one_command)
{
  Work work;
  work.name = "run";
  work.folder = folder_ / "run";
  {
    MessagesFile held(work);
    EXPECT_THROW(MessagesFile second(work), Refusal);
    EXPECT_TRUE(fs::exists(work.messages()));
    EXPECT_GE(held.given(), 0);
    held.end(true);
    EXPECT_NO_THROW(MessagesFile second(work));
  }
  EXPECT_NO_THROW(MessagesFile again(work));
}

TEST_F(TwoDesks, are_not_held_by_a_fifo_where_messages_go)
{
  const DeskClient desk(folder_.path());
  fs::create_directories(folder_ / "out");
  ASSERT_EQ(::mkfifo((folder_ / "out/case.messages").c_str(), 0600), 0);
  const Response refused = desk.post("/api/runs", {{"case", "case.toml"}, {"out", "out/case"}});
  EXPECT_EQ(refused.status, 409) << refused.body;
  EXPECT_NE(refused.json().value("error", "").find("case.messages: it is not a regular file"), std::string::npos) << refused.body;
  EXPECT_EQ(desk.get("/api/runs").status, 200);
  // Without a name it goes to the next place.
  EXPECT_EQ(desk.post("/api/runs", {{"case", "case.toml"}}).json().value("path", ""), "out/case_2");
}

}  // namespace
}  // namespace berm::desk::this_file
