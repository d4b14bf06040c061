// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace berm::user_law {

/// While one of these lives, a crash or an exit inside a call of a user's law (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, or exit(), which is what STOP does in
/// Fortran) ends the program with a message to stderr that names the law, and with exit status 1. Nothing else is done: what is on disk stays as it is, as after
/// a kill. Elsewhere signals do what they did before.
class CrashGuard {
public:
  CrashGuard();
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;
};

/// Marks that this thread is inside a call, as long as it lives; `law` is what a message says of the law.
class InsideCall {
public:
  explicit InsideCall(const std::string& law);
  ~InsideCall();
  InsideCall(const InsideCall&) = delete;
  InsideCall& operator=(const InsideCall&) = delete;
};

}  // namespace berm::user_law
