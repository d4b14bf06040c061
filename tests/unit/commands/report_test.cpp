// SPDX-License-Identifier: BSD-3-Clause
// berm report from outside: what it reads, where it writes, runs that broke off.
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <fstream>
#include <gtest/gtest.h>

namespace berm::commands::this_file {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// What is expected of the small case, and claimed of it.
const std::string expected = R"(requirement = "It ends."
derived = "there"
[run.a]
case = "a.toml"
[[expect]]
run = "a"
quantity = "finished"
least = 1
source = "s"
why = "w"
[published]
source = "A test"
[[published.claim]]
statement = "The pipe is dragged"
where = "1"
why = "It counts as far as it comes."
runs = ["a"]
expect = [{label = "H", quantity = "H_at_part", at = 1, least = "0 N/m"}]
)";

/// A folder with two runs of the small case, out/a and out/b, made once for all tests, and a copy of it for each.
class Report : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    made_ = new TemporaryFolder;
    made_->write("a.toml", test::small_case);
    made_->write("b.toml", test::small_case);
    made_->write("expected.toml", expected);
    const Ended ended = run_program(made_->path(), {"run", "a.toml", "b.toml", "-o", "out", "--threads", "1"});
    ASSERT_EQ(ended.status, 0) << ended.err;
  }
  static void TearDownTestSuite() { delete made_; }

  Report() { fs::copy(*made_ / "out", place_ / "out", fs::copy_options::recursive); }
  Ended berm(const Words& arguments, const Words& environment = {}) const { return run_program(place_.path(), arguments, environment); }
  std::string text(const std::string& file) const { return text_of_file(place_ / file); }
  fs::path file(const std::string& name) const { return place_ / name; }
  void cut(const std::string& name, double part) const
  {
    const fs::path path = file(name);
    fs::resize_file(path, static_cast<std::uintmax_t>(part * static_cast<double>(fs::file_size(path))));
  }

private:
  static TemporaryFolder* made_;
  TemporaryFolder place_;
};
TemporaryFolder* Report::made_ = nullptr;

TEST_F(Report, of_one_run_lies_in_its_folder_and_of_several_beside_them)
{
  const Ended one = berm({"report", "out/a"});
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(one.out.find("out/a/report.html"), 0u) << one.out;
  EXPECT_TRUE(fs::exists(file("out/a/report.html")));
  const Ended both = berm({"report", "out/a", "out/b"});
  EXPECT_EQ(both.status, 0) << both.err;
  EXPECT_TRUE(fs::exists(file("out/report.html")));
  EXPECT_EQ(berm({"report", "out", "-o", "page.html"}).status, 0);
  EXPECT_EQ(text("page.html"), text("out/report.html"));
}

TEST_F(Report, reads_what_is_expected_where_the_run_took_it_along_or_where_it_is_named)
{
  ASSERT_EQ(text("out/a/expected.toml"), expected);
  ASSERT_EQ(berm({"report", "out/a"}).status, 0);
  EXPECT_NE(text("out/a/report.html").find("The pipe is dragged"), std::string::npos);
  EXPECT_NE(text("out/a/report.html").find("id=\"expected-table\""), std::string::npos);
  ASSERT_EQ(berm({"report", "out/b"}).status, 0);
  EXPECT_EQ(text("out/b/report.html").find("The pipe is dragged"), std::string::npos) << "nothing is expected of b.toml";

  std::ofstream(file("other.toml")) << "missing = 3\n" << expected;
  const Ended wrong = berm({"report", "out/a", "--expected", "other.toml"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("other.toml:1: "), std::string::npos) << wrong.err;
  const Ended former = berm({"report", "out/a", "--claims", "other.toml"});
  EXPECT_EQ(former.status, 2);
  EXPECT_NE(former.err.find("--expected"), std::string::npos) << former.err;

  std::ofstream(file("out/a/expected.toml")) << "run = 3\n";
  EXPECT_EQ(berm({"report", "out/a"}).status, 0) << "a run whose expected.toml is damaged is shown without it";
  EXPECT_NE(text("out/a/report.html").find("its expected values are left out"), std::string::npos);
}

TEST_F(Report, passes_over_what_an_earlier_report_wrote)
{
  ASSERT_EQ(berm({"report", "out", "--figures"}).status, 0);
  ASSERT_TRUE(fs::exists(file("out/report_figures")));
  const Ended again = berm({"report", "out/a", "out/b", "out/report.html", "out/report_figures"});
  EXPECT_EQ(again.status, 0) << again.err;
}

TEST_F(Report, draws_figures_for_print)
{
  ASSERT_EQ(berm({"report", "out", "--figures"}, {with_pictures()}).status, 0);
  for (const char* name : {"V_w", "H_u", "w_u", "H_over_V_u", "a_energies", "b_contact", "a_soil", "a_mechanism", "b_soil"})
    for (const char* ending : {".svg", ".png"})
      EXPECT_TRUE(fs::exists(file(std::string("out/report_figures/") + name + ending))) << name << ending;
}

TEST_F(Report, draws_no_figures_through_a_link)
{
  fs::remove_all(file("out/report_figures"));
  fs::create_directory(file("elsewhere"));
  fs::create_directory_symlink("../elsewhere", file("out/report_figures"));
  const Ended ended = berm({"report", "out", "--figures"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("it is a link, and berm writes through none"), std::string::npos) << ended.err;
  EXPECT_TRUE(fs::is_empty(file("elsewhere")));
  fs::remove(file("out/report_figures"));
  fs::remove(file("elsewhere"));
}

TEST_F(Report, needs_no_other_file)
{
  ASSERT_EQ(berm({"report", "out/a"}).status, 0);
  const std::string page = text("out/a/report.html");
  std::string markup = page.substr(0, page.find("<script"));  // what scripts do is tested in a browser
  const std::string picture = "<img src=\"data:image/png;base64,";
  const std::size_t look = markup.find("id=\"first-look\">"), figure = markup.find("<figure>" + picture);
  EXPECT_TRUE(look < figure && figure < markup.find("<section", look)) << "the soil stands beside the answer";
  for (std::size_t at; (at = markup.find(picture)) != std::string::npos;) markup.erase(at, picture.size());
  for (const char* fetched : {"<link", "src=", "@import", "url("}) EXPECT_EQ(markup.find(fetched), std::string::npos) << fetched;
  EXPECT_NE(page.find("\"V_N_m\""), std::string::npos);
  EXPECT_NE(page.find("id=\"film-0-position\""), std::string::npos);
}

TEST_F(Report, of_a_run_that_broke_off_says_so_and_shows_what_there_is)
{
  fs::remove(file("out/a/summary.json"));
  cut("out/a/history.csv", 0.6);
  cut("out/a/frames/particles_0003.vtu", 0.5);
  const Ended ended = berm({"report", "out/a"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string page = text("out/a/report.html");
  EXPECT_NE(page.find("has not finished"), std::string::npos);
  EXPECT_NE(page.find("frame 4 of"), std::string::npos) << "the damaged frame is not told";
  EXPECT_NE(page.find("id=\"film-0-position\""), std::string::npos);
  EXPECT_NE(page.find("\"V_N_m\""), std::string::npos);
}

TEST_F(Report, of_a_run_with_nothing_but_its_case_says_what_is_missing)
{
  for (const char* name : {"summary.json", "history.csv", "run.log", "frames"}) fs::remove_all(file("out/a") / name);
  const Ended ended = berm({"report", "out/a"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string page = text("out/a/report.html");
  for (const char* said : {"has not finished", "history.csv is missing", "run.log is missing"})
    EXPECT_NE(page.find(said), std::string::npos) << said;
}

TEST_F(Report, of_damaged_files_says_which)
{
  std::ofstream(file("out/a/summary.json")) << "{\"quantities\": [";
  std::ofstream(file("out/a/history.csv")) << "time_s,stage,u_m\n0,push,nonsense\n";
  std::ofstream(file("out/a/frames/frames.pvd")) << "<VTKFile>";
  const Ended ended = berm({"report", "out/a"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string page = text("out/a/report.html");
  for (const char* said : {"summary.json is damaged", "is of another history"}) EXPECT_NE(page.find(said), std::string::npos) << said;
}

TEST_F(Report, takes_no_ground_from_a_damaged_file)
{
  const auto faults = [&](const std::string& corners) {
    std::ofstream(file("out/a/ground.csv")) << "x_m,y_m\n" << corners;
    EXPECT_EQ(berm({"report", "out/a"}).status, 0);
    return text("out/a/report.html").find("ground.csv is damaged") != std::string::npos;
  };
  EXPECT_FALSE(faults("-1,0\n0.5,0\n0.5,-0.1\n1,0.2\n"));
  for (const char* corners : {"", "-1,0\n", "-1,0\n1,nan\n", "-1,0\n1,inf\n", "1,0\n-1,0.2\n", "-1,0\n1,\n", "-1,0\n1,0.2,3\n"})
    EXPECT_TRUE(faults(corners)) << corners;
}

TEST_F(Report, of_several_runs_leaves_out_one_that_cannot_be_read_and_says_so)
{
  std::ofstream(file("out/b/resolved.toml")) << "title = 3\n";
  const Ended ended = berm({"report", "out/a", "out/b"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("b is left out"), std::string::npos) << ended.err;
  EXPECT_NE(text("out/report.html").find("b is left out"), std::string::npos);
}

TEST_F(Report, takes_a_folder_where_a_file_should_be_as_damaged)
{
  fs::remove(file("out/a/summary.json"));
  fs::create_directory(file("out/a/summary.json"));
  cut("out/a/frames/frames.pvd", 0.7);
  const Ended ended = berm({"report", "out/a"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(text("out/a/report.html").find("summary.json is damaged"), std::string::npos);
  EXPECT_NE(text("out/a/report.html").find("frames.pvd"), std::string::npos);
}

TEST_F(Report, tells_that_a_finished_run_lost_the_end_of_its_history)
{
  cut("out/a/history.csv", 0.3);
  ASSERT_EQ(berm({"report", "out/a"}).status, 0);
  EXPECT_NE(text("out/a/report.html").find("although the run finished: it was truncated"), std::string::npos);
}

TEST_F(Report, says_why_a_run_was_stopped)
{
  std::string summary = text("out/a/summary.json"), log = text("out/a/run.log");
  const std::string finished = "\"finished\": true", last = "everything is in";
  ASSERT_NE(summary.find(finished), std::string::npos);
  summary.replace(summary.find(finished), finished.size(), "\"finished\": false");
  log.insert(log.rfind('\n', log.find(last)) + 1, "2026-01-31 12:00:00 warning: stopped at t = 0.4 s in stage \"push\"\n");
  std::ofstream(file("out/a/summary.json")) << summary;
  std::ofstream(file("out/a/run.log")) << log;
  ASSERT_EQ(berm({"report", "out/a"}).status, 0);
  EXPECT_NE(text("out/a/report.html").find("Its message: stopped at t = 0.4 s"), std::string::npos);
}

TEST_F(Report, finds_the_runs_of_a_study_and_writes_beside_them)
{
  fs::create_directories(file("study/runs"));
  fs::copy(file("out/a"), file("study/runs/a"), fs::copy_options::recursive);
  const Ended ended = berm({"report", "study"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(fs::exists(file("study/report.html")));
}

TEST_F(Report, tells_runs_of_one_name_apart)
{
  fs::create_directory(file("other"));
  fs::copy(file("out/b"), file("other/a"), fs::copy_options::recursive);
  const Ended ended = berm({"report", "out/a", "other/a", "out/../out/a", "--figures", "-o", "page.html"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string page = text("page.html");
  EXPECT_NE(page.find("2 runs"), std::string::npos);
  for (const char* name : {"out/a", "other/a"}) EXPECT_NE(page.find(name), std::string::npos) << name;
  for (const char* name : {"out_a_soil.png", "other_a_soil.png"}) EXPECT_TRUE(fs::exists(file("report_figures") / name)) << name;
}

TEST_F(Report, names_of_folders_run_nothing_and_are_no_markup)
{
  const std::string name = "<touch pwned; +';system(\"touch pwned\");y='z <img src=x>\xff";
  fs::rename(file("out/a"), file("out") / name);
  const Ended ended = berm({"report", "out", "--figures", "-o", "page.html"}, {with_pictures()});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_FALSE(fs::exists(file("pwned")));
  EXPECT_FALSE(fs::exists(file("report_figures/plots/pwned")));
  EXPECT_EQ(ended.err.find("not drawn"), std::string::npos) << ended.err;
  const std::string page = text("page.html"), markup = page.substr(0, page.find("<script"));
  EXPECT_EQ(markup.find("<img src=x"), std::string::npos);
  EXPECT_EQ(page.find('\xff'), std::string::npos);
}

TEST_F(Report, refuses_what_is_no_run_folder)
{
  fs::create_directory(file("empty"));
  for (const auto& [name, said] :
       {std::pair{"nowhere", "there is no such folder"}, {"out/a/history.csv", "is a file"}, {"empty", "is not a run folder"}}) {
    const Ended ended = berm({"report", name});
    EXPECT_EQ(ended.status, 2) << name;
    EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find(name), std::string::npos) << ended.err;
  }
  std::ofstream(file("out/a/resolved.toml")) << "title = 3\n";
  const Ended broken = berm({"report", "out/a"});
  EXPECT_EQ(broken.status, 2);
  EXPECT_NE(broken.err.find("resolved.toml"), std::string::npos) << broken.err;
}

TEST_F(Report, writes_a_word_document_with_title_numbers_and_pictures_or_says_what_is_missing)
{
  const Ended ended = berm({"report", "out/a", "--docx"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("out/a/report.docx"), std::string::npos) << ended.out;
  std::ofstream(file("read.py")) << ("import re, sys, zipfile\nword = zipfile.ZipFile('out/a/report.docx')\n"
                                     "print(sum(name.endswith('.png') for name in word.namelist()))\n"
                                     "print(re.sub('<[^>]+>', '', word.read('word/document.xml').decode()))\n");
  ASSERT_EQ(std::system(("cd '" + file("").string() + "' && python3 -B read.py > words.txt").c_str()), 0);
  const std::string words = text("words.txt");
  EXPECT_NE(words.find("Reliability"), std::string::npos) << words;
  EXPECT_NE(words.find("Largest lateral resistance"), std::string::npos) << words;
  EXPECT_GT(std::atoi(words.c_str()), 1) << "pictures";
  const Ended without = berm({"report", "out/b", "--docx"}, {"PATH=/nowhere"});
  EXPECT_NE(without.err.find("--docx: pandoc is not installed; install it"), std::string::npos) << without.err;
  EXPECT_FALSE(fs::exists(file("out/b/report.docx")));
}
TEST_F(Report, refuses_to_name_its_page_as_a_pdf)
{
  for (const char* name : {"page.pdf", "page.PDF"})
    for (const Words& more : {Words{}, Words{"--pdf"}}) {
      Words words{"report", "out/a", "-o", name};
      words.insert(words.end(), more.begin(), more.end());
      const Ended ended = berm(words);
      EXPECT_EQ(ended.status, 2);
      for (const char* part : {name, "page.html", "--pdf writes page.pdf"}) EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
      EXPECT_FALSE(fs::exists(file(name)));
    }
}

TEST_F(Report, that_cannot_be_written_fails)
{
  const Ended ended = berm({"report", "out/a", "-o", "nowhere/page.html"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("nowhere/page.html"), std::string::npos) << ended.err;
}

TEST_F(Report, a_new_run_removes_the_old_page)
{
  ASSERT_EQ(berm({"report", "out/a"}).status, 0);
  std::ofstream(file("a.toml")) << test::small_case;
  ASSERT_EQ(berm({"run", "a.toml", "-o", "out/a", "--threads", "1", "--force"}).status, 0);
  EXPECT_FALSE(fs::exists(file("out/a/report.html")));
}

}  // namespace
}  // namespace berm::commands::this_file
