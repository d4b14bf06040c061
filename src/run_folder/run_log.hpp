// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <spdlog/logger.h>
#include <string_view>

namespace berm::run_folder {

class StderrSink;
class LogFileSink;

/// While it lives, spdlog's messages go to stderr ("warning: ..." in colour on a terminal) and, with their time, to the run's log file.
/// On a terminal it also keeps one line that is rewritten in place, below the messages.
class RunLog {
public:
  /// Begins the file, or goes on behind what it holds. Throws RunError where it cannot be written.
  explicit RunLog(const std::filesystem::path& file, bool resume = false);
  ~RunLog();
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;

  /// True where stderr is a terminal.
  bool has_terminal() const { return has_terminal_; }
  /// Shows the line in place of the one before, cut to the terminal's width; an empty one clears it. Never goes to the file.
  void rewrite_line(std::string_view line);
  /// A message to the file alone.
  void info_to_file(std::string_view message);
  /// Throws RunError where a message could not be written to the file, or the disk does not take it.
  void check() const;

private:
  bool has_terminal_;
  std::shared_ptr<StderrSink> terminal_;
  std::shared_ptr<LogFileSink> file_;
  std::shared_ptr<spdlog::logger> file_only_, before_;
};

}  // namespace berm::run_folder
