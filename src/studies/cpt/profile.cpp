// SPDX-License-Identifier: BSD-3-Clause
#include "cpt/profile.hpp"

#include "formulas/cone.hpp"
#include "os/error.hpp"
#include "site/doubts.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::cpt {
namespace {

/// N/m3. The fit gives less than any soil where both resistance and friction are next to nothing.
constexpr Real least_unit_weight = 11e3;

std::vector<Reading> rows_of(const site::Sounding& sounding, const Choice& choice)
{
  std::vector<Reading> rows;
  Real sigma = 0, above = 0;
  for (std::size_t i = 0; i < sounding.depth.size(); ++i) {
    const Real z = sounding.depth[i], q_t = sounding.q_t[i], f_s = sounding.f_s[i];
    const formulas::Formula weight = formulas::cone_unit_weight(q_t, f_s, site::gamma_w);
    const Real gamma = std::max(weight.valid ? weight.value : rows.empty() ? 0 : rows.back().gamma, least_unit_weight);
    sigma += gamma * (z - above);
    above = z;
    const Real u_0 = site::gamma_w * z, effective = sigma - u_0, net = q_t - sigma;
    const formulas::SoilBehaviour soil = formulas::soil_behaviour(q_t, f_s, sigma, effective);
    if (!soil.I_c.valid) continue;
    const Real I_c = soil.I_c.value, u_2 = sounding.u_2.empty() ? nan : sounding.u_2[i];
    const bool sand = I_c < formulas::end_of_sand;
    rows.push_back({.depth = z,
                    .q_t = q_t,
                    .f_s = f_s,
                    .u_2 = u_2,
                    .B_q = (u_2 - u_0) / net,
                    .Q_tn = soil.Q_tn,
                    .F_r = soil.F_r,
                    .I_c = I_c,
                    .gamma = gamma,
                    .sigma_v0 = sigma,
                    .effective_stress = effective,
                    .D_r = sand ? std::clamp(formulas::cone_relative_density(q_t, effective).value, Real(0), Real(1)) : nan,
                    .s_u = sand ? nan : net / choice.N_kt,
                    .phi = sand ? std::min(site::friction_of(q_t, effective, choice.correlation), site::most_friction_angle) : nan,
                    .E = sand ? formulas::cone_modulus(I_c, net).value : nan,
                    .zone = formulas::zone_of(I_c)});
  }
  return rows;
}

void join_equal(std::vector<Layer>& layers)
{
  for (std::size_t i = 1; i < layers.size();)
    if (layers[i].zone == layers[i - 1].zone) {
      layers[i - 1].base = layers[i].base;
      layers[i - 1].last = layers[i].last;
      layers.erase(layers.begin() + static_cast<std::ptrdiff_t>(i));
    } else
      ++i;
}

void join_thin(Profile& profile, Real thinnest)
{
  std::vector<Layer>& layers = profile.layers;
  const auto thinner = [](const Layer& a, const Layer& b) { return a.base - a.top < b.base - b.top; };
  while (layers.size() > 1) {
    const auto thin = std::min_element(layers.begin(), layers.end(), thinner);
    if (thin->base - thin->top >= thinnest * (1 - 1e-9)) return;
    const auto apart = [&](const Layer& other) {
      return std::abs(mean_of(profile, other, &Reading::I_c).value - mean_of(profile, *thin, &Reading::I_c).value);
    };
    const bool above = thin != layers.begin() && (thin + 1 == layers.end() || apart(*(thin - 1)) <= apart(*(thin + 1)));
    thin->zone = above ? (thin - 1)->zone : (thin + 1)->zone;
    join_equal(layers);
  }
}

}  // namespace

Mean mean_of(const Profile& profile, const Layer& layer, Real Reading::*quantity)
{
  Real sum = 0, squares = 0, count = 0;
  for (std::size_t i = layer.first; i < layer.last; ++i)
    if (const Real value = profile.rows[i].*quantity; !std::isnan(value)) sum += value, ++count;
  const Real mean = count > 0 ? sum / count : nan;
  for (std::size_t i = layer.first; i < layer.last; ++i)
    if (const Real value = profile.rows[i].*quantity; !std::isnan(value)) squares += (value - mean) * (value - mean);
  return {mean, count > 1 ? std::sqrt(squares / (count - 1)) : nan};
}

Profile profile_of(const site::Sounding& sounding, const Choice& choice)
{
  if (sounding.f_s.empty())
    throw InputError(
        fmt::format("{}: has no sleeve friction, and without it there is no index of soil behaviour I_c: it needs columns of depth, q_c or "
                    "q_t, and f_s, which a table names depth_m,q_c_MPa,f_s_kPa",
                    sounding.file));
  Profile profile = {rows_of(sounding, choice), {}, site::doubts_of_rows(sounding, 0)};
  const std::vector<Reading>& rows = profile.rows;
  if (rows.empty())
    throw InputError(fmt::format("{}: no row has a sleeve friction above 0 and a cone resistance above the overburden", sounding.file));
  if (const std::size_t without = sounding.depth.size() - rows.size(); without > 0)
    profile.doubts.push_back(
        fmt::format("without I_c, as f_s is not above 0 or the cone resistance not above the overburden: {} rows", without));
  for (std::size_t i = 0; i < rows.size(); ++i)
    profile.layers.push_back({i == 0 ? 0 : (rows[i - 1].depth + rows[i].depth) / 2,
                              i + 1 == rows.size() ? rows[i].depth : (rows[i].depth + rows[i + 1].depth) / 2, i, i + 1, rows[i].zone});
  join_equal(profile.layers);
  join_thin(profile, choice.thinnest);
  return profile;
}

}  // namespace berm::cpt
