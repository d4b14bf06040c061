// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "envelope/envelope_probes.hpp"
#include "run_folder/history.hpp"

namespace berm::envelope {

/// Where the body and the forces on it were.
struct EnvelopePoint {
  Real V = nan, H = V;  ///< N/m (in space N)
  Real w = V;           ///< m; of a footing that of the middle of its base
  Real M = nan;         ///< N (in space N m), of a footing about the middle of its base, clockwise where H goes to the right
};

/// How a footing moved at first, until it met a tenth of what it met along its motion at the end, and by how much its load grew: elastic soil.
struct FirstMotion {
  Real w, u, theta;  ///< m, rad
  EnvelopePoint load;
};

/// The last part of the travel, over which growth is told.
inline constexpr Real last_part = 0.25;

/// What a probe found.
struct ProbeResult {
  EnvelopePoint end;
  Real growth =
      end.V;  ///< of the resistance V sin a + H cos a along the motion, a below the horizontal (of a footing with (H cos b + M/D sin b) instead of H, b towards rotation), in the last quarter of the travel, over its last
  Real unbalance = end.V, overstress = end.V;  ///< of the last increment; NaN where the method has none
  std::vector<EnvelopePoint> path;             ///< of a swipe: its rows, at most 100
  Real travel = nan;                           ///< m
  std::optional<FirstMotion> first = {};       ///< of a footing
};

/// The result of a probe of this body from its run's history. Those of the material point method are freed from noise over +-0.01 D of travel, of a footing +-0.05 of its travel at most (TravelCurve::at), which is that
/// of (u, w), of a footing of (u, w, theta D) of the middle of its base. The history has the moment of the soil about the centre of the body, counter-clockwise: the load turns against it.
ProbeResult result_of(const Probe& probe, const run_folder::History& history, const base::EmbeddedBody& body);

/// One probe in the table.
struct EnvelopeRow {
  Probe probe;
  std::string state;  ///< "finished", "failed" or "interrupted"
  ProbeResult result;
};

/// The extremes of an envelope, N/m, N (in space N, N m); NaN where no probe gives them.
struct EnvelopeExtremes {
  Real V_max = nan;                            ///< V of the probe that goes straight down
  Real H_max = nan, V_at_H_max = nan;          ///< where H is largest: at the end of a probe that does not turn, or on the swipe's path
  Real M_max = nan, V_at_M_max = nan;          ///< where M is largest while H = 0: of the probes that turn and are free sideways
  Real M_largest = nan, H_at_M_largest = nan;  ///< where M is largest, whatever H
};
EnvelopeExtremes extremes_of(const std::vector<EnvelopeRow>& rows);

/// Where the swipes of a footing pass these V, between the points of their paths: those that turn and are not free sideways, and the one that does not turn.
std::vector<EnvelopePoint> section_at(Real V, const std::vector<EnvelopeRow>& rows);

/// envelope.csv: a line for the end of each probe, then one for each point of the swipe's path. What is not known is empty. Forces are whole where the dimension is 3; with
/// moments there are their columns and those of the probes that turn.
std::string envelope_csv(const std::vector<EnvelopeRow>& rows, bool with_moments = false, int force_dimension = 2);

}  // namespace berm::envelope
