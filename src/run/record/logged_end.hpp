// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace berm::record {

/// How a run that is not finished came to its end, by its run.log.
struct LoggedEnd {
  std::string words;     ///< as RunRecord::last_log_line
  bool stopped = false;  ///< by who started it, and not by an error
};
LoggedEnd logged_end(const std::filesystem::path& folder);

}  // namespace berm::record
