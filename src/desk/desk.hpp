// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/http.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace berm::desk {

struct DeskSettings {
  std::filesystem::path folder = ".";
  Listen listen = {};
  int threads = 0;  ///< of all runs together; 0: all processors
  Proxy proxy = {};
  /// Where a run of a case goes by default.
  std::function<std::filesystem::path(const std::filesystem::path&)> place;
};

/// A folder of cases and runs as a page in a browser of this machine: docs/how_to/desk.md says what it serves.
class Desk {
public:
  explicit Desk(const DeskSettings& settings);
  ~Desk();

  /// Where a browser finds it, with the token that it asks for.
  std::string address() const;
  /// Answers until stop(); what it began goes on after that, what waits in its queue does not begin.
  void serve();
  void stop();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace berm::desk
