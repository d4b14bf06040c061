// SPDX-License-Identifier: BSD-3-Clause
#include "soil_fit/measured.hpp"

#include "soil_fit/laboratory_table.hpp"
#include "soil_fit/passages.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::soil_fit {
namespace {

using element::TestKind;

/// What a laboratory's table has of one test.
struct Columns {
  const MeasuredFile& file;
  const TestKind& kind;
  const LaboratoryTable& table;
  const std::vector<std::size_t> rows;

  bool has(Reading reading) const { return table.has(reading); }
  /// NaN where the row has no number.
  Real at(Reading reading, std::size_t row) const { return table.has(reading) ? table.value(reading, rows[row]) : nan; }
  /// Natural strain from the first row.
  Real strain(Reading reading, std::size_t row) const
  {
    const Real sense = reading == Reading::axial_strain ? element::sense(kind) : 1;
    return sense * (natural(sense * at(reading, row)) - natural(sense * at(reading, 0)));
  }
  static Real natural(Real engineering) { return -std::log(1 - engineering); }
  /// From the strain of the volume, or from the void ratio.
  bool has_volume() const { return has(Reading::volumetric_strain) || has(Reading::void_ratio); }
  Real volumetric_strain(std::size_t row) const
  {
    if (has(Reading::volumetric_strain)) return strain(Reading::volumetric_strain, row);
    return std::log((1 + at(Reading::void_ratio, 0)) / (1 + at(Reading::void_ratio, row)));
  }

  Real lateral(std::size_t row) const
  {
    if (has(Reading::lateral_stress)) return at(Reading::lateral_stress, row);
    if (std::holds_alternative<element::Triaxial>(kind) && has(Reading::p) && has(Reading::q))
      return at(Reading::p, row) - at(Reading::q, row) / 3;
    return element::start_of(kind).horizontal();
  }
  Real q(std::size_t row) const { return has(Reading::q) ? at(Reading::q, row) : (at(Reading::stress_ratio, row) - 1) * lateral(row); }

  [[noreturn]] void refuse(std::size_t row, const std::string& what) const { table.refuse(rows[row], what); }
};

/// Whether columns tell the lateral stress of each row.
bool knows_lateral(const Columns& of)
{
  return of.has(Reading::lateral_stress) ||
         (std::holds_alternative<element::Triaxial>(of.kind) && of.has(Reading::p) && of.has(Reading::q));
}

/// The columns that a kind of test needs, each as alternatives.
std::vector<std::vector<Reading>> needed(const TestKind& kind)
{
  using enum Reading;
  const bool undrained = !element::drained(kind);
  if (std::holds_alternative<element::SimpleShear>(kind)) return {{shear_strain}, {tau}};
  if (std::holds_alternative<element::Oedometer>(kind)) return {{vertical_stress}, {axial_strain, void_ratio}};
  if (std::holds_alternative<element::Isotropic>(kind)) return {{p}, {volumetric_strain, void_ratio}};
  if (undrained) return {{axial_strain}, {q}};
  return {{axial_strain}, {q, stress_ratio}};
}

/// Sets the stress at the start from the first row where the input leaves it to the file.
void take_start(const Columns& of, element::TestSettings& settings)
{
  element::StartStress start = element::start_of(settings.kind);
  if (start.confining_stress || start.vertical_stress) return;
  Real vertical = nan, lateral = nan;
  if (std::holds_alternative<element::Isotropic>(settings.kind)) {
    vertical = lateral = of.at(Reading::p, 0);
  } else if (std::holds_alternative<element::Oedometer>(settings.kind) || std::holds_alternative<element::SimpleShear>(settings.kind)) {
    vertical = of.at(Reading::vertical_stress, 0);
    lateral = of.has(Reading::lateral_stress) ? of.at(Reading::lateral_stress, 0) : start.k0.value_or(nan) * vertical;
  } else if (knows_lateral(of)) {
    lateral = of.lateral(0);
    vertical = lateral + of.q(0);
  }
  if (!std::isfinite(vertical) || !std::isfinite(lateral))
    of.refuse(0, fmt::format("the stress at the start is not known: give confining_stress, or vertical_stress and k0, of measured.{}",
                             of.file.name));
  start.vertical_stress = vertical;
  start.k0 = vertical > 0 ? lateral / vertical : 1;
  std::visit([&](auto& kind) { kind.start = start; }, settings.kind);
}

constexpr Real least_stress = 100, most_stress = 1e8, most_strain = 1;  // Pa, Pa, bare: beyond, the unit is another

void check_numbers(const Columns& of)
{
  const auto extreme = [&](Reading reading) {
    std::size_t row = 0;
    for (std::size_t k = 0; k < of.rows.size(); ++k)
      if (const Real x = of.at(reading, k); std::isfinite(x) && !(std::abs(x) <= std::abs(of.at(reading, row)))) row = k;
    return row;
  };
  const auto first_below = [&](Reading reading, Real least) -> std::optional<std::size_t> {
    for (std::size_t k = 0; k < of.rows.size(); ++k)
      if (of.at(reading, k) < least) return k;
    return std::nullopt;
  };
  const auto any_above = [&](Reading reading, Real most) {  // a test that goes to and fro is on both sides
    for (std::size_t k = 0; k < of.rows.size(); ++k)
      if (of.at(reading, k) > most) return true;
    return false;
  };
  const bool extends = element::sense(of.kind) < 0;
  constexpr Real slack = -1e-3, touch = -1e3;  // of strain, and Pa: what a device shows before it touches
  for (const Reading reading : {Reading::axial_strain, Reading::shear_strain, Reading::volumetric_strain}) {
    if (!of.has(reading)) continue;
    const std::size_t row = extreme(reading);
    const Real x = of.at(reading, row);
    const std::string name = of.table.words_of(reading);
    if (std::abs(x) >= most_strain && reading != Reading::shear_strain)
      of.refuse(row, fmt::format("{} is {:.4g}, which no specimen strains by: is its unit %?", name, x));
    if (reading == Reading::axial_strain && x < slack && !any_above(reading, -slack))
      of.refuse(row,
                fmt::format("{} reaches {:.4g}: compression is positive; with direction = \"extension\" extension is positive", name, x));
  }
  for (const Reading reading : {Reading::q, Reading::p, Reading::vertical_stress, Reading::lateral_stress, Reading::tau}) {
    if (!of.has(reading)) continue;
    const std::size_t row = extreme(reading);
    const std::string name = of.table.words_of(reading);
    const bool may_be_negative = reading == Reading::tau || (reading == Reading::q && (extends || any_above(reading, -touch)));
    if (const auto below = first_below(reading, touch); below && !may_be_negative)
      of.refuse(*below, fmt::format("{} is {:.4g} Pa: stresses are effective, and compression is positive", name, of.at(reading, *below)));
    if (reading == Reading::q && extends && of.at(reading, of.rows.size() - 1) > of.at(reading, 0))
      of.refuse(of.rows.size() - 1, fmt::format("{} rises to {:.4g} Pa: in extension q, vertical less lateral stress, decreases", name,
                                                of.at(reading, of.rows.size() - 1)));
    if (const Real x = std::abs(of.at(reading, row)); x < least_stress || x > most_stress)
      of.refuse(row, fmt::format("{} is {:.4g} Pa at most, which is not a stress of a test of soil: is its unit right?", name, x));
  }
  if (knows_lateral(of) && element::drained(of.kind))
    for (std::size_t k = 0; k < of.rows.size(); ++k)
      if (of.lateral(k) < touch) of.refuse(k, fmt::format("the lateral stress, p less q/3, is {:.4g} Pa", of.lateral(k)));
  if (!of.has(Reading::volumetric_strain) || !of.has(Reading::void_ratio)) return;
  const std::size_t row = extreme(Reading::volumetric_strain);
  const Real by_strain = of.strain(Reading::volumetric_strain, row),
             by_void_ratio = std::log((1 + of.at(Reading::void_ratio, 0)) / (1 + of.at(Reading::void_ratio, row)));
  constexpr Real round_off = 1e-3;
  if (by_strain * by_void_ratio < 0 && std::abs(by_strain) > round_off && std::abs(by_void_ratio) > round_off)
    of.refuse(row, fmt::format("{} and {} have opposite signs: compression is positive, and makes the void ratio smaller",
                               of.table.words_of(Reading::volumetric_strain), of.table.words_of(Reading::void_ratio)));
}

std::vector<Compared> compared_of(const Columns& of, bool total_stress)
{
  using enum Compared;
  const bool undrained = !element::drained(of.kind), triaxial = std::holds_alternative<element::Triaxial>(of.kind);
  if (std::holds_alternative<element::Oedometer>(of.kind)) return {axial_strain};
  if (std::holds_alternative<element::Isotropic>(of.kind)) return {volumetric_strain};
  const bool shears = std::holds_alternative<element::SimpleShear>(of.kind);
  std::vector<Compared> all = {shears ? tau : q};
  if (!undrained && of.has_volume()) all.push_back(volumetric_strain);
  if (!undrained || total_stress) return all;
  if (shears && of.has(Reading::vertical_stress)) all.push_back(vertical_stress);
  if (triaxial && (of.has(Reading::p) || of.has(Reading::excess_pore_pressure))) all.push_back(p);
  return all;
}

Real measured_value(const Columns& of, Compared what, std::size_t row)
{
  switch (what) {
  case Compared::q:
    return of.q(row);
  case Compared::tau:
    return of.at(Reading::tau, row);
  case Compared::vertical_stress:
    return of.at(Reading::vertical_stress, row);
  case Compared::volumetric_strain:
    return of.volumetric_strain(row);
  case Compared::axial_strain:
    return of.has(Reading::axial_strain) ? of.strain(Reading::axial_strain, row) : of.volumetric_strain(row);
  case Compared::p:
  case Compared::resistance:
    break;
  }
  if (of.has(Reading::p)) return of.at(Reading::p, row);
  const element::StartStress& start = element::start_of(of.kind);
  const Real p_at_start = (start.vertical() + 2 * start.horizontal()) / 3;
  return p_at_start + (of.at(Reading::q, row) - of.at(Reading::q, 0)) / 3 -
         (of.at(Reading::excess_pore_pressure, row) - of.at(Reading::excess_pore_pressure, 0));
}

/// The rows of a test; of one by its stress without those that a laboratory calls unloaded, where laws have no state.
std::vector<std::size_t> loaded_rows(const TestKind& kind, const LaboratoryTable& table, const std::vector<std::size_t>& rows)
{
  if (!element::is_compression(kind)) return rows;
  const Reading driving = std::holds_alternative<element::Isotropic>(kind) ? Reading::p : Reading::vertical_stress;
  std::vector<std::size_t> loaded;
  for (const std::size_t row : rows)
    if (!(table.value(driving, row) < least_stress)) loaded.push_back(row);
  if (loaded.empty())
    table.refuse(rows.front(), fmt::format("no row of the test has a stress above {:.0f} Pa: is its unit right?", least_stress));
  return loaded;
}

MeasuredTest test_of(const Columns& all, const std::string& name, const FitCase& c)
{
  check_numbers(all);
  MeasuredTest test;
  test.name = name;
  test.settings.name = name;
  test.settings.material = c.material_name();
  test.settings.strain_rate = all.file.strain_rate;
  test.settings.kind = all.kind;
  take_start(all, test.settings);
  const Columns of{all.file, test.settings.kind, all.table, all.rows};
  for (const auto& [key, heading] : all.file.specimen) test.specimen[key] = all.table.first_of(heading, all.rows.front());
  try {
    (void)material_with(c, test.specimen);
  } catch (const InputError& error) {
    all.refuse(0, fmt::format("measured.{}.specimen: {}", all.file.name, error.what()));
  }
  for (const Compared what : compared_of(of, element::knows_total_stress_alone(c.material.front().second)))
    test.curves.push_back({what, {}});
  if (auto* oedometer = std::get_if<element::Oedometer>(&test.settings.kind)) oedometer->stress_path = {0};
  const bool shears = std::holds_alternative<element::SimpleShear>(test.settings.kind);
  const bool holds =
      element::drained(test.settings.kind) && !test.by_stress() && (shears ? of.has(Reading::vertical_stress) : knows_lateral(of));
  const Reading driving = std::holds_alternative<element::Isotropic>(test.settings.kind) ? Reading::p : Reading::vertical_stress;
  for (std::size_t row = 0; row < all.rows.size(); ++row) {
    const Real driven = test.by_stress() ? of.at(driving, row)
                        : shears         ? of.at(Reading::shear_strain, row) - of.at(Reading::shear_strain, 0)
                                         : of.strain(Reading::axial_strain, row);
    const Real held = !holds ? nan : shears ? of.at(Reading::vertical_stress, row) : of.lateral(row);
    if (!std::isfinite(driven) || (holds && !std::isfinite(held))) {
      if (row == 0) of.refuse(row, "the first row of a test needs all its columns");
      continue;
    }
    if (!test.by_stress() && std::abs(driven) > all.file.largest_strain.value_or(infinity)) continue;
    if (all.file.test.empty() && !test.by_stress() && row > 0 && std::abs(driven) < 1e-4 && !test.driven.empty() &&
        test.driven.back() > 0.002)
      if (const std::string other = all.table.changed_name(all.rows[row]); !other.empty())
        all.refuse(
            row,
            fmt::format(
                "the strain begins again here, where the column {0} changes: several tests are named by it, measured.{1}.test = \"{0}\"",
                other, all.file.name));
    test.driven.push_back(driven);
    if (holds) test.held.push_back(held);
    for (MeasuredCurve& curve : test.curves) curve.values.push_back(measured_value(of, curve.what, row));
  }
  if (test.rows() < 2) of.refuse(0, fmt::format("{} has no second row to compare", name));
  return test;
}

}  // namespace

const char* name_of(Compared what)
{
  constexpr const char* names[] = {"q", "tau", "p'", "vertical stress", "volumetric strain", "axial strain", "resistance"};
  return names[static_cast<int>(what)];
}

const char* word_of(Compared what)
{
  constexpr const char* words[] = {"q", "tau", "p", "vertical_stress", "volumetric_strain", "axial_strain", "resistance"};
  return words[static_cast<int>(what)];
}

bool is_strain(Compared what)
{
  return what == Compared::volumetric_strain || what == Compared::axial_strain;
}

Real engineering_strain(Real natural)
{
  return 1 - std::exp(-natural);
}

Real as_measured(const MeasuredTest& test, Real driven)
{
  if (test.passages || test.by_stress() || std::holds_alternative<element::SimpleShear>(test.settings.kind)) return driven;
  const Real sense = element::sense(test.settings.kind);
  return sense * engineering_strain(sense * driven);
}

std::vector<MeasuredTest> read_measured(const FitCase& c)
{
  std::vector<MeasuredTest> tests;
  for (const MeasuredFile& file : c.measured) {
    const LaboratoryTable table(c.folder / file.file, file);
    const std::optional<TestKind> kind = laboratory_test(file.kind);
    for (const auto& alternatives : kind ? needed(*kind) : columns_of_passages()) table.need(alternatives);
    const auto is_among = [](const std::string& name, const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const auto& [name, rows] : table.tests()) {
      if (!file.tests.empty() && !is_among(name, file.tests)) continue;
      std::vector<MeasuredTest> found;
      if (kind)
        found.push_back(test_of({file, *kind, table, loaded_rows(*kind, table, rows)}, name, c));
      else
        found = passages_of(file, table, name, rows);
      for (MeasuredTest& test : found) {
        for (const MeasuredTest& other : tests)
          if (other.name == test.name) table.refuse(rows.front(), fmt::format("{} is the name of another test", test.name));
        test.weight = file.weight;
        test.held_out = is_among(name, file.held_out);
        tests.push_back(std::move(test));
      }
    }
    for (const auto* names : {&file.tests, &file.held_out})
      for (const std::string& name : *names) table.need_test(name);
  }
  if (std::all_of(tests.begin(), tests.end(), [](const MeasuredTest& test) { return test.held_out; }))
    throw InputError(fmt::format("{}: measured: no test is left to fit", c.document.file));
  return tests;
}

}  // namespace berm::soil_fit
