// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "envelope/envelope_probes.hpp"
#include "run_folder/history.hpp"

namespace berm::envelope {

/// Where the body and the forces on it were.
struct EnvelopePoint {
  Real V = nan, H = V;  ///< N/m
  Real w = V;           ///< m
};

/// What a probe found.
struct ProbeResult {
  EnvelopePoint end;
  Real growth =
      end.V;  ///< of the resistance V sin a + H cos a along the motion, a below the horizontal, in the last quarter of the travel, over its last
  Real unbalance = end.V, overstress = end.V;  ///< of the last increment; NaN where the method has none
  std::vector<EnvelopePoint> path;             ///< of a swipe: its rows, at most 100
};

/// The result of a probe from its run's history. Those of the material point method are freed from noise over +-0.01 D of travel (TravelCurve::at).
ProbeResult result_of(const Probe& probe, const run_folder::History& history, Real width);

/// One probe in the table.
struct EnvelopeRow {
  Probe probe;
  std::string state;  ///< "finished", "failed" or "interrupted"
  ProbeResult result;
};

/// The extremes of an envelope, N/m; NaN where no probe gives them.
struct EnvelopeExtremes {
  Real V_max;              ///< V of the probe that goes straight down
  Real H_max, V_at_H_max;  ///< where H is largest: at the end of a probe or on the swipe's path
};
EnvelopeExtremes extremes_of(const std::vector<EnvelopeRow>& rows);

/// envelope.csv: a line for the end of each probe, then one for each point of the swipe's path. What is not known is empty.
std::string envelope_csv(const std::vector<EnvelopeRow>& rows);

}  // namespace berm::envelope
