// SPDX-License-Identifier: BSD-3-Clause
#include "macro_element/parameters.hpp"

#include "os/error.hpp"
#include "samples/error_of.hpp"
#include "samples/macro_element_parameters.hpp"

#include <cstring>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::macro_element::this_file {
namespace {

using Json = nlohmann::ordered_json;

Parameters with_points()
{
  Parameters p = sample_parameters();
  p.backbone_points = 2;
  p.backbone_w[0] = 0.01, p.backbone_w[1] = 0.1;
  p.backbone_V[0] = 1000. / 3, p.backbone_V[1] = 4000;
  return p;
}

/// The refusal of what json_of() gives, once a value at that place is another.
std::string refused(const char* place, const Json& value)
{
  Json all = json_of(with_points());
  all[Json::json_pointer(place)] = value;
  return test::error_of<InputError>([&] { parameters_in(all.dump(), "m.json"); });
}

TEST(MacroElementParameters, come_back_from_their_file_bit_for_bit)
{
  for (const Parameters& p : {sample_parameters(), with_points()}) {
    const Parameters back = parameters_in(json_of(p).dump(2), "m.json");
    for (const berm_macro_element_member& m : berm_macro_element_members) EXPECT_EQ(value_of(back, m), value_of(p, m)) << m.name;
    ASSERT_EQ(back.backbone_points, p.backbone_points);
    EXPECT_EQ(std::memcmp(back.backbone_w, p.backbone_w, sizeof p.backbone_w), 0);
    EXPECT_EQ(std::memcmp(back.backbone_V, p.backbone_V, sizeof p.backbone_V), 0);
    EXPECT_EQ(berm_macro_element_check(&back, nullptr), BERM_MACRO_ELEMENT_OK);
  }
}

TEST(MacroElementParameters, are_refused_with_file_key_and_what_is_allowed)
{
  EXPECT_EQ(refused("/version", 1), "m.json: version: it is 1, and this berm takes 2: fit to the runs again by berm macro-element");
  EXPECT_EQ(refused("/parameters/peak_ratio/value", -1), "m.json: parameters.peak_ratio.value: -1 is not more than 0");
  for (const double value : {1e-296, 1e300})
    EXPECT_EQ(refused("/parameters/vertical_stiffness/value", value),
              fmt::format("m.json: parameters.vertical_stiffness.value: {:g} is beyond any pipe and soil", value));
  EXPECT_EQ(refused("/parameters/first_yield/value", 0.4), "m.json: parameters.first_yield.value: 0.4 is not 0.5 or more, 1 or less");
  EXPECT_EQ(refused("/parameters/surface_b1/value", 1), "m.json: parameters.surface_b1.value: 1 is not more than 0, less than 1");
  EXPECT_EQ(refused("/parameters/flow_zero/value", 1), "m.json: parameters.flow_zero.value: 1 is not 0.95 or less");
  EXPECT_EQ(refused("/parameters/uplift_ratio/value", 0.5), "m.json: parameters.uplift_ratio.value: surface_beta or less");
  EXPECT_EQ(refused("/parameters/axial_friction/value", "0.5"), "m.json: parameters.axial_friction.value: a number");
  EXPECT_EQ(refused("/parameters/axial_mobilisation/unit", "mm"), "m.json: parameters.axial_mobilisation.unit: \"m\"");
  EXPECT_EQ(refused("/parameters/backbone_w/value", {0.1, 0.01}),
            "m.json: parameters.backbone_w.value: numbers that ascend, the first more than 0");
  EXPECT_EQ(refused("/parameters/backbone_V/value", {1000}), "m.json: parameters.backbone_V.value: as many numbers as backbone_w has");
  EXPECT_EQ(refused("/parameters/backbone_w/value", std::vector<int>(33, 1)),
            "m.json: parameters.backbone_w.value: a list of 32 numbers at most");
  EXPECT_EQ(refused("/parameters", 0), "m.json: there is no parameters.diameter");
  EXPECT_EQ(test::error_of<InputError>([] { parameters_in("{}", "m.json"); }), "m.json: there is no version");
  EXPECT_EQ(test::error_of<InputError>([] { parameters_in("[1, \x7f", "m.json"); }), "m.json: no JSON at line 1, column 5");
  EXPECT_EQ(test::error_of<InputError>([] { parameters_in(std::string(100000, '['), "m.json"); }).find("m.json: no JSON"), 0U);
}

}  // namespace
}  // namespace berm::macro_element::this_file
