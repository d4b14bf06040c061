// SPDX-License-Identifier: BSD-3-Clause
#include "report/results/results_section.hpp"

#include "settings/drainage.hpp"
#include "structures/base/soil_words.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

std::string known(Real value, const std::string& words)
{
  return std::isnan(value) ? "–" : words;
}

std::string sentence_of(const record::RunRecord& run, const settings::Consolidation& soil)
{
  return text::html_text(fmt::format("{}: \"{}\"{} has c_v = {:.3g} m2/s, with the modulus of one-dimensional compression M = {}.",
                                     run.name, soil.material,
                                     soil.depth > 0 ? fmt::format(", {} below the surface,", text::length_words(soil.depth)) : "", soil.c_v,
                                     text::stress_words(soil.modulus)));
}

/// A time of the run, and beside it that of the soil which is modelled.
std::string times(Real in_run, const std::optional<Real>& part)
{
  constexpr Real hour = 3600, day = 24 * hour;  // s
  if (!part) return text::time_words(in_run);
  const Real of_soil = in_run / *part;
  return fmt::format("{} ({})", of_soil < 2 * day ? fmt::format("{:.3g} h", of_soil / hour) : fmt::format("{:.3g} days", of_soil / day),
                     text::time_words(in_run));
}

std::string inertia_cell(const settings::Case& c, const settings::StageDrainage& stage, const settings::Consolidation& soil, Real width)
{
  if (!(width > 0)) return "–";
  const std::optional<settings::StageInertia> inertia = inertia_in(c, stage, soil, width);
  return inertia ? text::html_text(base::inertia_words(*inertia)) : "none";
}

void add_rows(const record::RunRecord& run, Real width, const settings::Consolidation& soil, text::HtmlTable& table)
{
  const std::vector<base::Dissipation> rests = base::dissipation_of(run);
  const std::optional<Real> part = settings::part_of_real_time(run.settings);
  for (const settings::StageDrainage& stage : drainage_of_stages(run.settings, width, soil.c_v)) {
    const std::string& name = run.settings.stage[stage.stage].name;
    const auto rest = std::find_if(rests.begin(), rests.end(), [&](const base::Dissipation& d) { return d.stage == name; });
    const base::Dissipation d = rest != rests.end() ? *rest : base::Dissipation{name, nan, nan, nan, nan, nan};
    const Real T = std::isnan(d.T) && !stage.moves ? stage.number : d.T, v = stage.moves && width > 0 ? stage.number : nan;
    table.row({{text::html_text(run.name)},
               {text::html_text(name)},
               {known(v, fmt::format("{:.3g}", v)), true},
               {std::isnan(v) ? "–" : base::drainage_word(v)},
               {inertia_cell(run.settings, stage, soil, width)},
               {width > 0 ? known(T, fmt::format("{:.3g}", T)) : "–", true},
               {known(d.degree, text::percent_words(d.degree)), true},
               {known(d.t50, times(d.t50, part)), true},
               {known(d.T50, fmt::format("{:.3g}", d.T50)), true}});
  }
}

}  // namespace

std::string consolidation_table(const std::vector<record::RunRecord>& runs)
{
  text::HtmlTable table("consolidation", "Drainage, stage by stage");
  table.columns({{"run"},
                 {"stage"},
                 {"<i>v D</i>/<i>c</i><sub>v</sub>", true},
                 {"drainage"},
                 {"inertia"},
                 {"<i>T</i> = <i>c</i><sub>v</sub> <i>t</i>/<i>D</i>²", true},
                 {"<i>U</i> at the end", true},
                 {"<i>t</i><sub>50</sub>", true},
                 {"<i>T</i><sub>50</sub>", true}});
  std::string soils;
  for (const record::RunRecord& run : runs) {
    const Real width = base::body_scale(run).width;
    const std::vector<settings::Consolidation> found = consolidation_of(run.settings, width);
    if (found.empty()) continue;
    for (const settings::Consolidation& soil : found) soils += sentence_of(run, soil) + "<br>\n";
    add_rows(run, width, found.front(), table);
  }
  if (soils.empty()) return "";
  const std::string how = fmt::format("Soil is drained up to v D/c_v = {:g} and undrained from {:g} on, within 5 %, and partially drained "
                                      "between. U is 1 minus the largest excess pore pressure in the soil over the largest in the stage; "
                                      "t50 is the time until U = 50 %; in brackets its time in the run, where that differs.",
                                      settings::drained_up_to, settings::undrained_from);
  return "<h3>Consolidation</h3>\n<p>" + soils + "</p>\n" + text::html_paragraph(how, "quiet") + (table.empty() ? "" : table.html());
}

}  // namespace berm::report
