// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/base/run_details.hpp"

namespace berm::driven {

/// Further numbers of a run (docs/how_to/check_berm.md lists them): V, H, w and u at any place of push and first drag, and what the soil does in the frames. u is
/// counted from the begin of the drag.
base::RunDetails details_of(const record::RunRecord& run);

/// Their names.
std::vector<std::string> detail_names();

}  // namespace berm::driven
