// SPDX-License-Identifier: BSD-3-Clause
// Cone penetration tests in files of AGS 4, GEF and tables: exact numbers, and what is refused, with file, line, column and unit.
#include "site/sounding.hpp"

#include "os/error.hpp"
#include "samples/error_of.hpp"
#include "samples/temporary_folder.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::site::this_file {
namespace {

constexpr const char* ags = R"("GROUP","PROJ"
"HEADING","PROJ_ID"
"UNIT",""
"TYPE","ID"
"DATA","made"

"GROUP","SCPG"
"HEADING","LOCA_ID","SCPG_TESN","SCPG_CAR"
"UNIT","","",""
"TYPE","ID","X","2DP"
"DATA","CPT1","1","0.80"
"DATA","CPT2","1",""

"GROUP","SCPT"
"HEADING","LOCA_ID","SCPG_TESN","SCPT_DPTH","SCPT_RES","SCPT_FRES","SCPT_PWP2","SCPT_REM"
"UNIT","","","m","MN/m2","kN/m2","kN/m2",""
"TYPE","ID","X","2DP","3DP","2DP","2DP","X"
"DATA","CPT1","1","0.02","0.100","2.00","10.00","first, of two"
"DATA","CPT1","1","0.04","0.200","","20.00",""
"DATA","CPT1","1","0.06","0.300","6.00","30.00",""
"DATA","CPT2","1","0.02","1.000","5.00","10.00",""
"DATA","CPT2","1","0.04","2.000","5.00","20.00",""
)";

constexpr const char* gef = R"(#GEFID= 1, 1, 0
#REPORTCODE= GEF-CPT-Report, 1, 1, 2
#COLUMN= 5
#COLUMNINFO= 1, m, penetration length, 1
#COLUMNINFO= 2, MPa, cone resistance, 2
#COLUMNINFO= 3, MPa, sleeve friction, 3
#COLUMNINFO= 4, kPa, pore pressure, 6
#COLUMNINFO= 5, deg, inclination, 8
#COLUMNVOID= 2, -9999.000000
#MEASUREMENTVAR= 3, 0.75, -, area ratio
#EOH=
0.02 1.0 0.010 40.0 0.1
0.04 -9999.0 0.020 40.0 0.1
0.06 3.0 0.030 40.0 0.1
)";

class Soundings : public testing::Test {
protected:
  Sounding read(const std::string& name, const std::string& text, const std::string& location = "") const
  {
    folder_.write(name, text);
    return read_sounding(folder_ / name, location);
  }
  std::string refusal(const std::string& name, const std::string& text, const std::string& location = "") const
  {
    return test::error_of<InputError>([&] { read(name, text, location); });
  }
  static std::string changed(std::string text, const std::string& from, const std::string& to)
  {
    return text.replace(text.find(from), from.size(), to);
  }
  TemporaryFolder folder_;
};

void expect_near(const std::vector<Real>& found, const std::vector<Real>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9 * std::abs(expected[i]));
}

TEST_F(Soundings, of_ags_are_corrected_by_the_area_ratio_of_their_cone)
{
  const Sounding one = read("site.ags", ags, "CPT1/1");
  expect_near(one.depth, {0.02, 0.04, 0.06});
  expect_near(one.q_t, {102e3, 204e3, 306e3});  // q_c + 0.2 u_2, also where f_s is void
  EXPECT_EQ(one.f_s[0], 2e3);
  EXPECT_TRUE(std::isnan(one.f_s[1]));
  EXPECT_TRUE(one.left_out.empty());
  EXPECT_EQ(one.corrected, "q_t = q_c + (1 - 0.8) u_2");
  const Sounding other = read("site.ags", ags, "CPT2/1");
  expect_near(other.q_t, {1e6, 2e6});  // without its area ratio
}

TEST_F(Soundings, of_ags_are_named_where_there_are_several)
{
  EXPECT_NE(refusal("site.ags", ags).find("has 2 soundings: name one with --location (CPT1/1, CPT2/1)"), std::string::npos);
  EXPECT_NE(refusal("site.ags", ags, "CPT3/1").find("has no sounding \"CPT3/1\""), std::string::npos);
}

TEST_F(Soundings, of_gef_have_their_columns_by_quantity_and_no_void_rows)
{
  const Sounding one = read("cpt.GEF", gef);
  expect_near(one.depth, {0.02, 0.06});
  expect_near(one.q_t, {1.01e6, 3.01e6});  // q_c + 0.25 u_2
  expect_near(one.f_s, {10e3, 30e3});
  EXPECT_NE(rows_of(one).find("cpt.GEF: 2 of 3 rows, 0.02 to 0.06 m; left out: 1 without a cone resistance"), std::string::npos)
      << rows_of(one);
}

TEST_F(Soundings, of_gef_may_have_separators_and_a_corrected_depth)
{
  std::string text = changed(gef, "#COLUMNINFO= 5, deg, inclination, 8",
                             "#COLUMNINFO= 5, m, corrected depth, 11\n#COLUMNSEPARATOR= ;\n#RECORDSEPARATOR= !");
  text = text.substr(0, text.find("0.02 1.0")) + "0.02;1.0;0.010;40.0;0.01;!\n0.04;2.0;0.010;40.0;0.03;!\n";
  expect_near(read("cpt.gef", text).depth, {0.01, 0.03});
}

TEST_F(Soundings, of_tables_have_names_with_units)
{
  const Sounding one = read("cpt.csv", "# made\ndepth_m,q_c_MPa,f_s_kPa,u_2_kPa\n0.1,1,10,1\n0.2,2,20,2\n");
  expect_near(one.q_t, {1e6, 2e6});
  expect_near(one.f_s, {10e3, 20e3});
  expect_near(read("cpt.csv", "Depth (cm);qt [MPa];note [-]\n10;1.5;soft\n20;2.5;\n").q_t, {1.5e6, 2.5e6});
}

TEST_F(Soundings, of_tables_may_say_the_area_ratio_of_their_cone_in_a_comment)
{
  const std::string rows = "depth_m,q_c_MPa,u_2_kPa\n0.1,1,100\n0.2,2,200\n";
  for (const char* line : {"# area_ratio = 0.75\n", "#Area ratio: 0.75,,\r\n", "# made\n# area_ratio=0.75\n"}) {
    const Sounding one = read("cpt.csv", line + rows);
    expect_near(one.q_t, {1.025e6, 2.05e6});  // q_c + 0.25 u_2
    EXPECT_EQ(one.corrected, "q_t = q_c + (1 - 0.75) u_2");
  }
  const Sounding without = read("cpt.csv", "# the area ratio is not known\n" + rows);
  expect_near(without.q_t, {1e6, 2e6});
  EXPECT_EQ(without.corrected, "q_c for q_t: the file does not say the area ratio of the cone");
  EXPECT_EQ(read("cpt.csv", "# area_ratio = 0.75\ndepth_m,q_c_MPa\n0.1,1\n0.2,2\n").corrected, "q_c for q_t: the file does not say u_2");
}

TEST_F(Soundings, that_are_wrong_are_refused_with_line_column_and_unit)
{
  const struct {
    const char *name, *text, *said;
  } wrong[] = {
      {"a.csv", "depth_m,q_c_s\n0,1\n1,2\n",
       "a.csv:1: column \"q_c_s\": \"s\" is not a unit of the cone resistance q_c, which is a pressure"},
      {"a.csv", "depth,q_c_MPa\n0,1\n1,2\n", "a.csv:1: column \"depth\" gives no unit of the depth"},
      {"a.csv", "depth_m,q_c_MPa\n0,1\n1,x\n", "a.csv:3: column \"q_c_MPa\": \"x\" is not a number"},
      {"a.csv", "depth_m,q_c_MPa\n0,1\n1\n", "a.csv:3: has 1 values, and 2 columns were named"},
      {"a.csv", "depth_m,q_c_MPa\n1,1\n1,2\n",
       "a.csv: 1 of 2 rows, 1.00 to 1.00 m; left out: 1 not deeper than the row before, and two are needed"},
      {"a.csv", "depth_m,q_c_MPa\n-1,1\n1,2\n",
       "left out: 1 above the seabed, and two are needed at least: depths are positive below the seabed"},
      {"a.csv", "depth_m,q_c_MPa\n1,1\n", "a.csv: 1 of 1 rows"},
      {"a.csv", "depth_m,q_c_MPa\n1,\n2,\n", "a.csv: has no column of the cone resistance, q_c or q_t, with a value"},
      {"a.csv", "depth_m,f_s_MPa\n1,1\n2,1\n", "a.csv: has no column of the cone resistance"},
      {"a.csv", "depth_m,q_c_MPa,qc_kPa\n1,1,1\n2,1,1\n",
       "a.csv:1: column \"qc_kPa\" is the cone resistance q_c, as column \"q_c_MPa\" is"},
      {"a.csv", "# area_ratio = 80 %\ndepth_m,q_c_MPa\n1,1\n2,1\n", "a.csv:1: area_ratio: \"80 %\" is not a number"},
      {"a.csv", "# area_ratio = 80\ndepth_m,q_c_MPa\n1,1\n2,1\n", "a.csv:1: area_ratio: the area ratio of a cone is above 0 and at most 1"},
      {"a.csv", "# area_ratio = 0.8\n# area_ratio = 0.7\ndepth_m,q_c_MPa\n", "a.csv:2: area_ratio occurs twice in the file"},
      {"a.gef", "#MEASUREMENTVAR= 3, 15, cm2, area\n#EOH=\n1 1\n", "a.gef:1: #MEASUREMENTVAR 3: the area ratio of a cone is above 0"},
      {"a.ags", "\"DATA\",\"x\"\n", "a.ags:1: begins with \"DATA\""},
      {"a.ags", "\"GROUP\",\"LOCA\"\n\"HEADING\",\"LOCA_ID\"\n\"DATA\",\"a\",\"b\"\n", "a.ags:3: has 2 values, and the group 1 headings"},
      {"a.ags", "\"GROUP\",\"LOCA\"\n", "a.ags: has no group SCPT"},
      {"a.ags", "\"GROUP\",\"SCPT\"\n\"HEADING\",\"SCPT_RES\"\n", "a.ags: the group SCPT has no line DATA"},
      {"a.gef", "#GEFID= 1\n0.1 1\n", "a.gef: has no line #EOH="},
      {"a.gef", "#GEFID= 1\n", "a.gef: has no line #EOH="},
      {"a.gef", "#REPORTCODE= GEF-BORE-Report\n#EOH=\n", "a.gef:1: #REPORTCODE is \"GEF-BORE-Report\""},
      {"a.gef", "#COLUMNINFO= 1, m, depth\n#EOH=\n", "a.gef:1: #COLUMNINFO has 3 values, and 4 are needed"},
      {"a.gef", "#COLUMNINFO= 2, MPa, cone, 2\n#EOH=\n1 1\n", "a.gef:1: column 2 comes without column 1"},
  };
  for (const auto& one : wrong) {
    const std::string said = refusal(one.name, one.text);
    EXPECT_NE(said.find(one.said), std::string::npos) << said;
  }
}

TEST_F(Soundings, tell_the_mean_friction_ratio)
{
  Sounding one;
  one.depth = {1, 2, 3};
  one.q_t = {115.81e3, 131.62e3, 147.43e3};
  one.f_s = {2e3, 4e3, nan};
  EXPECT_NEAR(friction_ratio(one, 6000), 0.03, 1e-12);
}

}  // namespace
}  // namespace berm::site::this_file
