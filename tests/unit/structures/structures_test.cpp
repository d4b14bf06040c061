// SPDX-License-Identifier: BSD-3-Clause
#include "structures/structures.hpp"

#include "input/read_case.hpp"
#include "input/structure_words.hpp"
#include "os/error.hpp"
#include "samples/made_run.hpp"
#include "samples/temporary_folder.hpp"
#include "samples/wrong_inputs.hpp"
#include "structures/base/driven_body.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace berm::structures::this_file {
namespace {

/// Cases of a pipe, of a footing, and of one whose bodies nothing drives.
settings::Case footing()
{
  settings::Case c = MadeRun{}.settings();
  c.rigid[0].first = c.contact[0].second.rigid = "strip_footing";
  c.rigid[0].second.shape = bodies::BoxSettings{{0, 0.01}, {0.04, 0.02}, 0};
  for (settings::StageSettings& stage : c.stage) stage.rigid = "strip_footing";
  return c;
}
settings::Case free_bodies()
{
  settings::Case c = MadeRun{}.settings();
  c.stage = {MadeRun::stage_of("fall", settings::StageKind::free)};
  return c;
}

TEST(Structures, one_applies_to_each_case_and_the_last_to_every_case)
{
  const std::vector<base::Structure>& all = all_structures();
  EXPECT_EQ(&structure_of(MadeRun{}.settings()), &all[all.size() - 2]);
  EXPECT_NE(&structure_of(footing()), &structure_of(MadeRun{}.settings()));
  EXPECT_EQ(&structure_of(free_bodies()), &all.back());
  for (const settings::Case& c : {MadeRun{}.settings(), footing(), free_bodies(), settings::Case{}}) EXPECT_TRUE(all.back().applies_to(c));
}

/// The message that refuses a case of a pipe in plane strain, or of a ball around an axis, whose body is called this; "" where it is taken.
std::string refusal(const std::string& word, bool around_an_axis)
{
  std::string text(test::good_case);
  const auto replace = [&](const std::string& from, const std::string& to) { text.replace(text.find(from), from.size(), to); };
  if (around_an_axis) {
    replace("gravity = [0", "geometry = \"axisymmetric\"\ngravity = [0");
    replace("center = [1.0, \"1.4 m\"]", "center = [0, \"1.4 m\"]");
    replace("mass = \"430 kg/m\"", "mass = \"430 kg\"");
    replace("kind = \"drag\"\nvelocity", "kind = \"push\"\nvelocity");
  }
  replace("[rigid.pipe]\n", "[rigid.pipe]\nstructure = \"" + word + "\"\n");
  const TemporaryFolder folder;
  try {
    EXPECT_EQ(input::case_of(folder.write("case.toml", text)).settings.rigid[0].second.structure, word);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Structures, the_input_names_one_that_there_is_and_that_the_geometry_can_have)
{
  ASSERT_EQ(input::structure_words().size(), all_structures().size());
  for (const base::Structure& structure : all_structures()) {
    const auto words = std::ranges::find_if(input::structure_words(),
                                            [&](const input::StructureWord& one) { return one.word == std::string(structure.word); });
    ASSERT_NE(words, input::structure_words().end()) << structure.word;
    EXPECT_EQ(refusal(structure.word, true).empty(), words->geometry != input::StructureGeometry::plane) << structure.word;
    EXPECT_EQ(refusal(structure.word, false).empty(), words->geometry != input::StructureGeometry::round) << structure.word;
  }
  EXPECT_EQ(refusal("automatic", false), "");
  const auto expect = [](const std::string& message, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  const std::string line = std::string(test::good_case.substr(0, test::good_case.find("[rigid.pipe]")));
  const std::string place = fmt::format("case.toml:{}: rigid.pipe.structure: ", std::count(line.begin(), line.end(), '\n') + 2);
  expect(refusal("bal", false),
         {place, "did you mean \"ball\"", "allowed: automatic, cone, ball, t_bar, pile, skirt, footing, anchor, pipeline, pipe, other"});
  expect(refusal("t_bar", true), {"is loaded normal to its axis", "needs geometry = \"plane_strain\""});
  expect(refusal("cone", false), {place, "is round: it needs geometry"});
}

TEST(Structures, have_words_among_which_are_those_that_berm_finds_itself_and_which_params_lists)
{
  const input::Listed all = input::case_catalogue();
  const auto of = [](const input::Listed& table, const std::string& key) {
    return *std::ranges::find(table.children, key, &input::Listed::key);
  };
  const input::Listed listed = of(of(all, "rigid"), "structure");
  EXPECT_EQ(listed.words.size(), all_structures().size() + 1);
  EXPECT_EQ(listed.default_text, "automatic");
  for (const settings::Case& c : {MadeRun{}.settings(), footing(), free_bodies()})
    EXPECT_NE(std::ranges::find(listed.words, base::kind_of(c)), listed.words.end());
}

TEST(Structures, tell_what_they_have_of_a_run_and_nothing_of_one_without_rows)
{
  const MadeRun made;
  const base::Structure& pipe = structure_of(made.settings());
  EXPECT_FALSE(pipe.quantities(made.record(), {}).empty());
  record::RunRecord without_rows = made.record(), of_free_bodies = made.record();
  without_rows.history = {};
  of_free_bodies.settings = free_bodies();
  EXPECT_TRUE(pipe.quantities(without_rows, {}).empty());
  EXPECT_TRUE(structure_of(free_bodies()).quantities(of_free_bodies, {}).empty());
  EXPECT_EQ(structure_of(free_bodies()).table_of(of_free_bodies), "");
}

TEST(Structures, measure_forces_by_the_region_below_the_body)
{
  record::RunRecord run = MadeRun{}.record();
  const base::Structure& pipe = structure_of(run.settings);
  const auto bare_V = [&] {
    run.quantities = pipe.quantities(run, {});
    const run_folder::Quantity* bare = run.quantity("V_at_w_0.1D_over_gammaD2");
    return bare == nullptr ? 0 : bare->value;
  };
  const Real in_own_soil = bare_V();
  material::MohrCoulomb heavy = MadeRun::sand_law();
  heavy.density *= 2;
  run.settings.material.emplace_back("heavy", heavy);
  run.settings.body[0].second.regions = {"bed", "filled"};
  run.settings.body[0].second.region_material = {{"filled", "heavy"}};
  run.summary.emplace().text[base::region_entry] = "filled";
  EXPECT_GT(in_own_soil, 0);
  EXPECT_NEAR(bare_V(), in_own_soil / 2, 1e-9 * in_own_soil);
}

TEST(Structures, measure_a_driven_body_by_its_own_name)
{
  const settings::Case c = footing();
  bool named = false;
  for (const base::TrustMeasure& measure : structure_of(c).measures(c)) {
    named = named || measure.what == "cells at the strip footing";
    EXPECT_EQ(measure.what.find("pipe"), std::string::npos) << measure.what;
  }
  EXPECT_TRUE(named);
  EXPECT_EQ(base::body_scale(c).width, 0.04);
}

TEST(Structures, without_a_driven_body_have_the_measures_of_any_run)
{
  const settings::Case c = free_bodies();
  std::vector<std::string> what;
  for (const base::TrustMeasure& measure : structure_of(c).measures(c)) what.push_back(measure.what);
  EXPECT_EQ(what.size(), 16u);
  EXPECT_EQ(std::count(what.begin(), what.end(), "momentum that does not balance"), 1);
  EXPECT_FALSE(structure_of(c).details(MadeRun{}.record()).find);
}

TEST(Structures, have_no_envelope_where_they_know_none)
{
  EXPECT_THROW(structure_of(free_bodies()).embedded(free_bodies()), InputError);
}

}  // namespace
}  // namespace berm::structures::this_file
