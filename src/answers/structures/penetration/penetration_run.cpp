// SPDX-License-Identifier: BSD-3-Clause
#include "structures/penetration/penetration_run.hpp"

#include "structures/driven/path.hpp"
#include "structures/penetration/soil_profile.hpp"

#include <algorithm>

namespace berm::penetration {
namespace {

using record::TravelCurve;

/// A third of the way at most is its end.
constexpr Real largest_end = 1. / 3;
constexpr Real largest_half = 1. / 20;  // of the way: what is averaged over
constexpr Real same_place = 1e-6;       // of D

}  // namespace

PenetrationRun::PenetrationRun(const record::RunRecord& run, const Penetrometer& how_read, std::size_t number_on_page)
    : record(run),
      how(how_read),
      scale(base::body_scale(run)),
      soil(run),
      number(number_on_page),
      q_curve_({}, {}),
      factor_curve_({}, {}),
      friction_curve_({}, {})
{
  const Index rigid = main_rigid(run.settings);
  if (rigid == none) return;
  const std::optional<base::BodyProfile> profile = base::body_profile(run.settings.rigid[rigid].second.shape);
  if (!profile) return;
  body = *profile;
  take_geometry();
  take_rows();
  take_last();
}

void PenetrationRun::take_geometry()
{
  const settings::Case& c = record.settings;
  whole_width_ = body.width;
  if (c.geometry == settings::Geometry::axisymmetric) {
    whole_width_ = 2 * body.right;
    area_ = pi * (body.right * body.right - body.bore * body.bore);
    return;
  }
  const bodies::RigidShapeSettings& shape = c.rigid[main_rigid(c)].second.shape;
  if (c.geometry == settings::Geometry::space) {
    const auto* box = std::get_if<bodies::BoxSettings>(&shape);
    part_ = part_in_space(record, body, bodies::center_of<3>(bodies::make_shape<3>(shape))[2]);
    if (box != nullptr) area_ = part_ * box->size[0] * box->size[2];
    if (bodies::is_round_from_above(shape)) area_ = part_ * pi * (body.width * body.width / 4 - body.bore * body.bore);
    return;
  }
  const Walls walls = walls_of(record, body);
  const Real left = std::max(body.left, walls.left), right = std::min(body.right, walls.right);
  area_ = right - left;
  if (body.left < walls.left + same_place * body.width || body.right > walls.right - same_place * body.width) whole_width_ = 2 * area_;
}

Measure PenetrationRun::measure_of_soil() const
{
  const SoilAt here = soil.at(z_.empty() ? base::reference_depth(record.settings, record.ground) : z_.back());
  if (here.strength > 0) return Measure::strength;
  if (!(here.friction_angle > 0)) return Measure::none;
  if (how.sand_measure == SandMeasure::half_weight) return here.unit_weight > 0 ? Measure::half_weight : Measure::none;
  return here.overburden > 0 ? Measure::overburden : Measure::none;
}

void PenetrationRun::take_rows()
{
  const run_folder::History& history = record.history;
  if (history.rows() == 0 || !history.has("w_m") || !history.has_label("V")) return;
  const driven::Stages stages = driven::stages_of(record.settings);
  const driven::PushPath push = driven::path_of(history, stages).push;
  const bool begins_in_soil = !push.w.empty() && push.w.front() > body.shoulder + same_place * body.width;
  const std::vector<Real>* shaft = history.has_label("V shaft") ? &history.by_label("V shaft") : nullptr;
  for (std::size_t k = 0; k < push.w.size(); ++k) {
    const Real z = push.w[k] - body.shoulder;
    if (how.flows_around ? push.w[k] < 0 : z < 0 && !begins_in_soil) continue;
    z_.push_back(z);
    const Real sides = shaft == nullptr ? 0 : (*shaft)[push.rows[k]];
    q_.push_back((push.V[k] - sides) / area_);
    if (shaft != nullptr) friction_.push_back(z > 0 ? sides / shaft_area(z) : 0);
  }
  force_limit_ = driven::force_that_ended(push, history, stages);
  measure_ = measure_of_soil();
  q_curve_ = TravelCurve(z_, q_);
  if (knows_shaft()) friction_curve_ = TravelCurve(z_, friction_);
  if (measure_ == Measure::none) return;
  std::vector<Real> factors;
  for (std::size_t k = 0; k < z_.size(); ++k) factors.push_back(factor(z_[k], q_[k]));
  factor_curve_ = TravelCurve(z_, factors);
}

Real PenetrationRun::shaft_area(Real z) const
{
  return part_ * pi * (body.width * z + 2 * body.bore * std::min(z, body.lid));
}

Real PenetrationRun::displaced(Real z) const
{
  const Real R = body.width / 2, low = std::clamp(z + body.shoulder, Real(0), body.width), part = area_ / body.width;
  if (record.settings.force_dimension() == 3) return part_ * pi * low * low * (R - low / 3);
  const Real b = std::acos(std::clamp(1 - low / R, Real(-1), Real(1)));
  return part * R * R * (b - std::sin(b) * std::cos(b));
}

Real PenetrationRun::net(Real z, Real q) const
{
  const SoilAt here = soil.at(z);
  return how.flows_around ? q - here.unit_weight * displaced(z) / area_ : q - here.overburden;
}

Real PenetrationRun::factor(Real z, Real q) const
{
  const SoilAt here = soil.at(z);
  switch (measure_) {
  case Measure::none:
    return nan;
  case Measure::strength:
    return net(z, q) / here.strength;
  case Measure::overburden:
    return here.overburden > 0 ? net(z, q) / here.overburden : nan;
  case Measure::half_weight:
    return 2 * net(z, q) / (here.unit_weight * whole_width_);
  }
  return nan;
}

const Symbol* PenetrationRun::symbol() const
{
  return measure_ == Measure::none ? nullptr : measure_ == Measure::strength ? &how.in_clay : &how.in_sand;
}

Real PenetrationRun::half() const
{
  if (!scale.noisy || q_curve_.empty()) return 0;
  return std::min(how.averaging * body.width, largest_half * (q_curve_.end() - q_curve_.begin()));
}

Real PenetrationRun::q_at(Real z) const
{
  return q_curve_.empty() ? nan : q_curve_.at(z, half());
}

Real PenetrationRun::factor_at(Real z) const
{
  return factor_curve_.empty() ? nan : factor_curve_.at(z, half());
}

Real PenetrationRun::V_at(Real z) const
{
  return q_at(z) * area_ + (friction_curve_.empty() ? 0 : friction_curve_.at(z, half()) * shaft_area(z));
}

void PenetrationRun::take_last()
{
  const TravelCurve& judged = factor_curve_.empty() ? q_curve_ : factor_curve_;
  if (judged.travel().size() < 3) return;
  last_.travel = std::min(how.last_travel * body.width, largest_end * (judged.end() - judged.begin()));
  const Real window = last_.travel / 2, middle = judged.end() - window;
  last_.q = q_curve_.at(middle, window);
  if (!friction_curve_.empty()) last_.friction = friction_curve_.at(middle, window);
  if (!factor_curve_.empty()) last_.factor = factor_curve_.at(middle, window);
  const Real mean = judged.at(middle, window), end = judged.at(judged.end(), window);
  last_.change = 2 * (end - mean) / std::abs(mean);
  Real squares = 0;
  int count = 0;
  for (std::size_t k = 0; k < judged.travel().size(); ++k) {
    if (judged.travel()[k] < judged.end() - last_.travel) continue;
    const Real off = judged.value()[k] - mean - (judged.travel()[k] - middle) / window * (end - mean);
    squares += off * off, ++count;
  }
  last_.scatter = std::sqrt(squares / count) / std::abs(mean);
  if (!last_.steady()) return;
  const TravelCurve smooth = judged.smoothed(half());
  last_.steady_from = smooth.begin();
  for (std::size_t k = 0; k < smooth.travel().size() && smooth.travel()[k] <= judged.end() - last_.travel; ++k)
    if (std::abs(smooth.value()[k] - mean) > LastTravel::max_change * std::abs(mean)) last_.steady_from = smooth.travel()[k];
}

}  // namespace berm::penetration
