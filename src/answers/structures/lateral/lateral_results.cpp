// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/lateral/lateral_run_test.cpp
#include "structures/lateral/lateral_results.hpp"

#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::lateral {
namespace {

constexpr Real reached = 1e-3;  // of D: a stage that ends at a displacement may stop this much short of it

}  // namespace

std::string name_at(Real over_D)
{
  return fmt::format("lateral_H_at_u_{:g}D", over_D);
}

std::vector<run_folder::Quantity> lateral_quantities(const LateralRun& run)
{
  std::vector<run_folder::Quantity> list;
  if (run.empty() || run.H_curve().empty()) return list;
  using enum run_folder::QuantityKind;
  const auto add = [&](const std::string& name, Real value, const char* unit, const std::string& meaning,
                       run_folder::QuantityKind kind = answer) {
    if (std::isfinite(value)) list.push_back({name, value, unit, meaning, kind, "lateral load"});
  };
  const LateralResults& r = run.results();
  for (const Real part : told_at)
    if (part * run.width <= run.H_curve().end() + reached * run.width)
      add(name_at(part), run.H_at(std::min(part * run.width, run.H_curve().end())), "N", "lateral load; u is the displacement at the bed");
  add("lateral_H_max", r.max_H, "N", "largest lateral load");
  add("u_at_lateral_H_max", r.u_at_max, "m", "displacement at the bed there");
  add("lateral_H_end", r.H, "N", "lateral load at the end");
  add("lateral_M_end", r.M, "N m", "its moment about the axis at the bed");
  add("lateral_u_end", r.u, "m", "displacement at the bed at the end", prescribed);
  add("lateral_u_load_end", r.u_load, "m", "displacement at the height of the load at the end", prescribed);
  add("lateral_tilt_end", r.tilt, "rad", "tilt at the end");
  add("lateral_height_end", r.height, "m", "height above the bed at which the load acts", prescribed);
  add("lateral_pivot_end", r.pivot, "m", "depth below the bed of the point of the axis that stayed");
  add("lateral_H_end_over_DLsu", run.over_strength(r.H), "1", "lateral load at the end over D, length in the bed and mean strength", ratio);
  return list;
}

std::vector<std::string> lateral_names()
{
  std::vector<std::string> names = {"lateral_H_max",     "u_at_lateral_H_max",     "lateral_H_end",    "lateral_M_end",
                                    "lateral_u_end",     "lateral_u_load_end",     "lateral_tilt_end", "lateral_height_end",
                                    "lateral_pivot_end", "lateral_H_end_over_DLsu"};
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
