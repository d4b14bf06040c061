// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/pipeline_settings.hpp"
#include "structures/line/shapes.hpp"

namespace berm::line {

/// What a shape of half of a line tells of its buckle.
struct Buckle {
  int lobes = 0;  ///< of the whole line, of those that are more than a hundredth of the largest
  Real lobe_length =
      nan;  ///< m, between the crossings of the largest lobe; of one that is its own mirror image at x = 0 twice the distance to the first
  Real half_length = nan;  ///< m, from x = 0 to the end of the last of these lobes; the end of the line where that does not end
  Real slip_length = nan;  ///< m, from x = 0 to the last place that has slipped along the line
  Real bending = 0;        ///< the largest strain by bending, in both planes together
};
Buckle buckle_of(const Shape& shape, const settings::PipelineSettings& line);

/// The mean over the line of u, m.
Real mean_axial(const Shape& shape);

}  // namespace berm::line
