// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace berm::io {

/// Description of the host in a line: "AMD EPYC 9B14, 2 processors, Linux 6.1 x86_64". Unknown parts are left out; the
/// processors are those that this process may use.
std::string host_description();

/// Model of the processor from the text of /proc/cpuinfo, with single spaces; "" where it is missing.
std::string processor_model(const std::string& cpuinfo);

/// A point in time as ISO 8601 in UTC, to the second: "2026-01-31T12:00:00Z".
std::string utc_date(std::chrono::system_clock::time_point time);

}  // namespace berm::io
