// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/display_units.hpp"

#include <gtest/gtest.h>

namespace berm::base::this_file {
namespace {

using Quantities = std::vector<run_folder::Quantity>;

const Quantities pushed = {{"V_end_of_push", 800, "N/m"}}, pushed_in_space = {{"V_end_of_push", 800, "N"}};
const BodyScale plane{.width = 0.02, .unit_weight = 430e3, .gravity_level = 50};
const BodyScale space{.width = 0.02, .unit_weight = 430e3, .gravity_level = 50, .dimension = 3};

TEST(DisplayUnits, tell_forces_of_the_plane_per_metre_and_over_the_weight_of_the_soil)
{
  const DisplayUnits shown({{plane, &pushed}});
  EXPECT_EQ(shown.force_text(plane, 800), "0.8 kN/m (40 kN/m in the prototype, 4.65 γ′ D²)");
  EXPECT_EQ(shown.force_columns("V")[0].content, "V, kN/m");
}

TEST(DisplayUnits, tell_forces_in_space_in_newtons_and_in_the_prototype_by_the_square_of_the_gravity_level)
{
  const DisplayUnits shown({{space, &pushed_in_space}});
  EXPECT_EQ(shown.force_text(space, 800), "0.8 kN (2000 kN in the prototype)");
  EXPECT_EQ(shown.force_columns("V")[0].content, "V, kN");
  EXPECT_NE(shown.scale_words().find("times its square"), std::string::npos);
  EXPECT_EQ(force_measure(space).kind, ForceMeasure::Kind::unknown);
}

TEST(ForceMeasure, is_an_entry_of_the_summary_where_there_is_one)
{
  const auto entry = [](const BodyScale& scale) {
    const auto found = measure_quantity(scale).value_or(run_folder::Quantity{"none", 0, ""});
    return std::pair(found.name, found.value);
  };
  EXPECT_EQ(entry(plane), std::pair(std::string("gammaD2"), 430e3 * 0.02 * 0.02));
  EXPECT_EQ(entry({.width = 0.5, .unit_weight = 7e3, .strength = 2e3}), std::pair(std::string("suD"), 1e3));
  EXPECT_EQ(entry(space).first, "none");
  EXPECT_EQ(entry({.width = 0, .unit_weight = 7e3, .strength = 2e3}).first, "none") << "no push or drag moves the body";
  EXPECT_EQ(entry({.width = 0.5, .unit_weight = 0}).first, "none");
}

TEST(DisplayUnits, name_both_units_on_a_page_of_both)
{
  const DisplayUnits shown({{plane, &pushed}, {space, &pushed_in_space}});
  EXPECT_EQ(shown.force_columns("V")[0].content, "V, kN/m, whole body kN");
  EXPECT_EQ(shown.force_text(plane, 100).substr(0, 8), "0.1 kN/m");
}

}  // namespace
}  // namespace berm::base::this_file
