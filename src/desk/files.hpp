// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/folder.hpp"
#include "desk/http.hpp"

#include <deque>
#include <mutex>

namespace berm::desk {

/// The bytes of a file that berm made. Throws Refusal where it is of another kind, missing or too large.
Answer file_answer(const std::filesystem::path& file);

/// Pages that are shown in a frame: each by an address that nobody guesses, in an origin of its own. The script of berm's reports runs in them, by its hash, and no other.
class ShownFiles {
public:
  explicit ShownFiles(const Folder& folder) : folder_(folder) {}

  struct Shown {
    std::string address;
    bool without_scripts = false;  ///< it has some, and they are not those of this program's reports
  };
  /// An address of the file from now on: /shown/WORD. The oldest of many are forgotten.
  Shown add(const std::string& name);
  Answer answer(const std::string& address) const;

private:
  const Folder& folder_;
  mutable std::mutex mutex_;
  std::deque<std::pair<std::string, std::string>> names_;  ///< address, and the file's name
};

}  // namespace berm::desk
