// SPDX-License-Identifier: BSD-3-Clause
#include "route/route_settings.hpp"

#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::route::this_file {
namespace {

const std::string good =
    "[pipe]\ndiameter = \"0.3 m\"\nwall = \"15 mm\"\nweight_laying = \"700 N/m\"\nweight_operation = \"900 N/m\"\nlay_factor = 2\n"
    "[operation]\nkp = [\"0 km\", \"10 km\"]\ntemperature_rise = [\"80 K\", \"20 K\"]\npressure_rise = [\"10 MPa\"]\n"
    "[[section]]\nname = \"a\"\nkp_from = \"0 km\"\nkp_to = \"10 km\"\nundrained_strength = [\"1 kPa\", \"2 kPa\", \"3 "
    "kPa\"]\nadhesion_factor = [0.5]\n"
    "submerged_unit_weight = \"5 kN/m^3\"\n";

RouteCase read_text(const std::string& text, const std::vector<std::string>& set = {})
{
  const TemporaryFolder folder;
  folder.write("route.toml", text);
  return read_route_case(folder.path() / "route.toml", set);
}

TEST(RouteSettings, are_read_with_one_number_or_three)
{
  const RouteCase c = read_text(good);
  EXPECT_EQ(c.operation.kp, (std::vector<Real>{0, 10000}));
  EXPECT_EQ(c.operation.pressure, std::vector<Real>{10e6});
  const Section& s = c.section.at(0);
  EXPECT_EQ(s.strength, (Estimates3{1000, 2000, 3000}));
  EXPECT_EQ(s.adhesion_factor, Estimates3{0.5});
  EXPECT_EQ(s.sensitivity, Estimates3{1});
  EXPECT_TRUE(s.is_clay());
  EXPECT_FALSE(c.pipe.flooded.has_value());
}

TEST(RouteSettings, are_refused_where_they_make_no_sense)
{
  const auto words = [](const std::vector<std::string>& set, const std::string& more = "") {
    try {
      read_text(good + more, set);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const auto& [set, told] : {std::pair("section.a.kp_to=\"0 km\"", "is not beyond kp_from"),
                                  {"section.a.undrained_strength=[\"3 kPa\", \"2 kPa\", \"1 kPa\"]", "has to rise from low to high"},
                                  {"section.a.undrained_strength=[\"2 kPa\", \"3 kPa\"]", "has to be one number"},
                                  {"section.a.friction_angle=[\"30 deg\"]", "cannot be combined with undrained_strength"},
                                  {"pipe.wall=\"0.2 m\"", "half of the diameter"},
                                  {"pipe.steel_diameter=\"0.4 m\"", "more than the outer diameter"},
                                  {"operation.temperature_rise=[\"1 K\", \"2 K\", \"3 K\"]", "has 3 numbers"}})
    EXPECT_NE(words({set}).find(told), std::string::npos) << set << ": " << words({set});
  const std::string second = "[[section]]\nkp_from = \"9 km\"\nkp_to = \"12 km\"\nsubmerged_unit_weight = \"9 kN/m^3\"\n";
  EXPECT_NE(
      words({}, second + "friction_angle = [\"30 deg\"]\ninterface_angle = [\"25 deg\"]\n").find("is not where the section before ends"),
      std::string::npos);
  EXPECT_NE(words({}, second).find("friction_angle"), std::string::npos) << words({}, second);
}

}  // namespace
}  // namespace berm::route::this_file
