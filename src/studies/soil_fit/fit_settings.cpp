// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_fit/measured_test.cpp
#include "soil_fit/fit_settings.hpp"

#include "input/message_text.hpp"
#include "input/override.hpp"
#include "input/reader.hpp"
#include "input/units.hpp"
#include "material/clay.hpp"
#include "os/error.hpp"
#include "soil_fit/laboratory_table.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::soil_fit {

namespace {

void describe_tool(Describe& d, Penetrometer& tool, const char* least_area)
{
  d.value("diameter", tool.diameter, {.meaning = "diameter of the tool", .unit = "m", .range = positive, .required = true});
  d.value("area", tool.area, {.meaning = least_area, .unit = "m^2", .range = positive});
  d.value(
      "resistance_factor", tool.resistance_factor,
      {.meaning =
           "resistance divided by the undrained strength of clay that neither softens nor has a rate effect; undrained_strength depends on "
           "it, sensitivity and ductility do not",
       .range = positive});
  d.value("passage_strain", tool.passage_strain,
          {.meaning =
               "plastic shear strain xi_T that one passage leaves in the clay on average [recalled: Zhou and Randolph 2009]; ductility is "
               "proportional to it",
           .range = positive});
  d.value("zero_shift", tool.zero_shift,
          {.meaning = "resistance that the file shows where nothing resists, down positive: shift of zero, or pressure of the ground on "
                      "the tool that was not subtracted",
           .unit = "Pa"});
}

bool by_logarithm(const FreeKey& free)
{
  constexpr Real wide = 20;
  return free.from > 0 && free.to >= wide * free.from;
}

}  // namespace

const Penetrometer* penetrometer_of(const MeasuredKind& kind)
{
  const Penetrometer* bar = std::get_if<TBar>(&kind);
  return bar != nullptr ? bar : std::get_if<Ball>(&kind);
}

std::optional<element::TestKind> laboratory_test(const MeasuredKind& kind)
{
  return std::visit(
      [](const auto& test) -> std::optional<element::TestKind> {
        if constexpr (std::is_base_of_v<Penetrometer, std::decay_t<decltype(test)>>)
          return std::nullopt;
        else
          return test;
      },
      kind);
}

const char* word_of(const MeasuredKind& kind)
{
  return std::visit([](const auto& test) { return test.word; }, kind);
}

void describe(Describe& d, TBar& bar)
{
  describe_tool(d, bar, "of a file with a force: the area that it acts on, diameter times length");
}

void describe(Describe& d, Ball& ball)
{
  describe_tool(d, ball, "of a file with a force: the area that it acts on (absent: the cross-section of the ball)");
}

Real value_at(const FreeKey& free, Real x)
{
  return std::clamp(by_logarithm(free) ? free.from * std::pow(free.to / free.from, x) : free.from + (free.to - free.from) * x, free.from,
                    free.to);
}

Real place_of(const FreeKey& free, Real value)
{
  return by_logarithm(free) ? std::log(value / free.from) / std::log(free.to / free.from) : (value - free.from) / (free.to - free.from);
}

Real slope_of(const FreeKey& free, Real value)
{
  return by_logarithm(free) ? value * std::log(free.to / free.from) : free.to - free.from;
}

void describe(Describe& d, FreeKey& free)
{
  d.value("key", free.key, {.meaning = "key of the material that is fitted, such as friction_angle", .required = true});
  d.value("from", free.from, {.meaning = "its least value", .required = true, .any_unit = &free.unit});
  d.value("to", free.to, {.meaning = "its greatest value", .required = true, .any_unit = &free.unit});
}

void describe(Describe& d, MeasuredFile& measured)
{
  d.value("name", measured.name, {.meaning = "name, for messages; where the file has one test, that of the test", .required = true});
  d.value("file", measured.file, {.meaning = "CSV file with headings, or file of AGS 4, relative to this file's folder", .required = true});
  using namespace element;
  d.one_of(
      "kind", measured.kind, {Triaxial::word, Biaxial::word, SimpleShear::word, Isotropic::word, Oedometer::word, TBar::word, Ball::word},
      {.meaning = "which test, with the keys of [[test]] of berm element but its paths; the stress at the start, where it is left out, is "
                  "that of the first row. t_bar and ball: a full-flow penetrometer that was moved down and up over a depth",
       .required = true});
  d.value("test", measured.test, {.meaning = "heading of the column that names the tests; absent: the file is one test"});
  d.value("tests", measured.tests, {.meaning = "names of the tests that are taken; absent: all of the file"});
  d.value("held_out", measured.held_out, {.meaning = "names of tests that are computed with the fitted soil and not fitted"});
  d.value("columns", measured.columns,
          {.meaning = "heading of the column, with its unit, by what it holds: {q = \"dev (kPa)\"}; what is not named is looked for under "
                      "its own name, such as q (kPa) or q_kPa"});
  d.value("specimen", measured.specimen,
          {.meaning = "keys of the material that each specimen has of its own, by the heading of their column, whose first row counts: "
                      "{void_ratio = \"e\"}"});
  d.value("weight", measured.weight, {.meaning = "weight of each test of the file in the sum of squares", .range = positive});
  d.value("largest_strain", measured.largest_strain,
          {.meaning = "rows beyond this strain from the start are not compared: beyond the peak, bands belong to the specimen",
           .range = positive});
  d.value("strain_rate", measured.strain_rate,
          {.meaning = "rate of the axial strain (simple_shear: of the shear strain; t_bar and ball: of the clay around the tool, some 0.4 "
                      "times its speed divided by its diameter); absent: so slow that the strength does not depend on it",
           .unit = "1/s",
           .range = positive});
}

void describe(Describe& d, FitCase& c)
{
  d.value("title", c.title, {.meaning = "title of the page"});
  d.named_tables("material", c.material, {.meaning = "the soil; the values of its free keys are where the search begins"});
  d.array("free", c.free, {.meaning = "keys of the soil that are fitted", .required = true});
  d.array("measured", c.measured, {.meaning = "measured tests", .required = true});
  d.value("starts", c.starts,
          {.meaning = "number of searches: from the material as it is, and from other places within the bounds", .range = {1, 100}});
  d.value("largest_step", c.largest_step,
          {.meaning = "largest strain of a step that is computed between two measured rows", .range = {1e-6, 0.01}});
  d.check(c.material.size() == 1, "material",
          fmt::format("one table [material.NAME] is needed, the soil that is fitted; there are {}", c.material.size()));
  for (const auto& [name, material] : c.material) check(d, "material." + name, material);
  for (std::size_t k = 0; k < c.free.size(); ++k) {
    const std::string path = fmt::format("free[{}]", k);
    d.check(c.free[k].from < c.free[k].to, path + ".to", "is not more than from");
    for (std::size_t before = 0; before < k; ++before) d.check(c.free[before].key != c.free[k].key, path + ".key", "is free already");
  }
  const std::vector<std::string> readings = reading_words();
  for (std::size_t k = 0; k < c.measured.size(); ++k) {
    const std::string path = fmt::format("measured[{}]", k);
    for (const auto& [word, heading] : c.measured[k].columns)
      d.check(std::find(readings.begin(), readings.end(), word) != readings.end(), path + ".columns." + word, "is not a quantity of a test",
              readings);
    const std::optional<element::TestKind> laboratory = laboratory_test(c.measured[k].kind);
    d.check((laboratory && !element::is_compression(*laboratory)) || !c.measured[k].largest_strain, path + ".largest_strain",
            "is of tests that are driven by their strain");
    d.check(laboratory || c.measured[k].specimen.empty(), path + ".specimen", "is of laboratory tests");
    for (std::size_t before = 0; before < k; ++before)
      d.check(c.measured[before].name != c.measured[k].name, path + ".name", "is the name of measured tests before it");
    for (const auto& [key, heading] : c.measured[k].specimen)
      d.check(std::none_of(c.free.begin(), c.free.end(), [&, &own = key](const FreeKey& free) { return free.key == own; }),
              path + ".specimen." + key, "is free, too: leave out one of the two");
    if (c.material.size() != 1) continue;
    d.check(laboratory || c.material[0].second.get_if<material::Clay>() != nullptr, path + ".kind",
            "is a test of clay that softens: law = \"clay\"");
    d.check(!laboratory || !element::drained(*laboratory) || element::is_compression(*laboratory) ||
                !element::knows_total_stress_alone(c.material[0].second),
            path + ".drained", fmt::format("{} has an undrained strength, and cannot be drained", c.material[0].first));
  }
}

namespace {

/// The value of a node as an override takes it.
void set(input::Document& document, const std::string& material, const std::string& key, Real value)
{
  input::apply_override(document, fmt::format("material.{}.{}={:.17g}", material, key, value));
}

FitCase case_of(input::Document document, const std::filesystem::path& folder, const std::vector<std::string>& overrides)
{
  for (const std::string& override : overrides) input::apply_override(document, override);
  if (const input::Node* free = member(document.root, "free"))
    for (const input::Node& item : free->items) {
      const input::Node *from = member(item, "from"), *to = member(item, "to");
      const auto has_unit = [](const input::Node& node) { return node.kind == input::Node::Kind::text; };
      if (from != nullptr && to != nullptr && has_unit(*from) != has_unit(*to))
        refuse(document, *to, "free.to", "one of the bounds has a unit: give both with it, or both in SI units");
    }
  FitCase c;
  c.document = document;
  c.folder = folder;
  std::erase_if(c.document.root.items, [](const input::Node& item) { return item.key != "material"; });
  read(document, c);
  for (const FreeKey& free : c.free) {
    const Real start = value_in(c, free);
    if (start < free.from || start > free.to)
      throw InputError(fmt::format("{}: free.{}: the material has {}, which is not within its bounds, {} to {}", document.file, free.key,
                                   input::quantity(start, free.unit), input::quantity(free.from, free.unit),
                                   input::quantity(free.to, free.unit)));
  }
  return c;
}

}  // namespace

FitCase read_fit_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  return case_of(input::parse_file(file), file.parent_path(), overrides);
}

FitCase read_fit_text(const std::string& file, const std::string& text, const std::filesystem::path& folder,
                      const std::vector<std::string>& overrides)
{
  return case_of(input::parse_text(file, text), folder, overrides);
}

material::Material material_with(const FitCase& c, const Values& values)
{
  input::Document document = c.document;
  for (const auto& [key, value] : values) set(document, c.material_name(), key, value);
  element::MaterialsOfCase materials;
  read(document, materials);
  return materials.material.front().second;
}

Real value_in(const FitCase& c, const FreeKey& free)
{
  const std::string path = "material." + c.material_name() + "." + free.key;
  const input::Found found = input::follow(c.document.root, path);
  const auto wrong = [&](const std::string& what) { return InputError(fmt::format("{}: free.{}: {}", c.document.file, free.key, what)); };
  if (!found.whole) {
    std::vector<std::string> keys;
    for (const input::Node& item : input::follow(c.document.root, "material." + c.material_name()).node->items) keys.push_back(item.key);
    throw wrong(fmt::format("[material.{}] has no such key, whose value is where the search begins{}", c.material_name(),
                            input::suggestion(free.key, keys)));
  }
  if (found.node->kind == input::Node::Kind::number) return found.node->number;
  if (found.node->kind == input::Node::Kind::whole) return static_cast<Real>(found.node->whole);
  if (found.node->kind != input::Node::Kind::text || !input::is_quantity(found.node->text))
    throw wrong("is not a number of [material." + c.material_name() + "]");
  const input::SiQuantity value = input::to_si(found.node->text);
  if (!input::same_dimension(value.unit, free.unit.empty() ? "1" : free.unit))
    throw wrong(fmt::format("its bounds need the dimension of the material's {}", input::in_quotes(found.node->text)));
  return value.value;
}

input::Listed fit_catalogue()
{
  return input::catalogue_of<FitCase>();
}

}  // namespace berm::soil_fit
