// SPDX-License-Identifier: BSD-3-Clause
#include "samples/program.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::commands::this_file {
namespace {

constexpr const char* line =
    "[pipe]\ndiameter = \"0.4 m\"\nwall = \"15 mm\"\nweight_laying = \"1 kN/m\"\nweight_operation = \"1.2 kN/m\"\nlay_factor = 2\n"
    "[operation]\ntemperature_rise = [\"60 K\"]\npressure_rise = [\"10 MPa\"]\n[[section]]\nname = \"a\"\nkp_from = \"0 km\"\nkp_to = \"3 "
    "km\"\n";

TEST(RouteCommand, gives_springs_by_kp_and_a_page)
{
  TemporaryFolder folder;
  folder.write("route.toml",
               std::string(line) + "friction_angle = [\"33 deg\"]\ninterface_angle = [\"28 deg\"]\nsubmerged_unit_weight = \"9 kN/m^3\"\n");
  const Ended ended = run_program(folder.path(), {"route", "route.toml", "-o", "out"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("lateral breakout resistance"), std::string::npos) << ended.out;
  for (const char* file : {"route.html", "springs.csv", "soils.csv", "summary.json"})
    EXPECT_FALSE(folder.read(std::string("out/") + file).empty());
  EXPECT_EQ(run_program(folder.path(), {"route", "route.toml", "-o", "out"}).status, 2) << "not over earlier results";
}

TEST(RouteCommand, takes_the_springs_of_a_run)
{
  TemporaryFolder folder;
  folder.write("route.toml", std::string(line) + "run = \"nowhere\"\n");
  const Ended refused = run_program(folder.path(), {"route", "route.toml", "-o", "out"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("there is no folder"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace berm::commands::this_file
