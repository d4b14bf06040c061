// SPDX-License-Identifier: BSD-3-Clause
#include "site/doubts.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::site {
namespace {

/// Of the rows of a file; m; of the usual distance of readings; of the depth of the bed.
constexpr Real most_left_out = 0.1, most_first_depth = 0.1, least_gap = 0.25, gap_of_readings = 5, least_of_bed = 0.9;

/// Clay is of high strength from 75 kPa, of extremely high strength from 300 kPa, and weak rock from 0.6 MPa in compression on (ISO 14688-2, 14689).
constexpr Real stiff_clay = 100e3, no_clay = 1e6;

/// s_u / sigma'_v0 = 0.22 OCR^0.8 (Jamiolkowski et al. 1985): 5 is an OCR of 50, the most of what has been tested. Within the first metre sigma'_v0 says little.
constexpr Real most_strength_ratio = 5, depth_of_ratio = 1;

/// A lens: strength this many times that above and below, within so many layers.
constexpr Real lens = 4;
constexpr std::size_t layers_of_lens = 4;

/// Friction ratios: sand below, clay above (Robertson 1990).
constexpr Real most_of_sand = 0.01, least_of_clay = 0.03;

/// (q_t / p_a) (p_a / sigma'_v0)^0.5: the chart of Robertson (1990) ends at 1000, gravelly and cemented sand.
constexpr Real most_normalized = 1000;

Real median(std::vector<Real> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void doubt_gaps(const Sounding& sounding, std::vector<std::string>& doubts)
{
  std::vector<Real> spaces;
  for (std::size_t i = 1; i < sounding.depth.size(); ++i) spaces.push_back(sounding.depth[i] - sounding.depth[i - 1]);
  const Real most = std::max(least_gap, gap_of_readings * median(spaces));
  std::string gaps;
  for (std::size_t i = 0; i < spaces.size(); ++i)
    if (spaces[i] > most) gaps += fmt::format("{}{:.2f} to {:.2f} m", gaps.empty() ? "" : ", ", sounding.depth[i], sounding.depth[i + 1]);
  if (!gaps.empty())
    doubts.push_back(fmt::format("no readings from {}: the strength there is interpolated from the readings around it", gaps));
}

void doubt_lenses(const StrengthProfile& s_u, std::vector<std::string>& doubts)
{
  const std::vector<Strength>& all = s_u.strength;
  for (std::size_t i = 1; i < all.size(); ++i)
    for (std::size_t end = i + 1; end <= i + layers_of_lens && end < all.size(); ++end) {
      const Real around = std::max(all[i - 1].value, all[end].value);
      const auto within = std::minmax_element(all.begin() + static_cast<std::ptrdiff_t>(i), all.begin() + static_cast<std::ptrdiff_t>(end),
                                              [](const Strength& a, const Strength& b) { return a.value < b.value; });
      if (within.first->value <= lens * around) continue;
      doubts.push_back(fmt::format("s_u is {:.3g} kPa at {:.2f} to {:.2f} m and {:.3g} kPa around it: a lens of sand, which drains, has no "
                                   "s_u; remove its points from the profile",
                                   within.second->value / 1000, all[i].middle, all[end - 1].middle, around / 1000));
      i = end;
      break;
    }
}

void doubt_layers_without(const StrengthProfile& profile, const char* what, std::vector<std::string>& doubts)
{
  if (profile.without.empty()) return;
  std::string depths;
  for (const Layer& layer : profile.without) depths += fmt::format("{}{:.2f} m", depths.empty() ? "" : ", ", layer.middle);
  doubts.push_back(fmt::format("{} at {}: left out, the strength there is that of the layers around it", what, depths));
}

}  // namespace

std::vector<std::string> doubts_of_rows(const Sounding& sounding, Real base)
{
  std::vector<std::string> doubts = sounding.notes;
  if (const auto left_out = sounding.rows - static_cast<Index>(sounding.depth.size());
      static_cast<Real>(left_out) > most_left_out * static_cast<Real>(sounding.rows))
    doubts.push_back(fmt::format("{} of {} rows are left out: check the file", left_out, sounding.rows));
  if (sounding.depth.front() > most_first_depth * (1 + 1e-9))
    doubts.push_back(fmt::format("the first reading is at {:.2f} m: the strength from the seabed to there, the depth of a pipe, is that of "
                                 "the first layer; replace it by your own",
                                 sounding.depth.front()));
  doubt_gaps(sounding, doubts);
  if (sounding.depth.back() < least_of_bed * base)
    doubts.push_back(
        fmt::format("the sounding ends at {:.2f} m with {} readings, and the bed is {:g} m deep: below, the strength is that of "
                    "its deepest layer",
                    sounding.depth.back(), sounding.depth.size(), base));
  return doubts;
}

std::vector<std::string> doubts_of_clay(const Sounding& sounding, const StrengthProfile& s_u, Real submerged_unit_weight)
{
  std::vector<std::string> doubts;
  const auto largest =
      std::max_element(s_u.strength.begin(), s_u.strength.end(), [](const Strength& a, const Strength& b) { return a.value < b.value; });
  std::vector<Real> values;
  for (const Strength& one : s_u.strength) values.push_back(one.value);
  const Real middle = median(values);
  if (middle > no_clay)
    throw InputError(fmt::format("{}: s_u would be {:.3g} MPa (median), and no clay has more than {:g} MPa: is the cone resistance in kPa "
                                 "under the unit MPa, or is it of sand or rock?",
                                 sounding.file, middle / 1e6, no_clay / 1e6));
  const Real ratio = friction_ratio(sounding, submerged_unit_weight);
  const bool as_sand = ratio > 0 && ratio < most_of_sand;
  if (as_sand && middle > stiff_clay)
    throw InputError(
        fmt::format("{}: this is sand: the mean friction ratio is {:.1f} %, and s_u would be {:.0f} kPa (median). Begin with a "
                    "kind in sand, such as pipe-in-sand",
                    sounding.file, 100 * ratio, middle / 1000));
  if (as_sand)
    doubts.push_back(fmt::format(
        "the mean friction ratio is {:.1f} %, and clay has more than 1 %: is it sand or silt, or is the unit of f_s or u_2 wrong?",
        100 * ratio));
  if (largest->value > stiff_clay)
    doubts.push_back(fmt::format("s_u is up to {:.0f} kPa, at {:.2f} m, and this kind is for clay below {:g} kPa: is it sand, or is the "
                                 "unit of the cone resistance wrong?",
                                 largest->value / 1000, largest->middle, stiff_clay / 1000));
  for (const Strength& one : s_u.strength)
    if (const Real most = most_strength_ratio * submerged_unit_weight * one.middle; one.middle >= depth_of_ratio && one.value > most) {
      doubts.push_back(fmt::format("s_u is {:.0f} kPa at {:.2f} m, more than {:g} times the effective overburden: clay with an "
                                   "overconsolidation ratio of 50, or sand",
                                   one.value / 1000, one.middle, most_strength_ratio));
      break;
    }
  doubt_lenses(s_u, doubts);
  doubt_layers_without(s_u, "the cone resistance is not more than the overburden", doubts);
  return doubts;
}

std::vector<std::string> doubts_of_sand(const Sounding& sounding, const StrengthProfile& phi, Real submerged_unit_weight)
{
  std::vector<std::string> doubts;
  std::vector<Real> normalized;
  for (const Layer& layer : layers_of(sounding))
    if (layer.middle > 0) normalized.push_back(layer.q_t / p_a / std::sqrt(submerged_unit_weight * layer.middle / p_a));
  if (!normalized.empty() && median(normalized) > most_normalized)
    throw InputError(
        fmt::format("{}: the cone resistance is {:.3g} MPa at {:.2f} m, more than any sand has under that overburden: is it in kPa "
                    "under the unit MPa?",
                    sounding.file, sounding.q_t.front() / 1e6, sounding.depth.front()));
  if (const Real ratio = friction_ratio(sounding, submerged_unit_weight); ratio > least_of_clay)
    doubts.push_back(
        fmt::format("the mean friction ratio is {:.1f} %, and sand has less than {:g} %: is it clay? Then start with a kind in clay",
                    100 * ratio, 100 * least_of_clay));
  const auto at_most = std::count_if(phi.strength.begin(), phi.strength.end(),
                                     [](const Strength& one) { return one.value > most_friction_angle - 0.01 * degree; });
  if (at_most > 0)
    doubts.push_back(
        fmt::format("the correlation gives 45 deg or more in {} of {} layers, written as 45 deg: it is not calibrated for low stresses",
                    at_most, phi.strength.size()));
  doubt_layers_without(phi, "the cone resistance is too low for sand (less than 25 deg)", doubts);
  return doubts;
}

}  // namespace berm::site
