// SPDX-License-Identifier: BSD-3-Clause
#include "beam/spring_laws.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::beam {
namespace {

constexpr Real round_off = 1e-9;  // a spring within this part of its resistance slides

SpringForce resistance(const LinearSpring& law, const SpringState&, Real u)
{
  return {law.stiffness * u, law.stiffness};
}

SpringForce resistance(const OneSidedSpring& law, const SpringState&, Real u)
{
  return u <= 0 ? SpringForce{law.stiffness * u, law.stiffness} : SpringForce{};  // one that just touches holds what is laid on it
}

SpringForce resistance(const HolonomicSpring& law, const SpringState&, Real u)
{
  return {std::copysign(law.backbone.force(std::abs(u)), u), law.backbone.slope(std::abs(u)),
          std::abs(u) >= law.backbone.points.front().displacement};
}

SpringForce resistance(const PlasticSpring& law, const SpringState& state, Real u)
{
  const Real k = law.backbone.stiffness(), elastic = law.backbone.points.front().displacement;
  const Real forward = std::max(elastic, state.forward), backward = std::max(elastic, state.backward);
  if (u > forward) return {law.backbone.force(u), law.backbone.slope(u), true};
  if (u < -backward) return {-law.backbone.force(-u), law.backbone.slope(-u), true};
  const Real trial = k * (u - state.slip), upper = law.backbone.force(forward), lower = -law.backbone.force(backward);
  const bool slides = trial >= (1 - round_off) * upper || trial <= (1 - round_off) * lower;
  return {std::clamp(trial, lower, upper), slides ? 0 : k, slides};
}

void check_backbone(const Backbone& backbone)
{
  if (backbone.points.empty()) throw InputError("a curve of resistance has no points");
  CurvePoint last;
  for (const CurvePoint& point : backbone.points) {
    if (!(point.displacement > last.displacement) || !(point.force > 0) || !std::isfinite(point.displacement) ||
        !std::isfinite(point.force))
      throw InputError(
          fmt::format("a curve of resistance continues to {} N/m at {} m after {} m: displacements ascend from 0, forces are positive",
                      point.force, point.displacement, last.displacement));
    if (point.force - last.force > (1 + round_off) * backbone.stiffness() * (point.displacement - last.displacement))
      throw InputError(
          fmt::format("a curve of resistance is steeper up to {} m than at first, and unloads along its first slope", point.displacement));
    last = point;
  }
}

}  // namespace

Real Backbone::force(Real u) const
{
  CurvePoint last;
  for (const CurvePoint& point : points) {
    if (u < point.displacement)
      return last.force + (point.force - last.force) * (u - last.displacement) / (point.displacement - last.displacement);
    last = point;
  }
  return last.force;
}

Real Backbone::slope(Real u) const
{
  CurvePoint last;
  for (const CurvePoint& point : points) {
    if (u < point.displacement) return (point.force - last.force) / (point.displacement - last.displacement);
    last = point;
  }
  return 0;
}

PlasticSpring friction(Real limit, Real mobilisation)
{
  return {{{{mobilisation, limit}}}};
}

SpringForce force_of(const SpringLaw& law, const SpringState& state, Real u)
{
  return std::visit([&](const auto& l) { return resistance(l, state, u - state.origin); }, law);
}

SpringState accepted(const SpringLaw& law, const SpringState& state, Real u)
{
  const auto* const plastic = std::get_if<PlasticSpring>(&law);
  if (plastic == nullptr) return state;
  const SpringForce now = force_of(law, state, u);
  const Real from_origin = u - state.origin;
  SpringState next = state;
  next.slip = from_origin - now.force / plastic->backbone.stiffness();
  if (now.slides && now.force > 0) next.forward = std::max(state.forward, from_origin);
  if (now.slides && now.force < 0) next.backward = std::max(state.backward, -from_origin);
  return next;
}

void check(const SpringLaw& law)
{
  std::visit(
      [](const auto& l) {
        if constexpr (requires { l.backbone; })
          check_backbone(l.backbone);
        else if (!(l.stiffness >= 0) || !std::isfinite(l.stiffness))
          throw InputError(fmt::format("the stiffness of a spring is {} N/m2: it is a positive number", l.stiffness));
      },
      law);
}

}  // namespace berm::beam
