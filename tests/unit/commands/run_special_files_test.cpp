// SPDX-License-Identifier: BSD-3-Clause
// What is no file where one is read, and links where a run writes.
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace berm::commands::this_file {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// A FIFO that nobody writes into, and a device without an end; `what` is what berm calls them.
struct Special {
  const char* what;
  void put(const fs::path& path) const
  {
    fs::remove_all(path);
    if (std::string(what) == "a FIFO")
      ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    else
      fs::create_symlink("/dev/zero", path);
  }
};
constexpr Special specials[] = {{"a FIFO"}, {"a device"}};

/// A command that reads a file, and the files beside it.
struct Door {
  std::string file;
  Words command;
  std::vector<std::pair<std::string, std::string>> beside;
};

/// A text with the part from `from` up to `to` replaced.
std::string with(const std::string& text, const std::string& from, const std::string& to, const std::string& by)
{
  const std::size_t first = text.find(from), end = text.find(to, first);
  EXPECT_NE(end, std::string::npos) << from;
  return text.substr(0, first) + by + text.substr(end);
}

const std::vector<Door>& doors()
{
  const std::string study = "[[case]]\nname = \"pipe\"\nfile = \"case.toml\"\n[[table]]\nfile = \"rows.csv\"\n[[measure]]\nname = "
                            "\"end\"\nquantity = \"u_end_of_drag\"\n";
  const std::string surface =
      with(test::small_space_case, "shape = \"cylinder\"", "mass = ", "shape = \"surface\"\nfile = \"stone.stl\"\n");
  const std::string law = with(test::small_case, "[material", "[body",
                               "[material.sand]\nlaw = \"umat\"\nlibrary = \"law.so\"\nproperties = [1]\ndensity = 877\nyoung_modulus = "
                               "\"7 MPa\"\npoisson_ratio = 0.25\n");
  const auto meshed = [](const char* file) {
    return with(test::small_case, "[mesh]", "[material", fmt::format("[mesh]\nkind = \"gmsh\"\nfile = \"{}\"\n", file));
  };
  static const std::vector<Door> all = {
      {"f.toml", {"check", "f.toml"}, {}},
      {"f.toml", {"draw", "f.toml"}, {}},
      {"f.toml", {"run", "f.toml", "-o", "out"}, {}},
      {"f.toml", {"study", "f.toml"}, {}},
      {"f.toml", {"element", "f.toml"}, {}},
      {"f.toml", {"envelope", "f.toml"}, {}},
      {"f.toml", {"safety", "f.toml"}, {}},
      {"rows.csv", {"study", "study.toml", "-o", "out"}, {{"study.toml", study}, {"case.toml", test::small_case}}},
      {"load.csv",
       {"check", "case.toml"},
       {{"case.toml", test::small_case + "[[stage]]\nname = \"load\"\nkind = \"drag\"\nload_history = \"load.csv\"\n"}}},
      {"stone.stl", {"check", "case.toml"}, {{"case.toml", surface}}},
      {"law.so", {"check", "case.toml"}, {{"case.toml", law}}},
      {"soil.msh", {"check", "case.toml"}, {{"case.toml", meshed("soil.msh")}}},
      {"soil.geo", {"check", "case.toml"}, {{"case.toml", meshed("soil.geo")}}},
  };
  return all;
}

TEST(SpecialFiles, are_refused_by_name_where_an_input_is_read)
{
  for (const Door& door : doors())
    for (const Special& special : specials) {
      const TemporaryFolder place;
      for (const auto& [name, text] : door.beside) place.write(name, text);
      special.put(place / door.file);
      const Ended ended = run_program(place.path(), door.command);
      const std::string words = fmt::format("berm {}, where {} is {}: {}", door.command.front(), door.file, special.what, ended.err);
      EXPECT_EQ(ended.status, 2) << words;
      EXPECT_NE(ended.err.find(door.file), std::string::npos) << words;
      EXPECT_TRUE(door.file == "soil.geo" || ended.err.find(std::string("is ") + special.what) != std::string::npos) << words;
    }
}

/// A run of a pipe, with all that it leaves.
class SpecialFilesOfRuns : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    place_ = new TemporaryFolder;
    place_->write("small.toml", test::small_case);
    ASSERT_EQ(run_program(place_->path(), {"run", "small.toml", "--threads", "1", "-o", "whole"}).status, 0);
  }
  static void TearDownTestSuite()
  {
    delete place_;
    place_ = nullptr;
  }
  /// A copy of the run folder.
  static fs::path copy()
  {
    fs::remove_all(*place_ / "copy");
    fs::copy(*place_ / "whole", *place_ / "copy", fs::copy_options::recursive);
    return *place_ / "copy";
  }
  static Ended berm(const Words& words) { return run_program(place_->path(), words); }

  static TemporaryFolder* place_;
};
TemporaryFolder* SpecialFilesOfRuns::place_ = nullptr;

TEST_F(SpecialFilesOfRuns, are_left_out_of_the_report_or_refused_by_name)
{
  for (const char* file : {"summary.json", "history.csv", "history.schema.json", "run.log", "origin.json", "frames/frames.pvd",
                           "frames/particles_0001.vtu", "soil.png", "case.toml", "resolved.toml"})
    for (const Special& special : specials) {
      const fs::path run = copy();
      special.put(run / file);
      const Ended ended = berm({"report", "copy"});
      EXPECT_TRUE(ended.status == 0 || ended.status == 2) << file << ' ' << special.what << ": " << ended.err;
      const std::string said = ended.err + text_of_file(run / "report.html");
      EXPECT_TRUE(ended.status == 0 || said.find(file) != std::string::npos) << said;
      const bool of_curves_or_film = std::string(file).starts_with("history") || std::string(file).starts_with("frames");
      EXPECT_TRUE(!of_curves_or_film || said.find(fmt::format("copy/{}: is {}", file, special.what)) != std::string::npos) << file;
    }
}

TEST_F(SpecialFilesOfRuns, frames_that_are_one_file_are_refused)
{
  const fs::path run = copy();
  std::string frames = text_of_file(run / "frames/frames.pvd");
  const std::size_t first = frames.find("<DataSet"), end = frames.find('\n', first) + 1;
  const std::string line = frames.substr(first, end - first);
  for (int k = 0; k < 18; ++k) frames.insert(first, k == 0 ? line : frames.substr(first, frames.find("<DataSet", first + 1) - first));
  std::ofstream(run / "frames/frames.pvd") << frames;
  EXPECT_EQ(berm({"report", "copy"}).status, 0);
  EXPECT_NE(text_of_file(run / "report.html").find("it names a file twice"), std::string::npos);
}

/// A run that was stopped, in the folder `stopped` beside a folder of someone else.
class LinksOfRuns : public testing::Test {
protected:
  LinksOfRuns() { place_.write("small.toml", test::small_case); }
  void stop_a_run() const
  {
    Program run(place_.path(), {"run", "small.toml", "--threads", "1", "-o", "stopped", "--set", "stage.rest.until.time=100 s"});
    ASSERT_TRUE(wait_until([&] { return text_of_file(place_ / "stopped/history.csv").size() > 2000; }));
    run.signal(SIGTERM);
    ASSERT_EQ(run.wait().status, 75);
  }
  TemporaryFolder place_;
};

TEST_F(LinksOfRuns, are_not_written_through_where_a_run_begins)
{
  fs::create_directory(place_ / "new");
  place_.write("file", "mine");
  fs::create_symlink("../file", place_ / "new/lock");
  const Ended ended = run_program(place_.path(), {"run", "small.toml", "-o", "new"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("new/lock: it is a link, and berm writes through none"), std::string::npos) << ended.err;
  EXPECT_EQ(place_.read("file"), "mine");
}

TEST_F(LinksOfRuns, are_not_written_through_where_a_run_is_resumed)
{
  stop_a_run();
  for (const char* name : {"lock", "history.csv", "run.log", "frames"}) {
    const fs::path link = place_ / (std::string("stopped/") + name), aside = place_ / "aside";
    if (fs::exists(link))
      fs::rename(link, aside);
    else
      place_.write("aside", "mine");
    fs::create_symlink("../aside", link);
    const auto holds = [&] { return fs::is_directory(aside) ? fmt::format("{}", fmt::join(names_in(aside), ",")) : text_of_file(aside); };
    const std::string before = holds();
    const Ended ended = run_program(place_.path(), {"run", "--resume", "stopped"});
    EXPECT_EQ(ended.status, 1) << name;
    EXPECT_NE(ended.err.find(fmt::format("stopped/{}: it is a link, and berm writes through none", name)), std::string::npos) << ended.err;
    EXPECT_TRUE(holds() == before) << name;
    fs::remove(link);
    if (std::string(name) == "lock")
      fs::remove(aside);
    else
      fs::rename(aside, link);
  }
}

}  // namespace
}  // namespace berm::commands::this_file
