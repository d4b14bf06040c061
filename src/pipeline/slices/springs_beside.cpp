// SPDX-License-Identifier: BSD-3-Clause
#include "slices/springs_beside.hpp"

#include "os/error.hpp"
#include "problem/stages.hpp"

#include <fmt/format.h>

namespace berm::slices {

SpringsBeside::SpringsBeside(const settings::Case& c) : case_(c)
{
  const auto& [name, pipe] = c.rigid.front();
  if (!(pipe.mass > 0)) throw KeyError(fmt::format("pipeline.springs: drags [rigid.{}] under its weight, and it has no mass", name));
}

std::optional<DragCurve> SpringsBeside::find(const problem::Model<2>& model, const problem::State<2>& laid,
                                             const std::function<bool()>& stop)
{
  try {
    std::optional<DragCurve> found = drag_sideways(model, laid, case_.pipeline->submerged_weight, *case_.pipeline->springs, stop);
    if (!found) return {};
    curve_ = found->backbone;
    embedment_ = travel_of(model, laid, 0).w;
    make_line();
    return found;
  } catch (const RunError& error) {
    throw RunError(fmt::format("the drag for pipeline.springs: {}", error.what()));
  }
}

void SpringsBeside::make_line()
{
  settings::LateralCurve& curve = case_.pipeline->far_soil.lateral;
  curve = {};
  for (const beam::CurvePoint& point : curve_.points) curve.x.push_back(point.displacement), curve.y.push_back(point.force);
  line_.emplace(case_, embedment_);
}

void SpringsBeside::archive(Archive& k)
{
  std::vector<Real> u, H;
  for (const beam::CurvePoint& point : curve_.points) u.push_back(point.displacement), H.push_back(point.force);
  k("u", u);
  k("H", H);
  k("embedment", embedment_);
  if (k.reads()) {
    if (u.size() != H.size()) k.refuse("the resistance of the springs is incomplete");
    curve_.points.clear();
    for (std::size_t i = 0; i < u.size(); ++i) curve_.points.push_back({u[i], H[i]});
    line_.reset();
    if (!u.empty()) make_line();
  }
  if (ready()) k.table("line", [&] { line_->archive(k); });
}

}  // namespace berm::slices
