// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "slices/drag_curve.hpp"
#include "slices/line_on_springs.hpp"

namespace berm::slices {

/// A second line beside that on slices: on springs that have, everywhere, the resistance sideways of one drag in the laid slice, as a design with springs would have it. Along the line and
/// downwards its springs are the far soil's.
class SpringsBeside {
public:
  /// Of a case with pipeline.springs.
  explicit SpringsBeside(const settings::Case& c);

  /// Whether the resistance is known.
  bool ready() const { return line_.has_value(); }
  /// Finds it (drag_curve.hpp). Empty where stop() said so; the next call begins anew.
  std::optional<DragCurve> find(const problem::Model<2>& model, const problem::State<2>& laid, const std::function<bool()>& stop);
  /// As a line on these springs; only when they are ready.
  void step(const LineLoads& now, Real dt) { line_->step(now, dt); }
  const LineOnSprings& line() const { return *line_; }

  const beam::Backbone& curve() const { return curve_; }
  void archive(Archive& k);

private:
  void make_line();

  settings::Case case_;
  beam::Backbone curve_;
  Real embedment_ = 0;  ///< m, of the laid pipe
  std::optional<LineOnSprings> line_;
};

}  // namespace berm::slices
