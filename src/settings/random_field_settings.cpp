// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/settings/random_field_input_test.cpp
#include "settings/random_field_settings.hpp"

#include "core/names.hpp"
#include "settings/body_soil.hpp"
#include "settings/case.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {

void describe(Describe& d, SoundingSettings& sounding)
{
  d.value("x", sounding.x, {.meaning = "place of the vertical along x", .unit = "m"});
  d.value("z", sounding.z, {.meaning = "place of the vertical along z, in space", .unit = "m"});
  d.value("depth", sounding.depth,
          {.meaning = "depths below the seabed, the smallest first", .unit = "m", .range = not_negative, .required = true});
  d.value("value", sounding.value,
          {.meaning = "the property at these depths; within a cell of the field their geometric mean counts",
           .unit = "Pa",
           .range = positive,
           .required = true});
}

void describe(Describe& d, RandomFieldSettings& field)
{
  d.value("material", field.material, {.meaning = "name of its [material.NAME]", .required = true});
  d.value("property", field.property,
          {.meaning =
               "key of the material that varies: its strength (cohesion, undrained_strength), young_modulus, friction_angle, whose tangent "
               "varies, or density, with which unit weight and vertical stress at rest vary; the value in the material, with gradient, "
               "profile or shansep, is the mean (of the tangent). A rigidity_index keeps the stiffness proportional to the strength; "
               "dilation_angle stays, at most the friction angle, and associated flow stays associated; inertia_density varies with "
               "density",
           .required = true});
  d.value("coefficient_of_variation", field.coefficient_of_variation,
          {.meaning = "coefficient of variation (standard deviation divided by mean) at a point, of a lognormal distribution",
           .range = {0, 10, true},
           .required = true});
  d.value("correlation_length_x", field.correlation_length_x,
          {.meaning = "scale of fluctuation along x: the integral of the correlation of the logarithm over all distances; absent: the same "
                      "all along x",
           .unit = "m",
           .range = positive});
  d.value("correlation_length_depth", field.correlation_length_depth,
          {.meaning = "the same along the depth below the seabed", .unit = "m", .range = positive});
  d.value("correlation_length_z", field.correlation_length_z, {.meaning = "the same along z, in space", .unit = "m", .range = positive});
  d.choice(
      "correlation", field.correlation, {"markov", "gaussian"},
      {.meaning = "correlation of the logarithm along each direction, their product counts: exp(-2 t/length), or exp(-pi (t/length)^2)"});
  d.value("averaging_length", field.averaging_length,
          {.meaning =
               "side of the squares (cubes) over which the logarithm is averaged, such as the size of the cells of the mesh; absent: "
               "values at points, on a grid of a twentieth of the correlation lengths",
           .unit = "m",
           .range = positive});
  d.value("seed", field.seed, {.meaning = "another seed makes another realisation", .range = not_negative});
  d.array("sounding", field.sounding, {.meaning = "verticals along which the property is known"});
}

namespace {

void check_property(Describe& d, const Case& c, const std::string& path, const RandomFieldSettings& field)
{
  const Index number = index_of(c.material, field.material);
  if (number == none) return;
  const std::string key = path + ".property";
  const material::Material& material = c.material[number].second;
  std::vector<std::string> known;
  for (const FieldInfo& own : local_fields(material)) known.push_back(own.name);
  if (has_friction(material)) known.emplace_back(friction_word);
  known.emplace_back(density_word);
  d.check(std::find(known.begin(), known.end(), field.property) != known.end(), key,
          fmt::format("[material.{}] with the law \"{}\" has no property \"{}\" that varies from place to place", field.material,
                      law_word(material), field.property),
          known);
}

void check_sounding(Describe& d, const std::string& path, const RandomFieldSettings& field, const SoundingSettings& sounding)
{
  d.check(!sounding.depth.empty(), path + ".depth", "needs one depth at least");
  d.check(sounding.value.size() == sounding.depth.size(), path + ".value",
          fmt::format("needs a value for each of the {} depths, and has {}", sounding.depth.size(), sounding.value.size()));
  d.check(std::adjacent_find(sounding.depth.begin(), sounding.depth.end(), std::greater_equal<>()) == sounding.depth.end(), path + ".depth",
          "each depth must be larger than the one before");
  d.check(sounding.z == 0 || field.correlation_length_z, path + ".z", "is for a field with correlation_length_z");
}

}  // namespace

void check_random_fields(Describe& d, const Case& c)
{
  for (std::size_t k = 0; k < c.random_field.size(); ++k) {
    const auto& [name, field] = c.random_field[k];
    const std::string path = "random_field." + name;
    check_name(d, path + ".material", field.material, "material", names_of(c.material));
    check_property(d, c, path, field);
    d.check(index_of(c.material, field.material) == none || is_used(c, field.material), path + ".material",
            fmt::format("no body has [material.{}]", field.material));
    const auto lengths = field.lengths();
    d.check(lengths[0] || lengths[1] || lengths[2], path, "needs a correlation_length_x, correlation_length_depth or both");
    d.check(!field.correlation_length_z || c.dimension() == 3, path + ".correlation_length_z", "is for geometry = \"space\"");
    d.check(!field.correlation_length_x || c.geometry != Geometry::axisymmetric, path + ".correlation_length_x",
            "would make rings around the axis: in axisymmetry soil can vary along the depth alone");
    for (std::size_t other = 0; other < k; ++other)
      d.check(c.random_field[other].second.material != field.material || c.random_field[other].second.property != field.property, path,
              fmt::format("varies what [random_field.{}] varies", c.random_field[other].first));
    d.check(field.sounding.empty() || !field.by_classes(), path + ".sounding",
            "is for a strength or stiffness, in Pa: of a friction angle or density no values are taken");
    for (std::size_t s = 0; s < field.sounding.size(); ++s)
      check_sounding(d, fmt::format("{}.sounding[{}]", path, s), field, field.sounding[s]);
  }
}

}  // namespace berm::settings
