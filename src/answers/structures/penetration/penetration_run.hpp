// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/travel_curve.hpp"
#include "structures/penetration/penetrometer.hpp"
#include "structures/penetration/soil_profile.hpp"

namespace berm::penetration {

/// What the net resistance is divided by.
enum class Measure { none, strength, overburden, half_weight };

/// How a resistance ends.
struct LastTravel {
  Real travel = nan;    ///< m, the travel over which the following is taken
  Real q = nan;         ///< Pa, mean
  Real friction = nan;  ///< Pa, mean of the friction of the shaft
  Real factor = nan;    ///< mean
  Real change = nan;    ///< of the straight line fitted to the factor there (without one: to q), over the mean
  Real scatter = nan;   ///< standard deviation of the rows about that line, over the mean
  Real steady_from =
      nan;  ///< m, where steady: the depth from which the averaged factor stays within max_change of the mean, at most that where this travel begins

  bool steady() const { return std::abs(change) < max_change; }

  /// The change below which a resistance is called steady.
  static constexpr Real max_change = 0.05;
};

/// A run as one of a body that is pushed down: its resistance as q = V/A over the depth of its level of full width, without what the sides along the axis carry where
/// the history tells it (V_shaft). The record must outlive it.
class PenetrationRun {
public:
  PenetrationRun(const record::RunRecord& run, const Penetrometer& how, std::size_t number_on_page = 0);

  const record::RunRecord& record;
  const Penetrometer& how;
  base::BodyScale scale;
  base::BodyProfile body;
  SoilProfile soil;
  std::size_t number;  ///< on the page, which gives its colour

  /// m2 of the part of the body that is modelled on a level plane (plane strain: m), of a ring or a skirt that of its own; NaN where it is not known.
  Real area() const { return area_; }
  /// m, of the whole body: twice the modelled part where a wall of the mesh is its plane of symmetry.
  Real whole_width() const { return whole_width_; }

  /// By row of the way down in the soil: depth and q.
  const std::vector<Real>& z() const { return z_; }
  const std::vector<Real>& q() const { return q_; }
  /// Whether q is without the shaft; then the mean friction of the shaft that is in the soil by row, Pa.
  bool knows_shaft() const { return !friction_.empty(); }
  /// m2 of the shaft in the soil of a body around an axis at a depth; of a skirt of both its faces, as if the soil inside lay at the level of the bed.
  Real shaft_area(Real z) const;
  const std::vector<Real>& friction() const { return friction_; }
  const record::TravelCurve& friction_curve() const { return friction_curve_; }
  /// q less what the soil that the body takes the place of weighs, Pa.
  Real net(Real z, Real q) const;
  /// The factor of a resistance at a depth; NaN where there is no measure.
  Real factor(Real z, Real q) const;

  /// What the net resistance is divided by: of the soil at the end of the way.
  Measure measure() const { return measure_; }
  /// The symbol of that factor; null without a measure.
  const Symbol* symbol() const;
  /// Half of the travel over which q and the factor are averaged, m.
  Real half() const;
  const record::TravelCurve& q_curve() const { return q_curve_; }
  const record::TravelCurve& factor_curve() const { return factor_curve_; }
  /// Averaged; NaN at depths beyond the way.
  Real q_at(Real z) const;
  Real factor_at(Real z) const;
  /// V there, with what the shaft carries, N (plane strain: N/m).
  Real V_at(Real z) const;
  /// V at which a limit of force ended the push; NaN where it ended otherwise.
  Real force_limit() const { return force_limit_; }

  const LastTravel& last() const { return last_; }
  /// V over the last travel, its mean, with what the shaft carries in its middle, N (plane strain: N/m).
  Real V_last() const
  {
    return last_.q * area_ + (std::isfinite(last_.friction) ? last_.friction * shaft_area(z_end() - last_.travel / 2) : 0);
  }
  /// m: depth of the level of full width, and of the lowest point, at the end of the way down; NaN without rows.
  Real z_end() const { return z_.empty() ? nan : z_.back(); }
  Real w_end() const { return z_end() + body.shoulder; }
  /// Of a body around which soil flows, the volume that it takes from the soil at a depth, m3 (plane strain: m2 of the modelled part).
  Real displaced(Real z) const;

private:
  void take_geometry();
  void take_rows();
  void take_last();
  Measure measure_of_soil() const;

  Real area_ = nan, whole_width_ = nan, part_ = 1;  ///< part: that is modelled, in space
  Real force_limit_ = nan;
  Measure measure_ = Measure::none;
  std::vector<Real> z_, q_, friction_;
  record::TravelCurve q_curve_, factor_curve_, friction_curve_;
  LastTravel last_;
};

using PenetrationRuns = std::vector<PenetrationRun>;

}  // namespace berm::penetration
