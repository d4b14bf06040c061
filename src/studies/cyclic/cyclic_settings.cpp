// SPDX-License-Identifier: BSD-3-Clause
#include "cyclic/cyclic_settings.hpp"

#include "input/message_text.hpp"
#include "input/override.hpp"
#include "input/places.hpp"
#include "input/reader.hpp"
#include "input/table_file.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::cyclic {

std::vector<Parcel> CyclicCase::parcels() const
{
  std::vector<Parcel> all;
  for (std::size_t k = 0; k < storm.load.size(); ++k) all.push_back({storm.cycles[k], storm.load[k] / storm.capacity.value_or(1)});
  if (storm.order == Order::ascending)
    std::stable_sort(all.begin(), all.end(), [](const Parcel& a, const Parcel& b) { return a.stress < b.stress; });
  return all;
}

void describe(Describe& d, ContourSettings& contours)
{
  d.value("table", contours.table,
          {.meaning = "CSV file of columns shear_strain (or pore_pressure_ratio), average_stress_ratio (tau_a/s_u), cycles (N), "
                      "cyclic_stress_ratio (tau_cy/s_u): points of contours, relative to this file's folder",
           .required = true});
  d.choice("of", contours.of, measure_words, {.meaning = "quantity of the contours, which accumulates from parcel to parcel"});
  d.value("failure", contours.failure, {.meaning = "the contour at which the clay has failed; absent: the highest", .range = positive});
}

void describe(Describe& d, StormSettings& storm)
{
  d.value("cycles", storm.cycles, {.meaning = "number of cycles of each parcel", .range = {1, 1e7}, .required = true});
  d.value("load", storm.load,
          {.meaning = "cyclic load of each parcel, half of its height from trough to crest, in any unit or as a ratio",
           .range = positive,
           .required = true,
           .any_unit = &storm.unit});
  d.value("average_load", storm.average_load,
          {.meaning = "load that acts all the time, which no multiplier changes", .range = not_negative, .any_unit = &storm.unit});
  d.value("static_capacity", storm.capacity,
          {.meaning = "load that the clay carries at its undrained strength; absent: loads are shear stresses divided by s_u",
           .range = positive,
           .any_unit = &storm.unit});
  d.choice("order", storm.order, {"ascending", "given"},
           {.meaning = "order in which the parcels come: by their load, or as they are given"});
}

void describe(Describe& d, CyclicCase& c)
{
  d.value("title", c.title, {.meaning = "title of the page"});
  d.named_tables("material", c.material, {.meaning = "a clay, as in a case; its undrained strength is multiplied for the storm"});
  d.table("contours", c.contours, {.meaning = "contour diagram of cyclic tests"});
  d.table("storm", c.storm, {.meaning = "the storm as parcels of cycles"});
  d.check(c.material.size() <= 1, "material",
          fmt::format("one table [material.NAME] at most, the clay of the contours; there are {}", c.material.size()));
  for (const auto& [name, material] : c.material) {
    const std::optional<material::Strength> strength = material::strength_at_rest(material);
    d.check(strength && strength->friction_angle == 0 && material::with_strength_over(material, 1), "material." + name + ".law",
            "has no undrained strength to multiply: take \"clay\", \"ngi_adp\", or \"mohr_coulomb\" without friction_angle");
    check(d, "material." + name, material);
  }
  d.check(c.storm.cycles.size() == c.storm.load.size(), "storm.load",
          fmt::format("has {} loads, and storm.cycles {} numbers: one of each for a parcel", c.storm.load.size(), c.storm.cycles.size()));
  d.check(c.storm.capacity || c.storm.unit.empty() || c.storm.unit == "1", "storm.static_capacity", "is needed where loads have a unit");
}

namespace {

/// Reads the points of the contours; what is wrong with a row comes with its line.
ContourTable read_contours(const ContourSettings& settings, const std::filesystem::path& folder)
{
  const std::string of = measure_words[static_cast<std::size_t>(settings.of)];
  ContourTable table;
  const input::TableForm form{.of = "contours",
                              .columns = {{"average_stress_ratio", ""}, {"cycles", ""}, {"cyclic_stress_ratio", ""}},
                              .header = "average_stress_ratio,cycles,cyclic_stress_ratio",
                              .first = {of, ""},
                              .over = "the quantity of the contours"};
  const ContourCurve* last = nullptr;
  const auto take = [&](Real strain, const std::vector<std::size_t>& columns, const std::vector<Real>& values) -> std::string {
    Real row[3] = {nan, nan, nan};
    for (std::size_t k = 0; k < columns.size(); ++k) row[columns[k]] = values[k];
    const auto [average, cycles, stress] = row;
    if (columns.size() < 3) return "a row of a contour needs average_stress_ratio, cycles and cyclic_stress_ratio";
    if (!(strain > 0 && strain <= 1))
      return fmt::format("{} = {:.6g} is not more than 0 and at most 1; in per cent write the heading {} (%)", of, strain, of);
    if (!(average >= 0 && average <= 2)) return fmt::format("average_stress_ratio = {:.6g} is not from 0 to 2", average);
    if (!(cycles >= 1)) return fmt::format("cycles = {:.6g} is less than 1", cycles);
    if (!(stress >= 0 && stress <= 5)) return fmt::format("cyclic_stress_ratio = {:.6g} is not from 0 to 5", stress);
    ContourCurve& curve = table[strain][average];
    if (!curve.empty() && last != &curve) return "the rows of a contour at an average stress must be consecutive";
    if (!curve.empty() && !(cycles > curve.back().cycles)) return "the cycles of a contour must ascend";
    if (!curve.empty() && stress > curve.back().stress) return "the stress of a contour must not increase with the number of cycles";
    curve.push_back({cycles, stress});
    last = &curve;
    return "";
  };
  input::read_table("contours.table", folder / settings.table, form, take);
  return table;
}

/// A bare number among loads with a unit would be one of the SI unit.
void check_units(const input::Document& document)
{
  const input::Node* storm = member(document.root, "storm");
  const input::Node* load = storm == nullptr ? nullptr : member(*storm, "load");
  if (load == nullptr || load->items.empty()) return;
  const auto has_unit = [](const input::Node& node) { return node.kind == input::Node::Kind::text; };
  const auto check = [&](const input::Node* node, const std::string& key) {
    if (node != nullptr && has_unit(*node) != has_unit(load->items.front()))
      refuse(document, *node, key, "of these loads some have a unit and some have none: give all with it, or all as ratios");
  };
  for (std::size_t k = 0; k < load->items.size(); ++k) check(&load->items[k], fmt::format("storm.load[{}]", k));
  for (const char* key : {"average_load", "static_capacity"}) check(member(*storm, key), std::string("storm.") + key);
}

}  // namespace

CyclicCase read_cyclic_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  input::Document document = input::parse_file(file);
  for (const std::string& override : overrides) input::apply_override(document, override);
  check_units(document);
  CyclicCase c;
  read(document, c);
  const input::Places places(std::move(document));
  try {
    const ContourTable table = read_contours(c.contours, file.parent_path());
    const Real failure = c.contours.failure.value_or(table.rbegin()->first);
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const auto& contour) { return std::abs(contour.first - failure) < 1e-9; });
    if (found == table.end()) {
      std::string all;
      for (const auto& contour : table) all += fmt::format("{}{:.6g}", all.empty() ? "" : ", ", contour.first);
      throw KeyError(fmt::format("contours.failure: there is no contour of {:.6g}; those of the table are {}", failure, all));
    }
    c.failure = static_cast<std::size_t>(std::distance(table.begin(), found));
    try {
      c.diagram = Contours(table, c.storm.average());
    } catch (const InputError& error) {
      throw KeyError(fmt::format("contours.table: {}", error.what()));
    }
  } catch (const KeyError& error) {
    throw input::LocatedError(places.located(error));
  }
  return c;
}

input::Listed cyclic_catalogue()
{
  return input::catalogue_of<CyclicCase>();
}

}  // namespace berm::cyclic
