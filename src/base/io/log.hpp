// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>
#include <string_view>

namespace berm::io {

/// Writes a line to the log of this process: of a run, also to its file.
void log_line(std::string_view line, bool warns);

/// spdlog::info and spdlog::warn, whose headers compile all of fmt wherever they are used.
template <class... Values>
void info(fmt::format_string<Values...> form, Values&&... values)
{
  log_line(fmt::format(form, std::forward<Values>(values)...), false);
}
template <class... Values>
void warn(fmt::format_string<Values...> form, Values&&... values)
{
  log_line(fmt::format(form, std::forward<Values>(values)...), true);
}

}  // namespace berm::io
