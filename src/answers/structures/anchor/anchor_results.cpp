// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/anchor/anchor_test.cpp
#include "structures/anchor/anchor.hpp"

#include "record/travel_curve.hpp"
#include "structures/driven/path.hpp"

#include <algorithm>

namespace berm::anchor {
namespace {

using record::TravelCurve;

constexpr Real averaging = 0.05, last = 1;   // of D
constexpr Real largest_last = 1. / 3;        // of the way
constexpr Real largest_averaging = 1. / 20;  // of the way

struct Largest {
  Real value = nan, at = nan;
};

Largest largest_of(const TravelCurve& curve)
{
  Largest largest;
  for (std::size_t k = 0; k < curve.travel().size(); ++k)
    if (!(curve.value()[k] <= largest.value)) largest = {curve.value()[k], curve.travel()[k]};
  return largest;
}

}  // namespace

TowPath tow_path(const record::RunRecord& run)
{
  TowPath path;
  if (run.history.rows() == 0 || !run.history.has_label("H")) return path;
  Real begin = 0;
  for (const driven::DragPath& drag : driven::path_of(run.history, driven::stages_of(run.settings)).drags) {
    for (std::size_t k = 0; k < drag.travel.size(); ++k) {
      path.travel.push_back(begin + drag.travel[k]);
      path.depth.push_back(drag.w[k]);
      path.H.push_back(drag.H[k]);
      path.V.push_back(drag.V[k]);
    }
    if (!drag.travel.empty()) begin += drag.travel.back();
  }
  return path;
}

TowResults tow_results(const TowPath& path, const base::BodyScale& scale)
{
  TowResults results;
  const TravelCurve depth(path.travel, path.depth), H(path.travel, path.H), V(path.travel, path.V);
  if (H.travel().size() < 3 || !(scale.width > 0)) return results;
  const Real way = H.end() - H.begin(), half = scale.noisy ? std::min(averaging * scale.width, largest_averaging * way) : 0;
  results.travel = H.end();
  results.first_depth = depth.value().front(), results.depth = depth.value().back();
  const Largest deepest = largest_of(depth), strongest = largest_of(H.smoothed(half));
  results.max_depth = deepest.value, results.at_depth = deepest.at;
  results.max_force = strongest.value, results.at_force = strongest.at;
  results.last_travel = std::min(last * scale.width, largest_last * way);
  const Real window = results.last_travel / 2, middle = H.end() - window;
  results.force = H.at(middle, window), results.vertical = V.at(middle, window);
  results.depth_change = 2 * (depth.at(depth.end(), window) - depth.at(middle, window));
  results.work = 0;
  for (std::size_t k = 1; k < H.travel().size(); ++k)
    results.work += (H.value()[k] + H.value()[k - 1]) / 2 * (H.travel()[k] - H.travel()[k - 1]);
  return results;
}

}  // namespace berm::anchor
