// SPDX-License-Identifier: BSD-3-Clause
#include "report/origin/origin_section.hpp"

#include "samples/pipe_case.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

record::RunRecord sample_run(const std::vector<std::string>& changes = {})
{
  record::RunRecord run;
  run.name = "case";
  run.settings = sample_case(changes);
  return run;
}

TEST(origin_section, shows_what_the_case_gives_of_its_document_and_nothing_else)
{
  const record::RunRecord run = sample_run({"report.project=\"Pipeline <A>\"", "report.revision=B", "report.checker=\"C. Checker\""});
  for (const std::string& html : {document_lines(run), origin_section({run})}) {
    for (const char* shown : {"Project", "Pipeline &lt;A&gt;", "Revision", "Checked by", "C. Checker"})
      EXPECT_NE(html.find(shown), std::string::npos) << shown << " in " << html;
    for (const char* hidden : {"Client", "Author", "<A>"}) EXPECT_EQ(html.find(hidden), std::string::npos) << hidden;
  }
  EXPECT_EQ(document_foot(run), "Pipeline <A>, revision B");
  EXPECT_EQ(document_lines(sample_run()), "");
  EXPECT_EQ(document_foot(sample_run()), "");
  EXPECT_EQ(origin_section({sample_run()}).find("id=\"documents\""), std::string::npos);
}

TEST(origin_section, shows_the_digests_of_input_and_program_and_when_it_was_resumed)
{
  record::RunRecord run = sample_run();
  run.begun = "2026-01-31T12:00:00Z";
  run.origin = run_folder::Origin{
      {{"case.toml", "11aa"}, {"resolved.toml", "22bb"}},
      {{run.begun, "0.1.0", "optimized", {{"berm", "33cc"}}}, {"2026-02-01T00:00:00Z", "0.1.1", "optimized", {{"berm", "44dd"}}, true}}};
  run.summary = run_folder::RunSummary{};
  run.summary->text["date"] = "2026-02-01T01:00:00Z";
  const std::string html = origin_section({run});
  for (const char* shown : {"2026-01-31T12:00:00Z", "2026-02-01T01:00:00Z", "SHA-256 of case.toml", "11aa", "22bb", "33cc", "44dd",
                            "berm 0.1.1", "resumed (UTC)", "gravity level", "not compared with the text of the code"})
    EXPECT_NE(html.find(shown), std::string::npos) << shown << " in " << html;
}

TEST(origin_section, shows_the_program_again_where_a_resumption_used_another_vector_unit)
{
  record::RunRecord run = sample_run();
  run.begun = "2026-01-31T12:00:00Z";
  run.origin = run_folder::Origin{{}, {{run.begun, "0.1.0", "vector unit AVX2", {{"berm", "33cc"}}}}};
  run.origin->sessions.push_back({"2026-02-01T00:00:00Z", "0.1.0", "vector unit AVX2", {{"berm", "33cc"}}, true});
  EXPECT_EQ(origin_section({run}).find("program, resumed"), std::string::npos);
  run.origin->sessions.back().build = "vector unit AVX-512";
  const std::string html = origin_section({run});
  for (const char* shown : {"program, resumed 2026-02-01T00:00:00Z", "AVX-512", "AVX2"})
    EXPECT_NE(html.find(shown), std::string::npos) << html;
}

TEST(origin_section, of_a_run_whose_beginning_is_not_known_says_so)
{
  record::RunRecord run = sample_run();
  run.begun = "2026-01-31 12:00:00";  // by its log
  run.origin = run_folder::Origin{{}, {{"2026-02-01T00:00:00Z", "0.1.1", "optimized", {{"berm", "44dd"}}, true}}};
  const std::string html = origin_section({run});
  for (const char* shown :
       {"2026-01-31 12:00:00 (local time)", "resumed (UTC)", "origin.json was missing or damaged", "program, resumed", "44dd"})
    EXPECT_NE(html.find(shown), std::string::npos) << shown << " in " << html;
}

TEST(origin_section, says_from_which_surface_w_counts_on_uneven_ground)
{
  record::RunRecord run = sample_run();
  EXPECT_EQ(origin_section({run}).find("under the axis"), std::string::npos);
  run.ground.line.corners = {Vec<2>(-1, 0), Vec<2>(1, 0.1)};
  EXPECT_NE(origin_section({run}).find("under the axis"), std::string::npos);
}

TEST(origin_section, of_a_run_without_a_note_says_so_and_tells_local_time)
{
  record::RunRecord run = sample_run();
  run.begun = "2026-01-31 12:00:00";
  const std::string html = origin_section({run});
  EXPECT_NE(html.find("2026-01-31 12:00:00 (local time)"), std::string::npos) << html;
  EXPECT_NE(html.find("made by an earlier version"), std::string::npos);
  EXPECT_EQ(html.find("sha256sum"), std::string::npos);
}

}  // namespace
}  // namespace berm::report::this_file
