// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/progress_test.cpp
#include "io/log.hpp"

#include <spdlog/spdlog.h>

namespace berm::io {

void log_line(std::string_view line, bool warns)
{
  spdlog::default_logger_raw()->log(warns ? spdlog::level::warn : spdlog::level::info, spdlog::string_view_t(line.data(), line.size()));
}

}  // namespace berm::io
