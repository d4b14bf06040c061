// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <spdlog/logger.h>
#include <spdlog/sinks/sink.h>
#include <string_view>

namespace berm::run_folder {

class StderrSink;
class LogFileSink;

/// While it lives, and has not stepped aside, spdlog's messages go to stderr ("warning: ..." in colour on a terminal) and, with their time, to the run's log file.
/// On a terminal it also keeps one line that is rewritten in place, below the messages.
class RunLog {
public:
  /// Begins the file, or appends to what it holds. Messages go to `instead` of stderr where it is given. Throws RunError where the file cannot be
  /// written.
  explicit RunLog(const std::filesystem::path& file, bool resume = false, const std::shared_ptr<spdlog::sinks::sink>& instead = {});
  ~RunLog();
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;

  /// Leaves spdlog's messages to whoever had them before, until take_over().
  void step_aside();
  void take_over();
  /// True where messages go to stderr and that is a terminal.
  bool has_terminal() const { return has_terminal_; }
  /// Shows the line in place of the one before, cut to the terminal's width; an empty one clears it. Never goes to the file.
  void rewrite_line(std::string_view line);
  /// What a run found: to the standard output (or to `instead`) and to the file.
  void result(std::string_view message);
  /// A message to the file alone.
  void info_to_file(std::string_view message);
  /// Throws RunError where a message could not be written to the file, or the disk does not take it.
  void check() const;

private:
  bool has_terminal_;
  std::shared_ptr<StderrSink> terminal_;
  std::shared_ptr<LogFileSink> file_;
  std::shared_ptr<spdlog::logger> own_, file_only_, instead_;
  std::shared_ptr<spdlog::logger> before_;  ///< while this has stepped aside: none
};

}  // namespace berm::run_folder
