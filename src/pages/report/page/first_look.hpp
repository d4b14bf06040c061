// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::report {

/// What is seen of a run without scrolling, as HTML: its stages in one line, the place of its curves (which the page's script draws), and its last picture of the
/// soil, as far as the run folder has one.
std::string first_look(const record::RunRecord& run);

}  // namespace berm::report
