// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::base {

/// The force of a support on the soil at the end of a stage: means over its last twentieth.
struct SupportReaction {
  std::string stage, support;
  std::vector<Real> force;  ///< N/m or N, by direction
};
/// Of all stages and supports whose reactions the history has.
std::vector<SupportReaction> support_reactions_of(const record::RunRecord& run);

/// The same for the summary: SUPPORT_Fx_of_STAGE and so on.
std::vector<run_folder::Quantity> support_quantities(const record::RunRecord& run);
/// Their names, of a run of this case that goes through all stages.
std::vector<std::string> support_quantity_names(const settings::Case& c);

}  // namespace berm::base
