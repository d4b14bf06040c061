// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace berm::run_folder {

/// Reads a JSON file that berm has written. Its texts go into tables, pages and decks of other programs, so they are of the kind that input may have: control characters are
/// refused. Throws RunError "FILE is damaged: WHY", or "FILE: WHY" where it cannot be read or has more than `most` bytes.
nlohmann::ordered_json read_json(const std::filesystem::path& file, std::uintmax_t most = 100'000'000);

}  // namespace berm::run_folder
