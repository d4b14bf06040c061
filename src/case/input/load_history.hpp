// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/stage.hpp"

#include <filesystem>

namespace berm::input {

/// Reads the file of the load history of the stage of this number, a path from `folder`, into its times and factors: two numbers a line with a comma between them, a first line of
/// words and lines that begin with # do not count. The stage ends with the last time at the latest. Throws KeyError where there is no such file, and InputError
/// with file and line where it is wrong.
void read_load_history(problem::StageSettings& stage, std::size_t number, const std::filesystem::path& folder);

}  // namespace berm::input
