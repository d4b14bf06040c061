// SPDX-License-Identifier: BSD-3-Clause
#include "structures/line/shapes.hpp"

#include "os/error.hpp"
#include "samples/error_of.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::line::this_file {
namespace {

const std::string shape_head = "frame,time_s,stage,x_m,y_m,z_m,u_m,P_N,M_Nm,strain_max,strain_min\n";
const std::string two_nodes = "0,1.5,heat,0,0.4,0,0,1e3,2e3,1e-4,-1e-4\n0,1.5,heat,4,0.1,0,-0.01,1e3,0,0,0\n";

class Shapes : public testing::Test {
protected:
  /// The message that refuses a line.csv of such lines.
  std::string refusal(const std::string& lines)
  {
    folder_.write("line.csv", lines);
    return test::error_of<RunError>([&] { read_shapes(folder_.path()); });
  }
  TemporaryFolder folder_;
};

TEST_F(Shapes, are_read_frame_by_frame_and_none_without_a_file)
{
  EXPECT_TRUE(read_shapes(folder_.path()).empty());
  folder_.write("line.csv", shape_head + two_nodes + "1,2,cool,0,0.3,0,0,-5,-0,0,0\n1,2,cool,4,0.2,0,0,-5,-0,0,0\n");
  const std::vector<Shape> shapes = read_shapes(folder_.path());
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_EQ(shapes[0].stage, "heat");
  EXPECT_EQ(shapes[0].time, 1.5);
  EXPECT_EQ(shapes[0].u[1], -0.01);
  EXPECT_EQ(shapes[1].P[0], -5);
  EXPECT_EQ(last_of(shapes, "cool"), &shapes[1]);
  EXPECT_EQ(last_of(shapes, "lay"), nullptr);
}

TEST_F(Shapes, that_are_damaged_are_refused_with_file_and_line)
{
  EXPECT_NE(refusal("x,y\n").find("line.csv:1: the head of a file of shapes is frame,time_s"), std::string::npos);
  EXPECT_NE(refusal(shape_head + two_nodes + "1,2,cool,0,0.3\n").find("line.csv:4: 5 fields, and the head has 11"), std::string::npos);
  EXPECT_NE(refusal(shape_head + "0,1.5,heat,0,zero,0,0,1,2,0,0\n").find("line.csv:2: \"zero\" is not a number"), std::string::npos);
  EXPECT_LT(refusal(shape_head + "0,1.5,heat,0," + std::string(5000, 'a') + ",0,0,1,2,0,0\n").size(), 300u)
      << "a message does not repeat a word of thousands of letters";
  EXPECT_NE(refusal(shape_head + "0,1.5,heat,0,nan,0,0,1,2,0,0\n").find("line.csv:2: y_m is not finite"), std::string::npos);
  EXPECT_NE(refusal(shape_head + two_nodes + "0,1.5,heat,4,0,0,0,1,2,0,0\n").find("line.csv:4: x does not grow"), std::string::npos);
  EXPECT_NE(
      refusal(shape_head + two_nodes + "1,2,cool,0,0.3,0,0,-5,0,0,0\n").find("line.csv:4: the shapes have different numbers of nodes"),
      std::string::npos);
  EXPECT_NE(refusal(shape_head + two_nodes + "2,2,cool,0,0.3,0,0,-5,0,0,0\n").find("line.csv:4: the frame is neither"), std::string::npos);
  EXPECT_NE(refusal(shape_head + two_nodes + "1,2,cool,1,0.3,0,0,-5,0,0,0\n").find("line.csv:4: the nodes are not those"),
            std::string::npos);
  EXPECT_NE(
      refusal(shape_head + two_nodes + "1,2,cool,0,0.3,0,0,-5,0,0,0\n2,3,cool,0,0.3,0,0,-5,0,0,0\n").find("line.csv:5: the shapes have"),
      std::string::npos);
  EXPECT_NE(refusal(shape_head + two_nodes + "1,2").find("line.csv:3: the line after it has no end"), std::string::npos);
}

// Each byte by others that mean something to a table.
TEST_F(Shapes, that_are_damaged_anywhere_are_read_or_refused)
{
  const std::string whole = shape_head + two_nodes + "1,2,cool,0,0.3,0,0,-5,-0,0,0\n1,2,cool,4,0.2,0,0,-5,-0,0,0\n";
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const char other : {',', '"', '\n', '9', 'e', '-'}) {
      std::string damaged = whole;
      damaged[at] = other;
      folder_.write("line.csv", damaged);
      try {
        for (const Shape& shape : read_shapes(folder_.path())) EXPECT_EQ(shape.x.size(), shape.strain_min.size());
      } catch (const RunError&) {  // refused
      }
    }
}

}  // namespace
}  // namespace berm::line::this_file
