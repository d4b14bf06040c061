// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace berm::sanity {

/// Whether a case that makes no sense is not run at all, or run with a warning.
enum class Severity { warn, refuse };

/// What is doubtful of a case: the key that says it ("stage[1].velocity"), the number found, what is expected, and what to change.
struct Finding {
  Severity severity;
  std::string key, message;
};

/// What the questions found.
class Findings {
public:
  void warn(const std::string& key, const std::string& message) { all_.push_back({Severity::warn, key, message}); }
  void refuse(const std::string& key, const std::string& message) { all_.push_back({Severity::refuse, key, message}); }
  const std::vector<Finding>& all() const { return all_; }

private:
  std::vector<Finding> all_;
};

}  // namespace berm::sanity
