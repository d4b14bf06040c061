// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <sys/types.h>
#include <vector>

namespace berm::sandbox {

/// The processes that a process has started, and those have, as far as they are there. One that adopts orphans keeps them all below itself.
class Descendants {
public:
  /// What is there now, and what it starts, is none of them.
  explicit Descendants(pid_t of);

  /// Looks for new ones.
  void look();
  /// Ends all that are known, and what those have started, by SIGKILL.
  void end();

private:
  void add_children_of(pid_t process, std::vector<pid_t>& added);

  pid_t of_;
  std::vector<pid_t> others_;   ///< that were there before
  std::map<pid_t, int> known_;  ///< and descriptors, so that a number that is used again means nobody else
};

}  // namespace berm::sandbox
