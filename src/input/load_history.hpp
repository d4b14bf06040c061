// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/stage.hpp"

#include <filesystem>

namespace berm::input {

/// Reads the file of a stage's load history, a path from `folder`, into its times and factors: two numbers a line with a comma between them, a first line of
/// words and lines that begin with # do not count. A stage that has no other limit ends with the last time. Throws InputError with file and line.
void read_load_history(problem::StageSettings& stage, const std::filesystem::path& folder);

}  // namespace berm::input
