// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "structures/pipe/pipe_report.hpp"

#include "formulas/axial.hpp"
#include "structures/pipe/axial_results.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <fmt/format.h>

namespace berm::pipe {

std::string axial_table(const driven::DrivenRuns& runs, const base::DisplayUnits& shown)
{
  text::HtmlTable table("axial", "Axial friction resistance, from the effective stress on the pipe at the end of each stage");
  std::string source;
  for (const driven::DrivenRun& run : runs)
    for (const AxialState& state : axial_states(run.record)) {
      const formulas::Formula wedge = formulas::wedging_factor(run.scale.width, state.w);
      const auto force = [&](Real value) { return text::table_number(shown.in_force_unit(value)); };
      if (source.empty()) {
        const char* unit = shown.force_unit(run.scale);
        table.columns({{"run"},
                       {"stage"},
                       {"<i>w</i>/<i>D</i>", true},
                       {fmt::format("<i>V</i> ({})", unit), true},
                       {fmt::format("<i>N</i><sub>eff</sub> ({})", unit), true},
                       {"<i>N</i><sub>eff</sub>/<i>V</i>", true},
                       {"ζ", true},
                       {fmt::format("<i>μ N</i><sub>eff</sub> ({})", unit), true},
                       {fmt::format("<i>ζ μ V</i> ({})", unit), true}});
        source = citation(wedge.source);
      }
      table.row({{text::html_text(run.name)},
                 {text::html_text(state.stage)},
                 {text::table_number(state.w / run.scale.width), true},
                 {force(state.V), true},
                 {force(state.N_eff), true},
                 {text::table_number(state.wedging()), true},
                 {wedge.valid ? text::table_number(wedge.value) : "–", true},
                 {force(state.resistance()), true},
                 {wedge.valid ? force(wedge.value * state.mu * state.V) : "–", true}});
    }
  if (table.empty()) return "";
  const std::string how =
      fmt::format("N_eff is the integral of the effective normal stress over the surface in contact, and μ N_eff the axial friction that "
                  "it gives at that time; axial motion of the pipe, which would change the pore pressure again, is not modelled, and "
                  "adhesion is not included. ζ is the wedging factor of drained soil ({}), whose normal stress falls with the "
                  "cosine of the angle from the invert.",
                  source);
  return table.html() + text::html_paragraph(how, "quiet");
}

std::string consolidation_words(const driven::DrivenRun& run, const base::DisplayUnits& shown)
{
  std::string words;
  for (const AxialGain& gain : axial_gains(run.record))
    words += fmt::format(
        "{}In \"{}\" {} of the excess pore pressure dissipates (U), and the axial friction resistance {} from {} to {}, {} times.",
        words.empty() ? "" : " ", text::html_text(gain.stage), text::percent_words(gain.degree), gain.ratio() < 1 ? "falls" : "grows",
        shown.force_text(run.scale, gain.before), shown.force_text(run.scale, gain.after), text::short_number(gain.ratio()));
  return words;
}

}  // namespace berm::pipe
