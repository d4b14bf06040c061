// SPDX-License-Identifier: BSD-3-Clause
#include "springs/formats.hpp"

#include "os/error.hpp"
#include "samples/made_run.hpp"
#include "samples/made_springs.hpp"
#include "samples/temporary_folder.hpp"
#include "structures/base/invalid_answer.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

namespace berm::springs::this_file {
namespace {

using Lines = std::vector<std::string>;

/// A peak of 60 N/m at 0.05 D, 40 N/m from 0.15 D on, under 80 N/m; a push to 0.1 D.
Design sample_design(int drags = 1)
{
  MadeRun run;
  run.method = settings::Method::fem;
  run.gravity_level = 1;
  run.held_V = 80;
  std::vector<Springs> draws;
  for (int k = 0; k < 20; ++k) {
    const Real peak = 50 + k;
    run.H = [peak](Real u) { return peak * (u < 0.001 ? u / 0.001 : u < 0.003 ? 1 - (u - 0.001) / 0.006 : 2. / 3); };
    draws.push_back(springs_of(run.record()));
    for (int more = 1; more < drags; ++more) {
      draws.back().lateral.push_back(draws.back().lateral[0]);
      draws.back().lateral.back().stage = fmt::format("drag_{}", more);
    }
  }
  Design design = design_of_sample("pipe", draws[10], draws);
  design.provenance = {"written by berm 0", "a pipe"};
  return design;
}

const ExportFile& file(const ExportFiles& files, const std::string& name)
{
  for (const ExportFile& one : files)
    if (one.name == name) return one;
  throw std::runtime_error("no file " + name);
}

Lines lines_of(const std::string& text)
{
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The pairs of numbers between commas of the lines behind `begin`, up to one that has none.
Points pairs_behind(const std::string& text, const std::string& begin)
{
  Points points;
  bool found = false;
  for (const std::string& line : lines_of(text)) {
    Point p{};
    if (found && std::sscanf(line.c_str(), "%lf ,%lf", &p.x, &p.F) == 2)
      points.push_back(p);
    else if (found && !points.empty())
      break;
    found = found || line.starts_with(begin);
  }
  return points;
}

void expect_ascending(const Points& points)
{
  for (std::size_t k = 1; k < points.size(); ++k) EXPECT_GT(points[k].x, points[k - 1].x) << k;
}

TEST(Formats, each_estimate_gets_a_file_of_its_own)
{
  const Design design = sample_design();
  for (const Format& format : formats) {
    const ExportFiles files = format.files(design);
    ASSERT_FALSE(files.empty()) << format.name;
    std::set<std::string> names;
    for (const ExportFile& one : files) {
      EXPECT_FALSE(one.text.empty()) << one.name;
      EXPECT_TRUE(names.insert(one.name).second) << one.name << " twice";
    }
    const std::string name = format.name;
    if (name == "table" || name == "json") continue;
    EXPECT_EQ(files.size(), name == "calculix" ? 9u
                            : name == "buckpy" ? 1u
                                               : 3u)
        << name << ": a spring a file, a sheet, an estimate a file";
  }
  MadeRun run;
  EXPECT_EQ(abaqus_files(design_of_sample("one", springs_of(run.record()), std::vector<Springs>(10, springs_of(run.record())))).size(), 3u);
  Design alone;
  alone.best = springs_of(run.record());
  EXPECT_EQ(abaqus_files(alone).size(), 1u);
}

TEST(Formats, say_run_and_state_in_each_file_and_the_travel_and_formula_of_each_spring)
{
  const Design design = made_design();
  for (const Format& format : formats) {
    std::string all;
    for (const ExportFile& one : format.files(design)) {
      std::string text = one.text;
      for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at)) {
        // Comments go on behind their mark.
        std::size_t end = at + 1;
        while (end < text.size() && std::string("*#!' ").find(text[end]) != std::string::npos) ++end;
        text.replace(at, end - at, " ");
      }
      EXPECT_NE(text.find("b1"), std::string::npos) << format.name << ": " << one.name;
      EXPECT_NE(text.find("operation"), std::string::npos) << format.name << ": " << one.name;
      all += text;
    }
    for (const char* words : {"sweep_1", "sweep_2", "White and Randolph 2007"})
      EXPECT_NE(all.find(words), std::string::npos) << format.name << ": " << words;
    if (std::string(format.name) == "table" || std::string(format.name) == "json") continue;
    EXPECT_NE(all.find("sweep_2, computed, no residual, 1129 N/m against a berm at its end, which is not a residual"), std::string::npos)
        << format.name << "\n"
        << all;
  }
}

TEST(Formats, have_the_berm_of_a_sweep_as_a_number_of_its_own_and_no_residual)
{
  const Design design = made_design();
  const auto lateral = nlohmann::json::parse(json_files(design)[0].text)["springs"]["best"]["lateral"];
  EXPECT_TRUE(lateral[1]["residual_N_m"].is_null());
  EXPECT_EQ(lateral[1]["berm_resistance_N_m"], 1129);
  EXPECT_EQ(lateral[0]["residual_N_m"], 500);
  EXPECT_TRUE(lateral[0]["berm_resistance_N_m"].is_null());
  const std::string table = file(table_files(design), "springs.csv").text;
  EXPECT_NE(table.find("\nlateral sweep_2,berm_resistance,N/m,1129,"), std::string::npos) << table;
  EXPECT_EQ(table.find("\nlateral sweep_2,residual,"), std::string::npos);
  EXPECT_NE(table.find("\nlateral sweep_1,residual,N/m,500,"), std::string::npos);
  EXPECT_EQ(file(sima_files(design), "springs_best.inp").text.find("R2BEST"), std::string::npos) << "no component of a residual";
}

TEST(Formats, of_tables_have_run_state_travel_and_source_of_each_number_at_the_end_of_its_line)
{
  const ExportFiles files = table_files(made_design());
  const auto line_of = [&](const std::string& name, const std::string& begin) {
    for (const std::string& line : lines_of(file(files, name).text))
      if (line.starts_with(begin)) return line;
    return "no line " + begin;
  };
  const auto ends = [](const std::string& line, const std::string& end) { EXPECT_TRUE(line.ends_with(end)) << line; };
  ends(line_of("springs.csv", "spring,"), ",meaning,run,state,travel,source");
  ends(line_of("springs.csv", "lateral sweep_1,peak,"), ",b1,operation,sweep_1,computed");
  ends(line_of("springs.csv", "axial,undrained,"), ",b1,operation,,White and Randolph 2007");
  ends(line_of("springs.csv", "axial,u_breakout,"), ",b1,operation,,\"DNVGL-RP-F114, table 4-2\"");
  ends(line_of("springs.csv", "vertical,embedment,"), ",b1,operation,,\"computed, end of stage unload\"");
  ends(line_of("curves.csv", "lateral sweep_2,low,"), ",b1 (forces at 5 % of 11 runs),operation,sweep_2,computed");
  ends(line_of("springs.csv", "axial,residual,"), ",b1,operation,,White and Randolph 2007");
  ends(line_of("curves.csv", "vertical,best,"), ",b1,operation,push,computed");
  ends(line_of("curves.csv", "vertical virgin,best,"), ",b1,operation,push,computed");
}

TEST(Formats, never_have_a_stiffness_that_is_negative_or_none_and_say_why)
{
  Springs springs = made_springs();
  springs.vertical.unloading.push_back({"pause", 1000, 1100, nan});
  const Design design = made_design(springs);
  for (const Format& format : formats)
    for (const ExportFile& one : format.files(design)) {
      EXPECT_EQ(one.text.find("104219"), std::string::npos) << format.name << ": " << one.name;
      EXPECT_FALSE(std::regex_search(one.text, std::regex("(^|[^a-z])-?nan([^a-z]|$)"))) << format.name << ": " << one.name;
    }
  for (const ExportFiles& files : {table_files(design), json_files(design), sima_files(design), moordyn_files(design)}) {
    EXPECT_NE(files[0].text.find("stiffness dV/dw in stage unload is not written: V fell from 1860 to 1000 N/m"), std::string::npos)
        << files[0].text;
    EXPECT_NE(files[0].text.find("stage pause is not written: w does not follow V in it"), std::string::npos) << files[0].text;
  }
  const auto vertical = nlohmann::json::parse(json_files(design)[0].text)["springs"]["best"]["vertical"];
  for (const auto& unloading : vertical["unloading"]) EXPECT_TRUE(unloading["stiffness_N_m2"].is_null());
}

TEST(Formats, of_abaqus_is_force_then_displacement_ascending_through_the_origin_and_the_same_both_ways)
{
  const Design design = sample_design();
  const std::string text = file(abaqus_files(design), "springs_best.inp").text;
  EXPECT_NE(text.find("*PIPE-SOIL INTERACTION, ELSET=SOIL_BEST\n"), std::string::npos) << text;
  Points lateral = pairs_behind(text, "*PIPE-SOIL STIFFNESS, TYPE=NONLINEAR, DIRECTION=HORIZONTAL");
  for (Point& p : lateral) std::swap(p.x, p.F);
  const Points spring = design.best.lateral[0].spring();
  ASSERT_EQ(lateral.size(), 2 * spring.size() - 1);
  expect_ascending(lateral);
  for (std::size_t k = 0; k < lateral.size(); ++k) {
    EXPECT_EQ(lateral[k].F, -lateral[lateral.size() - 1 - k].F) << k;
    if (k + 1 >= spring.size()) {
      EXPECT_NEAR(lateral[k].F, spring[k + 1 - spring.size()].F, 1e-4 * 60) << k;
    }
  }
  Points push = pairs_behind(text, "*PIPE-SOIL STIFFNESS, TYPE=NONLINEAR, DIRECTION=VERTICAL");
  for (Point& p : push) std::swap(p.x, p.F);
  expect_ascending(push);
  EXPECT_EQ(push.front().F, 0) << "a pipe that is lifted meets nothing";
  ASSERT_EQ(push.size(), 5u) << "lifted, without load, the state, the preload, beyond it";
  EXPECT_EQ(push[1].x, 0);
  EXPECT_EQ(push[1].F, 0);
  EXPECT_NEAR(push[2].F, 80, 1e-4);
  EXPECT_NEAR(push[3].F, 4e5 * 0.002, 1e-2) << "the end of the push";
  EXPECT_EQ(text[0], '*');
  for (const std::string& line : lines_of(text)) EXPECT_LE(line.size(), 256u) << line;
}

TEST(Formats, of_orcaflex_is_the_resistance_over_the_normal_reaction)
{
  const Design design = sample_design();
  const std::string text = file(orcaflex_files(design), "springs_high.csv").text;
  const Points profile = pairs_behind(text, "deflection (m),effective friction coefficient");
  const Points spring = design.high->lateral[0].spring();
  ASSERT_EQ(profile.size(), spring.size());
  for (std::size_t k = 0; k < spring.size(); ++k) {
    EXPECT_NEAR(profile[k].x, spring[k].x, 1e-5 * 0.02);
    EXPECT_NEAR(profile[k].F, spring[k].F / 80, 1e-5);
  }
  const Points reaction = pairs_behind(text, "penetration (m),normal reaction (kN/m)");
  ASSERT_EQ(reaction.size(), 5u);
  EXPECT_NEAR(reaction[2].x, design.best.embedment, 1e-6);
  EXPECT_NEAR(reaction[2].F, 0.08, 1e-5) << "kN/m: under V of the state the pipe lies at its embedment";
}

TEST(Formats, of_ansys_has_no_more_points_than_the_element_takes_and_none_at_the_same_place)
{
  Design design = sample_design();
  design.best.vertical.curve.clear();
  design.best.V = nan;
  for (int k = 1; k <= 50; ++k) design.best.vertical.curve.push_back({0.001 * k, std::sqrt(0.001 * k)});
  const std::string text = file(ansys_files(design), "springs_best.mac").text;
  int springs = 0;
  Points points;
  const auto check = [&] {
    if (points.empty()) return;
    ++springs;
    EXPECT_LE(points.size(), 20u);
    expect_ascending(points);
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](const Point& p) { return p.x == 0 && p.F == 0; }));
    EXPECT_GE(points.back().F, points[points.size() - 2].F) << "the slope at the end may not be negative";
    points.clear();
  };
  for (std::string line : lines_of(text)) {
    if (line.starts_with("R,")) {
      check();
      EXPECT_TRUE(line.starts_with("R,BERM_REAL+")) << line;
    }
    if (!line.starts_with("R,") && !line.starts_with("RMORE,")) continue;
    std::istringstream fields(line.substr(line.find(',') + 1));
    std::string field;
    if (line.starts_with("R,")) std::getline(fields, field, ',');
    while (std::getline(fields, field, ',')) {
      points.push_back({std::stod(field), 0});
      ASSERT_TRUE(std::getline(fields, field, ','));
      EXPECT_TRUE(field.ends_with("*BERM_LENGTH")) << field;
      points.back().F = std::stod(field);
    }
  }
  check();
  EXPECT_EQ(springs, 3) << "lateral, axial, vertical";
  EXPECT_NE(text.find("0.05,0.223607*BERM_LENGTH"), std::string::npos) << "the end of the push stays";
}

TEST(Formats, of_sima_have_stiffness_and_friction_of_each_drag_in_kilonewtons)
{
  const Design design = sample_design();
  const std::string text = file(sima_files(design), "springs_best.inp").text;
  const Lateral& l = design.best.lateral[0];
  EXPECT_NE(text.find(fmt::format("{:.6g} {:.6g} 0 0\n", l.stiffness() / 1000, l.peak / 80)), std::string::npos) << text;
  EXPECT_NE(text.find(fmt::format("{:.6g} {:.6g} 0 0\n", l.stiffness() / 1000, l.residual / 80)), std::string::npos) << text;
  std::set<std::string> names;
  for (const std::string& line : lines_of(sima_files(sample_design(2))[1].text))
    if (line.ends_with(" SPRI")) {
      EXPECT_LE(line.size(), 8 + 5u) << "a name has eight characters";
      EXPECT_TRUE(names.insert(line).second) << line;
    }
}

TEST(Formats, of_sima_say_which_drag_has_no_component_and_why)
{
  Springs s = made_springs();
  s.lateral[0].mobilised = {nan, nan, nan, nan};
  const auto text = [&] { return sima_files(made_design(s))[1].text; };
  EXPECT_NE(text().find(fmt::format("{:.6g} 0.8 0 0\n", 800 / 0.02 / 1000)), std::string::npos) << "secant to the peak: " << text();
  s.lateral[0].u_peak = 0;
  EXPECT_NE(text().find("' sweep_1 has no component: H begins with its peak"), std::string::npos) << text();
  EXPECT_EQ(text().find("B1BEST"), std::string::npos);
  s.lateral[0].V = 0;
  EXPECT_NE(text().find("' sweep_1 has no coefficient of friction"), std::string::npos) << text();
}

TEST(Formats, of_sima_have_an_undrained_axial_friction_over_the_V_of_the_travel_and_say_so)
{
  Springs s = made_springs();
  s.lateral[0].V = 1200;
  const std::string text = sima_files(made_design(s))[1].text;
  EXPECT_NE(text.find(fmt::format("{:.6g} {:.6g} 0\n", 240 / 0.005 / 1000, 240. / 1200)), std::string::npos) << text;
  EXPECT_NE(text.find("' FRIAXI: divided by V of the travel\n"), std::string::npos) << text;
}

TEST(Formats, say_what_is_missing)
{
  Springs s = made_springs();
  s.missing = {"\"storm\" is driven by a force"};
  const Design design = made_design(s);
  for (const Format& format : formats) EXPECT_NE(format.files(design)[0].text.find("storm"), std::string::npos) << format.name;
}

TEST(Formats, refuse_springs_of_which_they_can_write_none)
{
  Design nothing;
  nothing.best = made_springs();
  nothing.best.lateral.clear();
  nothing.best.vertical.curve.clear();
  nothing.best.axial = {};
  nothing.best.V = -2936;
  nothing.best.vertical.unloading = {{"uplift", 100, -2936, 1e5}};
  nothing.best.missing = {"resistance to uplift is uplift.R_max in summary.json"};
  Design pushed = nothing, lifted_after = nothing;
  pushed.best.vertical.curve = {{0.1, 2000}};
  lifted_after.best.lateral = made_springs().lateral;
  for (Lateral& l : lifted_after.best.lateral) l.V = -10;
  const auto refusal = [](const Design& design, const Format& format) {
    try {
      check_taken(design, format);
    } catch (const RunError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const Format& format : formats) {
    const std::string name = format.name;
    EXPECT_NE(refusal(nothing, format).find("state operation has no spring that --to " + name + " can write: resistance to uplift is"),
              std::string::npos)
        << refusal(nothing, format);
    EXPECT_EQ(refusal(made_design(), format), "");
    EXPECT_EQ(refusal(pushed, format).empty(), name != "sima" && name != "buckpy") << name;
    const bool of_coefficients = name == "orcaflex" || name == "sima" || name == "moordyn" || name == "buckpy";
    EXPECT_EQ(refusal(lifted_after, format).find("sweep_1 has no coefficient") != std::string::npos, of_coefficients) << name;
  }
}

TEST(Formats, tables_and_json_tell_the_same_numbers)
{
  const Design design = sample_design();
  const auto json = nlohmann::json::parse(json_files(design)[0].text);
  const Lines table = lines_of(file(table_files(design), "springs.csv").text);
  int found = 0;
  for (const auto& e : json["estimates"])
    for (const std::string& line : table)
      if (line.starts_with(e["spring"].get<std::string>() + "," + e["number"].get<std::string>() + "," + e["unit"].get<std::string>() +
                           ",")) {
        ++found;
        if (!e["low"].is_null()) {
          EXPECT_NE(line.find(fmt::format(",{},", e["low"].get<double>())), std::string::npos) << line;
        }
      }
  EXPECT_EQ(found, static_cast<int>(json["estimates"].size()));
  EXPECT_EQ(json["springs"]["low"]["lateral"][0]["spring"].size(), design.low->lateral[0].spring().size());
  EXPECT_EQ(json["provenance"][1], "a pipe");
}

TEST(Formats, both_tables_of_an_invalid_run_begin_with_why)
{
  Design design = sample_design();
  const auto begins = [&](const std::string& name) { return file(table_files(design), name).text.starts_with("#"); };
  EXPECT_FALSE(begins("curves.csv"));
  design.provenance = {fmt::format("{} energy does not balance", base::invalid_line_begin)};
  EXPECT_EQ(lines_of(file(table_files(design), "springs.csv").text).front(), "# (!) energy does not balance");
  EXPECT_EQ(lines_of(file(table_files(design), "curves.csv").text).front(), "# (!) energy does not balance");
}

TEST(Formats, picture_shows_the_sample_and_the_estimates)
{
  const TemporaryFolder folder;
  EXPECT_EQ(draw_springs(sample_design(), folder.path()), std::vector<std::string>{"springs.png"});
  EXPECT_GT(std::filesystem::file_size(folder.path() / "springs.png"), 5000u);
}

}  // namespace
}  // namespace berm::springs::this_file
