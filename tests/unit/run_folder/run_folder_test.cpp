// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/run_folder.hpp"

#include "io/atomic_file.hpp"
#include "os/error.hpp"
#include "samples/program.hpp"
#include "samples/run_to_write.hpp"

#include <csignal>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace berm::run_folder::this_file {
namespace {

namespace fs = std::filesystem;

std::string refusal(const fs::path& path)
{
  try {
    RunFolder folder(path);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

TEST(RunFolder, is_made_with_its_parents)
{
  const TemporaryFolder base;
  const RunFolder folder(base.path() / "out" / "probe" / "case");
  EXPECT_TRUE(fs::is_directory(base.path() / "out/probe/case"));
  EXPECT_EQ(folder.file("frames/mesh.vtu"), base.path() / "out/probe/case/frames/mesh.vtu");
  EXPECT_TRUE(fs::is_directory(folder.subfolder("plots")));
}

TEST(RunFolder, an_empty_folder_is_taken)
{
  const TemporaryFolder base;
  EXPECT_EQ(refusal(base.path()), "");
}

TEST(RunFolder, a_file_is_refused)
{
  const TemporaryFolder base;
  put(base.path() / "file", "mine");
  EXPECT_NE(refusal(base.path() / "file").find("not a folder"), std::string::npos);
  EXPECT_NE(refusal(base.path() / "file" / "below"), "");
  EXPECT_EQ(content_of(base.path() / "file"), "mine");
}

TEST(RunFolder, a_place_that_cannot_be_written_is_refused)
{
  EXPECT_NE(refusal("/proc/berm/run"), "");
}

TEST(RunFolder, a_folder_of_something_else_is_refused_and_left_alone)
{
  const TemporaryFolder base;
  put(base.path() / "history.csv", "mine");
  EXPECT_NE(refusal(base.path()).find("not of a run"), std::string::npos);
  EXPECT_EQ(content_of(base.path() / "history.csv"), "mine");
}

TEST(RunFolder, of_a_run_that_was_killed_as_it_began_is_taken)
{
  const TemporaryFolder base;
  fs::create_directories(base.path() / "start.part/checkpoint");
  put(base.path() / "start.part/resolved.toml.part", "[me");
  put(base.path() / "start.part/checkpoint/case_file.txt", "of another case");
  put(base.path() / io::FolderLock::file_name, "");
  const RunFolder folder(base.path());
  EXPECT_TRUE(fs::is_empty(base.path() / "start.part"));
}

/// What a run is given.
const std::vector<std::string> given = {"resolved.toml", "case.toml", "checkpoint/case_file.txt"};

void give(const fs::path& folder)
{
  fs::create_directories(folder / "checkpoint");
  for (const std::string& name : given) put(folder / name, name);
}

TEST(RunFolder, holds_all_that_a_run_is_given_or_nothing)
{
  const TemporaryFolder base;
  const RunFolder folder(base.path());
  EXPECT_THROW(folder.begin([](const fs::path& start) {
    give(start);
    throw RunError("no more");
  }),
               RunError);
  EXPECT_EQ(names_in(base.path()), std::vector<std::string>{"lock"});
  folder.begin(give);
  EXPECT_EQ(names_in(base.path()), (std::vector<std::string>{"case.toml", "checkpoint/", "lock", "resolved.toml"}));
}

TEST(RunFolder, gets_the_rest_of_what_a_run_was_given_that_was_killed_once_it_had_begun)
{
  const TemporaryFolder base;
  give(base.path() / "start.part");
  finish_start(base.path());  // not begun yet
  EXPECT_EQ(names_in(base.path()), std::vector<std::string>{"start.part/"});
  fs::rename(base.path() / "start.part/resolved.toml", base.path() / "resolved.toml");
  finish_start(base.path());
  for (const std::string& name : given) EXPECT_EQ(content_of(base.path() / name), name);
  EXPECT_FALSE(fs::exists(base.path() / "start.part"));
}

TEST(RunFolder, changes_all_that_a_run_goes_on_with_or_nothing)
{
  const TemporaryFolder base;
  for (const char* name : {"resolved.toml", "mesh.msh"}) std::ofstream(base.path() / name) << "old";
  std::optional<RunFolder> folder = RunFolder::of_earlier_run(base.path());
  const auto give_new = [](const fs::path& change) {
    for (const char* name : {"resolved.toml", "mesh.msh"}) std::ofstream(change / name) << "new";
  };
  EXPECT_THROW(folder->change([&](const fs::path& change) {
    give_new(change);
    throw RunError("no more");
  }),
               RunError);
  const auto both_are = [&](const char* text) {
    return content_of(base.path() / "resolved.toml") == text && content_of(base.path() / "mesh.msh") == text;
  };
  EXPECT_TRUE(both_are("old"));
  folder->change(give_new);
  EXPECT_TRUE(both_are("new"));
  folder.reset();
  // Killed before all was made: it goes; while files are moved: the rest follows.
  fs::create_directory(base.path() / "change.part");
  finish_start(base.path());
  EXPECT_FALSE(fs::exists(base.path() / "change.part"));
  EXPECT_TRUE(both_are("new"));
  fs::create_directory(base.path() / "start.part");
  for (const char* name : {"resolved.toml", "start.part/mesh.msh"}) std::ofstream(base.path() / name) << "newer";
  finish_start(base.path());
  EXPECT_TRUE(both_are("newer"));
}

TEST(RunFolder, of_an_earlier_run_what_berm_wrote_is_removed_and_nothing_else)
{
  const TemporaryFolder base;
  fs::create_directories(base.path() / "frames");
  fs::create_directories(base.path() / "plots");
  fs::create_directories(base.path() / "soil_of_mine");
  const std::vector<std::string> own = {"history.csv",
                                        "history.schema.json",
                                        "summary.json",
                                        "run.log",
                                        "case.toml",
                                        "resolved.toml",
                                        "mesh.geo",
                                        "mesh.msh",
                                        "curves.png",
                                        "curves.json",
                                        "soil.png",
                                        "report.html",
                                        "frames/mesh.vtu",
                                        "frames/frames.pvd",
                                        "plots/curves.gp",
                                        "report.pdf",
                                        "plots/soil.bin",
                                        "soil_overstress.png",
                                        "plots/soil_overstress.gp"};
  const std::vector<std::string> others = {"notes.txt",          "paraview.png", "plots/mine.gp",
                                           "soil_of_mine/a.png", "soils.png",    "soil_table.csv"};
  for (const auto& name : own) put(base.path() / name, "old");
  for (const auto& name : others) put(base.path() / name, "mine");
  const RunFolder folder(base.path());
  for (const auto& name : own) EXPECT_FALSE(fs::exists(base.path() / name)) << name;
  for (const auto& name : others) EXPECT_EQ(content_of(base.path() / name), "mine") << name;
}

TEST(RunFolder, what_a_link_points_to_is_not_removed)
{
  const TemporaryFolder base, elsewhere;
  put(elsewhere.path() / "precious", "mine");
  put(base.path() / "resolved.toml", "");
  fs::create_directory_symlink(elsewhere.path(), base.path() / "frames");
  const RunFolder folder(base.path());
  EXPECT_FALSE(fs::exists(fs::symlink_status(base.path() / "frames")));
  EXPECT_EQ(content_of(elsewhere.path() / "precious"), "mine");
}

TEST(WholeFile, replaces_the_old_content_and_leaves_nothing_beside)
{
  const TemporaryFolder base;
  io::write_atomically(base.path() / "a", "old and longer");
  io::write_atomically(base.path() / "a", std::string("new\0x", 5));
  EXPECT_EQ(content_of(base.path() / "a"), std::string("new\0x", 5));
  EXPECT_EQ(std::distance(fs::directory_iterator(base.path()), {}), 1);
}

// A limit on the size of files stands in for a full disk: the write stops half way.
TEST(WholeFile, a_write_that_fails_half_way_leaves_the_old_file_and_says_why)
{
  const TemporaryFolder base;
  io::write_atomically(base.path() / "a", "old");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string message;
  try {
    io::write_atomically(base.path() / "a", std::string(5000, 'x'));
  } catch (const RunError& error) {
    message = error.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("File too large"), std::string::npos) << message;
  EXPECT_EQ(content_of(base.path() / "a"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(base.path()), {}), 1);
}

TEST(WholeFile, a_missing_folder_is_named)
{
  EXPECT_THROW(io::write_atomically("/nowhere/a", "x"), RunError);
}

}  // namespace
}  // namespace berm::run_folder::this_file
