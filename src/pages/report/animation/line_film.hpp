// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/animation/film.hpp"

namespace berm::report {

/// The line of the run of a pipeline in plan, frame by frame: `json` is LineData of web/src/data.ts. Of a long run every n-th frame is kept, never without the
/// ends of stages, and of a long line the nodes that a page can tell apart. Ids begin with `prefix`.
Film make_line_film(const record::RunRecord& run, const std::string& prefix);

}  // namespace berm::report
