// SPDX-License-Identifier: BSD-3-Clause
// Files of soundings as loggers, databases and spreadsheets write them: the same sounding in each kind of file, with its value, what is said of it, or its refusal.
#include "os/error.hpp"
#include "samples/error_of.hpp"
#include "samples/temporary_folder.hpp"
#include "site/sounding.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <gtest/gtest.h>

namespace berm::site::this_file {
namespace {

constexpr int rows = 20;

/// Row n of the sounding: at 0.05 n m, q_c = (60 + 40 z) kPa, f_s = 2 kPa, u_2 = 24 z kPa. At 0.5 m q_c is 80 kPa, and q_t 83 kPa with an area ratio of 0.75.
Real depth(int n)
{
  return 0.05 * n;
}
std::string q_c(int n)
{
  return fmt::format("{:.4f}", (60 + 40 * depth(n)) / 1000);  // MPa
}
std::string u_2(int n)
{
  return fmt::format("{:.2f}", 24 * depth(n));  // kPa
}
constexpr Real measured = 80e3, corrected = 83e3;

std::string changed(std::string text, const std::string& from, const std::string& to)
{
  EXPECT_NE(text.find(from), std::string::npos) << from;
  return text.replace(text.find(from), from.size(), to);
}

std::string everywhere(std::string text, const std::string& from, const std::string& to)
{
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) text.replace(at, from.size(), to);
  return text;
}

using Line = std::function<std::string(int n)>;

std::string lines(const Line& line)
{
  std::string text;
  for (int n = 1; n <= rows; ++n) text += line(n) + "\n";
  return text;
}

std::string of_csv(int n)
{
  return fmt::format("{:.2f},{},2.00,{}", depth(n), q_c(n), u_2(n));
}
std::string of_gef(int n)
{
  return fmt::format("{:.2f} {} 0.0020 {}", depth(n), q_c(n), u_2(n));
}
std::string of_ags(int n)
{
  return fmt::format("\"DATA\",\"P7\",\"1\",\"{:.2f}\",\"{}\",\"2.00\",\"{}\"", depth(n), q_c(n), u_2(n));
}

const std::string csv_head = "depth_m,q_c_MPa,f_s_kPa,u_2_kPa\n", area = "# area_ratio = 0.75\n",
                  gef_head = "#GEFID= 1, 1, 0\n#REPORTCODE= GEF-CPT-Report, 1, 1, 2\n#COLUMN= 4\n#COLUMNINFO= 1, m, length, 1\n"
                             "#COLUMNINFO= 2, MPa, tip, 2\n#COLUMNINFO= 3, MPa, sleeve, 3\n#COLUMNINFO= 4, kPa, pressure, 6\n"
                             "#COLUMNVOID= 4, -1.00\n#MEASUREMENTVAR= 3, 0.75, -, area ratio\n",
                  scpg = "\"GROUP\",\"SCPG\"\n\"HEADING\",\"LOCA_ID\",\"SCPG_TESN\",\"SCPG_CAR\"\n\"UNIT\",\"\",\"\",\"\"\n"
                         "\"TYPE\",\"ID\",\"X\",\"2DP\"\n\"DATA\",\"P7\",\"1\",\"0.75\"\n\n",
                  scpt =
                      "\"GROUP\",\"SCPT\"\n\"HEADING\",\"LOCA_ID\",\"SCPG_TESN\",\"SCPT_DPTH\",\"SCPT_RES\",\"SCPT_FRES\",\"SCPT_PWP2\"\n"
                      "\"UNIT\",\"\",\"\",\"m\",\"MPa\",\"kPa\",\"kPa\"\n\"TYPE\",\"ID\",\"X\",\"2DP\",\"4DP\",\"2DP\",\"2DP\"\n";

/// A kind of file: how many rows count, q_t at 0.5 m, and words that are said of it; 0 rows: it is refused with these words.
struct File {
  std::string what, name, text;
  Index counted;
  Real q_t;
  std::string said, location = "";
};

std::vector<File> files_of_ags()
{
  const std::string data = lines(of_ags), plain = scpg + scpt + data;
  // Of a second sounding, P8, in kPa: 70 + 10 n.
  const std::string in_kpa = changed(scpt, "MPa", "kPa") + lines([](int n) {
                               return fmt::format("\"DATA\",\"P8\",\"1\",\"{:.2f}\",\"{}\",\"2.00\",\"\"", depth(n), 70 + 10 * n);
                             });
  return {
      {"as the standard has it", "a.ags", plain, rows, corrected, ""},
      {"with a byte order mark", "a.ags", "\xEF\xBB\xBF" + plain, rows, corrected, ""},
      {"with CR and LF", "a.ags", everywhere(plain, "\n", "\r\n"), rows, corrected, ""},
      {"in MN/m2", "a.ags", changed(plain, "MPa", "MN/m2"), rows, corrected, ""},
      {"without a unit", "a.ags", changed(plain, "MPa", ""), 0, 0, "column \"SCPT_RES\" gives no unit of the cone resistance"},
      {"two groups with units of their own: the first", "a.ags", plain + "\n" + in_kpa, rows, corrected, "", "P7"},
      {"two groups with units of their own: the second", "a.ags", plain + "\n" + in_kpa, rows, 170e3, "does not say u_2", "P8/1"},
      {"two groups, none of them named", "a.ags", plain + "\n" + in_kpa, 0, 0, "name one with --location (P7/1, P8/1)"},
      {"one sounding in two groups of other units", "a.ags", plain + "\n" + everywhere(in_kpa, "P8", "P7"), 0, 0,
       "P7/1 has readings in this group SCPT and in that of line 7, with other headings or units"},
      {"one sounding in two groups alike", "a.ags",
       scpg + scpt + data.substr(0, data.find("\"DATA\",\"P7\",\"1\",\"0.60\"")) + "\n" + scpt +
           data.substr(data.find("\"DATA\",\"P7\",\"1\",\"0.60\"")),
       rows, corrected, ""},
      {"two lines HEADING", "a.ags", changed(plain, "\"TYPE\"", "\"HEADING\",\"A\",\"B\",\"C\"\n\"TYPE\""), 0, 0,
       "a second line HEADING in the group SCPG"},
      {"area ratios that differ", "a.ags", scpg + changed(scpg, "0.75", "0.80") + scpt + data, 0, 0,
       "has the area ratio 0.8 here and 0.75 before"},
      {"a location that has one test", "a.ags", plain, rows, corrected, "", "P7"},
      {"a location that has two tests", "a.ags", plain + everywhere(data, "\"P7\",\"1\"", "\"P7\",\"2\""), 0, 0,
       "--location P7 has 2 tests: name one (P7/1, P7/2)", "P7"},
      {"an empty column of q_t", "a.ags",
       scpg + changed(changed(scpt, "SCPT_FRES", "SCPT_QT"), "\"kPa\",\"kPa\"", "\"MPa\",\"kPa\"") + everywhere(data, "\"2.00\"", "\"\""),
       rows, corrected, "column \"SCPT_QT\", the corrected cone resistance q_t, is empty"},
      {"an empty column of u_2", "a.ags",
       scpg + scpt + lines([](int n) { return fmt::format("\"DATA\",\"P7\",\"1\",\"{:.2f}\",\"{}\",\"2.00\",\"\"", depth(n), q_c(n)); }),
       rows, measured, "column \"SCPT_PWP2\", the pore pressure u_2, is empty"},
      {"a text over two lines", "a.ags", everywhere(changed(plain, "SCPT_FRES", "SCPT_REM"), "\"2.00\"", "\"slow\nhere\""), rows, corrected,
       ""},
      {"a quotation mark that is not closed", "a.ags", changed(plain, "\"0.10\"", "\"0.10"), 0, 0, "a quotation mark is not closed"},
      {"of AGS 3", "a.ags", "\"**PROJ\"\n\"*PROJ_ID\"\n", 0, 0, "is of AGS 3, which has other groups and units: have it exported as AGS 4"},
      {"u_2 with the pressure of 300 m of water", "a.ags",
       scpg + scpt + lines([](int n) {
         return fmt::format("\"DATA\",\"P7\",\"1\",\"{:.2f}\",\"{}\",\"2.00\",\"{:.2f}\"", depth(n), q_c(n), 2943 + 24 * depth(n));
       }),
       rows, corrected, "u_2 is 2944 kPa at the seabed, the pressure of some 300 m of water above it: subtracted"},
      {"u_2 in kPa under the unit MPa", "a.ags", changed(plain, "\"kPa\",\"kPa\"", "\"kPa\",\"MPa\""), 0, 0,
       "which no soil has: is its unit right"},
  };
}

std::vector<File> files_of_gef()
{
  const std::string data = lines(of_gef), plain = gef_head + "#EOH=\n" + data;
  const auto with = [&](const std::string& line) { return gef_head + line + "#EOH=\n" + data; };
  const std::string no_area = changed(gef_head, "#MEASUREMENTVAR= 3, 0.75, -, area ratio\n", "");
  const std::string second_depth = "#COLUMNINFO= 5, m, depth, 11\n#COLUMNVOID= 5, -1\n";
  return {
      {"as the standard has it", "a.gef", plain, rows, corrected, ""},
      {"with a byte order mark", "a.gef", "\xEF\xBB\xBF" + plain, rows, corrected, ""},
      {"with CR and LF", "a.gef", everywhere(plain, "\n", "\r\n"), rows, corrected, ""},
      {"with tabs", "a.gef", gef_head + "#EOH=\n" + everywhere(data, " ", "\t"), rows, corrected, ""},
      {"in kN/m2", "a.gef", gef_head + "#EOH=\n" + data, rows, corrected, ""},
      {"in Latin-1 with kN/m2 by its sign", "a.gef",
       changed(gef_head, "4, kPa", "4, kN/m\xB2") + "#MEASUREMENTTEXT= 1, S\xFC\x64, place\n#EOH=\n" + data, rows, corrected, ""},
      {"with semicolons and marks at the ends of rows", "a.gef",
       gef_head + "#COLUMNSEPARATOR= ;\n#RECORDSEPARATOR= !\n#EOH=\n" + everywhere(everywhere(data, " ", ";"), "\n", ";!\n"), rows,
       corrected, ""},
      {"with decimal commas", "a.gef",
       everywhere(gef_head, "0.75", "0,75") + "#COLUMNSEPARATOR= ;\n#EOH=\n" + everywhere(everywhere(data, ".", ","), " ", ";"), rows,
       corrected, ""},
      {"with a text over two lines", "a.gef", with("#MEASUREMENTTEXT= 4, a note\nthat goes on\n"), rows, corrected,
       "lines of the header that are no #KEY= VALUE are not read: 1"},
      {"#EOH without =", "a.gef", gef_head + "#EOH\n" + data, rows, corrected, ""},
      {"without #EOH", "a.gef", gef_head + data, 0, 0, "has no line #EOH=, which ends the header"},
      {"with a report code in small letters", "a.gef", changed(plain, "GEF-CPT-Report", "gef-cpt-report"), rows, corrected, ""},
      {"with keys in small letters", "a.gef", changed(plain, "#REPORTCODE", "#reportcode"), rows, corrected, ""},
      {"of a borehole", "a.gef", changed(plain, "GEF-CPT", "GEF-BORE"), 0, 0, "a sounding has GEF-CPT-Report"},
      {"with blanks before =", "a.gef", everywhere(plain, "= ", " = "), rows, corrected, ""},
      {"with an area ratio of 0", "a.gef", changed(plain, "3, 0.75", "3, 0.00"), rows, measured, "the area ratio of the cone"},
      {"with an empty area ratio", "a.gef", changed(plain, "3, 0.75", "3, "), rows, measured, "the area ratio of the cone"},
      {"without the area ratio", "a.gef", no_area + "#EOH=\n" + data, rows, measured, "the area ratio of the cone"},
      {"with an area ratio in percent", "a.gef", changed(plain, "3, 0.75", "3, 75"), 0, 0,
       "the area ratio of a cone is above 0 and at most 1"},
      {"with a column twice", "a.gef", with("#COLUMNINFO= 2, kPa, tip, 2\n"), 0, 0, "#COLUMNINFO of column 2 occurs twice in the file"},
      {"with u_2 void everywhere", "a.gef",
       gef_head + "#EOH=\n" + lines([](int n) { return fmt::format("{:.2f} {} 0.0020 -1", depth(n), q_c(n)); }), rows, measured,
       "column \"pressure\", the pore pressure u_2, is empty"},
      {"with u_2 void in two rows", "a.gef", changed(changed(plain, u_2(3) + "\n", "-1\n"), u_2(4) + "\n", "-1\n"), rows, corrected,
       "2 rows have no u_2: q_t is q_c there"},
      {"with a depth twice", "a.gef", changed(plain, "0.40 ", "0.35 "), rows - 1, corrected, "1 not deeper than the row before"},
      {"drawn back at a rod change", "a.gef", changed(plain, "0.40 ", "0.33 "), rows - 1, corrected, "1 not deeper than the row before"},
      {"with a hole of 0.22 m before the test", "a.gef", with("#MEASUREMENTVAR= 13, 0.22, m, predrilled\n"), rows - 4, corrected,
       "4 in the predrilled hole, to 0.22 m"},
      {"with a corrected depth that begins late", "a.gef",
       gef_head + second_depth + "#EOH=\n" + lines([](int n) { return of_gef(n) + (n < 4 ? " -1" : fmt::format(" {:.2f}", depth(n))); }),
       rows, corrected, "3 rows have no corrected depth: it is the length of penetration there"},
  };
}

std::vector<File> files_of_csv()
{
  const std::string data = lines(of_csv), plain = area + csv_head + data;
  const std::string commas = everywhere(
      everywhere(csv_head, ",", ";") + lines([](int n) { return fmt::format("{:.2f};{};2.00;{}", depth(n), q_c(n), u_2(n)); }), ".", ",");
  const std::string words = "depth,qc,fs,u2\nm,MPa,kPa,kPa\n";
  return {
      {"as the guide has it", "a.csv", plain, rows, corrected, ""},
      {"with a byte order mark", "a.csv", "\xEF\xBB\xBF" + plain, rows, corrected, ""},
      {"with CR alone", "a.csv", everywhere(plain, "\n", "\r"), rows, corrected, ""},
      {"in UTF-16", "a.csv", std::string("\xFF\xFE") + "d", 0, 0, "is text in UTF-16: save it as text in UTF-8"},
      {"with a NUL byte", "a.csv", plain + std::string(1, '\0'), 0, 0, "holds a NUL byte"},
      {"with units in brackets", "a.csv", area + "Depth [m],qc (MPa),fs [kPa],u2 [kPa]\n" + data, rows, corrected, ""},
      {"with blanks that do not break", "a.csv", area + "Depth\u00A0[m],qc\u202F(MPa),fs [kPa],u2 [kPa]\n" + data, rows, corrected, ""},
      {"with a line of units", "a.csv", area + words + data, rows, corrected, ""},
      {"without units", "a.csv", "depth,qc,fs,u2\n" + data, 0, 0, "column \"depth\" gives no unit of the depth"},
      {"with semicolons and decimal commas", "a.csv", changed(area, "0.75", "0,75") + commas, rows, corrected, ""},
      {"with sep=; and decimal commas", "a.csv", "sep=;\n" + commas, rows, measured, ""},
      {"with points and commas in one table", "a.csv", everywhere(csv_head, ",", ";") + "0.5;0.08;2,00;\n1;0.1;2,00;\n", 0, 0,
       "\"2,00\" has a decimal comma: write 2.00"},
      {"with a comma that may be either", "a.csv", "depth_m;q_c_kPa\n1;1,000\n2;1,200\n", 0, 0,
       "\"1,000\" is 1000 if its comma separates thousands, and 1.000 if it is a decimal comma"},
      {"with three decimals behind commas, one of them clear", "a.csv", "depth_m;q_c_MPa\n0,500;0,080\n1,000;1,100\n", 2, measured, ""},
      {"with decimal commas between commas", "a.csv", "depth_m,q_c_MPa\n0,1,0,1\n", 0, 0,
       "write decimals with a point, or separate columns by semicolons"},
      {"with commas between thousands", "a.csv", "depth_m,q_c_Pa\n0.5,\"1,080,000\"\n1,2\n", 0, 0,
       "has commas between thousands: write 1080000"},
      {"with an index without a name", "a.csv", area + "," + csv_head + lines([](int n) { return fmt::format("{},{}", n - 1, of_csv(n)); }),
       rows, corrected, ""},
      {"with empty columns at the end", "a.csv",
       area + changed(csv_head, "\n", ",,\n") + lines([](int n) { return of_csv(n) + ",,"; }) + ",,,,,\n", rows, corrected, ""},
      {"with a column of words without a unit", "a.csv",
       area + changed(csv_head, "\n", ",remark\n") + lines([](int n) { return of_csv(n) + ",soft"; }), rows, corrected, ""},
      {"with f_s void near the seabed", "a.csv", everywhere(plain, ",2.00,", ",,"), rows, corrected,
       "column \"f_s_kPa\", the sleeve friction f_s, is empty"},
      {"with f_s void in a row", "a.csv", changed(plain, ",2.00,", ",,"), rows, corrected, "1 row has no f_s"},
      {"with NaN", "a.csv", changed(plain, q_c(3), "NaN"), rows - 1, corrected, "1 without a cone resistance"},
      {"with -9999 for no value", "a.csv", changed(plain, q_c(3), "-9999"), rows - 1, corrected, "1 without a cone resistance"},
      {"with a first reading at 0", "a.csv", area + csv_head + "0.00,-0.01,0,0\n" + data, rows + 1, corrected, ""},
      {"with a first reading above the seabed", "a.csv", area + csv_head + "-0.02,0.0,0,0\n" + data, rows, corrected, "1 above the seabed"},
      {"of elevations", "a.csv", csv_head + lines([](int n) { return "-" + of_csv(n); }), 0, 0, "depths are positive below the seabed"},
      {"with the deepest first", "a.csv", csv_head + lines([](int n) { return of_csv(rows + 1 - n); }), 0, 0, "depths ascend"},
      {"of one row", "a.csv", csv_head + of_csv(1) + "\n", 0, 0, "1 of 1 rows"},
      {"in mm under the unit m", "a.csv", "depth_m,q_c_MPa\n0,0.1\n500,0.2\n", 0, 0, "no cone is pushed to 200 m: is its unit right"},
      {"in kPa under the unit MPa", "a.csv", changed(plain, q_c(20), "123.4"), 0, 0, "no cone withstands more than 100 MPa"},
  };
}

class UsualFiles : public testing::Test {
protected:
  void expect(const File& file) const
  {
    SCOPED_TRACE(file.name + ": " + file.what);
    folder_.write(file.name, file.text);
    Sounding sounding;
    const std::string refusal = test::error_of<InputError>([&] { sounding = read_sounding(folder_ / file.name, file.location); });
    if (file.counted == 0) {
      EXPECT_NE(refusal.find(file.said), std::string::npos) << refusal;
      return;
    }
    ASSERT_EQ(refusal, "");
    EXPECT_EQ(static_cast<Index>(sounding.depth.size()), file.counted) << rows_of(sounding);
    const auto half = std::find_if(sounding.depth.begin(), sounding.depth.end(), [](Real z) { return std::abs(z - 0.5) < 1e-9; });
    ASSERT_NE(half, sounding.depth.end());
    // Pressures in the files have two to four decimals; that of the water is known to what the soil adds at 0.05 m, 0.7 kPa of u_2.
    EXPECT_NEAR(sounding.q_t[static_cast<std::size_t>(half - sounding.depth.begin())], file.q_t, 0.25e3);
    std::string all = rows_of(sounding) + "; " + sounding.corrected;
    for (const std::string& note : sounding.notes) all += "; " + note;
    EXPECT_NE(all.find(file.said), std::string::npos) << all;
    EXPECT_TRUE(!file.said.empty() || sounding.notes.empty()) << all;
  }
  TemporaryFolder folder_;
};

TEST_F(UsualFiles, of_ags_give_the_sounding_or_say_why_not)
{
  for (const File& file : files_of_ags()) expect(file);
}

TEST_F(UsualFiles, of_gef_give_the_sounding_or_say_why_not)
{
  for (const File& file : files_of_gef()) expect(file);
}

TEST_F(UsualFiles, of_tables_give_the_sounding_or_say_why_not)
{
  for (const File& file : files_of_csv()) expect(file);
}

}  // namespace
}  // namespace berm::site::this_file
