// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/chart.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/driven/path.hpp"

namespace berm::driven {

/// V_w of the way down; H_u, w_u, V_u and H_over_V_u of each drag over u from where the first began, H along x; H_travel: H against each drag over its travel, as key
/// results and springs take it; V_s of each lift, over its travel upwards. None without a history.
base::Charts run_charts(const run_folder::History& history, const base::BodyScale& scale, const Stages& stages);

}  // namespace berm::driven
