// SPDX-License-Identifier: BSD-3-Clause
#include "report/quality/quality_section.hpp"

#include "io/atomic_file.hpp"
#include "samples/history_columns.hpp"
#include "samples/pipe_case.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/structures.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

std::string trust_of(const std::vector<record::RunRecord>& runs)
{
  return quality_section(runs, judgements_of(runs));
}

void set_gap(record::RunRecord& run, Real metres)
{
  for (run_folder::Quantity& quantity : run.quantities) {
    if (quantity.name == "gap_mean") quantity.value = metres;
    if (quantity.name == "gap_mean_over_D") quantity.value = metres / base::body_scale(run.settings).width;
  }
}

/// What is looked at in a run, by its words.
base::TrustMeasure measure_of(const record::RunRecord& run, const std::string& what)
{
  for (const base::TrustMeasure& measure : structures::structure_of(run.settings).measures(run.settings))
    if (measure.what == what) return measure;
  throw std::out_of_range(what);
}

/// The row of a table of the page.
std::string row_of(const std::string& html, const std::string& heading)
{
  const std::size_t begin = html.find("<th scope=\"row\">" + heading);
  return begin == std::string::npos ? "" : html.substr(begin, html.find("</tr>", begin) - begin);
}

TEST(trust, nothing_wrong_is_said)
{
  const std::string html =
      trust_of({sample_record(sample_case({"material.sand.friction_angle=9 deg", "material.sand.dilation_angle=9 deg"}))});
  EXPECT_TRUE(contains(html, "nothing is wrong")) << html;
  EXPECT_FALSE(contains(html, "li class=\"warning\"")) << html;
}

TEST(trust, each_limit_names_a_section_of_what_will_catch_you)
{
  const std::string page = io::read_text_file(std::string(BERM_SOURCE_DIR) + "/docs/how_to/what_will_catch_you.md");
  for (int effect = 0; effect < static_cast<int>(base::Effect::count); ++effect) {
    const std::string heading = base::heading_of(static_cast<base::Effect>(effect));
    EXPECT_TRUE(contains(page, "\n## " + heading + "\n")) << heading;
  }
  const std::string html = trust_of({sample_record(sample_case())});
  EXPECT_TRUE(contains(row_of(html, "energy that does not balance"), "See <cite>Energy</cite>")) << html;
  EXPECT_TRUE(contains(row_of(html, "kinetic energy over the work, push"), "See <cite>Drive speed</cite>"));
  EXPECT_TRUE(contains(row_of(html, "cells at the pipe"), "See <cite>Cells</cite>"));
  EXPECT_TRUE(contains(html, "docs/how_to/what_will_catch_you.md"));
}

TEST(trust, cells_that_are_fine_enough_for_other_soil_are_bad_where_it_dilates)
{
  const auto said = [](const char* dilation_angle) {
    return contains(trust_of({sample_record(sample_case({std::string("material.sand.dilation_angle=") + dilation_angle}))}),
                    "soil that dilates so much is too strong");
  };
  EXPECT_TRUE(said("35 deg"));
  EXPECT_FALSE(said("5 deg"));
}

// A wall works the soil over its depth, however thick it is.
TEST(trust, cells_in_dilating_soil_are_judged_by_the_depth_of_a_wall_that_is_only_dragged)
{
  record::RunRecord wall = sample_record(sample_case({"material.sand.dilation_angle=35 deg"}));
  wall.settings.rigid[0].second.shape = bodies::BoxSettings{{0, 0}, {10, 0.02}, 0};
  wall.history = {columns_named({"time_s", "w_m"}), {{0, 1}, {0.012, 0.012}}, {"drag", "drag"}};
  EXPECT_FALSE(contains(trust_of({wall}), "of its depth in the soil")) << "it is pushed, too";
  std::erase_if(wall.settings.stage, [](const auto& stage) { return stage.kind == settings::StageKind::push; });
  EXPECT_TRUE(contains(trust_of({wall}), "of its depth in the soil at the"));
  wall.history.values = {{}, {}}, wall.history.stage = {};
  EXPECT_FALSE(contains(trust_of({wall}), "of its depth in the soil")) << "it has not begun";
}

TEST(trust, a_filter_that_takes_much_of_the_work_is_bad)
{
  record::RunRecord run = sample_record(sample_case());
  for (const auto& [part, bad] : {std::pair(0.01, false), std::pair(0.11, true)}) {
    run.summary->checks["filter_over_work"] = part;
    EXPECT_EQ(contains(trust_of({run}), "slows flowing soil"), bad) << part;
  }
}

// A slope or a cut that fails by its own weight: there is no width to compare the cells with.
TEST(trust, cells_are_not_called_fine_where_nothing_judges_them)
{
  record::RunRecord run = sample_record(sample_case());
  ASSERT_FALSE(contains(trust_of({run}), "Cells are not judged"));
  for (settings::StageSettings& stage : run.settings.stage) stage.kind = settings::StageKind::free;
  run.quantities.clear();
  const std::string html = trust_of({run});
  EXPECT_TRUE(contains(html, "Cells are not judged: <strong>" + run.name)) << html;
  EXPECT_FALSE(contains(html, "nothing is wrong"));
}

TEST(trust, elements_at_a_body_that_is_turned_are_judged)
{
  record::RunRecord run = sample_record(sample_case());
  run.settings.method = settings::Method::fem;
  for (settings::StageSettings& stage : run.settings.stage) stage.kind = settings::StageKind::drive, stage.drive.rotation.velocity = 0.01;
  const Real width = width_of<2>(bodies::make_shape<2>(run.settings.rigid[0].second.shape));
  for (const auto& [elements, words] : {std::pair(150, "badge good"), std::pair(67, "badge fair"), std::pair(20, "badge bad")}) {
    run.settings.fem.contact_size = width / elements;
    const std::string html = trust_of({run});
    EXPECT_TRUE(contains(row_of(html, "elements at the"), words)) << elements << row_of(html, "elements at the");
    EXPECT_FALSE(contains(html, "Cells are not judged"));
  }
}

TEST(trust, shear_bands_are_not_warned_of_around_a_cavity_or_below_slices_that_are_springs)
{
  const char* words = "friction that shear bands can lose";
  record::RunRecord run = sample_record(sample_case({"material.sand.dilation_angle=0"}));
  EXPECT_TRUE(contains(trust_of({run}), words));
  record::RunRecord slices = run;
  slices.settings.pipeline.emplace().slices.as_spring = settings::SliceAsSpring::always;
  EXPECT_FALSE(contains(trust_of({slices}), words));
  run.settings.geometry = settings::Geometry::axisymmetric;
  EXPECT_TRUE(contains(trust_of({run}), words));
  for (settings::StageSettings& stage : run.settings.stage) stage.kind = settings::StageKind::drive, stage.drive.x.velocity = 0.25;
  EXPECT_FALSE(contains(trust_of({run}), words));
}

TEST(trust, cells_over_the_radius_of_a_disk_are_judged)
{
  for (const auto& [cells, words] : {std::pair(64.0, "badge good"), std::pair(32.0, "badge fair"), std::pair(16.0, "badge bad")}) {
    record::RunRecord run = sample_record(sample_case());
    run.settings.mesh = mesh::BoxMesh{.lower = {0, 0}, .size = {0.8, 0.8}, .cells = {cells, cells}};
    run.settings.rigid.clear();
    run.settings.body.front().second.disk = bodies::DiskSettings{.center = {0.4, 0.4}, .diameter = 0.4, .spacing = 0.01};
    EXPECT_TRUE(contains(row_of(trust_of({run}), "cells over the radius of the smallest disk"), words)) << cells;
    EXPECT_FALSE(contains(trust_of({run}), "Cells are not judged"));
  }
}

TEST(trust, friction_of_cells_is_judged_where_bands_have_a_width)
{
  const auto page = [](const char* width) {
    return trust_of({sample_record(sample_case({"material.sand.dilation_angle=0", std::string("material.sand.band_width=") + width}))});
  };
  const std::string row = "cells across a shear band of the soil";
  EXPECT_TRUE(contains(row_of(page("3 mm"), row), "badge good")) << row_of(page("3 mm"), row);
  EXPECT_TRUE(contains(row_of(page("3 mm"), row), "phi is"));
  EXPECT_TRUE(contains(row_of(page("6 mm"), row), "badge fair"));
  EXPECT_TRUE(contains(row_of(page("12 mm"), row), "badge bad"));
  EXPECT_TRUE(contains(page("12 mm"), "with fewer than four they localise"));
  EXPECT_EQ(row_of(trust_of({sample_record(sample_case({"material.sand.dilation_angle=0"}))}), row), "");
}

TEST(trust, what_viscosity_and_damping_take_is_told_apart)
{
  record::RunRecord run = sample_record(sample_case());
  run.summary->checks["viscosity_over_work"] = 0.03;
  EXPECT_TRUE(contains(trust_of({run}), "the bulk viscosity dissipated 3 % of the work"));
  run.summary->checks["viscosity_over_work"] = 0.01;
  EXPECT_FALSE(contains(trust_of({run}), "the bulk viscosity dissipated"));
  EXPECT_FALSE(contains(trust_of({run}), "local damping dissipated"));
  run.history.columns = columns_named({"time_s", "internal_J_m", "damping_J_m", "external_J_m"});
  run.history.values = {{0, 1, 2}, {0, 80, 100}, {0, 50, 59}, {0, 60, 90}};
  run.history.stage = {"geostatic", "geostatic", "push"};
  EXPECT_TRUE(contains(trust_of({run}), "local damping dissipated 9 % of the work while the body was driven")) << trust_of({run});
}

TEST(trust, large_gap_is_a_warning_and_a_small_one_is_not)
{
  record::RunRecord run = sample_record(sample_case());
  set_gap(run, 0.05e-3);
  EXPECT_FALSE(contains(trust_of({run}), "gap is"));
  set_gap(run, 0.4e-3);
  const std::string html = trust_of({run});
  EXPECT_TRUE(contains(html, "gap is 0.4 h: the effective diameter of the pipe is up to 4 % larger")) << html;
  EXPECT_TRUE(contains(row_of(html, "contact gap on both sides"), "badge fair"));
}

TEST(trust, measures_that_work_against_each_other_are_said_to_do_so_in_one_line)
{
  record::RunRecord run = sample_record(sample_case());
  set_gap(run, 0.4e-3);
  EXPECT_FALSE(contains(trust_of({run}), "have opposite effects")) << trust_of({run});
  run.summary->checks["shaking_at_body"] = 0.2;
  EXPECT_TRUE(
      contains(trust_of({run}), "have opposite effects, and the sign of their sum is not known. Resistance is too large because of: "))
      << trust_of({run});
  EXPECT_TRUE(contains(trust_of({run}), "Too small because of: spurious stress oscillation at the pipe")) << trust_of({run});
}

TEST(trust, gap_is_counted_in_cells_at_the_pipe_and_judged_by_the_size_of_the_pipe)
{
  record::RunRecord run = sample_record(sample_case({"mesh.near_size=2 mm"}));
  set_gap(run, 0.8e-3);
  EXPECT_TRUE(contains(trust_of({run}), "gap is 0.4 h: the effective diameter of the pipe is up to 8 % larger")) << trust_of({run});
  EXPECT_TRUE(contains(row_of(trust_of({run}), "contact gap on both sides"), "badge bad"));
}

TEST(trust, verdicts_change_at_their_limits)
{
  const record::RunRecord run = sample_record(sample_case());
  const base::Limit energy = *measure_of(run, "energy that does not balance, divided by the work").limit,
                    cells = *measure_of(run, "cells at the pipe").limit;
  EXPECT_EQ(judge(energy, energy.good), text::Standing::good);
  EXPECT_EQ(judge(energy, 1.001 * energy.good), text::Standing::fair);
  EXPECT_EQ(judge(energy, energy.bad), text::Standing::fair);
  EXPECT_EQ(judge(energy, 1.001 * energy.bad), text::Standing::bad);
  EXPECT_EQ(judge(cells, 20), text::Standing::good);
  EXPECT_EQ(judge(cells, 19.9), text::Standing::fair);
  EXPECT_EQ(judge(cells, 9.9), text::Standing::bad);
  EXPECT_EQ(judge(energy, std::nan("")), text::Standing::unknown);
}

TEST(trust, verdicts_of_the_page_follow_the_numbers)
{
  record::RunRecord run = sample_record(sample_case());
  EXPECT_TRUE(contains(row_of(trust_of({run}), "energy that does not balance"), "0.4 % <span class=\"badge good\">"));
  run.summary->checks["energy_error"] = 0.03;
  EXPECT_TRUE(contains(row_of(trust_of({run}), "energy that does not balance"), "badge fair"));
  run.summary->checks["energy_error"] = 0.3;
  EXPECT_TRUE(contains(row_of(trust_of({run}), "energy that does not balance"), "badge bad"));
  EXPECT_TRUE(contains(trust_of({run}), "30 % of the work is not balanced"));
}

TEST(trust, kinetic_energy_of_a_fast_push_is_a_warning)
{
  record::RunRecord run = sample_record(sample_case());
  run.history.columns = columns_named({"kinetic_J_m", "internal_J_m"});
  run.history.values = {{}, {}};
  for (int k = 0; k < 40; ++k) {
    run.history.stage.emplace_back(k < 20 ? "push" : "drag");
    // All of the energy is kinetic when the push begins; that says nothing.
    run.history.values[0].push_back(k < 2 ? 5 : k == 12 ? 0.12 : 0.01);
    run.history.values[1].push_back(1);
  }
  EXPECT_DOUBLE_EQ(measure_of(run, "kinetic energy over the work, push").value(run), 0.12);
  EXPECT_DOUBLE_EQ(measure_of(run, "kinetic energy over the work, drag").value(run), 0.01);
  EXPECT_TRUE(contains(trust_of({run}), "kinetic energy is 12 % of the work in the push: drive slower")) << trust_of({run});
}

TEST(trust, place_of_the_largest_energy_error_is_told)
{
  record::RunRecord run = sample_record(sample_case());
  run.history.columns = columns_named({"u_m", "w_m", "internal_J_m", "external_J_m", "energy_error_J_m"});
  run.history.values = {{0, 0, 0.004}, {0, 0.002, 0.003}, {0, 1, 2}, {0, 1, 2}, {0, -0.1, 0.05}};
  run.history.stage = {"push", "push", "drag"};
  EXPECT_EQ(base::energy_error(run).where, "push, w = 2 mm");
  EXPECT_DOUBLE_EQ(base::energy_error(run).over_work, 0.004);
  run.summary.reset();
  EXPECT_DOUBLE_EQ(base::energy_error(run).over_work, 0.05);
}

TEST(trust, plain_triangles_are_a_warning)
{
  const std::string html = trust_of({sample_record(sample_case({"mpm.volumetric_projection=false"}))});
  EXPECT_TRUE(contains(html, "plain triangles lock")) << html;
}

TEST(trust, coarse_cells_are_a_warning)
{
  record::RunRecord run = sample_record(sample_case({"mesh.near_size=4 mm"}));
  EXPECT_TRUE(contains(trust_of({run}), "cells at the pipe are D/5: resistance on a coarse mesh is too large")) << trust_of({run});
}

TEST(trust, friction_that_shear_bands_lose_is_a_warning)
{
  const std::string html = trust_of({sample_record(sample_case())});  // 1 - sin 35 deg / tan 35 deg
  EXPECT_TRUE(contains(html, "can lose 18 % of its friction in shear bands")) << html;
  EXPECT_TRUE(contains(html, "phi* = 29.8 deg")) << html;
  EXPECT_TRUE(contains(row_of(html, "friction that shear bands can lose"), "badge fair"));
}

TEST(trust, run_without_a_summary_says_what_is_not_known)
{
  record::RunRecord run = sample_record(sample_case());
  run.summary.reset();
  run.end = record::RunEnd::unfinished;
  const std::string html = trust_of({run});
  EXPECT_TRUE(contains(html, "the run has no summary")) << html;
  EXPECT_TRUE(contains(row_of(html, "momentum that does not balance"), "<span class=\"badge none\">not known</span>"));
  EXPECT_FALSE(contains(html, "nothing is wrong"));
}

TEST(trust, finite_elements_have_rows_of_their_own_only)
{
  record::RunRecord run = sample_record(sample_case({"stage.drag.vertical=fixed"}));
  run.settings.method = settings::Method::fem;
  const std::string html = trust_of({run});
  EXPECT_TRUE(contains(html, "fraction of the stress beyond the strength"));
  EXPECT_TRUE(contains(row_of(html, "strength that lags behind the pressure"), "badge good"));
  EXPECT_TRUE(contains(html, "0 of 1\u00a0000"));
  for (const char* words : {"noise of V", "contact gap", "momentum", "particles per cell", "kinetic", "V that the drag holds"})
    EXPECT_FALSE(contains(html, words)) << words;
  run.summary->checks["largest_overstress"] = 0.06;
  EXPECT_TRUE(contains(trust_of({run}), "6 % of the stress is beyond the soil's strength"));
}

TEST(trust, warnings_of_the_log_are_there_and_not_too_many)
{
  record::RunRecord run = sample_record(sample_case());
  for (int k = 0; k < 8; ++k) run.warnings.push_back("<careful> " + std::to_string(k));
  const std::string html = trust_of({run});
  EXPECT_TRUE(contains(html, "run.log: &lt;careful&gt; 0"));
  EXPECT_TRUE(contains(html, "run.log has 3 more warnings"));
  EXPECT_FALSE(contains(html, "<careful>"));
}

TEST(trust, what_was_doubtful_of_a_case_is_there_once_and_all_of_it)
{
  record::RunRecord run = sample_record(sample_case());
  for (int k = 0; k < 8; ++k) run.summary->warnings.push_back("case.toml:3: k0: doubt " + std::to_string(k));
  run.warnings = run.summary->warnings;
  const std::string html = trust_of({run});
  EXPECT_TRUE(contains(html, "the case is doubtful: case.toml:3: k0: doubt 7")) << html;
  EXPECT_FALSE(contains(html, "run.log")) << html;
}

TEST(trust, cells_that_grow_along_the_path_are_a_warning_with_both_sizes)
{
  record::RunRecord run = sample_record(sample_case());
  run.summary->checks["cells_at_body_first_m"] = 0.95e-3;
  run.summary->checks["cells_at_body_largest_m"] = 1e-3;
  EXPECT_TRUE(contains(row_of(trust_of({run}), "cells at the pipe"), "D/20 (1 mm)")) << "cells of one size differ a little";
  run.summary->checks["cells_at_body_largest_m"] = 6e-3;
  const std::string html = trust_of({run}), row = row_of(html, "cells at the pipe");
  EXPECT_TRUE(contains(row, "D/20 at the start, D/3.17 where they are largest")) << row;
  EXPECT_TRUE(contains(row, "badge bad")) << row;
  EXPECT_TRUE(contains(html, "cells at the pipe are D/3.17 over part of its travel, D/20 at the start")) << html;
}

TEST(trust, a_push_that_ends_within_its_first_cell_is_a_warning)
{
  record::RunRecord run = sample_record(sample_case());
  for (const auto& [w, words] : {std::pair(0.4e-3, "badge bad"), std::pair(1.5e-3, "badge fair"), std::pair(2e-3, "badge good")}) {
    run.quantities.push_back({"w_end_of_push", w, "m"});
    EXPECT_TRUE(contains(row_of(trust_of({run}), "embedment at the end of the push, in cells"), words)) << w;
    EXPECT_EQ(contains(trust_of({run}), "the push ends 0.4 cells deep"), w < 0.5e-3) << w;
    run.quantities.pop_back();
  }
}

TEST(trust, cells_of_a_mesh_of_the_user_are_those_that_the_run_found)
{
  record::RunRecord run = sample_record(sample_case());
  run.settings.mesh = mesh::GmshFile{"mine.msh"};
  EXPECT_TRUE(contains(row_of(trust_of({run}), "cells at the pipe"), "not known"));
  run.summary->checks["cells_at_body_first_m"] = run.summary->checks["cells_at_body_largest_m"] = 2e-3;
  EXPECT_TRUE(contains(row_of(trust_of({run}), "cells at the pipe"), "D/10 (2 mm)"));
}

}  // namespace
}  // namespace berm::report::this_file
