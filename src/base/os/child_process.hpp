// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
#include <string>
#include <vector>

namespace berm {

/// A program to start, without a shell.
struct ChildStart {
  std::vector<std::string> words;             ///< what it is called, and its arguments
  std::string program = {};                   ///< its file; "": the first word, looked for in PATH
  std::string messages = {};                  ///< the regular file of its standard output and error; "": the next
  int out = -1;                               ///< the open file of them; -1: where this program's own errors go
  int in = -1;                                ///< the open file that it reads; -1: nothing
  std::string folder = {};                    ///< where it works; "": here
  std::vector<std::string> environment = {};  ///< NAME=VALUE, where they differ from this program's
  std::vector<int> processors = {};           ///< that it may use; none: all that this program may
  int end_by = SIGKILL;   ///< the signal that it gets where this program, however it ends, or the ChildProcess ends before it
  bool outlives = false;  ///< it gets none where this program ends
};

/// A program that this one started, in a process group of its own: what a terminal sends to this program does not reach it. All children of berm are started here.
class ChildProcess {
public:
  /// Throws std::system_error where it cannot be started (ENOENT: there is no such program), RunError where the file for its messages cannot be written.
  explicit ChildProcess(const ChildStart& start);
  /// Ends its group by `end_by`, and waits, where it has not ended.
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  bool has_ended();
  /// Waits until it has ended. Its exit status, 128 + N after signal N.
  int wait();
  /// To all processes of its group.
  void send(int signal) const;
  /// Whether any process of its group is there. What the child left behind is this program's child, so that it does not wait for somebody to take note of its end, where
  /// adopt_orphans() was called before.
  bool group_lives() const;

private:
  bool reap(int options);

  int process_ = 0, end_by_;
  int status_ = -1;  ///< -1: it has not ended
};

/// From now on processes whose parent ends become children of this one.
void adopt_orphans();

/// Waits while the child works; throws Interrupted, and ends it, once a signal asks to stop.
int wait_unless_interrupted(ChildProcess& child, const std::string& name);

}  // namespace berm
