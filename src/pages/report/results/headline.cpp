// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "report/results/results_section.hpp"

#include "structures/structures.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <fmt/format.h>

namespace berm::report {
namespace {

/// A number in the unit of its size.
std::string in_unit(Real value, const text::NamedUnit& unit)
{
  return fmt::format("{} {}", text::short_number(value / unit.size), unit.name);
}

/// With three digits that count, and what stands small behind it.
std::string value_words(const record::RunRecord& run, const run_folder::Quantity& q)
{
  const Real size = std::abs(q.value);
  if (q.unit == "N/m" || q.unit == "N") return in_unit(q.value, text::unit_of_forces(size, q.unit == "N" ? 3 : 2));
  if (q.unit == "N m")
    return in_unit(q.value, size < 1e3   ? text::NamedUnit{1, "N m"}
                            : size < 1e6 ? text::NamedUnit{1e3, "kN m"}
                                         : text::NamedUnit{1e6, "MN m"});
  if (q.unit == "m") {
    const Real width = base::body_scale(run).width;
    const std::string parts = width > 0 ? fmt::format(" <small>{} D</small>", text::short_number(q.value / width)) : "";
    return in_unit(q.value, size < 1 ? text::NamedUnit{1e-3, "mm"} : text::NamedUnit{1, "m"}) + parts;
  }
  if (q.unit == "Pa") return in_unit(q.value, size < 1e6 ? text::NamedUnit{1e3, "kPa"} : text::NamedUnit{1e6, "MPa"});
  if (q.unit == "rad") return fmt::format("{}°", text::short_number(q.value / degree));
  if (q.unit != "1") return fmt::format("{} {}", text::short_number(q.value), text::html_text(q.unit));
  const bool is_part = q.name.starts_with("U_of_") || q.name.find("strain") != std::string::npos;
  return is_part ? text::percent_words(q.value) : text::short_number(q.value);
}

/// The band of a number where the run has one.
std::string band_words(const record::RunRecord& run, const run_folder::Quantity& q)
{
  if (!run.summary || !run.summary->uncertainty) return "";
  const run_folder::Band* band = run.summary->uncertainty->find(q.name);
  if (band == nullptr) return "";
  const auto end = [&](Real value) { return value_words(run, {q.name, value, q.unit}); };
  return fmt::format("<dd class=\"quiet\">band {} to {}</dd>", end(band->converged - band->half_width),
                     end(band->converged + band->half_width));
}

}  // namespace

std::string headline_of(const record::RunRecord& run, const base::DisplayUnits& shown)
{
  std::string items;
  for (const base::HeadlineNumber& number : structures::structure_of(run.settings).headline(run, shown)) {
    const run_folder::Quantity& q = *run.quantity(number.quantity);
    items += fmt::format("<div><dt>{}</dt><dd class=\"number\">{}</dd>{}{}</div>\n", number.label, value_words(run, q), band_words(run, q),
                         number.beside.empty() ? "" : fmt::format("<dd class=\"quiet\">{}</dd>", number.beside));
  }
  return items.empty() ? "" : fmt::format("<dl class=\"headline\">\n{}</dl>\n", items);
}

}  // namespace berm::report
