// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "run_folder/run_log.hpp"

#include "io/atomic_file.hpp"
#include "io/tell.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <fmt/format.h>
#include <new>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/ansicolor_sink.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace berm::run_folder {
namespace {

/// "warning: " before what is not plain information, behind the name of whoever says it where there is one.
class LevelWord : public spdlog::custom_flag_formatter {
public:
  explicit LevelWord(std::string_view speaker) : speaker_(speaker) {}
  void format(const spdlog::details::log_msg& message, const std::tm&, spdlog::memory_buf_t& out) override
  {
    if (message.level == spdlog::level::info) return;
    out.append(speaker_.data(), speaker_.data() + speaker_.size());
    const auto word = spdlog::level::to_string_view(message.level);
    out.append(word.data(), word.data() + word.size());
    out.push_back(':');
    out.push_back(' ');
  }
  std::unique_ptr<custom_flag_formatter> clone() const override { return std::make_unique<LevelWord>(speaker_); }

private:
  std::string_view speaker_;
};

std::unique_ptr<spdlog::formatter> formatter(const char* pattern, std::string_view speaker = "")
{
  auto result = std::make_unique<spdlog::pattern_formatter>();
  result->add_flag<LevelWord>('*', speaker).set_pattern(pattern);
  return result;
}

std::size_t terminal_width()
{
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

/// Clears the line in place before a message and shows it again behind it.
class StderrSink : public spdlog::sinks::ansicolor_stderr_sink_mt {
public:
  void log(const spdlog::details::log_msg& message) override
  {
    const std::string line = line_;
    rewrite("");
    ansicolor_sink::log(message);
    if (!line.empty()) rewrite(line);
  }
  void rewrite(std::string_view line)
  {
    if (line.empty() && line_.empty()) return;
    line_ = line.substr(0, std::min(line.size(), terminal_width() - 1));
    io::tell("\r\x1b[2K{}", line_);
  }

private:
  std::string line_;
};

/// Hands each message to the system whole, and remembers why it did not take one.
class LogFileSink : public spdlog::sinks::base_sink<std::mutex> {
public:
  LogFileSink(const std::filesystem::path& path, bool resume)
      : path_(path),
        file_(io::open_to_write(path, O_WRONLY | O_APPEND | (resume ? 0 : O_TRUNC)))
  {
  }
  ~LogFileSink() override { ::close(file_); }
  LogFileSink(const LogFileSink&) = delete;
  LogFileSink& operator=(const LogFileSink&) = delete;

  void check()
  {
    const std::lock_guard lock(mutex_);
    if (failure_ == 0 && ::fsync(file_) != 0) failure_ = errno;
    errno = failure_;
    if (failure_ != 0) io::throw_errno(fmt::format("cannot write {}", path_.string()));
  }

private:
  void sink_it_(const spdlog::details::log_msg& message) override
  {
    spdlog::memory_buf_t text;
    formatter_->format(message, text);
    if (!io::write_all(file_, std::string_view(text.data(), text.size())) && failure_ == 0) failure_ = errno;
  }
  void flush_() override {}

  std::filesystem::path path_;
  int file_, failure_ = 0;
};

RunLog::RunLog(const std::filesystem::path& file, bool resume, const std::shared_ptr<spdlog::sinks::sink>& instead)
    : has_terminal_(!instead && ::isatty(STDERR_FILENO) == 1),
      terminal_(std::make_shared<StderrSink>()),
      file_(std::make_shared<LogFileSink>(file, resume))
{
  file_->set_formatter(formatter("%Y-%m-%d %H:%M:%S %*%v"));
  terminal_->set_formatter(formatter("%^%*%$%v", "berm: "));
  file_only_ = std::make_shared<spdlog::logger>("file", file_);
  if (instead) instead_ = std::make_shared<spdlog::logger>("results", instead);
  own_ = std::make_shared<spdlog::logger>("berm", spdlog::sinks_init_list{instead ? instead : terminal_, file_});
  own_->flush_on(spdlog::level::info);
  take_over();
}

RunLog::~RunLog()
{
  try {
    rewrite_line("");
    step_aside();
  } catch (const std::bad_alloc&) {  // what is said from here on goes to this log, too
  }
}

void RunLog::take_over()
{
  if (before_) return;
  before_ = spdlog::default_logger();
  spdlog::set_default_logger(own_);
}

void RunLog::step_aside()
{
  if (!before_) return;
  spdlog::set_default_logger(before_);
  before_.reset();
}

void RunLog::rewrite_line(std::string_view line)
{
  if (has_terminal_) terminal_->rewrite(line);
}

void RunLog::check() const
{
  file_->check();
}

void RunLog::result(std::string_view message)
{
  file_only_->info("{}", message);
  if (instead_) return instead_->info("{}", message);
  rewrite_line("");
  fmt::print("{}\n", message);
  std::fflush(stdout);
}

void RunLog::info_to_file(std::string_view message)
{
  file_only_->info("{}", message);
}

}  // namespace berm::run_folder
