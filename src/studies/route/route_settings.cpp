// SPDX-License-Identifier: BSD-3-Clause
#include "route/route_settings.hpp"

#include "input/override.hpp"
#include "input/reader.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::route {

void describe(Describe& d, Pipe& pipe)
{
  d.value("diameter", pipe.diameter,
          {.meaning = "outer diameter, with coating", .unit = "m", .range = {0, 10, true, false}, .required = true});
  d.value("steel_diameter", pipe.steel_diameter,
          {.meaning = "outer diameter of the steel; absent: no coating", .unit = "m", .range = positive});
  d.value("wall", pipe.wall, {.meaning = "thickness of the steel wall", .unit = "m", .range = positive, .required = true});
  d.value("young_modulus", pipe.young_modulus, {.meaning = "Young's modulus of the steel", .unit = "Pa", .range = positive});
  d.value("poisson_ratio", pipe.poisson_ratio, {.meaning = "Poisson's ratio of the steel", .range = {0, 0.5}});
  d.value("expansion", pipe.expansion, {.meaning = "thermal expansion of its length", .unit = "1/K", .range = not_negative});
  d.value("weight_laying", pipe.laying,
          {.meaning = "submerged weight while it is laid", .unit = "N/m", .range = positive, .required = true});
  d.value("weight_flooded", pipe.flooded,
          {.meaning = "submerged weight full of water, in a test; absent: it is not flooded", .unit = "N/m", .range = positive});
  d.value("weight_operation", pipe.operation,
          {.meaning = "submerged weight in operation", .unit = "N/m", .range = positive, .required = true});
  d.value("lay_tension", pipe.lay_tension,
          {.meaning = "effective tension on the seabed while it is laid", .unit = "N", .range = not_negative});
  d.value("lay_factor", pipe.lay_factor,
          {.meaning = "largest vertical load of laying divided by the weight; absent: by DNV-RP-F114 with the tension", .range = {1, 20}});
}

void describe(Describe& d, Operation& operation)
{
  d.value("kp", operation.kp,
          {.meaning = "places along the route of the numbers below; absent: one number for the whole route", .unit = "m"});
  d.value("temperature_rise", operation.temperature,
          {.meaning = "rise of the temperature since laying", .unit = "K", .range = {-300, 1000}, .required = true});
  d.value("pressure_rise", operation.pressure,
          {.meaning = "rise of the internal pressure since laying", .unit = "Pa", .range = {-1e9, 1e9}, .required = true});
  d.choice("ends", operation.ends, {"free", "anchored"},
           {.meaning = "ends of the line: free, so that its compression builds up by axial resistance, or anchored"});
}

void describe(Describe& d, Section& s)
{
  d.value("name", s.name, {.meaning = "name of the part of the route"});
  d.value("kp_from", s.from, {.meaning = "where it begins", .unit = "m", .required = true});
  d.value("kp_to", s.to, {.meaning = "where it ends", .unit = "m", .required = true});
  d.value("run", s.run,
          {.meaning = "folder of a run, or of a study with a sample, relative to this file's folder: its springs instead of formulas"});
  d.value("undrained_strength", s.strength,
          {.meaning = "s_u of clay at the seabed: [low, best, high], or [best]; absent: sand", .unit = "Pa", .range = not_negative});
  d.value("undrained_strength_gradient", s.gradient, {.meaning = "increase of s_u with depth", .unit = "Pa/m", .range = not_negative});
  d.value("submerged_unit_weight", s.unit_weight, {.meaning = "submerged unit weight of the soil", .unit = "N/m^3", .range = positive});
  d.value("sensitivity", s.sensitivity,
          {.meaning = "sensitivity, undisturbed divided by remoulded strength: [low, best, high], or [best]", .range = {1, 100}});
  d.value("adhesion_factor", s.adhesion_factor,
          {.meaning = "adhesion factor alpha of the pipe surface: [low, best, high], or [best]", .range = {0, 1}});
  d.value(
      "strength_ratio", s.strength_ratio,
      {.meaning =
           "s_u/sigma'_v of the normally consolidated clay at the pipe, for axial resistance after consolidation; absent: alpha s_u of the "
           "undisturbed clay",
       .range = {0, 2, true, false}});
  d.value("overconsolidation_exponent", s.exponent, {.meaning = "m of OCR^m in it", .range = {0, 2}});
  d.value("consolidation", s.consolidation, {.meaning = "degree of consolidation U under the weight in operation", .range = {0, 1}});
  d.value("friction_angle", s.friction_angle,
          {.meaning = "of sand: [low, best, high], or [best]", .unit = "rad", .range = {0, 50 * degree, true, false}});
  d.value("interface_angle", s.interface_angle,
          {.meaning = "drained friction angle of the surface of the pipe: [low, best, high], or [best]",
           .unit = "rad",
           .range = {0, 50 * degree, true, false}});
  d.value("cover", s.cover,
          {.meaning = "soil above the crown of a buried line; absent: it lies on the seabed", .unit = "m", .range = positive});
  d.value("prop_height", s.prop_height,
          {.meaning = "height of the imperfection that the line was laid over, for upheaval", .unit = "m", .range = {0, 5}});
  d.value("curve_radius", s.curve_radius, {.meaning = "radius of the route here, for buckling in a curve", .unit = "m", .range = positive});
}

namespace {

void check_estimates(Describe& d, const Estimates3& values, const std::string& path)
{
  d.check(values.empty() || values.size() == 1 || values.size() == 3, path, "has to be one number, or low, best and high");
  d.check(std::is_sorted(values.begin(), values.end()), path, "has to rise from low to high");
}

void check_section(Describe& d, const Section& s, const std::string& path)
{
  d.check(s.to > s.from, path + "kp_to", "is not beyond kp_from");
  if (!s.run.empty()) return;
  for (const auto& [values, key] : {std::pair(&s.strength, "undrained_strength"),
                                    {&s.sensitivity, "sensitivity"},
                                    {&s.adhesion_factor, "adhesion_factor"},
                                    {&s.strength_ratio, "strength_ratio"},
                                    {&s.friction_angle, "friction_angle"},
                                    {&s.interface_angle, "interface_angle"}})
    check_estimates(d, *values, path + key);
  d.check(s.unit_weight > 0, path + "submerged_unit_weight", "is needed without run");
  if (s.is_clay()) {
    d.check(s.strength.front() > 0 || s.gradient > 0, path + "undrained_strength", "is 0 at all depths");
    d.check(!s.adhesion_factor.empty(), path + "adhesion_factor", "is needed of clay");
    d.check(s.friction_angle.empty(), path + "friction_angle", "cannot be combined with undrained_strength");
    return;
  }
  d.check(!s.friction_angle.empty(), path + "friction_angle", "is needed of sand; clay has undrained_strength");
  d.check(!s.interface_angle.empty(), path + "interface_angle", "is needed of sand");
  d.check(s.strength_ratio.empty() && s.adhesion_factor.empty(), path + "adhesion_factor", "is of clay: it needs undrained_strength");
  const auto estimate = [](const std::vector<Real>& values, std::size_t k) { return values.size() == 1 ? values[0] : values[k]; };
  for (std::size_t k = 0; k < std::max(s.friction_angle.size(), s.interface_angle.size()); ++k)
    d.check(estimate(s.interface_angle, k) <= estimate(s.friction_angle, k), path + "interface_angle", "exceeds friction_angle");
}

}  // namespace

void describe(Describe& d, RouteCase& c)
{
  d.value("title", c.title, {.meaning = "title of the page"});
  d.table("pipe", c.pipe, {.meaning = "pipe and its weights"});
  d.table("operation", c.operation, {.meaning = "temperature and pressure by KP"});
  d.array("section", c.section, {.meaning = "parts of the route, in order of KP", .required = true});
  const Pipe& pipe = c.pipe;
  d.check(pipe.steel_diameter.value_or(pipe.diameter) <= pipe.diameter, "pipe.steel_diameter", "is more than the outer diameter");
  d.check(2 * pipe.wall < pipe.steel_diameter.value_or(pipe.diameter), "pipe.wall", "is half of the diameter or more");
  d.check(pipe.lay_factor || pipe.lay_tension > 0, "pipe.lay_factor", "is needed where pipe.lay_tension is 0");
  const Operation& operation = c.operation;
  const std::size_t count = std::max<std::size_t>(1, operation.kp.size());
  d.check(std::is_sorted(operation.kp.begin(), operation.kp.end(), std::less_equal<>()), "operation.kp", "has to rise");
  for (const auto& [values, key] :
       {std::pair(&operation.temperature, "operation.temperature_rise"), {&operation.pressure, "operation.pressure_rise"}})
    d.check(values->size() == count || values->size() == 1, key,
            fmt::format("has {} numbers, operation.kp {}", values->size(), operation.kp.size()));
  d.check(!c.section.empty(), "section", "is needed: at least one part of the route");
  for (std::size_t k = 0; k < c.section.size(); ++k) {
    const std::string path = fmt::format("section[{}].", k);
    check_section(d, c.section[k], path);
    d.check(k == 0 || c.section[k].from == c.section[k - 1].to, path + "kp_from", "is not where the section before ends");
  }
}

RouteCase read_route_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  input::Document document = input::parse_file(file);
  for (const std::string& override : overrides) input::apply_override(document, override);
  RouteCase c;
  read(document, c);
  c.folder = file.parent_path();
  return c;
}

input::Listed route_catalogue()
{
  return input::catalogue_of<RouteCase>();
}

}  // namespace berm::route
