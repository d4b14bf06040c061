// SPDX-License-Identifier: BSD-3-Clause
#include "os/error.hpp"
#include "samples/clay_footing.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

/// The message that refuses the sample footing with a stage of this drive instead of its push; "" where it is not refused.
std::string refusal(const std::string& drive, const std::vector<std::string>& set = {})
{
  std::string text(coarse_footing);
  const std::string push = "kind = \"push\"\nvelocity = \"0.1 m/s\"";
  text.replace(text.find(push), push.size(), "kind = \"drive\"\n" + drive);
  try {
    read_case_text("footing.toml", text, set);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FiniteElements, drive_each_freedom_by_velocity_force_or_moment_and_have_no_springs)
{
  const std::vector<std::string> mass = {"rigid.footing.mass=1"};
  EXPECT_EQ(refusal("drive.x.velocity = 1\ndrive.rotation.velocity = 0.1"), "");
  EXPECT_EQ(refusal("drive.x.free = true\ndrive.y.hold = true\ndrive.rotation.moment = 5", mass), "");
  for (const char* spring : {"x.spring", "y.spring", "rotation.spring"}) {
    const std::string message = refusal(std::string("drive.") + spring + " = 5", mass);
    EXPECT_NE(message.find(std::string("stage.push.drive.") + spring), std::string::npos) << message;
    EXPECT_NE(message.find("finite elements have no springs"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace berm::input::this_file
