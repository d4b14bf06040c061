// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"
#include "structures/base/published_envelope.hpp"

#include <optional>

namespace berm::envelope {

/// How an envelope is looked for.
struct EnvelopeSettings {
  int directions = 10;
  Real travel = 0.1;  ///< of each probe, over the width
  /// Of a footing: so many directions with rotation, and so many swipes with both; 5 where it is not given. A pipe has none.
  std::optional<int> turns = std::nullopt;
};

/// The body whose envelope is looked for, as its structure says that it lies before the first stage. Throws InputError where the case has none that has an
/// envelope.
base::EmbeddedBody embedded_body(const settings::Case& c);

/// What a probe does: it goes in one direction until the soil yields, or pushes first and then drags at that depth.
enum class ProbeKind { direction, swipe };

/// One run towards the envelope, from the case's first state.
struct Probe {
  std::string name;
  ProbeKind kind = ProbeKind::direction;
  Real angle = 0;              ///< degrees below the horizontal in which a direction probe goes; NaN of a swipe
  settings::Case settings;     ///< the case with the probe's own stages
  std::string stage;           ///< whose rows of the history tell the probe's path
  Real turn = 0;               ///< degrees from sideways (u) towards rotation (theta D) in which it goes besides: 90 turns alone
  bool free_sideways = false;  ///< nothing holds the body sideways, so H = 0
};

/// The probes of an envelope: straight down (the first), in equal steps of angle to 45 degrees above the horizontal, and a swipe. The stages of the
/// case before its first push or drag stay; those from there on give way to the probe's, which take its speed, ramp, rigid body and damping.
///
/// Those of a footing, whose displacements are w, u and theta D of the point that its moments are about, go down, in equal steps of angle towards the horizontal, and swipe; turn with H = 0 in
/// directions from 60 degrees below to 20 above the rotation, and in a swipe with w fixed; and swipe sideways and turning at once.
///
/// Throws InputError as embedded_body, where that stage has no velocity, where turns are asked of a body that has none, and where a body that inertia
/// moves has no mass.
std::vector<Probe> choose_probes(const settings::Case& c, const EnvelopeSettings& settings);

}  // namespace berm::envelope
