// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/lateral/lateral_run_test.cpp
#include "structures/lateral/lateral_results.hpp"

#include "structures/base/answer_table.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>

namespace berm::lateral {
namespace {

constexpr Real reached = 1e-3;  // of D: a stage that ends at a displacement may stop this much short of it

template <auto Number>
constexpr base::Access<LateralRun> at_end = [](const LateralRun& run) { return run.results().*Number; };

/// A run at a displacement at the seabed.
struct AtDisplacement {
  const LateralRun& run;
  Real u;  ///< m
};

using enum base::AnswerUnit;
using run_folder::QuantityKind;

constexpr base::Answer<AtDisplacement> travel_answers[] = {
    {"lateral_H_at_u", force, "lateral load; u is the displacement at the seabed",
     [](const AtDisplacement& at) { return at.run.H_at(at.u); }},
};

using Row = base::Answer<LateralRun>;
constexpr Row lateral_answers[] = {
    Row{"lateral_H_max", force, "largest lateral load", at_end<&LateralResults::max_H>}.headed({"largest H", "kN", 1e3}),
    Row{"u_at_lateral_H_max", length, "displacement at the seabed there", at_end<&LateralResults::u_at_max>}.headed({"at u", "mm", 1e-3}),
    Row{"lateral_H_end", force, "lateral load at the end", at_end<&LateralResults::H>}.headed({"H", "kN", 1e3}),
    Row{"lateral_M_end", moment, "its moment about the axis at the seabed", at_end<&LateralResults::M>}.headed(
        {"M at the seabed", "kN m", 1e3}),
    Row{"lateral_u_end", length, "displacement at the seabed at the end", at_end<&LateralResults::u>, QuantityKind::prescribed}.headed(
        {"u at the seabed", "mm", 1e-3}),
    Row{"lateral_u_load_end", length, "displacement at the height of the load at the end", at_end<&LateralResults::u_load>,
        QuantityKind::prescribed}
        .headed({"u at the load", "mm", 1e-3}),
    Row{"lateral_tilt_end", angle, "tilt at the end", at_end<&LateralResults::tilt>}.headed({"tilt", "°", degree}),
    Row{"lateral_height_end", length, "height above the seabed at which the load acts", at_end<&LateralResults::height>,
        QuantityKind::prescribed}
        .headed({"load above the seabed", "m"}),
    Row{"lateral_pivot_end", length, "depth below the seabed of the pivot, the point of the axis that did not move",
        at_end<&LateralResults::pivot>}
        .headed({"pivot below the seabed", "m"}),
    Row{"lateral_H_end_over_DLsu", base::AnswerUnit::ratio, "lateral load at the end over D, length in the seabed and mean strength",
        [](const LateralRun& run) { return run.over_strength(run.results().H); }, QuantityKind::ratio}
        .headed({"H/(s<sub>u</sub> D L)"}),
};

}  // namespace

std::string name_at(Real over_D)
{
  return travel_answers[0].name + base::AnswerList::ending_at(over_D);
}

std::vector<run_folder::Quantity> lateral_quantities(const LateralRun& run)
{
  if (run.empty() || run.H_curve().empty()) return {};
  base::AnswerList list(3);
  list.of("lateral load", "");
  const Real end = run.H_curve().end();
  for (const Real part : told_at)
    if (part * run.width <= end + reached * run.width)
      list.at(part), list.add(travel_answers, AtDisplacement{run, std::min(part * run.width, end)});
  list.at({});
  list.add(lateral_answers, run);
  return list.list();
}

std::string lateral_table(const LateralRuns& runs, const std::string& id)
{
  base::AnswerTable table({id, "Lateral load: at the end"}, 3, lateral_answers);
  const auto number = [](Real value) { return text::HtmlCell{text::table_number(value), true}; };
  for (const LateralRun& run : runs) table.add(run.record.name, run.record, "", {number(run.width), number(run.path.length)});
  return table.html({{"run"}, {"D, m", true}, {"L in the seabed, m", true}});
}

std::vector<std::string> lateral_names()
{
  base::AnswerList list(3);
  list.add_names(lateral_answers);
  for (const Real part : told_at) list.at(part), list.add_names(travel_answers);
  return list.names();
}

}  // namespace berm::lateral
