// SPDX-License-Identifier: BSD-3-Clause
#include "structures/line/beds.hpp"

#include "os/error.hpp"
#include "samples/error_of.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::line::this_file {
namespace {

const std::string head = "frame,slice,x_m,rise_m_at_-0.050_m,rise_m_at_0.050_m\n", first_frame = "3,0,0,0,0.1\n3,1,4,-0.2,0\n";

class BedsOfSlices : public testing::Test {
protected:
  /// The message that refuses a berms.csv of such lines.
  std::string refusal(const std::string& lines)
  {
    folder_.write("berms.csv", lines);
    return test::error_of<RunError>([&] { read_beds(folder_.path()); });
  }
  void expect_refused(const std::string& lines, const std::string& words)
  {
    EXPECT_NE(refusal(lines).find(words), std::string::npos) << words << " in " << refusal(lines);
  }
  TemporaryFolder folder_;
};

TEST_F(BedsOfSlices, are_read_by_frame_slice_and_column)
{
  EXPECT_TRUE(read_beds(folder_.path()).rise.empty()) << "there is no file";
  folder_.write("berms.csv", head + first_frame + "4,0,0,0.5,0.6\n4,1,4,0.7,0.8\n");
  const Beds beds = read_beds(folder_.path());
  EXPECT_EQ(beds.first_frame, 3);
  EXPECT_EQ(beds.x, (std::vector<Real>{0, 4}));
  EXPECT_EQ(beds.y, (std::vector<Real>{-0.05, 0.05}));
  EXPECT_EQ(beds.rise, (std::vector<std::vector<Real>>{{0, 0.1, -0.2, 0}, {0.5, 0.6, 0.7, 0.8}}));
}

TEST_F(BedsOfSlices, that_are_damaged_are_refused_with_file_and_line)
{
  expect_refused("frame,slice\n", "berms.csv:1: the head of a file of beds");
  expect_refused("frame,slice,x_m,height_m\n", "berms.csv:1: \"height_m\" names no column");
  expect_refused("frame,slice,x_m,rise_m_at_1_m,rise_m_at_0_m\n", "berms.csv:1: the columns do not ascend");
  expect_refused(head + "3,0,0,0\n", "berms.csv:2: 4 fields, and the head has 5");
  expect_refused(head + "3,1,4,0,0\n", "berms.csv:2: the frame is neither");
  expect_refused(head + "3,0,0,0,high\n", "berms.csv:2: \"high\" is not a number");
  expect_refused(head + "3,0,0,0,inf\n", "berms.csv:2: a rise is not finite");
  expect_refused(head + first_frame + "5,0,0,0,0\n", "berms.csv:4: the frame is neither");
  expect_refused(head + first_frame + "4,0,0,0,0\n4,2,8,0,0\n", "berms.csv:5: the slice does not follow");
  expect_refused(head + first_frame + "4,0,1,0,0\n", "berms.csv:4: the slices are not those");
  expect_refused(head + first_frame + "4,0,0,0,0\n", "berms.csv:4: the last frame lacks slices");
}

}  // namespace
}  // namespace berm::line::this_file
