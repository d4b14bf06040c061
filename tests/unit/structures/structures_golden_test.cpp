// SPDX-License-Identifier: BSD-3-Clause
#include "structures/structures.hpp"

#include "samples/made_line_run.hpp"
#include "samples/made_pile.hpp"
#include "samples/made_push.hpp"
#include "samples/made_run.hpp"
#include "samples/temporary_folder.hpp"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>

namespace berm::structures::this_file {
namespace {

/// What the page and the log say of a run, without its drawings.
std::string told_of(record::RunRecord run)
{
  const base::Structure& structure = structure_of(run.settings);
  run.quantities = structure.quantities(run, {});
  run.end = record::RunEnd::finished;
  const base::DisplayUnits shown({{base::body_scale(run), &run.quantities}});
  const base::Runs alone = {{&run, 0}};
  const std::string page = structure.in_words(run, shown) + "\n" + structure.key_results(alone, shown) +
                           structure.published_values(alone, shown) + structure.other_results(run, "results-0") +
                           structure.quality_note(alone);
  static const std::regex drawing("<svg[^]*?</svg>");
  return std::regex_replace(page, drawing, "<svg/>") + "<pre>\n" + structure.table_of(run) + "</pre>\n";
}

/// Compares with tests/samples/golden/STRUCTURE.html, which BERM_RENEW_GOLDEN=1 in the environment writes anew: read what git diff shows then.
void expect_golden(const record::RunRecord& run)
{
  const std::filesystem::path file =
      std::filesystem::path(BERM_SOURCE_DIR) / "tests/samples/golden" / (std::string(structure_of(run.settings).word) + ".html");
  const std::string told = told_of(run);
  if (const char* renew = std::getenv("BERM_RENEW_GOLDEN"); renew != nullptr && *renew == '1') std::ofstream(file) << told;
  std::ostringstream golden;
  golden << std::ifstream(file).rdbuf();
  EXPECT_EQ(told, golden.str()) << file;
}

MadePush pushed(const bodies::RigidShapeSettings& shape)
{
  MadePush made;
  made.shape = shape;
  return made;
}

TEST(GoldenPages, of_bodies_that_are_pushed_down)
{
  MadePush cone = pushed(MadePush::cone()), ball = pushed(bodies::CircleSettings{{0, 0.1}, 0.2}),
           footing = pushed(bodies::BoxSettings{{0, 0.05}, {0.2, 0.1}, 0}), bar = pushed(bodies::CircleSettings{{0, -0.4}, 0.2}),
           skirt = pushed(bodies::ProfileSettings{{0.09, 0.1, 0.1, 0.09}, {0, 0, 3, 3}});
  cone.q = [](Real z) { return 5e3 * z + (z < 1 ? 50e3 + 50e3 * z : 100e3); };
  footing.pushed_to = 0.1, footing.q = [](Real z) { return 5e3 * z + 6.048 * 10e3; };
  skirt.contact.adhesion = 4e3, skirt.shaft = [](Real z) { return 4e3 * pi * 0.38 * z; };
  for (const MadePush& made : {cone, ball, footing, skirt}) expect_golden(made.record());
  bar.geometry = settings::Geometry::plane_strain, bar.first_w = 0.5;
  expect_golden(bar.record());
}

TEST(GoldenPages, of_a_pile_that_is_loaded_sideways)
{
  expect_golden(MadePile{}.record());
}

TEST(GoldenPages, of_bodies_that_are_dragged)
{
  expect_golden(MadeRun{}.record());
  MadeRun towed;
  towed.method = settings::Method::fem, towed.dragged = 0.2;
  towed.sunk = [](Real u) { return std::min(u, 0.1) / 2; }, towed.H = [](Real u) { return 3e4 * std::min(u, 0.1); };
  record::RunRecord run = towed.record();
  run.settings.rigid[0].second.structure = "anchor";
  expect_golden(run);
}

TEST(GoldenPages, of_a_line_and_of_any_other_case)
{
  const TemporaryFolder folder;
  test::MadeLineRun line;
  line.springs = true;
  expect_golden(line.record(folder));
  record::RunRecord other = MadeRun{}.record();
  other.settings.stage = {MadeRun::stage_of("fall", settings::StageKind::free)};
  expect_golden(other);
}

}  // namespace
}  // namespace berm::structures::this_file
