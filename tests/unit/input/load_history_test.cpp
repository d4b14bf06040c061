// SPDX-License-Identifier: BSD-3-Clause
#include "input/load_history.hpp"

#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

using settings::load_factor;

class LoadHistory : public testing::Test {
protected:
  /// A case in the plane whose only stage, a drag, has the history "storm.csv"; it drags by a force where the file is of factors.
  static settings::Case case_with_history(bool of_factors)
  {
    settings::Case c;
    bodies::RigidSettings pipe;
    pipe.mass = 100;
    c.rigid = {{"pipe", pipe}};
    settings::StageSettings stage;
    stage.name = "storm";
    stage.kind = settings::StageKind::drag;
    if (of_factors) stage.force = 400;
    stage.load_history = "storm.csv";
    c.stage = {stage};
    return c;
  }
  settings::StageSettings read(settings::Case c, const std::string& text)
  {
    folder_.write("storm.csv", text);
    read_load_history(c, 0, folder_.path());
    return c.stage[0];
  }
  settings::StageSettings read(const std::string& text, std::optional<Real> time = {})
  {
    settings::Case c = case_with_history(true);
    c.stage[0].until.time = time;
    return read(c, text);
  }
  settings::StageSettings read_columns(const std::string& text) { return read(case_with_history(false), text); }
  std::string refusal(const std::string& text, bool of_factors = true) { return refusal(case_with_history(of_factors), text); }
  std::string refusal(const settings::Case& c, const std::string& text)
  {
    try {
      read(c, text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

TEST_F(LoadHistory, is_read_beside_the_case)
{
  const settings::StageSettings stage = read("time, factor\n# a comment\n0, 0\r\n\n0.5 , 1.5\n2,-1\n");
  EXPECT_EQ(stage.load_times, (std::vector<Real>{0, 0.5, 2}));
  EXPECT_EQ(stage.load_factors, (std::vector<Real>{0, 1.5, -1}));
  EXPECT_TRUE(stage.load_history.empty()) << "a resolved case needs no file";
  EXPECT_EQ(stage.until.time, 2) << "the stage ends with it at the latest";
}

TEST_F(LoadHistory, ends_its_stage_at_its_last_time_or_at_the_time_of_the_stage_whichever_is_first)
{
  EXPECT_EQ(read("0,0\n2,1\n", 1.5).until.time, 1.5);
  EXPECT_EQ(read("0,0\n2,1\n", 3).until.time, 2);
}

TEST_F(LoadHistory, with_a_unit_that_begins_with_a_number_is_refused_with_its_line)
{
  EXPECT_NE(refusal("time_2s,H_N_m\n0,0\n1,1\n", false).find("storm.csv:1: \"time_2s\" has no unit of a time"), std::string::npos)
      << refusal("time_2s,H_N_m\n0,0\n1,1\n", false);
}

TEST_F(LoadHistory, is_linear_between_its_times_and_constant_after)
{
  const settings::StageSettings stage = read("1,2\n3,6\n");
  EXPECT_EQ(load_factor(stage, 0), 2);
  EXPECT_EQ(load_factor(stage, 1), 2);
  EXPECT_EQ(load_factor(stage, 2), 4);
  EXPECT_EQ(load_factor(stage, 3), 6);
  EXPECT_EQ(load_factor(stage, 9), 6);
  EXPECT_EQ(load_factor(settings::StageSettings{}, 9), 1);
}

TEST_F(LoadHistory, in_a_shorter_time_keeps_its_forces_and_its_travels)
{
  settings::StageSettings stage = read("1,2\n3,6\n");
  stage.time_scale = 0.5;
  stage.velocity.reset();
  EXPECT_EQ(load_factor(stage, 1), 4);
  stage.velocity = 0.1;
  EXPECT_EQ(load_factor(stage, 1), 8) << "twice as fast for half as long";
  EXPECT_NEAR(speed_of(stage), 0.1 * 12, 1e-12);
}

TEST_F(LoadHistory, that_is_wrong_is_refused_with_its_line)
{
  EXPECT_NE(refusal("0,1\n1\n").find("storm.csv:2: a line of a load history is two numbers"), std::string::npos);
  EXPECT_NE(refusal("0,1\n1,x\n").find("storm.csv:2: \"x\" in column 2 is not a finite number"), std::string::npos);
  EXPECT_NE(refusal("0,1\n2,2\n1,3\n").find("storm.csv:3: times must ascend"), std::string::npos);
  EXPECT_NE(refusal("0\n").find("storm.csv:1: "), std::string::npos);
  EXPECT_NE(refusal("0,nan\n").find("storm.csv:1: \"nan\" in column 2 is not a finite number"), std::string::npos);
  EXPECT_NE(refusal("-1,1\n").find("storm.csv:1: times are measured from the start"), std::string::npos);
  for (const char* one_line : {"0,1\n", "2,1\n"})
    EXPECT_NE(refusal(one_line).find("storm.csv: has one line of numbers: it needs two at least"), std::string::npos) << one_line;
  EXPECT_NE(refusal("time,factor\n").find("storm.csv: has no line"), std::string::npos);
  EXPECT_NE(refusal("0,1,2\n1,2,3\n").find("of more columns the first line is their names"), std::string::npos);
  settings::Case c = case_with_history(true);
  c.stage[0].load_history = "none.csv";
  EXPECT_THROW(read_load_history(c, 0, folder_.path()), InputError);
}

TEST_F(LoadHistory, has_columns_that_its_header_names_with_their_units)
{
  const settings::StageSettings stage = read_columns("# a storm\ntime_s,H_kN_m,V_N_m\n0,0.1,400\n2,-0.2,300\n");
  EXPECT_EQ(stage.load_times, (std::vector<Real>{0, 2}));
  EXPECT_EQ(stage.loads.of("H"), (std::vector<Real>{100, -200}));
  EXPECT_EQ(stage.loads.of("V"), (std::vector<Real>{400, 300}));
  EXPECT_TRUE(stage.load_factors.empty());
  EXPECT_EQ(stage.until.time, 2);
  EXPECT_EQ(read_columns("time_min, u_mm_s\n0, 0\n0.5, 20\n").loads.of("u").back(), 0.02);
  EXPECT_EQ(read_columns("time_min, u_mm_s\n0, 0\n0.5, 20\n").until.time, 30);
  EXPECT_EQ(read("time_s,factor\n0,0\n2,1\n").load_factors.back(), 1);
}

TEST_F(LoadHistory, of_a_drive_has_columns_of_its_freedoms)
{
  settings::Case c = case_with_history(false);
  c.stage[0].kind = settings::StageKind::drive;
  const settings::StageSettings plane = read(c, "time_s,x_N_m,y_mm_s,rotation_Nm_m\n0,1,2,3\n1,1,2,3\n");
  EXPECT_EQ(plane.loads.of("x_force").back(), 1);
  EXPECT_EQ(plane.loads.of("y_velocity").back(), 0.002);
  EXPECT_EQ(plane.loads.of("rotation_moment").back(), 3);
  c.geometry = settings::Geometry::space;
  const settings::StageSettings space = read(c, "time_s,x_kN,z_m_s,rotation_z_Nm,rotation_x_rad_s\n0,1,2,3,4\n1,1,2,3,4\n");
  EXPECT_EQ(space.loads.of("x_force").back(), 1000);
  EXPECT_EQ(space.loads.of("z_velocity").back(), 2);
  EXPECT_EQ(space.loads.of("rotation_z_moment").back(), 3);
  EXPECT_EQ(space.loads.of("rotation_x_velocity").back(), 4);
}

TEST_F(LoadHistory, with_a_wrong_header_is_refused_with_what_was_meant)
{
  const auto says = [&](const std::string& header, const std::string& words) {
    const std::string answer = refusal(header + "\n0,1\n1,2\n", false);
    EXPECT_NE(answer.find("storm.csv:1: "), std::string::npos) << header << ": " << answer;
    EXPECT_NE(answer.find(words), std::string::npos) << header << ": " << answer;
  };
  says("time_s,h_N_m", "did you mean \"H_N_m\"? (allowed: factor, H_N_m, V_N_m, u_m_s, w_m_s, u_m, w_m, water_m_s)");
  says("time_s,v_N_m", "did you mean \"V_N_m\"?");
  says("time_s,U_mm", "did you mean \"u_m\"?");
  says("time_s,W_N_m", "did you mean \"w_m_s\"?");
  says("time_s,factor,H_N_m", "\"factor\" must be the only column after the time");
  says("time_s,H_N_m,factor", "\"factor\" must be the only column after the time");
  says("time_s,x_N_m", "not a column of the load history of this stage");
  says("t,H_N_m", "the first column is the time, \"time_s\"");
  says("time,H_N_m", "\"time\" has no unit");
  says("time_m,H_N_m", "\"time_m\" has no unit of a time");
  says("time_s,H_N", "\"H_N\" has no unit of a force per length");
  says("time_s,H_N", "write \"H_N_m\"");
  says("time_s,H_m_s", "has no unit of a force per length");
  says("time_s,H_N_m,H_kN_m", "\"H_kN_m\" repeats another column");
  says("time_s", "names no column after the time");
  EXPECT_NE(refusal("time_s,H_N_m,V_N_m\n0,1,2\n1,2\n", false).find("storm.csv:3: needs 3 numbers"), std::string::npos);
}

TEST_F(LoadHistory, with_a_wrong_number_names_its_line_and_column)
{
  for (const char* word : {"nan", "inf", "strong", ""}) {
    const std::string answer = refusal(std::string("time_s,H_N_m,V_N_m\n0,1,2\n1,") + word + ",2\n", false);
    EXPECT_NE(answer.find(std::string("storm.csv:3: \"") + word + "\" in column \"H_N_m\" is not a finite number"), std::string::npos)
        << answer;
  }
  EXPECT_NE(refusal("time_s,factor\n0,1\n1,x\n").find("storm.csv:3: \"x\" in column \"factor\""), std::string::npos);
}

TEST_F(LoadHistory, may_have_semicolons_between_its_columns)
{
  const settings::StageSettings stage = read_columns("# a storm, of one hour\ntime_s;H_kN_m;V_N_m\n0; 0.1; 400\n2;-0.2;300\n");
  EXPECT_EQ(stage.load_times, (std::vector<Real>{0, 2}));
  EXPECT_EQ(stage.loads.of("H"), (std::vector<Real>{100, -200}));
  EXPECT_EQ(stage.loads.of("V"), (std::vector<Real>{400, 300}));
  EXPECT_EQ(read("0;1\n2;3\n").load_factors, (std::vector<Real>{1, 3}));
}

TEST_F(LoadHistory, is_read_as_spreadsheets_and_programs_write_it)
{
  const settings::StageSettings stage = read("\xEF\xBB\xBFtime_s;factor\r\n+0.000E+00;+1.000E+00\r\n\"+1.0\";-.5e1\r\n;\r\n");
  EXPECT_EQ(stage.load_times, (std::vector<Real>{0, 1}));
  EXPECT_EQ(stage.load_factors, (std::vector<Real>{1, -5}));
  EXPECT_EQ(read("+0.000E+00,+0.000E+00\n+0.100E+00,+1.000E+00\n+1.000E+00,+1.000E+00\n").load_times, (std::vector<Real>{0, 0.1, 1}))
      << "a row of numbers, and no header";
  EXPECT_EQ(read("\"time_s\",\"factor\"\n\"0\",\"1\"\n\"2\",\"3\"\n").load_factors, (std::vector<Real>{1, 3}));
  for (const char* word : {"+nan", "+inf", "++1", "+-1", "+", "1.0.0", "1e", "0x10"})
    EXPECT_NE(
        refusal(std::string("0,1\n1,") + word + "\n").find(std::string("storm.csv:2: \"") + word + "\" in column 2 is not a finite number"),
        std::string::npos)
        << word;
  EXPECT_NE(refusal("nan,1\n1,2\n").find("storm.csv:1: \"nan\" in column 1 is not a finite number"), std::string::npos);
  EXPECT_NE(refusal("0,1\n1,1 000\n").find("storm.csv:2: \"1 000\" in column 2 has blanks between thousands: write 1000"),
            std::string::npos);
  EXPECT_NE(refusal("\xFF\xFEt\n").find("storm.csv: is text in UTF-16: save it as text in UTF-8"), std::string::npos);
  EXPECT_EQ(read("# Sturm, S\xFC\x64\r0,1\r2,-3\r").load_factors, (std::vector<Real>{1, -3})) << "Latin-1, lines that end with CR";
  EXPECT_EQ(read("0,1\n2,\u22123\n").load_factors, (std::vector<Real>{1, -3})) << "the minus sign of typesetting";
  EXPECT_EQ(read_columns("time [s],H (kN/m)\n0,1\n2,3\n").loads.of("H"), (std::vector<Real>{1000, 3000}));
  EXPECT_EQ(read_columns(",time_s,H_N_m,,\n0,0,1,,\n1,2,3,,\n").loads.of("H"), (std::vector<Real>{1, 3})) << "an index, empty columns";
  EXPECT_NE(refusal("time_s,H_N_m\n0,1\n1,\n", false).find("storm.csv:3: \"\" in column \"H_N_m\""), std::string::npos);
  EXPECT_EQ(read("sep=\t\ntime_s\tfactor\n0\t1\n2\t3\n").load_factors, (std::vector<Real>{1, 3}));
  EXPECT_NE(refusal("0,1\n\"1,2\n").find("storm.csv:2: a quotation mark is not closed"), std::string::npos);
}

TEST_F(LoadHistory, may_have_decimal_commas)
{
  EXPECT_EQ(read("time_s;factor\n0;1\n0,5;-1,5E+3\n").load_factors, (std::vector<Real>{1, -1500}));
  EXPECT_EQ(read("0,0;1,5\n0,5;2\n").load_times, (std::vector<Real>{0, 0.5}));
  EXPECT_EQ(read("\"0,5\",\"1,500\"\n\"1,500\",\"2,000\"\n").load_times, (std::vector<Real>{0.5, 1.5})) << "as 0,5 has one";
}

TEST_F(LoadHistory, with_commas_that_may_mean_something_else_is_refused_with_what_to_write)
{
  const auto says = [&](const std::string& text, const std::string& words) {
    EXPECT_NE(refusal(text, false).find(words), std::string::npos) << refusal(text, false);
  };
  says("time_s;H_N_m\n0;1.5\n0,5;2\n", "storm.csv:3: \"0,5\" in column \"time_s\" has a decimal comma: write 0.5");
  says("time_s;H_N_m\n0;1,000\n1;2\n",
       "storm.csv:2: \"1,000\" in column \"H_N_m\" is 1000 if its comma separates thousands, and 1.000 if it is a decimal comma");
  says("time_s;H_N_m\n0;1,000,000.5\n1;2\n", "has commas between thousands: write 1000000.5");
  says("time_s,H_N_m\n0,0,1,5\n",
       "storm.csv:2: needs 2 numbers, one for each column, and has 4; a comma separates numbers: write decimals with a point");
  says("time_s;H_N_m\n0;1\n1\n", "storm.csv:3: needs 2 numbers, one for each column, and has 1");
}

TEST_F(LoadHistory, jumps_where_the_same_time_stands_twice)
{
  const settings::StageSettings stage = read("0,0\n1,1\n1,-1\n2,-1\n");
  EXPECT_EQ(stage.load_times, (std::vector<Real>{0, 1, 1, 2}));
  EXPECT_EQ(load_factor(stage, 1), -1);
  EXPECT_NE(refusal("0,0\n1,1\n1,2\n1,3\n").find("storm.csv:4: the time 1 s occurs three times"), std::string::npos);
}

TEST_F(LoadHistory, of_displacements_begins_at_0_and_does_not_jump)
{
  const settings::StageSettings stage = read_columns("time_s,u_mm,w_m\n0,0,0\n0.5,20,0\n2,20,-0.1\n");
  EXPECT_EQ(stage.loads.of("u_displacement"), (std::vector<Real>{0, 0.02, 0.02}));
  EXPECT_EQ(stage.loads.of("w_displacement"), (std::vector<Real>{0, 0, -0.1}));
  settings::Case drive = case_with_history(false);
  drive.stage[0].kind = settings::StageKind::drive;
  EXPECT_NEAR(read(drive, "time_s,rotation_deg\n0,0\n1,180\n").loads.of("rotation_angle").back(), pi, 1e-15);
  drive.geometry = settings::Geometry::space;
  const settings::StageSettings space = read(drive, "time_s,z_mm,rotation_x_rad\n0,0,0\n1,2,3\n");
  EXPECT_EQ(space.loads.of("z_displacement").back(), 0.002);
  EXPECT_EQ(space.loads.of("rotation_x_angle").back(), 3);
  const auto says = [&](const std::string& text, const std::string& words) {
    EXPECT_NE(refusal(text, false).find(words), std::string::npos) << refusal(text, false);
  };
  says("time_s,u_m\n0,0.5\n1,1\n",
       "storm.csv:2: u is the displacement since the start of the stage: its first row must be 0 at the time 0, and is 0.5 m");
  says("time_s,u_m\n0.1,0\n1,1\n", "storm.csv:2: u is the displacement since the start of the stage");
  says("time_s,u_m\n0,0\n1,1\n1,2\n", "storm.csv:4: u jumps from 1 to 2 m at 1 s: a body cannot jump; give it time to get there");
}

TEST_F(LoadHistory, that_is_repeated_ends_its_stage_after_its_last_run)
{
  settings::Case c = case_with_history(false);
  c.stage[0].load_repeat = 3;
  c.stage[0].time_scale = 0.5;
  const settings::StageSettings stage = read(c, "time_s,u_m,V_N_m\n0,0,1\n1,0.1,2\n2,0,1\n");
  EXPECT_EQ(stage.load_times, (std::vector<Real>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(stage.loads.of("u_displacement"), (std::vector<Real>{0, 0.1, 0, 0.1, 0, 0.1, 0}));
  EXPECT_EQ(stage.until.time, 3);
  EXPECT_EQ(stage.load_repeat, 1) << "a resolved case has the runs themselves";
  c.stage[0].until.time = 1.2;
  EXPECT_EQ(read(c, "time_s,u_m\n0,0\n1,0.1\n2,0\n").until.time, 1.2);
  EXPECT_NE(refusal(c, "time_s,u_m\n0,0\n1,0.1\n").find("stage[0].load_repeat: u_displacement ends at 0.1 m"), std::string::npos);
}

TEST_F(LoadHistory, that_does_not_go_with_its_stage_is_refused_with_the_key)
{
  EXPECT_NE(refusal("time_s,H_N_m\n0,1\n1,2\n").find("stage[0].loads.H: drives what another key"), std::string::npos);
  EXPECT_NE(refusal("0,1\n1,2\n", false).find("stage[0]: needs either velocity or force"), std::string::npos);
  EXPECT_NE(refusal("time_s,V_N_m\n0,1\n1,2\n", false).find("stage[0]: needs either velocity, force or a column H or u"),
            std::string::npos);
  EXPECT_EQ(refusal("time_s,V_N_m\n0,1\n1,2\n"), "") << "the constant force drags";
  settings::Case light = case_with_history(false);
  light.rigid[0].second.mass = 0;
  EXPECT_NE(refusal(light, "time_s,H_N_m\n0,1\n1,2\n").find("[rigid.pipe], which therefore needs a mass"), std::string::npos);
  settings::Case held = case_with_history(false);
  held.stage[0].vertical_force = 3;
  EXPECT_NE(refusal(held, "time_s,H_N_m,V_N_m\n0,1,2\n1,2,3\n").find("stage[0].loads.V: drives what another key"), std::string::npos);
  settings::Case elements = case_with_history(false);
  elements.method = settings::Method::fem;
  EXPECT_NE(refusal(elements, "time_s,u_m_s\n0,1\n1,2\n").find("has no time"), std::string::npos);
  EXPECT_EQ(refusal(elements, "time_s,H_N_m\n0,1\n1,2\n"), "");
  settings::Case drive = case_with_history(false);
  drive.stage[0].kind = settings::StageKind::drive;
  EXPECT_NE(refusal(drive, "0,1\n1,2\n").find("stage[0].load_factors: multiply what a push or a drag drives"), std::string::npos);
}

TEST_F(LoadHistory, of_which_the_time_is_scaled_ends_its_stage_earlier)
{
  settings::Case c = case_with_history(false);
  c.stage[0].time_scale = 0.1;
  const settings::StageSettings stage = read(c, "time_s,H_N_m\n0,0\n20,100\n");
  EXPECT_EQ(stage.load_times.back(), 20) << "the times stay those of the record";
  EXPECT_EQ(stage.until.time, 2);
  c.stage[0].time_scale = settings::automatic_time_scale;
  EXPECT_NE(refusal(c, "time_s,H_N_m\n0,0\n20,100\n").find("stage[0].time_scale: is chosen for a record of forces"), std::string::npos)
      << "the pipe touches no soil here";
}

}  // namespace
}  // namespace berm::input::this_file
