// SPDX-License-Identifier: BSD-3-Clause
#include "cyclic/storm.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::cyclic {
namespace {

std::vector<Parcel> times(std::vector<Parcel> storm, Real factor)
{
  for (Parcel& parcel : storm) parcel.stress *= factor;
  return storm;
}

Real largest_of(const std::vector<Parcel>& storm)
{
  Real largest = 0;
  for (const Parcel& parcel : storm) largest = std::max(largest, parcel.stress);
  return largest;
}

}  // namespace

StormPath follow(const Contours& contours, const std::vector<Parcel>& storm, std::size_t failure)
{
  StormPath path;
  const Real failed = contours.strains()[failure];
  Real strain = 0;
  for (const Parcel& parcel : storm) {
    const std::string name = fmt::format("parcel {}, {:.4g} cycles of {:.4g} s_u", path.parcels.size() + 1, parcel.cycles, parcel.stress);
    ParcelPath& here = path.parcels.emplace_back(ParcelPath{parcel, contours.cycles(parcel.stress, strain)});
    here.end = here.begin + parcel.cycles;
    here.strain = strain = contours.strain(parcel.stress, std::min(here.end, contours.last()));
    const bool too_early = here.end < contours.first() && contours.strain(parcel.stress, contours.first()) >= failed;
    path.fails = too_early || strain >= failed;
    if (too_early)
      path.outside =
          fmt::format("{}, reaches the contour of failure, {:.4g} s_u, before N = {:.4g}, where the contours begin: give them from N = 1",
                      name, contours.stress(failure, contours.first()), contours.first());
    else if (path.fails)
      here.end = std::max(here.begin, contours.cycles(parcel.stress, failed)), here.strain = failed;
    else if (here.end > contours.last())
      path.outside =
          fmt::format("{}, ends at N = {:.4g}, and the contours at N = {:.4g}: give them to more cycles{}", name, here.end, contours.last(),
                      here.begin >= 0.999 * contours.last() ? ", or order = \"ascending\": the parcels before it made more strain" : "");
    if (path.fails || !path.outside.empty()) return path;
  }
  return path;
}

StormStrength strength_in(const Contours& contours, const std::vector<Parcel>& storm, std::size_t failure)
{
  const auto at = [&](Real factor) { return follow(contours, times(storm, factor), failure); };
  const auto known_at = [&](Real factor) {
    StormPath path = at(factor);
    if (!path.outside.empty())
      throw InputError(factor == 1 ? path.outside : fmt::format("with {:.4g} times the loads {}", factor, path.outside));
    return path;
  };
  StormStrength found;
  found.given = known_at(1);
  // Just beyond `most` the largest parcel fails where the contours begin, if not before.
  const Real largest = largest_of(storm), most = contours.stress(failure, contours.first());
  Real low = 0, high = most / largest * (1 + 1e-9);
  for (int step = 0; step < 60; ++step) {
    const Real middle = (low + high) / 2;
    (at(middle).fails ? high : low) = middle;
  }
  known_at(low);
  found.failing = known_at(high);
  found.multiplier = high;
  found.stress = high * largest;
  found.given_cycles = found.given.fails ? nan : contours.cycles(largest, found.given.parcels.back().strain);
  found.equivalent_cycles = contours.cycles(std::min(found.stress, most), contours.strains()[failure]);
  return found;
}

}  // namespace berm::cyclic
