// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::simulation {

/// s between rows of the history: a thousandth of the time that the stages take, unless the user says. Throws KeyError where no stage says how long it takes.
Real history_interval_of(const settings::Case& c);

}  // namespace berm::simulation
