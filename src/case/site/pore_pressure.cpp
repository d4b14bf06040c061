// SPDX-License-Identifier: BSD-3-Clause
#include "site/pore_pressure.hpp"

#include "os/error.hpp"

#include <cmath>
#include <fmt/format.h>

namespace berm::site {
namespace {

/// u_2 at the seabed that is more than this, and more than the cone resistance there, is that of the water above: its zero is not that at the seabed. It can be taken off where the
/// first reading is no deeper than half a metre, so that what the soil adds, some kPa, is small.
constexpr Real most_at_seabed = 50e3, deepest_first_reading = 0.5;

/// Excess pressures are 1.2 times the net cone resistance at most, in sensitive clay (Robertson 1990, chart of Q_t and B_q); with some kPa near the seabed.
constexpr Real most_over_q_t = 1.5, and_more = 20e3;

/// Rows, of ten, that may be no pore pressures of soil and are then done without.
constexpr Real most_single = 0.1;

/// Part of u_2 by which q_t is more than q_c where it is corrected: 1 - a is 0.1 to 0.5.
constexpr Real least_share = 0.05;

bool is_of_soil(Real q_c, Real area_ratio, Real u_2)
{
  return u_2 <= most_over_q_t * (q_c + (1 - area_ratio) * u_2) + and_more;
}

bool holds_water(Real depth, Real q_c, Real u_2)
{
  return u_2 - gamma_w * depth > most_at_seabed && u_2 > q_c;
}

/// The first row that counts, or how many there are.
template <class Counts>
std::size_t first_that(const Counts& counts, std::size_t rows)
{
  std::size_t row = 0;
  while (row < rows && !counts(row)) ++row;
  return row;
}

}  // namespace

void make_plausible(const std::string& file, const std::vector<Real>& depth, const std::vector<Real>& q_c, Real area_ratio,
                    std::vector<Real>& u_2, std::vector<std::string>& notes)
{
  const auto counts = [&](std::size_t row) { return depth[row] >= 0 && !std::isnan(q_c[row]) && !std::isnan(u_2[row]); };
  const std::size_t first = first_that(counts, depth.size());
  if (first == depth.size()) return;
  const Real at_seabed = u_2[first] - gamma_w * depth[first];
  const bool takes_off = holds_water(depth[first], q_c[first], u_2[first]) && depth[first] <= deepest_first_reading;
  if (takes_off) {
    for (Real& u : u_2) u -= at_seabed;
    notes.push_back(
        fmt::format("u_2 is {:.4g} kPa at the seabed, the pressure of some {:.3g} m of water above it: subtracted from all of its readings",
                    at_seabed / 1000, at_seabed / gamma_w));
  }
  std::vector<std::size_t> none_of_soil;
  Real readings = 0;
  for (std::size_t row = 0; row < u_2.size(); ++row) {
    if (!counts(row)) continue;
    ++readings;
    if (!is_of_soil(q_c[row], area_ratio, u_2[row])) none_of_soil.push_back(row);
  }
  if (none_of_soil.empty()) return;
  const std::size_t row = none_of_soil.front();
  if (static_cast<Real>(none_of_soil.size()) > most_single * readings)
    throw InputError(
        fmt::format("{}: u_2 is {:.4g} kPa at {:.2f} m beside a cone resistance of {:.4g} kPa{}, which no soil has: is its unit right, and "
                    "is it relative to the seabed? Subtract the pressure of the water above, or leave out its column",
                    file, u_2[row] / 1000, depth[row], q_c[row] / 1000, takes_off ? ", without that of the water above" : ""));
  for (const std::size_t one : none_of_soil) u_2[one] = nan;
  notes.push_back(
      fmt::format("u_2 is too large for the cone resistance in {} rows, as at {:.2f} m: not used there", none_of_soil.size(), depth[row]));
}

std::string doubt_of_given(const std::vector<Real>& depth, const std::vector<Real>& q_c, const std::vector<Real>& q_t,
                           const std::vector<Real>& u_2)
{
  const auto counts = [&](std::size_t row) {
    return depth[row] >= 0 && !std::isnan(q_c[row]) && !std::isnan(q_t[row]) && !std::isnan(u_2[row]);
  };
  const std::size_t first = first_that(counts, depth.size());
  if (first == depth.size() || !holds_water(depth[first], q_c[first], u_2[first])) return "";
  if (q_t[first] - q_c[first] <= least_share * u_2[first]) return "";
  return fmt::format("u_2 is {:.4g} kPa at {:.2f} m, with the pressure of the water above the seabed, and q_t there is q_c plus {:.4g} "
                     "kPa: q_t includes that pressure, too; leave out its column",
                     u_2[first] / 1000, depth[first], (q_t[first] - q_c[first]) / 1000);
}

}  // namespace berm::site
