// SPDX-License-Identifier: BSD-3-Clause
// Programs that know coefficients of friction and no curves.
#include "route/route_report.hpp"
#include "springs/written_springs.hpp"
#include "study/study_report.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::springs {
namespace {

using Words = std::vector<std::string>;

std::string shown(Real value)
{
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

/// Whether a pipe full of water is meant.
bool is_hydrotest(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name.find("hydro") != std::string::npos || name.find("flood") != std::string::npos;
}

/// Coefficients of friction: the best, and of a sample low and high, with those by which a distribution is to be fitted. The ends of a band of discretisation are none of
/// the soil's.
template <class Coefficient>
Words coefficients_of(const Design& design, const Coefficient& coefficient)
{
  const bool sample = !design.draws.empty() && design.low && design.high;
  const Real low = sample ? coefficient(*design.low) : nan, best = coefficient(design.best),
             high = sample ? coefficient(*design.high) : nan;
  const bool all = std::isfinite(low) && std::isfinite(best) && std::isfinite(high);
  return {shown(low), shown(best), shown(high), all ? "LE_BE_HE" : ""};
}

Words axial_estimates(const Design& design)
{
  return coefficients_of(design,
                         [](const Springs& s) { return s.axial.breakout() > 0 && axial_V(s) > 0 ? s.axial.breakout() / axial_V(s) : nan; });
}

/// Breakout of a travel; none of it where it is not there.
Words lateral_estimates(const Design& design, const Lateral* travel)
{
  if (travel == nullptr) return Words(4);
  const std::size_t k = static_cast<std::size_t>(travel - design.best.lateral.data());
  return coefficients_of(
      design, [&](const Springs& s) { return k < s.lateral.size() && s.lateral[k].V > 0 ? s.lateral[k].peak / s.lateral[k].V : nan; });
}

std::string description(const Design& design, const char* condition, const Lateral* travel)
{
  if (travel == nullptr) return "";
  return fmt::format("; {}: {} divided by V = {:.4g} N/m ({})", condition, peak_words(*travel), travel->V, origin_of(design.best, *travel));
}

std::string axial_residual_words(const Springs& s)
{
  return axial_V(s) > 0 ? fmt::format(", residual {:.4g} divided by V = {:.4g} N/m", s.axial.residual / axial_V(s), axial_V(s)) : "";
}

Words row_of(const Design& design, const Lateral* hydrotest, const Lateral* operation)
{
  const Lateral* named = operation != nullptr ? operation : hydrotest;
  Words row = {"", named == nullptr ? design.name : design.name + " " + named->stage};
  for (const Words& numbers : {axial_estimates(design), lateral_estimates(design, hydrotest), lateral_estimates(design, operation)})
    row.insert(row.end(), numbers.begin(), numbers.end());
  row.push_back((axial_spring(design.best).empty()
                     ? "axial: not known"
                     : axial_title(design.best) + ": " + axial_origin(design.best) + axial_residual_words(design.best)) +
                description(design, "hydrotest", hydrotest) + description(design, "operation", operation));
  return row;
}

}  // namespace

ExportFiles buckpy_files(const Design& design)
{
  std::string text = comments(
      design, "# ",
      {"Coefficients of friction: forces divided by the vertical force at the same time. Rows for the sheet Soils of BuckPy's workbook; "
       "leave out these "
       "lines, and put in the name of your pipeline.",
       "Not run in BuckPy: columns are those of its page Getting Started. Fit bounds are written as its source compares them, LE_BE_HE; "
       "its "
       "page writes LE-BE-HE.",
       "Axial is breakout; the axial residual is in the description.",
       "LE, BE, HE: 95, 50 and 5 % probability of exceedance. Low and high have the forces of a sample at 5 and at 95 %, over the V of the "
       "best run. Without a sample there is only BE.",
       "Hydrotest are travels of the flooded pipe and those with hydro or flood in their name, operation are all others; an empty cell is "
       "not "
       "known from these runs."});
  text += study::csv_line(route::buckpy_columns());
  std::vector<const Lateral*> hydrotest, operation;
  for (const Lateral& l : design.best.lateral)
    if (!l.only_berm())
      (is_hydrotest(design.best.state) || is_hydrotest(l.state) || is_hydrotest(l.stage) ? hydrotest : operation).push_back(&l);
  if (operation.empty() && hydrotest.empty()) text += study::csv_line(row_of(design, nullptr, nullptr));
  for (const Lateral* l : operation) text += study::csv_line(row_of(design, hydrotest.empty() ? nullptr : hydrotest[0], l));
  if (operation.empty())
    for (const Lateral* l : hydrotest) text += study::csv_line(row_of(design, l, nullptr));
  return {{"soils.csv", text}};
}

ExportFiles moordyn_files(const Design& design)
{
  return by_estimate(design, "txt", [&](const std::string& set, const Springs& s) {
    std::string text = comments(design, "# ",
                                {"Options of MoorDyn: bottom stiffness in Pa/m, coefficients of friction relative to the vertical force. "
                                 "Take one block into the section "
                                 "OPTIONS; leave out lines that begin with #.",
                                 "Not run in MoorDyn: keys are those of its manual. Friction is Coulomb's there, in all directions "
                                 "(MoorDyn-C) or laterally and axially "
                                 "(MoorDyn-F); the mobilisation of H up to its peak is lost.",
                                 "Damping of bottom and friction (cBot, FricDamp, CV) is not a result of these runs."});
    for (const std::string& line : refused_stiffnesses(s)) text += remark("# ", line);
    const NormalStiffness normal = normal_stiffness(s);
    const Points axial = axial_spring(s);
    const auto option = [](Real value, const char* key, const std::string& words) {
      return fmt::format("{:<12} {:<20} {}\n", shown(value), key, words);
    };
    const std::string bottom =
        std::isnan(normal.value)
            ? "# kBot is not known from these runs\n"
            : remark("# ", "kBot: " + normal.origin) + option(normal.value / s.diameter, "kBot", "Pa/m, stiffness dV/dw divided by D");
    for (const Lateral& l : s.lateral) {
      if (!(l.V > 0)) text += remark("# ", without_friction(l.stage));
      if (!(l.V > 0) || !(l.peak > 0)) continue;
      const bool stays = l.residual > 0;
      const Real friction = (stays ? l.residual : l.peak) / l.V, ratio = stays ? l.peak / l.residual : 1;
      const std::string words = stays ? "residual H divided by V" : fmt::format("{} divided by V: it has no residual", peak_words(l)),
                        ratio_words = stays ? "peak divided by residual" : "as no residual is known";
      text += remark("# ", fmt::format("{} estimate, MoorDyn-C: {}", set, origin_of(s, l))) +
              option(friction, "FrictionCoefficient", words) + option(ratio, "StatDynFricScale", ratio_words) + bottom;
      text += remark("# ", fmt::format("{} estimate, MoorDyn-F: {}", set, origin_of(s, l))) + option(friction, "MU_KT", words);
      text += axial.empty() || !(axial_V(s) > 0) ? "# MU_KA is not known from these runs\n"
                                                 : remark("# ", "MU_KA, " + axial_title(s) + ": " + axial_origin(s)) +
                                                       option(s.axial.residual / axial_V(s), "MU_KA", "axial residual divided by V");
      text += option(ratio, "MC", ratio_words) + bottom;
    }
    if (s.lateral.empty()) text += "# there is no drag, and so no lateral friction\n" + bottom;
    return text;
  });
}

}  // namespace berm::springs
