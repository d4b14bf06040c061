// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/line_film.hpp"

#include "samples/film_decoding.hpp"
#include "samples/made_line.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

/// The numbers of a quantity by frame and node, as the page has them.
std::vector<std::vector<Real>> values_of(const Film& film, const char* quantity)
{
  const auto& about = film.json[quantity];
  const SeenFilm seen{film};
  std::vector<std::vector<Real>> values;
  const auto codes = decoded_places(seen.bytes(about["block"]), seen.frames(), film.json["x"].size(), 1);
  for (const std::vector<int>& frame : codes[0]) {
    std::vector<Real>& now = values.emplace_back();
    for (const int code : frame) now.push_back(about["low"].get<Real>() + about["step"].get<Real>() * code);
  }
  return values;
}

TEST(line_film, tells_the_line_of_a_case_and_decodes_within_half_a_step)
{
  const MadeLine made(5, 8);
  const Film film = make_line_film(made.run, "line-2");
  EXPECT_TRUE(film.faults.empty());
  EXPECT_EQ(film.json["half"], "symmetric");
  EXPECT_TRUE(film.json["bed"].is_null()) << "there is no berms.csv";
  EXPECT_EQ(film.json["diameter"], 0.4);
  EXPECT_EQ(film.json["weight"], 1500);
  EXPECT_EQ(film.json["slices"], (std::vector<Real>{0, 1, 2, 3}));
  EXPECT_EQ(film.json["x"], (std::vector<Real>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_NEAR(film.json["region"], 3.3, 1e-12);
  EXPECT_TRUE(film.json["note"].is_null());
  EXPECT_EQ(film.json["y"]["block"], "line-2-y");
  const auto y = values_of(film, "y"), P = values_of(film, "P"), M = values_of(film, "M"), smallest = values_of(film, "strain_min");
  const auto half_step = [&](const char* quantity) { return 0.5 * film.json[quantity]["step"].get<Real>() * (1 + 1e-9); };
  EXPECT_LT(half_step("y"), 1.6 / 65535);
  for (Index f = 0; f < 5; ++f) {
    EXPECT_EQ(film.json["frames"][f]["time"], made.time(f));
    EXPECT_EQ(film.json["frames"][f]["stage"], made.stage(f));
    for (Index k = 0; k < 8; ++k) {
      EXPECT_NEAR(y[f][k], made.y(f, k), half_step("y"));
      EXPECT_NEAR(P[f][k], made.P(f, k), half_step("P"));
      EXPECT_NEAR(M[f][k], -2 * made.P(f, k), half_step("M"));
      EXPECT_NEAR(smallest[f][k], -2e-4 * f, half_step("strain_min"));
    }
  }
}

TEST(line_film, marks_the_ends_of_the_stages_that_load_the_line)
{
  const MadeLine made(5, 8);
  const auto ends = make_line_film(made.run, "f").json["ends"];
  ASSERT_EQ(ends.size(), 1u) << "the stages before lay it";
  EXPECT_EQ(ends[0]["name"], "current");
  EXPECT_EQ(ends[0]["frame"], 4);
}

TEST(line_film, of_a_long_run_leaves_out_frames_evenly_and_never_the_end_of_a_stage)
{
  const MadeLine made(1000, 2);
  const auto film = make_line_film(made.run, "f").json;
  EXPECT_EQ(film["note"], "every 3rd frame");
  std::vector<Real> times;
  for (const auto& frame : film["frames"]) times.push_back(frame["time"]);
  EXPECT_EQ(times.size(), 335u);
  for (const Index f : {0, 1, 3, 6, 999}) EXPECT_TRUE(std::count(times.begin(), times.end(), made.time(f))) << f;
  EXPECT_EQ(film["ends"][0]["frame"], 334);
}

TEST(line_film, of_a_long_line_leaves_out_nodes_that_a_page_cannot_tell_apart)
{
  const MadeLine made(3, 5000);
  const auto film = make_line_film(made.run, "f").json;
  const std::vector<Real> x = film["x"];
  EXPECT_EQ(film["note"], "390 of 5000 nodes");
  EXPECT_EQ(x.size(), 390u);
  EXPECT_EQ(x.back(), 4999);
  for (const Real near : {0., 1., 2., 3., 4.}) EXPECT_TRUE(std::count(x.begin(), x.end(), near)) << "where the line moves, x = " << near;
}

TEST(line_film, has_the_bed_of_the_slices_from_the_frame_in_which_the_slices_are_coupled)
{
  const MadeLine made(4, 4);
  made.folder.write("berms.csv", "frame,slice,x_m,rise_m_at_0.0_m,rise_m_at_0.1_m\n2,0,0,0,0.5\n2,1,3,0,0\n3,0,0,-0.5,1\n3,1,3,0,0.25\n");
  const Film film = make_line_film(made.run, "f");
  const auto& bed = film.json["bed"];
  EXPECT_EQ(film.json["slices"], (std::vector<Real>{0, 3}));
  EXPECT_EQ(bed["first"], 2);
  EXPECT_EQ(bed["y"], (std::vector<Real>{0, 0.1}));
  const SeenFilm seen{film};
  const auto codes = decoded_places(seen.bytes(bed["block"]), bed["frames"], 4, 1)[0];
  const std::vector<std::vector<Real>> expected{{0, 0.5, 0, 0}, {-0.5, 1, 0, 0.25}};
  ASSERT_EQ(codes.size(), 2u);
  for (std::size_t f = 0; f < 2; ++f)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(bed["low"].get<Real>() + bed["step"].get<Real>() * codes[f][k], expected[f][k], 1.5 / 65535) << f << " " << k;
}

TEST(line_film, of_a_damaged_or_missing_file_is_a_fault_in_words)
{
  const MadeLine made(3, 4);
  made.folder.write("line.csv", "frame\n");
  const Film damaged = make_line_film(made.run, "f");
  EXPECT_TRUE(damaged.json.is_null());
  ASSERT_EQ(damaged.faults.size(), 1u);
  EXPECT_NE(damaged.faults[0].find("line.csv:1: "), std::string::npos) << damaged.faults[0];
  std::filesystem::remove(made.folder / "line.csv");
  EXPECT_EQ(make_line_film(made.run, "f").faults, (std::vector<std::string>{"there is no film of the line: line.csv is missing"}));
  MadeLine begun(3, 4);
  begun.run.history = {};
  std::filesystem::remove(begun.folder / "line.csv");
  EXPECT_TRUE(make_line_film(begun.run, "f").faults.empty()) << "nothing is written yet";
}

}  // namespace
}  // namespace berm::report::this_file
