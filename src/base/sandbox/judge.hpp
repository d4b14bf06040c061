// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sandbox/watcher.hpp"

#include <cerrno>
#include <seccomp.h>
#include <string>
#include <sys/types.h>
#include <vector>

namespace berm::sandbox {

/// What becomes of a call: it goes on (error 0), or fails with this error number. The note tells what was refused; "" where that is nobody's business.
struct Verdict {
  int error = 0;
  std::string note = {};
  bool ends = false;  ///< the process is ended
};

/// A call that the kernel knows as senseless, and the watcher answers: whoever gets the answer is in the sandbox, whatever its environment says.
constexpr unsigned question_flags = 0x6265726d;
constexpr int answer_inside = ENOTUNIQ;

/// The calls that are judged whatever their arguments are; open and openat beside them where they write.
const std::vector<int>& watched_calls();

/// Judges the calls of a process and of what it started.
class Judge {
public:
  Judge(const Allowed& allowed, pid_t watched) : allowed_(allowed), watched_(watched) {}

  Verdict operator()(const seccomp_notif& call) const;

private:
  Verdict start(const seccomp_notif& call) const;
  Verdict begin(const seccomp_notif& call) const;
  Verdict change(const seccomp_notif& call, const std::filesystem::path& file, bool only_here) const;
  Verdict refused(const seccomp_notif& call, const std::string& what) const;

  Allowed allowed_;
  pid_t watched_;
};

}  // namespace berm::sandbox
