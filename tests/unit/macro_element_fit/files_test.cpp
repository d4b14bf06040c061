// SPDX-License-Identifier: BSD-3-Clause
#include "macro_element_fit/files.hpp"

#include "io/atomic_file.hpp"
#include "io/scratch_folder.hpp"
#include "samples/macro_element_parameters.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::macro_element_fit::this_file {
namespace {

namespace fs = std::filesystem;

Parameters with_points()
{
  Parameters p = macro_element::sample_parameters();
  p.backbone_factor = p.backbone_power = 0;
  p.backbone_points = 2;
  p.backbone_w[0] = 0.01, p.backbone_w[1] = 0.1;
  p.backbone_V[0] = 1000. / 3, p.backbone_V[1] = 4000;
  return p;
}

TEST(MacroElementFiles, the_c_code_compiles_as_c99_by_itself_and_steps_to_the_bits_of_the_program)
{
  const io::ScratchFolder folder;
  const Parameters p = with_points();
  write_files(folder.path(), p, {});
  io::write_atomically(folder.path() / "main.c", R"(#include "macro_element.h"
#include <stdio.h>
int main(void)
{
  berm_macro_element_state s;
  double d[3] = {0, 0, 0.05}, F[3], K[3][3];
  int k, error = berm_macro_element_start(&berm_macro_element_fitted, d, 1000, &s);
  for (k = 0; k < 50 && !error; ++k) {
    d[0] += 0.001, d[1] += 0.003, d[2] += 0.0005;
    error = berm_macro_element_step(&berm_macro_element_fitted, &s, d, &s, F, K);
  }
  printf("%d %a %a %a %a", error, F[0], F[1], F[2], K[1][2]);
  return 0;
}
)");
  // Sums in the order of the source, as the program's own.
  const std::string command = fmt::format(
      "cd {} && cc -std=c99 -pedantic -Wall -Wextra -Werror -O1 -ffp-contract=off main.c macro_element.c -lm -o main && ./main > out",
      folder.path().string());
  ASSERT_EQ(std::system(command.c_str()), 0);
  berm_macro_element_state s;
  double d[3] = {0, 0, 0.05}, F[3], K[3][3];
  int error = berm_macro_element_start(&p, d, 1000, &s);
  for (int k = 0; k < 50 && error == 0; ++k) {
    d[0] += 0.001, d[1] += 0.003, d[2] += 0.0005;
    error = berm_macro_element_step(&p, &s, d, &s, F, K);
  }
  std::ifstream out(folder.path() / "out");
  int its_error = -1;
  std::string T, H, V, K12;
  out >> its_error >> T >> H >> V >> K12;
  EXPECT_EQ(error, 0);
  EXPECT_EQ(its_error, 0);
  EXPECT_DOUBLE_EQ(std::strtod(T.c_str(), nullptr), F[0]);
  EXPECT_DOUBLE_EQ(std::strtod(H.c_str(), nullptr), F[1]);
  EXPECT_DOUBLE_EQ(std::strtod(V.c_str(), nullptr), F[2]);
  EXPECT_NEAR(std::strtod(K12.c_str(), nullptr), K[1][2], 1e-9 * p.vertical_stiffness);
}

TEST(MacroElementFiles, json_has_each_parameter_with_its_unit_and_each_run_with_its_misfit)
{
  Path path;
  path.name = "a";
  path.diameter = 0.5;
  for (int k = 1; k < 20; ++k) path.points.push_back({0, 0.005 * k, 0, 100. * k, false});
  const Parameters p = with_points();
  const auto all = nlohmann::json::parse(json_of(p, {compare(p, path, false)}));
  EXPECT_EQ(all["parameters"]["peak_ratio"]["value"], 0.35);
  EXPECT_EQ(all["parameters"]["berm_rate"]["unit"], "N/m^3");
  EXPECT_EQ(all["parameters"]["backbone_V"]["value"][0], 1000. / 3);
  EXPECT_EQ(all["runs"][0]["fitted"], false);
  EXPECT_TRUE(all["runs"][0]["rms_H_over_largest"].is_null()) << "nothing was dragged";
  EXPECT_GT(all["runs"][0]["rms_V_over_largest"], 0);
}

TEST(MacroElementFiles, say_that_the_answer_of_a_run_is_invalid)
{
  Path path;
  path.name = "a";
  path.diameter = 0.5;
  path.invalid = {"11 % of the work */ is not balanced"};
  for (int k = 1; k < 20; ++k) path.points.push_back({0, 0.005 * k, 0, 100. * k, false});
  const Parameters p = with_points();
  const std::vector<Comparison> fitted{compare(p, path, true)};
  const std::string line = "(!) the answer of a is invalid, do not use what is fitted to it: 11 % of the work ";
  EXPECT_NE(table_of(fitted).find(line), std::string::npos);
  EXPECT_NE(code_of(p, fitted).find(line + "/ is"), std::string::npos) << "nothing ends the comment";
  EXPECT_EQ(nlohmann::json::parse(json_of(p, fitted))["runs"][0]["invalid"].size(), 1U);
  EXPECT_NE(table_of({compare(p, path, false)}).find("do not use it as a check"), std::string::npos);
}

TEST(MacroElementFiles, the_table_names_each_run_and_whether_it_was_fitted)
{
  Path path;
  path.name = "a";
  path.diameter = 0.5;
  for (int k = 1; k < 20; ++k) path.points.push_back({0, 0.005 * k, 0, 100. * k, false});
  const std::string table = table_of({compare(with_points(), path, false)});
  EXPECT_NE(table.find("a     not fitted             -"), std::string::npos) << table;
}

}  // namespace
}  // namespace berm::macro_element_fit::this_file
