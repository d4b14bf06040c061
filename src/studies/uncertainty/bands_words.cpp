// SPDX-License-Identifier: BSD-3-Clause
#include "text/quantity_words.hpp"
#include "uncertainty/bands.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::uncertainty {
namespace {

/// Forces as they are, lengths in mm.
struct ShownUnit {
  Real per_si;
  std::string name;
};

ShownUnit shown_unit(const std::string& unit)
{
  return unit == "m" ? ShownUnit{1000, "mm"} : ShownUnit{1, unit == "1" ? "" : unit};
}

std::string part(Real number, Real per_si)
{
  return text::short_number(number * per_si);
}

std::string words_of(const run_folder::Grains& grains)
{
  std::string table =
      fmt::format("the sand has no d50, so the width of its shear bands is set by the cells; on cells {:.3g} times as large:\n{:<24}{:>12}",
                  grains.size, "", "no d50");
  for (const Real d50 : grains.d50) table += fmt::format("{:>14}", fmt::format("d50 {:g} mm", 1000 * d50));
  for (const auto& [name, unit, without, with] : grains.numbers) {
    const auto& [per_si, shown] = shown_unit(unit);
    table += fmt::format("\n{:<24}{:>12}", name, part(without, per_si));
    for (const Real number : with) table += fmt::format("{:>14}", part(number, per_si));
    table += " " + shown;
  }
  return table + "\ngive the d50 of the sand, and the band is that of its own result\n";
}

}  // namespace

std::string words_of(const run_folder::Uncertainty& u, settings::Method method)
{
  Real finest = 1, largest = 1, time = 0;
  for (const run_folder::BandRun& run : u.runs)
    finest = std::min(finest, run.size), largest = std::max(largest, run.size), time += run.wall_s;
  std::string table = fmt::format("uncertainty: {} more runs, on cells {:.3g} to {:.3g} times as large, {:.3g} s of one thread in total\n",
                                  u.runs.size(), finest, largest, time);
  table += fmt::format("{:<24}{:>12}{:>24}{:>6}{:>8}{:>16}{:>10}{:>10}{:>12}\n", "", "this run", "converged", "", "order", "extrapolation",
                       "mesh", "noise", method == settings::Method::fem ? "increments" : "speed");
  for (const auto& [name, unit, band] : u.quantities) {
    const auto& [per_si, shown] = shown_unit(unit);
    table += fmt::format("{:<24}{:>12}{:>24} {:<5}{:>8}{:>16}{:>10}{:>10}{:>12}\n", name, part(band.value, per_si),
                         text::with_half_width(band.converged * per_si, band.half_width * per_si, "+-"), shown,
                         std::isnan(band.order) ? "-" : fmt::format("{:.1f}", band.order), part(band.extrapolation, per_si),
                         part(band.mesh, per_si), part(band.noise, per_si), part(band.speed, per_si));
  }
  table += "converged +- half width of the 95 % band: extrapolation + sqrt(mesh^2 + noise^2 + speed^2)\n"
           "order of convergence: -, where it is hidden by the scatter from mesh to mesh; the extrapolation takes 1\n";
  for (const std::string& why : u.left_out) table += fmt::format("not in the bands: {}\n", why);
  for (const auto& [name, why] : u.without) table += fmt::format("without a band: {}: {}\n", name, why);
  if (!u.grains.numbers.empty()) table += words_of(u.grains);
  return table;
}

}  // namespace berm::uncertainty
