// SPDX-License-Identifier: BSD-3-Clause
#include "report/results/results_section.hpp"

#include "structures/base/support_reactions.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <cmath>

namespace berm::report {
namespace {

constexpr Real round_off = 1e-9;  // of the largest force of the run

bool acts(const settings::Case& c, const base::SupportReaction& reaction)
{
  const Index support = index_of(c.support, reaction.support);
  const std::vector<std::string>& stages = c.support[static_cast<std::size_t>(support)].second.stages;
  return stages.empty() || std::find(stages.begin(), stages.end(), reaction.stage) != stages.end();
}

std::string force_cell(const base::SupportReaction& reaction, std::size_t direction, Real largest, Real unit)
{
  if (direction >= reaction.force.size()) return text::no_number;
  const Real force = reaction.force[direction];
  return text::table_number(std::abs(force) > round_off * largest ? force / unit : 0);
}

}  // namespace

std::string support_table(const std::vector<record::RunRecord>& runs)
{
  text::HtmlTable table("supports", "Force of each support on the soil at the ends of stages");
  table.columns({{"run"},
                 {"stage"},
                 {"support"},
                 {"<i>F</i><sub>x</sub>", true},
                 {"<i>F</i><sub>y</sub>", true},
                 {"<i>F</i><sub>z</sub>", true},
                 {"unit"}});
  bool around_axis = false, mirrored = false;
  for (const record::RunRecord& run : runs) {
    const std::vector<base::SupportReaction> reactions = base::support_reactions_of(run);
    Real largest = 0;
    for (const base::SupportReaction& reaction : reactions)
      for (const Real force : reaction.force) largest = std::max(largest, std::abs(force));
    const text::NamedUnit unit = text::unit_of_forces(largest, run.settings.force_dimension());
    for (const base::SupportReaction& reaction : reactions) {
      if (!acts(run.settings, reaction)) continue;
      std::vector<text::HtmlCell> cells{
          {text::html_text(run.name)}, {text::html_text(reaction.stage)}, {text::html_text(reaction.support)}};
      for (std::size_t d = 0; d < 3; ++d) cells.push_back({force_cell(reaction, d, largest, unit.size), true});
      cells.push_back({unit.name});
      table.row(cells);
    }
    around_axis = around_axis || (!reactions.empty() && run.settings.geometry == settings::Geometry::axisymmetric);
    mirrored = mirrored || (!reactions.empty() && !run.settings.symmetry.empty());
  }
  if (table.empty()) return "";
  std::string how = "Means over the last twentieth of each stage. ";
  if (around_axis) how += "Around an axis x is the radius: radial forces are added up all around. ";
  if (mirrored) how += "Across a plane of symmetry the forces of both sides are added up, each as on the modelled side. ";
  return "<h3>Supports</h3>\n" + text::html_paragraph(how, "quiet") + table.html();
}

}  // namespace berm::report
