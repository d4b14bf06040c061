// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace berm::jobs {

/// How a job ended. Interrupted: it was stopped or did not begin. Queued: it was handed over, and has not ended yet.
struct JobEnd {
  enum class Kind { finished, failed, interrupted, queued };
  Kind kind = Kind::interrupted;
  std::string reason;  ///< why it failed: its last message, or the signal that terminated it
};

/// How a command that runs cases ended. Unfinished: nothing failed, and the same command (of a single run: berm run --resume FOLDER) goes on.
enum class Outcome { done, unfinished, failed };

/// The exit status: 0 done, 1 failed, 75 unfinished (EX_TEMPFAIL of sysexits.h: try again later).
constexpr int status_of(Outcome outcome)
{
  return outcome == Outcome::done ? 0 : outcome == Outcome::failed ? 1 : 75;
}

constexpr Outcome worse(Outcome a, Outcome b)
{
  return a < b ? b : a;
}

constexpr Outcome outcome_of(JobEnd::Kind kind)
{
  return kind == JobEnd::Kind::finished ? Outcome::done : kind == JobEnd::Kind::failed ? Outcome::failed : Outcome::unfinished;
}

}  // namespace berm::jobs
