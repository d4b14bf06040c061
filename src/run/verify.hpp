// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace berm {

/// Runs the cases that each example's expected.toml names, into OUTPUT/EXAMPLE/CASE, each case with the same overrides once, and prints how their
/// results compare with what is expected. All input is read before the first run. True where all is as expected. Throws InputError and RunError.
bool verify(const std::vector<std::string>& examples, const std::filesystem::path& output, int threads);

}  // namespace berm
