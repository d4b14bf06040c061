// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/questions.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {

void do_cells_resolve_the_random_soil(const Scene& s, Findings& found)
{
  constexpr Real least_cells = 2, largest_usual = 1, largest_usual_by_classes = 0.3;
  const Index rigid = settings::main_rigid(s.c);
  const Real cell = rigid == none || !s.cell_size ? nan : s.cell_size(rigid, {});
  for (const auto& [name, field] : s.c.random_field) {
    const std::string path = "random_field." + name;
    if (field.by_classes() && field.coefficient_of_variation > largest_usual_by_classes)
      found.warn(path + ".coefficient_of_variation",
                 fmt::format("is {:.3g}: {}; is it that of the strength?", field.coefficient_of_variation,
                             field.of_friction() ? "tan(phi) of sand has 0.05 to 0.15" : "unit weight has 0.03 to 0.1"));
    else if (field.coefficient_of_variation > largest_usual)
      found.warn(path + ".coefficient_of_variation",
                 fmt::format("is {:.3g}: undrained strength has 0.1 to 0.5, stiffness 0.2 to 0.6; is it a ratio, not per cent?",
                             field.coefficient_of_variation));
    if (field.of_density() && !(s.gravity > 0))
      found.warn(path + ".property", "without gravity a density is no weight: give the case a gravity");
    Real shortest = infinity;
    for (const std::optional<Real>& length : field.lengths())
      if (length) shortest = std::min(shortest, *length);
    if (shortest < least_cells * cell && field.averaging_length.value_or(0) < cell)
      found.warn(
          path + (shortest == field.correlation_length_depth ? ".correlation_length_depth" : ".correlation_length_x"),
          fmt::format("{:.3g} m is less than two cells of the mesh at the body, {:.3g} m: what varies within a cell is lost. Take smaller "
                      "cells, or averaging_length = \"{:.3g} m\", which gives each cell the mean of what varies within it",
                      shortest, cell, cell));
    if (!s.c.symmetry.empty())
      found.warn(
          path,
          "varies in a part of the whole and its mirror image, which makes the resistance scatter more than in soil that is not symmetric: "
          "leave out symmetry");
  }
}

}  // namespace berm::sanity
