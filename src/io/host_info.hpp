// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace berm::io {

/// The machine that this runs on in a line: "AMD EPYC 9B14, 2 processors, Linux 6.1 x86_64". What is not known is left out; the processors are those
/// that this process may use.
std::string machine_words();

/// The model of the processor as the text of /proc/cpuinfo tells it, with single spaces; "" where it does not.
std::string processor_model(const std::string& cpuinfo);

/// A point in time as ISO 8601 in UTC, to the second: "2026-01-31T12:00:00Z".
std::string utc_date(std::chrono::system_clock::time_point time);

}  // namespace berm::io
