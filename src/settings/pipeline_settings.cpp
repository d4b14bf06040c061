// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_pipeline_test.cpp
#include "settings/pipeline_settings.hpp"

#include "core/usual.hpp"
#include "settings/case.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace berm::settings {
namespace {

constexpr int max_slices = 1000;

}  // namespace

std::vector<Real> places_of(const SliceSettings& slices)
{
  if (!slices.spacing || !slices.to) return slices.at;
  std::vector<Real> places;
  const int count = static_cast<int>(std::lround(*slices.to / *slices.spacing));
  for (int k = 0; k <= count; ++k) places.push_back(*slices.to * k / count);
  return places;
}

void describe(Describe& d, Imperfection& imperfection)
{
  d.value("amplitude", imperfection.amplitude, {.meaning = "largest lateral displacement, along x of the slices", .unit = "m"});
  d.value("length", imperfection.length, {.meaning = "length of the whole imperfection", .unit = "m", .range = not_negative});
}

void describe(Describe& d, OtherSoil& soil)
{
  d.value("from", soil.from, {.meaning = "position of the first of these slices", .unit = "m", .range = not_negative});
  d.value("to", soil.to, {.meaning = "position of the last of these slices", .unit = "m", .range = not_negative, .required = true});
  d.value("set", soil.set,
          {.meaning = "keys of material and contact that differ there, as for --set: \"material.clay.cohesion=3 kPa\"", .required = true});
}

void describe(Describe& d, Route& route)
{
  d.value("table", route.table, {.meaning = "CSV file, relative to the case file, whose columns x_m and y_m are the route, from x = 0"});
  d.value("x", route.x, {.meaning = "instead of a file: positions along the line, ascending from 0", .unit = "m"});
  d.value("y", route.y, {.meaning = "instead of a file: lateral position of the line there, along x of the slices", .unit = "m"});
}

void describe(Describe& d, LateralCurve& curve)
{
  d.value("table", curve.table,
          {.meaning = "CSV file, relative to the case file, whose columns u_m and H_N_m are the lateral resistance against displacement"});
  d.value("u", curve.x, {.meaning = "instead of a file: displacements, ascending from above 0", .unit = "m"});
  d.value("H", curve.y, {.meaning = "instead of a file: resistances at these displacements; constant after the last", .unit = "N/m"});
}

void describe(Describe& d, SpringsBeside& springs)
{
  d.value("travel", springs.travel,
          {.meaning = "travel of the drag in a copy of the laid slice, whose H(u) becomes that of the springs",
           .unit = "m",
           .range = positive,
           .required = true});
  d.value("velocity", springs.velocity, {.meaning = "speed of this drag", .unit = "m/s", .range = positive});
}

void describe(Describe& d, SliceSettings& slices)
{
  d.value("spacing", slices.spacing, {.meaning = "distance between slices", .unit = "m", .range = positive});
  d.value("to", slices.to,
          {.meaning = "position of the last slice along the line; the first is at 0. With `count` it may be left out",
           .unit = "m",
           .range = positive});
  d.value("at", slices.at, {.meaning = "instead of spacing: the positions of all slices, ascending from 0", .unit = "m"});
  d.value(
      "count", slices.count,
      {.meaning = "instead of spacing: number of slices; berm places them where the line on springs needs them", .range = {0, max_slices}});
  d.choice("as_spring", slices.as_spring, {"never", "until_sliding", "always"},
           {.meaning =
                "replace a slice by a spring of the far soil: until its lateral force reaches 40 % of the resistance, which saves time; "
                "always: the whole line lies on springs"});
}

void describe(Describe& d, FarSoil& soil)
{
  d.value("friction", soil.friction, {.meaning = "lateral resistance divided by the submerged weight", .range = not_negative});
  d.value("mobilisation", soil.mobilisation,
          {.meaning = "displacement at which it is mobilised; 0: a hundredth of the diameter", .unit = "m", .range = not_negative});
  d.value("axial_friction", soil.axial_friction,
          {.meaning = "axial resistance divided by the submerged weight, under the slices, too", .range = not_negative});
  d.value("axial_angle", soil.axial_angle,
          {.meaning =
               "angle of friction between pipe and soil along the line, instead of axial_friction: on the force V that a slice has, times "
               "the wedging factor of its embedment",
           .unit = "rad",
           .range = {0, 89.9 * degree}});
  d.value("axial_strength", soil.axial_strength,
          {.meaning = "shear strength between pipe and soil along the line, instead of axial_friction: on the buried part of the perimeter",
           .unit = "Pa",
           .range = not_negative});
  d.value("axial_mobilisation", soil.axial_mobilisation,
          {.meaning = "displacement at which it is mobilised", .unit = "m", .range = positive});
  d.value("stiffness", soil.stiffness,
          {.meaning = "vertical stiffness; absent: the submerged weight divided by a hundredth of the diameter",
           .unit = "N/m^2",
           .range = positive});
  d.optional_table("lateral", soil.lateral, {.meaning = "lateral resistance against displacement, instead of friction and mobilisation"});
  d.value("macro_element", soil.macro_element,
          {.meaning = "file of berm macro-element, relative to the case file, instead of the other keys: resistance in all directions"});
  declare_usual(d, {{"friction", {0.05, 3}},
                    {"axial_friction", {0.05, 2}},
                    {"axial_strength", {0, 5e5}},
                    {"mobilisation", {1e-4, 1}},
                    {"axial_mobilisation", {1e-4, 0.5}}});
}

void describe(Describe& d, PipelineSettings& pipeline)
{
  d.value("wall", pipeline.wall,
          {.meaning = "thickness of the steel wall; the outer diameter is that of the rigid body", .unit = "m", .range = positive});
  d.value("young_modulus", pipeline.young_modulus, {.meaning = "of the wall", .unit = "Pa", .range = positive});
  d.value("bending_stiffness", pipeline.bending_stiffness,
          {.meaning = "EI, instead of wall and young_modulus: of a cable, an umbilical", .unit = "N m^2", .range = positive});
  d.value("axial_stiffness", pipeline.axial_stiffness, {.meaning = "EA, required with bending_stiffness", .unit = "N", .range = positive});
  d.value("poisson_ratio", pipeline.poisson_ratio, {.meaning = "of the wall", .range = {0, 0.5}});
  d.value("expansion", pipeline.expansion, {.meaning = "thermal expansion of length", .unit = "1/K", .range = not_negative});
  d.value("submerged_weight", pipeline.submerged_weight,
          {.meaning = "submerged weight when the line was laid", .unit = "N/m", .range = positive, .required = true});
  d.value("mass", pipeline.mass,
          {.meaning = "mass in lateral and vertical motion: pipe, content and added mass of the water; absent: that of the rigid body",
           .unit = "kg/m",
           .range = positive});
  d.value("axial_mass", pipeline.axial_mass, {.meaning = "mass in axial motion; absent: `mass`", .unit = "kg/m", .range = positive});
  d.value("lay_tension", pipeline.lay_tension,
          {.meaning = "effective tension under which it was laid", .unit = "N", .range = not_negative});
  d.choice(
      "half", pipeline.half, {"symmetric", "antisymmetric", "none"},
      {.meaning =
           "the other half of the line, beyond x = 0: its mirror image, or rotated by 180 degrees; none: x = 0 is a free end of the line"});
  d.value("length", pipeline.length, {.meaning = "from x = 0 to the far end", .unit = "m", .range = positive, .required = true});
  d.choice("end", pipeline.end, {"anchored", "free", "spring"},
           {.meaning = "far end: fixed, or moving along the line, freely or against a spring"});
  d.value("end_stiffness", pipeline.end_stiffness,
          {.meaning = "of the spring of the far end, along the line", .unit = "N/m", .range = positive});
  d.table("imperfection", pipeline.imperfection,
          {.meaning = "the line's shape without stress: amplitude (1 + cos kx)/2 within its length, k = 2 pi/length; antisymmetric: "
                      "amplitude (1 + cos kx) sin kx 4/(3 sqrt 3)"});
  d.optional_table("route", pipeline.route, {.meaning = "the line's shape without stress, instead of an imperfection"});
  d.table("slices", pipeline.slices, {.meaning = "where slices of soil are", .required = true});
  d.array("soil", pipeline.soil, {.meaning = "slices in other soil than that of the case, each laid by itself"});
  d.table("far_soil", pipeline.far_soil, {.meaning = "springs beyond the last slice"});
  d.optional_table("springs", pipeline.springs,
                   {.meaning = "a second line on springs from the same soil, for comparison with a design on springs"});
  d.value(
      "vertical_damping", pipeline.vertical_damping,
      {.meaning =
           "vertical damping force divided by momentum of the line: removes the energy added by the soil reaction, which lags by one step",
       .unit = "1/s",
       .range = not_negative});
  declare_usual(d, {{"young_modulus", {5e8, 4.5e11}},  // of polyethylene to that of what is stiffer than carbon fibre
                    {"bending_stiffness", {10, 1e11}},
                    {"axial_stiffness", {1e5, 1e12}},
                    {"expansion", {1e-6, 3e-4}},
                    {"submerged_weight", {10, 5e4}},
                    {"lay_tension", {100, 2e7}}});
}

namespace {

void check_points(Describe& d, const GivenPoints& points, const std::string& key, const char* x, const char* y, std::size_t least)
{
  if (points.empty()) return;
  d.check(!points.table.empty() || points.x.size() >= least, key + "." + x,
          fmt::format("has {} numbers, and needs {} at least", points.x.size(), least));
  d.check(points.table.empty() || (points.x.empty() && points.y.empty()), key, "is either a table or numbers");
  d.check(points.x.size() == points.y.size(), key + "." + y, fmt::format("needs as many numbers as {}", x));
  d.check(std::adjacent_find(points.x.begin(), points.x.end(), std::greater_equal<>()) == points.x.end(), key + "." + x, "must ascend");
}

/// Imperfection or route.
void check_shape(Describe& d, const PipelineSettings& p)
{
  const Imperfection& shape = p.imperfection;
  check_points(d, p.route, "pipeline.route", "x", "y", 2);
  check_points(d, p.far_soil.lateral, "pipeline.far_soil.lateral", "u", "H", 1);
  d.check(p.route.empty() || shape.amplitude == 0, "pipeline.route", "cannot be combined with pipeline.imperfection");
  d.check(p.route.x.empty() || p.route.x.front() == 0, "pipeline.route.x", "must begin at 0");
  d.check(p.half != LineHalf::antisymmetric || p.route.y.empty() || p.route.y.front() == 0, "pipeline.route.y",
          "must begin at 0 where the other half is this one rotated by 180 degrees");
  if (shape.amplitude == 0)
    return d.check(!p.route.empty() || p.half == LineHalf::none, "pipeline.imperfection.amplitude",
                   "is 0: a straight line does not buckle");
  d.check(p.half != LineHalf::none, "pipeline.imperfection",
          "is around x = 0, where a line with half = \"none\" ends: give it a pipeline.route");
  d.check(shape.length / 2 < p.length, "pipeline.imperfection.length", "must be less than twice pipeline.length");
  const std::vector<Real> places = places_of(p.slices);
  Real apart = 0;
  for (std::size_t k = 1; k < places.size() && places[k - 1] < shape.length / 2; ++k) apart = std::max(apart, places[k] - places[k - 1]);
  d.check(shape.length >= 4 * apart, "pipeline.imperfection.length", "must be four spacings of the slices at least, which carry its shape");
}

void check_places(Describe& d, const SliceSettings& s, Real length)
{
  constexpr Real nearest = 1e-3;  // m
  d.check(s.spacing.has_value() + (s.count != 0) + !s.at.empty() == 1, "pipeline.slices",
          "needs one of these: spacing (with to), at, or count");
  d.check(!s.to || s.at.empty(), "pipeline.slices.to", "is the last position of pipeline.slices.at: leave it out");
  d.check(!s.spacing || s.to, "pipeline.slices.to", "is needed with spacing: the position of the last slice");
  d.check(!s.to || length >= *s.to, "pipeline.length", "must reach to the last slice, pipeline.slices.to");
  d.check(s.count == 0 || s.count >= 4, "pipeline.slices.count", "is less than 4: a line has four slices at least");
  if (s.spacing && s.to) {
    const Real spacings = std::round(*s.to / *s.spacing);
    d.check(spacings >= 3, "pipeline.slices.to",
            "gives fewer than four slices: it is the position of the last one, at least three spacings from 0");
    d.check(spacings < max_slices, "pipeline.slices.spacing", fmt::format("gives more than {} slices", max_slices));
    d.check(std::abs(spacings * *s.spacing - *s.to) <= 1e-6 * *s.to, "pipeline.slices.to", "must be a multiple of pipeline.slices.spacing");
  }
  if (s.at.empty()) return;
  d.check(s.at.size() >= 4, "pipeline.slices.at", fmt::format("has {} positions: a line has four slices at least", s.at.size()));
  d.check(s.at.size() <= max_slices, "pipeline.slices.at", fmt::format("has more than {} positions", max_slices));
  d.check(s.at.front() == 0, "pipeline.slices.at", "must begin at 0");
  for (std::size_t k = 1; k < s.at.size(); ++k)
    d.check(s.at[k] >= s.at[k - 1] + nearest, "pipeline.slices.at",
            fmt::format("must ascend, by {:g} m at least: {:.6g} m follows {:.6g} m", nearest, s.at[k], s.at[k - 1]));
  d.check(length >= s.at.back(), "pipeline.length", "must reach to the last slice, the last of pipeline.slices.at");
}

/// Numbers with which nothing can be computed, as a unit that was forgotten or a digit too many make them; what is unusual is doubted only.
void check_sizes(Describe& d, const PipelineSettings& p)
{
  struct Size {
    const char* key;
    std::optional<Real> value;
    Real least, most;
    const char* unit;
  };
  const Size sizes[] = {{"wall", p.wall, 1e-5, 1, "m"},
                        {"young_modulus", p.young_modulus, 1e5, 1e14, "Pa"},
                        {"bending_stiffness", p.bending_stiffness, 1e-6, 1e15, "N m^2"},
                        {"axial_stiffness", p.axial_stiffness, 1e-3, 1e16, "N"},
                        {"submerged_weight", p.submerged_weight, 1e-3, 1e8, "N/m"},
                        {"mass", p.mass, 1e-4, 1e8, "kg/m"},
                        {"axial_mass", p.axial_mass, 1e-4, 1e8, "kg/m"},
                        {"lay_tension", p.lay_tension, 0, 1e10, "N"}};
  for (const auto& [key, value, least, most, unit] : sizes)
    d.check(!value || (*value >= least && *value <= most), std::string("pipeline.") + key,
            fmt::format("is {0:g} {3}; no line has less than {1:g} or more than {2:g} {3}", value.value_or(0), least, most, unit));
}

void check_line(Describe& d, const PipelineSettings& p)
{
  check_sizes(d, p);
  const bool steel = p.wall || p.young_modulus, stiff = p.bending_stiffness || p.axial_stiffness;
  d.check(steel != stiff, "pipeline", "needs either wall and young_modulus, or bending_stiffness and axial_stiffness");
  d.check(!steel || (p.wall && p.young_modulus), "pipeline", "needs both wall and young_modulus");
  d.check(!stiff || (p.bending_stiffness && p.axial_stiffness), "pipeline", "needs both bending_stiffness and axial_stiffness");
  d.check(p.lay_tension == 0 || (p.end == LineEnd::anchored && p.half != LineHalf::none), "pipeline.lay_tension",
          "needs ends that hold it: end = \"anchored\", and not half = \"none\"");
  d.check((p.end == LineEnd::spring) == p.end_stiffness.has_value(), "pipeline.end_stiffness",
          "is needed with end = \"spring\", and with nothing else");
  check_shape(d, p);
}

void check_soil(Describe& d, const Case& c, const PipelineSettings& p)
{
  const FarSoil& far = p.far_soil;
  d.check(far.macro_element.empty() || p.slices.as_spring != SliceAsSpring::until_sliding, "pipeline.far_soil.macro_element",
          "cannot be combined with slices.as_spring = \"until_sliding\"");
  d.check(far.macro_element.empty() || !p.springs, "pipeline.springs", "has springs of a drag everywhere, and not a macro-element");
  d.check(far.lateral.empty() || far.macro_element.empty(), "pipeline.far_soil.lateral", "cannot be combined with macro_element");
  d.check(!(far.axial_angle || far.axial_strength) || far.macro_element.empty(), "pipeline.far_soil",
          "macro_element has its own axial resistance");
  d.check(p.slices.as_spring == SliceAsSpring::never || far.friction > 0 || !far.lateral.empty() || !far.macro_element.empty(),
          "pipeline.slices.as_spring", "needs a lateral resistance of the springs: pipeline.far_soil.friction");
  d.check(p.soil.empty() || (c.traction.empty() &&
                             std::none_of(c.support.begin(), c.support.end(), [](const auto& s) { return s.second.head.has_value(); })),
          "pipeline.soil", "cannot be combined with tractions and heads, whose times would differ where laying takes longer");
  d.check(p.soil.empty() || p.slices.as_spring != SliceAsSpring::always, "pipeline.soil",
          "cannot be combined with slices that are always springs");
  const std::vector<Real> places = places_of(p.slices);
  const Real last = places.empty() ? infinity : places.back() * (1 + 1e-9);
  for (std::size_t k = 0; k < p.soil.size(); ++k) {
    const std::string path = fmt::format("pipeline.soil[{}]", k);
    d.check(p.soil[k].from <= p.soil[k].to, path + ".to", "is before `from`");
    d.check(!(p.soil[k].to > last), path + ".to", fmt::format("is beyond the last slice, at {:.6g} m", places.empty() ? 0 : places.back()));
    d.check(p.soil[k].from > 0, path + ".from", "must be above 0: the slice at x = 0 is the case itself");
    d.check(k == 0 || p.soil[k].from > p.soil[k - 1].to, path + ".from", "must be beyond the slices before");
    for (const std::string& set : p.soil[k].set)
      d.check(set.starts_with("material.") || set.starts_with("contact."), path + ".set",
              "changes keys of material and contact only, not \"" + set + "\"");
  }
}

/// The rigid body is the pipe in each slice.
void check_slice(Describe& d, const Case& c, const PipelineSettings& p)
{
  d.check(c.method == Method::mpm && c.geometry == Geometry::plane_strain, "pipeline",
          "has slices in plane strain: it needs method = \"mpm\" and geometry = \"plane_strain\"");
  d.check(c.rigid.size() == 1, "pipeline", "needs one [rigid.NAME], the pipe in each slice");
  d.check(c.gravity.size() == 2 && c.gravity[0] == 0 && c.gravity[1] < 0, "pipeline", "needs gravity along -y");
  d.check(!c.safety, "pipeline", "cannot be combined with a trial of the factor of safety");
  if (c.rigid.size() != 1) return;
  const auto& [name, rigid] = c.rigid.front();
  const bodies::RigidShape<2> shape = bodies::make_shape<2>(rigid.shape);
  d.check(std::holds_alternative<bodies::CircleSettings>(rigid.shape), "rigid." + name,
          "is the pipe of a line, which is round: shape = \"circle\"");
  d.check(rigid.rotation == bodies::Rotation::fixed, "rigid." + name + ".rotation", "is fixed in the slices of a pipeline");
  for (const auto& [contact, settings] : c.contact)
    d.check(settings.other_body.empty(), "contact." + contact, "between two soils cannot be combined with [pipeline]");
  d.check(rigid.mass > 0 || p.mass, "pipeline.mass", "is needed: the rigid body has no mass");
  d.check(!p.wall || 2 * *p.wall < bodies::width_of<2>(shape), "pipeline.wall", "is more than half of the diameter");
}

bool loads_pipeline(const PipelineLoads& loads)
{
  return loads.temperature || loads.far_temperature || loads.pressure || loads.weight || loads.lateral || loads.pull;
}

}  // namespace

void check_pipeline(Describe& d, const Case& c)
{
  const auto is_of_line = [](const StageSettings& s) { return s.kind == StageKind::pipeline; };
  const auto first = std::find_if(c.stage.begin(), c.stage.end(), is_of_line);
  for (auto stage = c.stage.begin(); stage != c.stage.end(); ++stage) {
    const std::string path = fmt::format("stage[{}]", stage - c.stage.begin());
    d.check(is_of_line(*stage) || !loads_pipeline(stage->pipeline), path + ".pipeline", "is for kind = \"pipeline\"");
    d.check(!is_of_line(*stage) || c.pipeline, path + ".kind", "loads the line of [pipeline], and there is none");
    d.check(stage < first || is_of_line(*stage), path + ".kind",
            "comes after a stage of kind \"pipeline\": the slices are coupled to the line from then on");
    d.check(!is_of_line(*stage) || stage->until.time || has_load_history(*stage), path + ".until.time",
            "is needed: a stage of kind \"pipeline\" ends at a time, or with its load history");
    d.check(!is_of_line(*stage) ||
                (!stage->until.displacement && !stage->until.embedment && !stage->until.force && !stage->until.consolidation),
            path + ".until", "of kind \"pipeline\" is a time");
    d.check(!is_of_line(*stage) || !stage->until.time || stage->ramp <= *stage->until.time, path + ".ramp",
            "of kind \"pipeline\" must end before the stage does, at until.time");
    d.check(!is_of_line(*stage) || !has_load_history(*stage) || !loads_pipeline(stage->pipeline), path + ".pipeline",
            "cannot be combined with a load history: give it columns for all loads that change");
    d.check(!stage->pipeline.pressure || !c.pipeline || c.pipeline->wall, path + ".pipeline.pressure",
            "needs the wall of the pipe: pipeline.wall and young_modulus");
    d.check(!stage->pipeline.pull || !c.pipeline || c.pipeline->end != LineEnd::anchored, path + ".pipeline.pull",
            "is at the far end, which is anchored: pipeline.end = \"free\" or \"spring\"");
    d.check((!stage->pipeline.temperature && !stage->pipeline.far_temperature) || !c.pipeline || c.pipeline->expansion > 0,
            path + ".pipeline.temperature", "needs pipeline.expansion");
  }
  if (!c.pipeline) return;
  check_places(d, c.pipeline->slices, c.pipeline->length);
  check_soil(d, c, *c.pipeline);
  d.check(first != c.stage.end(), "pipeline", "no [[stage]] of kind \"pipeline\" loads it");
  d.check(first != c.stage.begin(), "pipeline",
          "must be laid first: stages before the first of kind \"pipeline\" push the pipe into the soil");
  check_line(d, *c.pipeline);
  check_slice(d, c, *c.pipeline);
}

}  // namespace berm::settings
