// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/folder.hpp"
#include "desk/http.hpp"

#include <deque>
#include <mutex>

namespace berm::desk {

/// The bytes of a file that berm made. Throws Refusal where it is of another kind, missing or too large.
Answer file_answer(const std::filesystem::path& file);

/// Pages that are shown in a frame: each by an address that nobody guesses, in an origin of its own, so that its script reaches neither the desk nor the net.
class ShownFiles {
public:
  explicit ShownFiles(const Folder& folder) : folder_(folder) {}

  /// An address of the file from now on: /shown/WORD. The oldest of many are forgotten.
  std::string add(const std::string& name);
  Answer answer(const std::string& address) const;

private:
  const Folder& folder_;
  mutable std::mutex mutex_;
  std::deque<std::pair<std::string, std::string>> names_;  ///< address, and the file's name
};

}  // namespace berm::desk
