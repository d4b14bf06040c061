// SPDX-License-Identifier: BSD-3-Clause
#include "samples/study_of_falls.hpp"

namespace berm::study::this_file {
namespace {

/// A stone that falls with the gravity of each row.
constexpr const char* falls = R"([[case]]
name = "stone"
file = "stone.toml"
[[table]]
file = "gravities.csv"
[[measure]]
name = "g"
column = "stone_vy_m_s"
measure = "acceleration"
scale = -1
)";

class StudyTables : public test::StudyOfFalls {
protected:
  StudyTables() : StudyOfFalls(falls) {}
};

TEST_F(StudyTables, have_a_run_for_each_row)
{
  folder_.write("gravities.csv", "name,gravity,material.*.density\nearth,\"[0, -10]\",1000\nmoon,\"[0, \"\"-1.6 m/s^2\"\"]\",2 g/cm^3\n");
  const Ended ended = study();
  EXPECT_EQ(ended.status, 0) << ended.err;
  const std::string table = result("results.md");
  for (const char* line : {"| case | gravities | g (m/s^2) |\n", "| stone | earth | 10 |\n", "| stone | moon | 1.6 |\n"})
    EXPECT_NE(table.find(line), std::string::npos) << line << " is not in\n" << table;
  EXPECT_EQ(names_in(folder_ / "results/runs"), (Words{"stone.earth/", "stone.moon/"}));
  EXPECT_NE(text_of_file(folder_ / "results/runs/stone.moon/resolved.toml").find("density = 2000"), std::string::npos);
}
TEST_F(StudyTables, are_refused_at_file_and_line_before_the_first_run)
{
  struct Wrong {
    std::string table, says;
  };
  for (const Wrong& wrong : std::vector<Wrong>{
           {"gravty\n1\n", "gravities.csv:2: gravty: unknown key; did you mean \"gravity\"?"},
           {"material.stone.density\n1000\nheavy\n", "gravities.csv:3: material.stone.density: \"heavy\" does not begin with a number"},
           {"material.stone.density\n1000\n\"1000,5\"\n", "gravities.csv:3: material.stone.density: \"1000,5\" has a decimal comma"},
           {"material.stone.density\n1000\n-5\n",
            "gravities.csv:3: material.stone.density: must be more than 0 kg/m^3; it is -5 kg/m^3 (./study.toml: stone, 2)"},
           {"material.ston.density\n1000\n",
            "gravities.csv:2: material.ston.density: material.ston: there is no [material.ston]; did you mean \"stone\"?"},
           {"material.stone.density (km)\n1000\n", "gravities.csv:2: material.stone.density: \"1000 km\" has the wrong dimension"},
           {"material.stone.density\n1000,2\n", "gravities.csv:2: 2 fields for 1 columns"}}) {
    folder_.write("gravities.csv", wrong.table);
    const Ended ended = study();
    EXPECT_EQ(ended.status, 2) << wrong.table;
    EXPECT_NE(ended.err.find("berm: ./" + wrong.says), std::string::npos) << ended.err << "and not\n" << wrong.says;
    EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "results")) << wrong.table;
  }
}
TEST_F(StudyTables, have_names_of_their_own_and_one_sample)
{
  folder_.write("gravities.csv", "gravity\n\"[0, -10]\"\n");
  const std::string table = "[[table]]\nfile = \"gravities.csv\"\n";
  write_study(falls + table);
  EXPECT_NE(study().err.find("study.toml:11: table.gravities: there is another axis \"gravities\""), std::string::npos) << study().err;
  write_study(falls + table + "name = \"again\"\n");
  EXPECT_NE(study().err.find("study.toml:11: table.again: is a second sample"), std::string::npos) << study().err;
}

}  // namespace
}  // namespace berm::study::this_file
