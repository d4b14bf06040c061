// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/row.hpp"

#include <filesystem>

namespace berm::run_folder {

/// Where the columns of a history are described: history.schema.json beside history.csv.
std::filesystem::path schema_path(const std::filesystem::path& history);

/// Writes {"columns": [{"name", "label", "unit", "meaning", "of"}, ...]} in the order of the file: time_s, stage (whose unit is null) and the others.
/// Throws RunError.
void write_schema(const std::filesystem::path& history, const std::vector<Column>& columns);

/// The columns but the stage, in the order of the file. Throws RunError where there is no schema beside the history, or one that is damaged.
std::vector<Column> read_schema(const std::filesystem::path& history);

}  // namespace berm::run_folder
