// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace berm::io {

/// Runs a program found in PATH in a folder, without a shell, and waits; what it says goes into the file `messages`. Its exit status, 128 + N after
/// signal N; -1, and errno says why, where it did not start.
int run_and_wait(const std::vector<std::string>& words, const std::filesystem::path& messages, const std::filesystem::path& folder = ".");

/// The last line of a file with more than blanks and ^ in it; "" where there is none.
std::string last_message(const std::filesystem::path& file);

}  // namespace berm::io
