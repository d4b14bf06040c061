// SPDX-License-Identifier: BSD-3-Clause
// The module is run by Python, with a class in place of OpenSees that keeps what it is told.
#include "samples/made_springs.hpp"
#include "samples/temporary_folder.hpp"
#include "springs/formats.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::springs::this_file {
namespace {

constexpr const char* reader = R"(import json
import springs_high as file

told = []


class Kept:
    def uniaxialMaterial(self, *words):
        told.append(["material", *words])

    def element(self, *words):
        told.append(["element", *words])


for number, name in enumerate(file.SPRINGS):
    file.element(Kept(), name, 10 + number, 1, 2, 3, 0.5)
with open("told.json", "w") as output:
    json.dump({"names": list(file.SPRINGS), "origins": [spring["origin"] for spring in file.SPRINGS.values()], "told": told}, output)
)";

TEST(OpenSeesFormat, gives_materials_through_the_points_of_the_springs_for_a_length_of_pipe)
{
  Springs named = made_springs();
  named.lateral[1].stage = "the \"second\"\n'sweep' \\";
  const Design design = made_design(named);
  const TemporaryFolder folder;
  for (const ExportFile& file : opensees_files(design)) folder.write(file.name, file.text);
  folder.write("read.py", reader);
  const std::string command = "cd '" + folder.path().string() + "' && python3 -B read.py 2> wrong.txt";
  ASSERT_EQ(std::system(command.c_str()), 0) << folder.read("wrong.txt");
  const auto read = nlohmann::json::parse(folder.read("told.json"));
  ASSERT_EQ(read["names"], nlohmann::json({"lateral sweep_1", "lateral " + named.lateral[1].stage, "axial", "vertical"}));
  EXPECT_NE(read["origins"][0].get<std::string>().find("run b1 (forces at 95 % of 11 runs), state operation (end of stage unload"),
            std::string::npos)
      << read["origins"][0];
  const Springs& high = *design.high;
  const std::vector<Points> springs = {high.lateral[0].spring(),
                                       high.lateral[1].spring(),
                                       {{0, 0}, {high.axial.u_breakout.best, high.axial.undrained}, {high.diameter, high.axial.undrained}}};
  ASSERT_EQ(read["told"].size(), 8u);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto &material = read["told"][2 * k], &element = read["told"][2 * k + 1];
    EXPECT_EQ(element, nlohmann::json({"element", "zeroLength", 10 + k, 1, 2, "-mat", 10 + k, "-dir", 3}));
    ASSERT_EQ(material[1], "ElasticMultiLinear");
    ASSERT_EQ(material[4], "-strain");
    const std::size_t count = (material.size() - 6) / 2;
    ASSERT_EQ(material[5 + count], "-stress");
    ASSERT_EQ(material.size(), 6 + 2 * count);
    const auto u = [&](std::size_t j) { return material[5 + j].get<double>(); };
    const auto F = [&](std::size_t j) { return material[6 + count + j].get<double>(); };
    for (std::size_t j = 1; j < count; ++j) EXPECT_GT(u(j), u(j - 1)) << "strains ascend";
    if (k == 3) {
      ASSERT_EQ(count, 5u) << "beyond the preload, the preload, the state, without load, above it";
      EXPECT_NEAR(F(1), -high.vertical.preload / 2, 1e-2) << "downwards is negative, on half a metre of pipe";
      EXPECT_NEAR(F(2), -high.V / 2, 1e-2);
      EXPECT_EQ(F(4), 0);
      EXPECT_EQ(F(3), 0);
      continue;
    }
    const bool axial = k == 2;
    const std::size_t points = springs[k].size(), ends = axial ? 0 : 1;
    ASSERT_EQ(count, 2 * (points + ends) - 1);
    for (std::size_t j = 0; j < points; ++j)
      for (const int sign : {1, -1}) {
        const std::size_t at = points + ends - 1 + static_cast<std::size_t>(sign) * j;
        EXPECT_NEAR(u(at), sign * springs[k][j].x, 1e-5 * springs[k][j].x);
        EXPECT_NEAR(F(at), sign * springs[k][j].F / 2, 1e-5 * springs[k][j].F) << "on half a metre of pipe";
      }
    EXPECT_EQ(F(count - 1), F(count - 2)) << "level beyond";
  }
}

}  // namespace
}  // namespace berm::springs::this_file
