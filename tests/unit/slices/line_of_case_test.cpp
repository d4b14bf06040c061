// SPDX-License-Identifier: BSD-3-Clause
#include "slices/line_of_case.hpp"

#include "samples/error_of.hpp"
#include "samples/macro_element_parameters.hpp"
#include "samples/pipeline_case.hpp"
#include "samples/temporary_folder.hpp"

#include "macro_element/parameters.hpp"
#include "os/error.hpp"

#include "os/error.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::slices::this_file {
namespace {

/// The line of a pipe of steel, 0.4 m x 15 mm, in its last stage at 30 K and 10 MPa.
settings::Case heated()
{
  settings::Case c = test::line_case();
  settings::PipelineSettings& p = *c.pipeline;
  p.bending_stiffness.reset(), p.axial_stiffness.reset();
  p.wall = 0.015;
  p.young_modulus = 206e9;
  p.expansion = 1.17e-5;
  p.length = 1000;
  p.slices.spacing = 8, p.slices.to = 64;
  p.imperfection = {0.4, 60};
  p.far_soil = {};
  c.stage.back().pipeline = {};
  c.stage.back().pipeline.temperature = 30, c.stage.back().pipeline.pressure = 10e6;
  return c;
}

TEST(LineOfCase, has_the_stiffness_and_the_compression_of_its_wall)
{
  const LineOfCase of(heated());
  const Real outer = 0.4, inner = 0.37, area = pi / 4 * (outer * outer - inner * inner);
  const beam::Section& section = of.line.section.front();
  EXPECT_NEAR(section.axial_stiffness, 206e9 * area, 1e-9 * section.axial_stiffness);
  EXPECT_NEAR(section.bending_stiffness, 206e9 * pi / 64 * (std::pow(outer, 4) - std::pow(inner, 4)), 1e-9 * section.bending_stiffness);
  EXPECT_EQ(section.mass, 330);
  LineLoads hot = of.laid();
  hot.temperature = 30, hot.pressure = 10e6;
  EXPECT_NEAR(of.constrained_force(hot, 0), 206e9 * area * 1.17e-5 * 30 + 0.4 * 10e6 * pi / 4 * inner * inner, 1) << "1 - 2 nu = 0.4";
  EXPECT_EQ(of.constrained_force(of.laid(), 0), 0);
}

TEST(LineOfCase, has_a_node_at_each_slice_and_elements_that_resolve_the_buckle)
{
  const LineOfCase of(heated());
  ASSERT_EQ(of.places.size(), 9U);
  for (const Real place : of.places)
    EXPECT_TRUE(std::find_if(of.line.x.begin(), of.line.x.end(), [&](Real x) { return std::abs(x - place) < 1e-9; }) != of.line.x.end())
        << place;
  const Real P = of.constrained_force(target_of(heated().stage.back().pipeline, of.laid()), 0),
             longest = pi * std::sqrt(of.line.section.front().bending_stiffness / P) / 4;
  for (Index e = 0; e < of.line.elements(); ++e) EXPECT_LE(of.line.length(e), longest * (1 + 1e-9)) << e;
  EXPECT_EQ(of.line.x.back(), 1000);
}

TEST(LineOfCase, has_its_imperfection_with_its_amplitude_and_its_slope)
{
  for (const settings::LineHalf half : {settings::LineHalf::symmetric, settings::LineHalf::antisymmetric}) {
    settings::Case c = heated();
    c.pipeline->half = half;
    const LineOfCase of(c);
    Real largest = 0;
    for (Index i = 0; i < of.line.nodes(); ++i) largest = std::max(largest, of.line.shape[of.line.across(beam::Plane::lateral, i)]);
    EXPECT_NEAR(largest, 0.4, 0.02) << "a node lies within 2 m of it";
    for (Index i = 1; i + 1 < of.line.nodes(); ++i) {
      const Index at = of.line.across(beam::Plane::lateral, i), before = of.line.across(beam::Plane::lateral, i - 1),
                  after = of.line.across(beam::Plane::lateral, i + 1);
      const Real slope = (of.line.shape[after] - of.line.shape[before]) / (of.line.x[i + 1] - of.line.x[i - 1]);
      EXPECT_NEAR(of.line.shape[at + 1], slope, 0.01) << "central differences over 8 m, x = " << of.line.x[i];
    }
  }
}

TEST(LineOfCase, carries_its_weight_on_slices_and_springs)
{
  const LineOfCase of(heated());
  Real on_slices = 0, on_springs = 0;
  for (const Real length : of.stations.lengths()) on_slices += length;
  for (const Real length : of.length_beyond) on_springs += length;
  EXPECT_NEAR(on_slices, 64, 1e-9);
  EXPECT_NEAR(on_slices + on_springs, of.line.x.back(), 1e-9);
}

TEST(LineOfCase, goes_from_load_to_load_and_keeps_what_a_stage_does_not_name)
{
  settings::PipelineLoads heat, flow, unload;
  heat.temperature = 30, flow.far_temperature = 10, unload.weight = 900;
  LineLoads laid;
  laid.weight = 1500;
  const LineLoads hot = target_of(heat, laid), empty = target_of(unload, hot), colder = target_of(flow, hot);
  EXPECT_EQ(hot.temperature, 30);
  EXPECT_EQ(hot.weight, 1500);
  EXPECT_EQ(empty.temperature, 30);
  EXPECT_EQ(empty.weight, 900);
  settings::StageSettings stage;
  stage.kind = settings::StageKind::pipeline;
  stage.pipeline = unload;
  stage.ramp = 8, stage.until.time = 10;
  EXPECT_EQ(loads_in(stage, hot, 2).weight, 1350);
  EXPECT_EQ(loads_in(stage, hot, 8).weight, 900);
  EXPECT_EQ(end_of(stage, hot).weight, 900);
  EXPECT_EQ(hot.far_temperature, 30) << "as hot as at x = 0";
  EXPECT_EQ(colder.temperature, 30);
  EXPECT_EQ(colder.far_temperature, 10);
  EXPECT_EQ(target_of(heat, colder).far_temperature, 30) << "a new temperature is that of the whole line";
}

/// Heated to 30 K and cooled to 10 K again under 10 MPa, by a load history in double the time of its record.
settings::StageSettings loaded_by_history()
{
  settings::StageSettings stage;
  stage.kind = settings::StageKind::pipeline;
  stage.load_times = {0, 4, 8};
  stage.loads.of("temperature") = {0, 30, 10};
  stage.loads.of("pressure") = {0, 10e6, 10e6};
  stage.time_scale = 2;
  stage.until.time = 16;
  return stage;
}

TEST(LineOfCase, is_loaded_as_a_load_history_has_it_and_keeps_what_it_does_not_name)
{
  LineLoads laid;
  laid.weight = 1500;
  const settings::StageSettings stage = loaded_by_history();
  const LineLoads hotter = loads_in(stage, laid, 2), cooler = loads_in(stage, laid, 12), end = end_of(stage, laid);
  EXPECT_EQ(hotter.temperature, 7.5);
  EXPECT_EQ(hotter.far_temperature, 7.5) << "as hot as at x = 0";
  EXPECT_EQ(hotter.pressure, 2.5e6);
  EXPECT_EQ(cooler.temperature, 20);
  EXPECT_EQ(end.temperature, 10);
  EXPECT_EQ(end.weight, 1500);
}

TEST(LineOfCase, has_elements_for_the_largest_compression_of_a_load_history_wherever_in_it_that_is)
{
  settings::Case by_ramp = heated(), by_history = heated();
  const std::string name = by_history.stage.back().name;
  by_history.stage.back() = loaded_by_history();
  by_history.stage.back().name = name;
  EXPECT_EQ(longest_element_of(by_history), longest_element_of(by_ramp));
  EXPECT_EQ(hottest_stage_of(by_history, LineOfCase(by_history)), by_history.stage.size() - 1);
}

TEST(LineOfCase, has_slices_at_places_of_their_own_a_node_at_each_and_all_of_the_line_between_them)
{
  settings::Case c = heated();
  c.pipeline->slices = {};
  c.pipeline->slices.at = {0, 3, 10, 14, 15, 40};
  const LineOfCase of(c);
  EXPECT_EQ(of.places, c.pipeline->slices.at);
  for (const Real place : of.places) EXPECT_NE(std::find(of.line.x.begin(), of.line.x.end(), place), of.line.x.end()) << place;
  const std::vector<Real> lengths = {1.5, 5, 5.5, 2.5, 13, 12.5};  // half of the gaps beside each
  ASSERT_EQ(of.stations.lengths().size(), lengths.size());
  for (std::size_t k = 0; k < lengths.size(); ++k) EXPECT_NEAR(of.stations.lengths()[k], lengths[k], 1e-9) << k;
  EXPECT_EQ(words_of_places(of.places), "6 slices 1 to 25 m apart, to 40 m");
}

TEST(LineOfCase, is_compressed_by_the_temperature_of_each_place)
{
  const LineOfCase of(heated());
  LineLoads hot = of.laid();
  hot.temperature = 30, hot.far_temperature = 10;
  const Real at_end = of.constrained_force(hot, of.line.x.back());
  EXPECT_NEAR(of.constrained_force(hot, 0), 3 * at_end, 1e-6 * at_end);
  EXPECT_NEAR(of.constrained_force(hot, of.line.x.back() / 2), 2 * at_end, 1e-6 * at_end);
}

// A parabola is its own spline of chords but for the first and the last piece.
TEST(LineOfCase, lies_on_its_route)
{
  settings::Case c = heated();
  c.pipeline->imperfection = {};
  for (int k = 0; k <= 20; ++k) {
    c.pipeline->route.x.push_back(50 * k);
    c.pipeline->route.y.push_back(1e-5 * 50 * 50 * k * k);
  }
  const LineOfCase of(c);
  for (Index i = 0; i < of.line.nodes(); ++i) {
    const Real x = of.line.x[i];
    if (x < 50 || x > 950) continue;
    const Index at = of.line.across(beam::Plane::lateral, i);
    EXPECT_NEAR(of.line.shape[at], 1e-5 * x * x, 1e-9) << x;
    EXPECT_NEAR(of.line.shape[at + 1], 2e-5 * x, 1e-9) << x;
  }
}

TEST(LineOfCase, refuses_a_route_and_a_curve_that_it_cannot_have_with_their_keys)
{
  settings::Case c = heated();
  c.pipeline->imperfection = {};
  c.pipeline->route.x = {0, 100, 200};
  c.pipeline->route.y = {0, 1, 30};
  const std::string steep = test::error_of<KeyError>([&] { LineOfCase{c}; });
  EXPECT_TRUE(steep.starts_with("pipeline.route.y: ")) << steep;
  EXPECT_NE(steep.find("a slope of 0.29 from x = 100 to 200 m"), std::string::npos) << steep;
  c = heated();
  c.pipeline->far_soil.lateral.x = {0.01, 0.02};
  c.pipeline->far_soil.lateral.y = {100, 300};
  const std::string steeper = test::error_of<KeyError>([&] { LineOfCase{c}; });
  EXPECT_TRUE(steeper.starts_with("pipeline.far_soil.lateral: ")) << steeper;
  EXPECT_NE(steeper.find("steeper up to 0.02 m than at first"), std::string::npos) << steeper;
}

TEST(LineOfCase, has_the_resistance_along_it_of_its_interface)
{
  settings::Case c = heated();
  c.pipeline->far_soil.axial_angle = 0.4;
  EXPECT_NEAR(LineOfCase(c).axial_resistance(0.2, 1000), 4 / pi * std::tan(0.4) * 1000, 1e-9) << "wedged, buried to half";
  EXPECT_EQ(LineOfCase(c).axial_resistance(0.2, -1000), 0) << "lifted";
  c.pipeline->far_soil.axial_angle.reset();
  c.pipeline->far_soil.axial_strength = 2000;
  EXPECT_NEAR(LineOfCase(c).axial_resistance(0.2, 1000), 2000 * 0.4 * pi / 2, 1e-9) << "half of the perimeter";
}

TEST(LineOfCase, stands_on_macro_elements_beyond_its_slices)
{
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "macro_element.json").string();
  std::ofstream(file) << macro_element::json_of(macro_element::sample_parameters());
  settings::Case c = heated();
  c.pipeline->far_soil.macro_element = file;
  const LineOfCase of(c);
  Real length = 0;
  for (const beam::MacroElement& element : of.line.macro_elements) length += element.length;
  EXPECT_NEAR(length, of.line.x.back() - of.places.back(), 1e-9);
  for (const beam::Spring& spring : of.line.springs) {
    EXPECT_EQ(spring.freedom, of.line.axial(spring.node)) << "along the slices alone";
    EXPECT_LE(of.line.x[spring.node], of.places.back());
  }
  EXPECT_NEAR(of.line.macro_soils.front().laid.V, 1500, 1) << "laid, and then under its weight";
  c.pipeline->far_soil.macro_element = (folder.path() / "nowhere.json").string();
  EXPECT_THROW(LineOfCase{c}, KeyError);
}

TEST(LineOfCase, may_begin_and_end_free_or_on_a_spring)
{
  settings::Case c = heated();
  c.pipeline->half = settings::LineHalf::none;
  c.pipeline->imperfection = {};
  c.pipeline->end = settings::LineEnd::spring;
  c.pipeline->end_stiffness = 1e6;
  const LineOfCase of(c);
  EXPECT_EQ(std::count(of.line.held.begin(), of.line.held.end(), 1), 0);
  const beam::Spring& end = of.line.springs.front();
  EXPECT_EQ(end.freedom, of.line.axial(of.line.nodes() - 1));
  EXPECT_EQ(std::get<beam::LinearSpring>(of.line.laws[end.law]).stiffness * end.length, 1e6);
}

}  // namespace
}  // namespace berm::slices::this_file
