// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::pipe {

/// Whether a key result is a number of the input: the embedment at which a push or the travel at which a drag ends, V where a push ends at a force or is
/// driven by one and of a drag under a force that is given, w of a drag at a fixed level. What cells or speed make of such a number is how exactly the limit is met, and no uncertainty.
bool is_prescribed(const record::RunRecord& run, const run_folder::Quantity& quantity);

}  // namespace berm::pipe
