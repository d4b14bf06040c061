// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"
#include "structures/base/published_envelope.hpp"

namespace berm::envelope {

/// How an envelope is looked for.
struct EnvelopeSettings {
  int directions = 10;
  Real travel = 0.1;  ///< of each probe, over the width
};

/// The body whose envelope is looked for, as its structure says that it lies before the first stage. Throws InputError where the case has none that has an
/// envelope.
base::EmbeddedBody embedded_body(const problem::Case& c);

/// What a probe does: it goes in one direction until the soil yields, or pushes first and then drags at that depth.
enum class ProbeKind { direction, swipe };

/// One run towards the envelope, from the case's first state.
struct Probe {
  std::string name;
  ProbeKind kind = ProbeKind::direction;
  Real angle = 0;          ///< degrees below the horizontal in which a direction probe goes; NaN of a swipe
  problem::Case settings;  ///< the case with the probe's own stages
  std::string stage;       ///< whose rows of the history tell the probe's path
};

/// The probes of an envelope: straight down (the first), in equal steps of angle to 45 degrees above the horizontal, and a swipe. The stages of the
/// case before its first push or drag stay; those from there on give way to the probe's, which take its speed, ramp, rigid body and damping. Throws
/// InputError as embedded_body, and where that stage has no velocity.
std::vector<Probe> choose_probes(const problem::Case& c, const EnvelopeSettings& settings);

}  // namespace berm::envelope
