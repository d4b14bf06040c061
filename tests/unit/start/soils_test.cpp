// SPDX-License-Identifier: BSD-3-Clause
// Soils by name: each has a source, and makes a case of each kind that takes it.
#include "start/soils.hpp"

#include "input/read_case.hpp"
#include "os/error.hpp"

#include <gtest/gtest.h>

namespace berm::start::this_file {
namespace {

TEST(Soils, have_a_source_and_say_how_far_they_reach)
{
  for (const Soil& one : soils()) {
    EXPECT_TRUE(one.material == "clay" || one.material == "sand") << one.name;
    EXPECT_GT(one.source.size(), 30u) << one.name;
    EXPECT_GT(one.trust.size(), 30u) << one.name;
  }
}

TEST(Soils, make_a_case_of_each_kind_that_takes_them)
{
  int count = 0;
  for (const Kind& kind : kinds())
    for (const std::string& soil : soils_for(kind)) {
      const std::string text = with_soil(kind, at_size(kind, "normal"), soil);
      EXPECT_NO_THROW(input::read_case_text(kind.name + ".toml", text)) << kind.name << " " << soil;
      ++count;
    }
  EXPECT_GT(count, 30);
}

TEST(Soils, take_the_place_of_the_material_and_leave_the_rest)
{
  const Kind& kind = kind_called("pipe-in-clay");
  const std::string text = with_soil(kind, kind.text, "kaolin");
  EXPECT_NE(text.find("[material.clay]\n# Kaolin"), std::string::npos);
  EXPECT_EQ(text.find("s_u = 2 kPa + 1.5 kPa/m z"), std::string::npos);
  EXPECT_EQ(text.substr(text.find("[body.clay]")), kind.text.substr(kind.text.find("[body.clay]")));
  const auto settings = input::read_case_text("case.toml", text);
  EXPECT_EQ(settings.material.size(), 1u);
}

TEST(Soils, are_refused_where_they_do_not_fit)
{
  const Kind& clay = kind_called("pipe-in-clay");
  EXPECT_THROW(with_soil(clay, clay.text, "calcareous"), InputError);
  EXPECT_THROW(with_soil(clay, clay.text, "mud"), InputError);
  const Kind& silt = kind_called("trench-and-backfill");
  EXPECT_THROW(with_soil(silt, silt.text, "kaolin"), InputError);
}

}  // namespace
}  // namespace berm::start::this_file
