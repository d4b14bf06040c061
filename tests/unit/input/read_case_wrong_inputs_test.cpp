// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"
#include "os/error.hpp"
#include "samples/falling_stone.hpp"
#include "samples/wrong_inputs.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::input::this_file {
namespace {

using test::WrongInput;

std::string message_of(const WrongInput& wrong)
{
  try {
    read_case_text("case.toml", text_of(wrong), wrong.overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class WrongInputs : public testing::TestWithParam<WrongInput> {};

TEST_P(WrongInputs, are_refused_in_one_line_with_place_key_and_what_is_allowed)
{
  const WrongInput& wrong = GetParam();
  ASSERT_NE(test::good_case.find(wrong.replaced), std::string::npos);
  const std::string message = message_of(wrong);
  ASSERT_FALSE(message.empty()) << "nothing was thrown";
  const std::string place = wrong.line > 0 ? "case.toml:" + std::to_string(wrong.line) + ": " : "--set ";
  EXPECT_TRUE(message.starts_with(place)) << message;
  for (const std::string& part : wrong.says) EXPECT_NE(message.find(part), std::string::npos) << "no `" << part << "` in: " << message;
  for (const char c : message) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << message;
  RecordProperty("message", message);
}

INSTANTIATE_TEST_SUITE_P(Table, WrongInputs, testing::ValuesIn(test::wrong_inputs()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(ReadCase, refuses_a_box_of_more_cells_than_any_soil_in_it_needs)
{
  const auto read = [](const char* cells) {
    read_case_text("case.toml", std::string(test::falling_stone), {std::string("mesh.cells=") + cells});
  };
  EXPECT_NO_THROW(read("[1000, 1000]"));
  try {
    read("[100000, 100]");
    ADD_FAILURE() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("mesh.cells: makes 1e+07 cells for "), std::string::npos) << error.what();
  }
}

TEST(ReadCase, takes_the_good_case)
{
  const settings::Case read = read_case_text("case.toml", std::string(test::good_case));
  EXPECT_EQ(read.title, "a pipe on sand");
  ASSERT_EQ(read.gravity.size(), 2u);
  EXPECT_DOUBLE_EQ(read.gravity[1], -standard_gravity);
  ASSERT_EQ(read.material.size(), 2u);
  EXPECT_EQ(read.material[0].first, "sand");
  EXPECT_DOUBLE_EQ(read.material[0].second.get<material::MohrCoulomb>().friction_angle, 35 * pi / 180);
  EXPECT_DOUBLE_EQ(read.material[1].second.get<material::LinearElastic>().young_modulus, 2e6);
  EXPECT_EQ(read.body[0].second.region_damping, (std::map<std::string, Real>{{"box", 0.05}}));
  EXPECT_FALSE(read.body[0].second.block.has_value());
  ASSERT_EQ(read.stage.size(), 2u);
  EXPECT_EQ(read.stage[0].kind, settings::StageKind::push);
  EXPECT_DOUBLE_EQ(read.stage[0].until.embedment.value(), 0.08);
  EXPECT_DOUBLE_EQ(read.stage[1].until.displacement.value(), 0.4);
  EXPECT_EQ(read.stage[1].until.force, std::nullopt);
  EXPECT_EQ(read.support[0].second.fixed, (std::vector<std::string>{"x", "y"}));
}

TEST(ReadCase, says_that_a_file_is_missing_or_a_folder)
{
  for (const char* path : {"/no/such/case.toml", "/"}) {
    try {
      read_case(path);
      FAIL() << "nothing was thrown";
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(path)) << error.what();
    }
  }
}

// Whatever a slip of the hand does to a good file: it is read, or refused with InputError; it never stops the program.
TEST(ReadCase, survives_random_damage)
{
  std::mt19937 random(1);
  const std::string marks = "[]{}\"'=.,#\n\r\t &\\_-+0xeEnT:\xff\xc3";
  int refused = 0;
  for (int trial = 0; trial < 10000; ++trial) {
    std::string text(test::good_case);
    for (auto hits = 1 + random() % 4; hits > 0; --hits) {
      const std::size_t place = random() % text.size();
      switch (random() % 3) {
      case 0:
        text[place] = marks[random() % marks.size()];
        break;
      case 1:
        text.insert(place, 1, marks[random() % marks.size()]);
        break;
      default:
        text.erase(place, 1 + random() % 5);
      }
    }
    try {
      read_case_text("case.toml", text);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 5000);
}

}  // namespace
}  // namespace berm::input::this_file
