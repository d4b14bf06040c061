// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/words.hpp"

#include "text/shown_number.hpp"

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

}  // namespace

std::string words_of(const run_folder::Uncertainty& u, problem::Method method)
{
  Real largest = 1, time = 0;
  for (const run_folder::BandRun& run : u.runs) largest = std::max(largest, run.size), time += run.wall_s;
  std::string table = fmt::format("uncertainty: {} runs with cells up to {:.3g} times as large, {:.3g} s of one thread in all\n",
                                  u.runs.size(), largest, time);
  table += fmt::format("{:<24}{:>12}{:>24}{:>6}{:>16}{:>10}{:>10}{:>12}\n", "", "this run", "converged", "", "extrapolation", "mesh",
                       "noise", method == problem::Method::fem ? "increments" : "speed");
  for (const auto& [name, unit, band] : u.quantities) {
    const auto& [per_si, shown] = shown_unit(unit);
    table += fmt::format("{:<24}{:>12}{:>24} {:<5}{:>16}{:>10}{:>10}{:>12}\n", name, part(band.value, per_si),
                         text::with_half_width(band.converged * per_si, band.half_width * per_si, "+-"), shown,
                         part(band.extrapolation, per_si), part(band.mesh, per_si), part(band.noise, per_si), part(band.speed, per_si));
  }
  table += "converged +- what it is uncertain by, nineteen times in twenty: extrapolation + sqrt(mesh^2 + noise^2 + speed^2)\n";
  for (const std::string& why : u.left_out) table += fmt::format("not in the bands: {}\n", why);
  for (const auto& [name, why] : u.without) table += fmt::format("without a band: {}: {}\n", name, why);
  return table;
}

}  // namespace berm::uncertainty
