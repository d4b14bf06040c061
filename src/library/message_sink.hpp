// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/library/library_test.cpp
#pragma once

#include <functional>
#include <mutex>
#include <spdlog/sinks/base_sink.h>
#include <string>

namespace berm {

/// Hands messages to a function of the user's; to none: nobody gets them.
class MessageSink : public spdlog::sinks::base_sink<std::mutex> {
public:
  explicit MessageSink(std::function<void(const std::string&)> take) : take_(std::move(take)) {}

protected:
  void sink_it_(const spdlog::details::log_msg& message) override
  {
    if (!take_) return;
    const std::string word = message.level >= spdlog::level::warn ? "warning: " : "";
    take_(word + std::string(message.payload.data(), message.payload.size()));
  }
  void flush_() override {}

private:
  std::function<void(const std::string&)> take_;
};

}  // namespace berm
