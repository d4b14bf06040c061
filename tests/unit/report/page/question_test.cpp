// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/page.hpp"

#include "samples/made_run.hpp"
#include "samples/pipe_case.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

record::RunRecord asked(const std::vector<std::string>& changes)
{
  return sample_record(sample_case(changes));
}

TEST(question, of_one_run_is_its_body_its_soil_and_its_stages)
{
  EXPECT_EQ(question_of({asked({})}), "Pipe of 20 mm in sand: push to w = 2 mm, drag 20 mm");
}

TEST(question, of_soil_without_friction_gives_its_strength)
{
  const std::string words =
      question_of({asked({"material.sand.friction_angle=0", "material.sand.dilation_angle=0", "material.sand.cohesion=2e3"})});
  EXPECT_EQ(words, "Pipe of 20 mm in sand with s_u = 2 kPa: push to w = 2 mm, drag 20 mm");
}

TEST(question, of_several_runs_is_what_they_have_in_common)
{
  EXPECT_EQ(question_of({asked({}), asked({"stage.drag.until.displacement=10e-3"})}), "Pipe of 20 mm in sand");
  record::RunRecord cable = asked({});
  cable.settings.rigid.front().first = "power_cable";
  for (auto& contact : cable.settings.contact) contact.second.rigid = "power_cable";
  for (settings::StageSettings& stage : cable.settings.stage) stage.rigid.clear();
  EXPECT_EQ(question_of({cable}), "Power cable of 20 mm in sand: push to w = 2 mm, drag 20 mm");
  EXPECT_EQ(question_of({asked({}), cable}), "") << "no common body: the page is named by titles";
}

TEST(question, counts_stages_of_one_kind_behind_one_another)
{
  record::RunRecord run = asked({});
  run.settings.stage.push_back(run.settings.stage.back());
  run.settings.stage.back().name = "back";
  EXPECT_EQ(question_of({run}), "Pipe of 20 mm in sand: push to w = 2 mm, 2 drags");
}

TEST(question, counts_pushes_in_their_plural)
{
  record::RunRecord run = asked({});
  run.settings.stage.insert(run.settings.stage.begin() + 1, run.settings.stage[1]);
  EXPECT_EQ(question_of({run}).find("pushs"), std::string::npos) << question_of({run});
  EXPECT_NE(question_of({run}).find("2 pushes, drag 20 mm"), std::string::npos) << question_of({run});
}

TEST(question, names_the_limits_that_a_run_came_to)
{
  const auto words = [](Real pushed_to, Real dragged, std::optional<Real> force) {
    record::RunRecord run = MadeRun{.pushed_to = pushed_to, .dragged = dragged}.record();
    for (settings::StageSettings& stage : run.settings.stage) {
      if (stage.kind == settings::StageKind::push) stage.until.embedment = 0.002, stage.until.force = force;
      if (stage.kind == settings::StageKind::drag) stage.until.displacement = 0.01;
    }
    return question_of({run});
  };
  EXPECT_NE(words(0.002, 0.01, {}).find("push to w = 2 mm, drag 10 mm"), std::string::npos) << words(0.002, 0.01, {});
  EXPECT_NE(words(0.001, 0.005, {}).find("push to w = 1 mm, drag 5 mm"), std::string::npos) << words(0.001, 0.005, {});
  EXPECT_NE(words(0.001, 0.01, 400).find("push to V = 0.4 kN/m, drag"), std::string::npos) << words(0.001, 0.01, 400);
}

TEST(question, of_runs_that_drive_no_body_is_not_known)
{
  record::RunRecord run = asked({});
  run.settings.rigid.clear();
  run.settings.stage.clear();
  EXPECT_EQ(question_of({run}), "");
}

/// Where a section begins in a page; npos: it has none.
std::size_t place_of(const std::string& page, const std::string& section)
{
  return page.find("<section id=\"" + section + "\"");
}

TEST(page, begins_with_the_answer_and_the_film_and_is_named_by_its_title)
{
  record::RunRecord run = asked({"title=\"A <test>\""});
  const std::string page = report_page({run});
  EXPECT_NE(page.find("<title>A &lt;test&gt;</title>"), std::string::npos);
  EXPECT_NE(page.find("<h1>A &lt;test&gt;</h1>\n<p class=\"subtitle\">Pipe of 20 mm in sand: push to w = 2 mm, drag 20 mm</p>"),
            std::string::npos);
  std::size_t last = 0;
  for (const char* section : {"answer", "soil", "curves", "model", "trust", "record"}) {
    const std::size_t place = place_of(page, section);
    ASSERT_NE(place, std::string::npos) << section;
    EXPECT_GT(place, last) << section;
    last = place;
  }
  EXPECT_EQ(place_of(page, "line"), std::string::npos);
  EXPECT_LT(page.find("href=\"#soil\""), page.find("href=\"#curves\""));
  EXPECT_LT(page.find("href=\"#curves\""), page.find("href=\"#model\""));
}

}  // namespace
}  // namespace berm::report::this_file
