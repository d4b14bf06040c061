// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/child_process.hpp"

#include <string>

namespace berm::jobs {

/// A text as one word of a shell's command line: 'it'\''s'. As it is where it has letters, digits and _-+=./:, alone.
std::string quoted(const std::string& word);

/// What a shell command left.
struct ShellEnd {
  int status = 0;   ///< exit status, 128 + N after signal N; 127: there is no such program
  std::string out;  ///< standard output and error
};

/// Starts a command with /bin/sh; standard output and error go to an open file, or with -1 to this program's standard error. Throws RunError where no process can be started.
ChildProcess started_shell(const std::string& command, int out = -1);

/// Runs a command with /bin/sh and waits for it. Throws RunError where no process can be started.
ShellEnd run_shell(const std::string& command);

/// Whether there is a program of that name in PATH.
bool has_program(const std::string& name);

/// The last line that is not blank.
std::string last_line(const std::string& text);

}  // namespace berm::jobs
