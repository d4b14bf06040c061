// SPDX-License-Identifier: BSD-3-Clause
#include "structures/line/line_shapes.hpp"

#include "samples/error_of.hpp"
#include "samples/made_line.hpp"

#include <gtest/gtest.h>

namespace berm::line::this_file {
namespace {

const std::string head = "frame,time_s,stage,x_m,y_m,z_m,u_m,P_N,M_Nm,strain_max,strain_min\n";
const std::string first = "0,0.5,heat,0,1,2,3,4,5,6,7\n0,0.5,heat,8,1,2,3,4,5,6,7\n";

TEST(LineShapes, are_read_as_they_were_written)
{
  const MadeLine made(4, 6);
  const LineShapes shapes = read_line_shapes(made.folder / "line.csv");
  ASSERT_EQ(shapes.x, (std::vector<Real>{0, 1, 2, 3, 4, 5}));
  ASSERT_EQ(shapes.frames.size(), 4u);
  for (Index f = 0; f < 4; ++f) {
    const LineShape& shape = shapes.frames[f];
    EXPECT_EQ(shape.time, made.time(f));
    EXPECT_EQ(shape.stage, made.stage(f));
    for (Index k = 0; k < 6; ++k) {
      EXPECT_EQ(shape.y[k], made.y(f, k));
      EXPECT_EQ(shape.z[k], -0.01 * f);
      EXPECT_EQ(shape.u[k], 0.001 * k);
      EXPECT_EQ(shape.P[k], made.P(f, k));
      EXPECT_EQ(shape.M[k], -2 * made.P(f, k));
      EXPECT_EQ(shape.strain_max[k], 1e-4 * f);
      EXPECT_EQ(shape.strain_min[k], -2e-4 * f);
    }
  }
}

TEST(LineShapes, have_no_frames_without_a_file)
{
  const TemporaryFolder folder;
  EXPECT_TRUE(read_line_shapes(folder / "line.csv").frames.empty());
}

/// A damaged text, and what is said of it.
struct Damage {
  std::string text, words;
};

TEST(LineShapes, that_are_damaged_are_refused_with_file_and_line)
{
  const TemporaryFolder folder;
  for (const auto& [text, words] : {
           Damage{"frame,x\n0,1\n", "line 1: the columns are not frame,time_s"},
           Damage{head + "0,0.5,heat,0,1,2\n", "line 2: 6 fields for 11 columns"},
           Damage{head + "0,0.5,heat,0,one,2,3,4,5,6,7\n", "line 2: y_m is no number"},
           Damage{head + "0,0.5,heat,0,nan,2,3,4,5,6,7\n", "line 2: y_m is no number"},
           Damage{head + first + "2,1,heat,0,1,2,3,4,5,6,7\n", "line 4: the frame is neither that of the line before nor the next"},
           Damage{head + first + "1,1,heat,1,1,2,3,4,5,6,7\n", "line 4: the nodes are not those of the first frame"},
           Damage{head + first + "1,1,heat,0,1,2,3,4,5,6,7\n", "line 4: a frame has fewer nodes than the first"},
           Damage{head + first + "1,1,heat,0,1,2,3,4,5,6,7\n2,1,heat,0,1,2,3,4,5,6,7\n", "line 5: a frame has fewer nodes than the first"},
           Damage{head + first + first + first.substr(0, 9), "line 5: the line after it has no end"},
       }) {
    folder.write("line.csv", text);
    const std::string error = test::error_of<RunError>([&] { read_line_shapes(folder / "line.csv"); });
    EXPECT_NE(error.find("line.csv: " + words), std::string::npos) << error << "\nfor\n" << text;
  }
}

}  // namespace
}  // namespace berm::line::this_file
