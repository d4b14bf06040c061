// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/lateral/lateral_run_test.cpp
#include "structures/lateral/lateral_results.hpp"

#include "structures/base/answer.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::lateral {
namespace {

constexpr Real reached = 1e-3;  // of D: a stage that ends at a displacement may stop this much short of it

template <auto Number>
constexpr base::Access<LateralRun> at_end = {[](const LateralRun& run) { return std::isfinite(run.results().*Number); },
                                             [](const LateralRun& run) { return run.results().*Number; }};

using enum base::AnswerUnit;
using run_folder::QuantityKind;

constexpr base::Answer<LateralRun> lateral_answers[] = {
    {"lateral_H_max", force, "largest lateral load", at_end<&LateralResults::max_H>},
    {"u_at_lateral_H_max", length, "displacement at the bed there", at_end<&LateralResults::u_at_max>},
    {"lateral_H_end", force, "lateral load at the end", at_end<&LateralResults::H>},
    {"lateral_M_end", moment, "its moment about the axis at the bed", at_end<&LateralResults::M>},
    {"lateral_u_end", length, "displacement at the bed at the end", at_end<&LateralResults::u>, QuantityKind::prescribed},
    {"lateral_u_load_end", length, "displacement at the height of the load at the end", at_end<&LateralResults::u_load>,
     QuantityKind::prescribed},
    {"lateral_tilt_end", angle, "tilt at the end", at_end<&LateralResults::tilt>},
    {"lateral_height_end", length, "height above the bed at which the load acts", at_end<&LateralResults::height>,
     QuantityKind::prescribed},
    {"lateral_pivot_end", length, "depth below the bed of the pivot, the point of the axis that did not move",
     at_end<&LateralResults::pivot>},
    {"lateral_H_end_over_DLsu",
     base::AnswerUnit::ratio,
     "lateral load at the end over D, length in the bed and mean strength",
     {[](const LateralRun& run) { return std::isfinite(run.over_strength(run.results().H)); },
      [](const LateralRun& run) { return run.over_strength(run.results().H); }},
     QuantityKind::ratio},
};

}  // namespace

std::string name_at(Real over_D)
{
  return fmt::format("lateral_H_at_u_{:g}D", over_D);
}

std::vector<run_folder::Quantity> lateral_quantities(const LateralRun& run)
{
  if (run.empty() || run.H_curve().empty()) return {};
  base::AnswerList list(3);
  list.of("lateral load", "");
  const Real end = run.H_curve().end();
  for (const Real part : told_at)
    if (const Real u = std::min(part * run.width, end); part * run.width <= end + reached * run.width && std::isfinite(run.H_at(u)))
      list.add(name_at(part), force, run.H_at(u), "lateral load; u is the displacement at the bed");
  list.add(lateral_answers, run);
  return list.list();
}

std::vector<std::string> lateral_names()
{
  std::vector<std::string> names;
  for (const auto& row : lateral_answers) names.emplace_back(row.name);
  for (const Real part : told_at) names.push_back(name_at(part));
  return names;
}

bool is_lateral(const run_folder::Quantity& quantity)
{
  return quantity.name.find("lateral_") != std::string::npos;
}

std::string lateral_table(const std::vector<run_folder::Quantity>& quantities)
{
  std::string table;
  for (const run_folder::Quantity& quantity : quantities) {
    if (!is_lateral(quantity)) continue;
    const std::string value = quantity.unit == "N"     ? text::force_words(quantity.value, 3)
                              : quantity.unit == "N m" ? text::force_words(quantity.value, 3) + " m"
                              : quantity.unit == "m"   ? text::length_words(quantity.value)
                              : quantity.unit == "rad" ? text::angle_words(quantity.value)
                                                       : text::number_words(quantity.value);
    table += fmt::format("{:<32}{:>16}\n", quantity.name, value);
  }
  return table;
}

}  // namespace berm::lateral
