// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

#include <nlohmann/json.hpp>

namespace berm::report {

/// RunData of web/src/data.ts, with "film": null and "of_test": false.
nlohmann::ordered_json run_data(const record::RunRecord& run);

}  // namespace berm::report
