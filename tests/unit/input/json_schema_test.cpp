// SPDX-License-Identifier: BSD-3-Clause
// That the examples fit and wrong inputs do not: web/tests/schema.test.ts.
#include "input/catalogue.hpp"
#include "settings/case.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::input::this_file {
namespace {

using Json = nlohmann::json;

const Json& schema()
{
  static const Json all = Json::parse(json_schema(catalogue_of<settings::Case>(), "A case"));
  return all;
}

/// The alternative of a table whose selector has this word.
Json alternative(const Json& table, const std::string& selector, const std::string& word)
{
  for (const Json& one : table["oneOf"])
    if (one["properties"][selector]["enum"][0] == word) return one;
  return {};
}

bool requires_key(const Json& table, const std::string& key)
{
  return table.contains("required") && std::ranges::find(table["required"], Json(key)) != table["required"].end();
}

TEST(JsonSchema, has_an_alternative_with_all_of_its_keys_for_each_word_that_selects)
{
  const Json sand = alternative(schema()["properties"]["material"]["additionalProperties"], "law", "mohr_coulomb");
  EXPECT_TRUE(sand["properties"].contains("friction_angle"));
  EXPECT_FALSE(sand["properties"].contains("undrained_strength"));
  EXPECT_TRUE(requires_key(sand, "law"));
  EXPECT_FALSE(requires_key(sand, "young_modulus")) << "a profile may stand for it";
  EXPECT_EQ(sand["additionalProperties"], false);
}

TEST(JsonSchema, takes_numbers_in_their_range_and_texts_with_units)
{
  const Json sand = alternative(schema()["properties"]["material"]["additionalProperties"], "law", "mohr_coulomb");
  const Json& density = sand["properties"]["density"];
  EXPECT_EQ(density["type"], Json({"number", "string"}));
  EXPECT_EQ(density["minimum"], 0);
  EXPECT_EQ(density["exclusiveMinimum"], true);
  EXPECT_EQ(density["x-unit"], "kg/m^3");
  EXPECT_NE(density["description"].get<std::string>().find("unit: kg/m^3"), std::string::npos);
}

TEST(JsonSchema, has_words_defaults_and_arrays)
{
  const Json& geometry = schema()["properties"]["geometry"];
  EXPECT_EQ(geometry["default"], "plane_strain");
  EXPECT_EQ(geometry["enum"].size(), 3u);
  EXPECT_EQ(schema()["properties"]["stage"]["type"], "array");
  EXPECT_TRUE(requires_key(schema(), "stage"));
}

}  // namespace
}  // namespace berm::input::this_file
