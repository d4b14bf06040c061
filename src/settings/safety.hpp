// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::settings {

/// The case with its strength over its safety.factor F, from its start on: of every soil (with_strength_over), and of interfaces tan(friction_angle), adhesion and finite tension; an adhesion that is a
/// share of the undrained strength falls with that. Contacts of two rigid bodies stay. Geostatic stages ask for an equilibrium of strictest_equilibrium. The case itself where it is no trial.
Case with_reduced_strength(Case c);

/// Largest out-of-balance force over the weight with which the soil of a trial is at rest.
constexpr Real strictest_equilibrium = 1e-3;

/// Whether a velocity or a displacement moves the body of a stage: what the soil does then is no sign of failure.
bool moves_body(const StageSettings& stage);

/// Refuses a trial without soil that has a strength which can be divided, without a load, or with a last stage that moves a body.
void check_safety(Describe& d, const Case& c);

/// c_v T / H^2 of the last stage, T being its time limit, H the depth of the soil (m), the longest way that its water can have, and c_v that of the slowest soil halfway down; NaN where no water flows or the stage has no
/// limit of time. Below 1 the water still flows when the stage ends.
Real time_factor_of_last_stage(const Case& c, Real depth);

}  // namespace berm::settings
