// SPDX-License-Identifier: BSD-3-Clause
#include "input/places.hpp"

#include "input/override.hpp"
#include "os/error.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

constexpr const char* text = R"(title = "a"
[support.base]
boundary = "bottom"
[[stage]]
name = "push"
until = {time = 1}
)";

TEST(Places, name_file_line_and_key_of_what_was_written)
{
  const Places places(parse_text("case.toml", text));
  EXPECT_EQ(places.located("support.base.boundary", "is wrong").text(), "case.toml:3: support.base.boundary: is wrong");
  EXPECT_EQ(places.located(KeyError("stage[0].until.time: is wrong: 3")).text(), "case.toml:6: stage.push.until.time: is wrong: 3");
}

TEST(Places, of_a_key_that_is_absent_are_those_of_the_nearest_table)
{
  const Places places(parse_text("case.toml", text));
  EXPECT_EQ(places.located("support.base.fixed", "is missing").text(), "case.toml:2: support.base.fixed: is missing");
  EXPECT_EQ(places.located("output.frame_time", "is missing").text(), "case.toml:1: output.frame_time: is missing");
  EXPECT_FALSE(places.has("output.frame_time"));
  EXPECT_TRUE(places.has("stage[0].until.time"));
  EXPECT_FALSE(places.has("stage[1]"));
}

TEST(Places, name_the_override_that_wrote_a_key)
{
  Document document = parse_text("case.toml", text);
  apply_override(document, "stage.push.until.time=2");
  EXPECT_EQ(Places(document).located("stage[0].until.time", "is wrong").text(), "--set stage.push.until.time: is wrong");
}

TEST(Places, of_the_drags_of_a_sweep_are_those_of_the_sweep)
{
  const std::string two = "[[stage]]\nname = \"push\"\n[[stage]]\nname = \"sweep\"\nvelocity = 1\n";
  const Places places(parse_text("case.toml", two), {0, 1, 1});
  EXPECT_EQ(places.located("stage[2].velocity", "is wrong").text(), "case.toml:5: stage.sweep.velocity: is wrong");
}
TEST(Places, of_what_ends_the_drags_of_a_sweep_are_its_amplitude)
{
  const std::string two = "[[stage]]\nname = \"push\"\nuntil.time = 1\n[[stage]]\nname = \"sweep\"\namplitude = 1\n";
  const Places places(parse_text("case.toml", two), {0, 1, 1});
  EXPECT_EQ(places.located("stage[2].until", "is far").text(), "case.toml:6: stage.sweep.amplitude: is far");
  EXPECT_EQ(places.located("stage[1].until.displacement", "is far").text(), "case.toml:6: stage.sweep.amplitude: is far");
  EXPECT_EQ(places.located("stage[0].until.time", "is long").text(), "case.toml:3: stage.push.until.time: is long");
}

TEST(Places, of_a_case_without_a_file_are_keys_alone)
{
  EXPECT_EQ(Places().located(KeyError("surface: is wrong")).text(), "surface: is wrong");
  EXPECT_EQ(Places().located(KeyError("a message without a key")).text(), "a message without a key");
  EXPECT_FALSE(Places().has("surface"));
}

}  // namespace
}  // namespace berm::input::this_file
