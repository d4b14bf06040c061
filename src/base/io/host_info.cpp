// SPDX-License-Identifier: BSD-3-Clause
#include "io/host_info.hpp"

#include "io/atomic_file.hpp"
#include "os/text_of_list.hpp"
#include "os/threads.hpp"

#include <algorithm>
#include <ctime>
#include <fmt/format.h>
#include <sstream>
#include <sys/utsname.h>
#include <vector>

namespace berm::io {
namespace {

/// "6.1.0-18-amd64" becomes 6.1.
std::string first_two_numbers(const std::string& release)
{
  std::size_t end = release.find_first_not_of("0123456789.");
  end = std::min(end, release.size());
  const std::size_t first = release.find('.');
  if (first != std::string::npos) end = std::min(end, release.find('.', first + 1));
  return release.substr(0, end);
}

}  // namespace

std::string processor_model(const std::string& cpuinfo)
{
  std::istringstream lines(cpuinfo);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with("model name") || colon == std::string::npos) continue;
    std::istringstream words(line.substr(colon + 1));
    std::string model;
    for (std::string word; words >> word;) model += (model.empty() ? "" : " ") + word;
    return model;
  }
  return "";
}

std::string host_description()
{
  std::vector<std::string> parts;
  if (const std::string model = processor_model(read_text_file("/proc/cpuinfo")); !model.empty()) parts.push_back(model);
  const int processors = processor_count();
  parts.push_back(fmt::format("{} processor{}", processors, processors == 1 ? "" : "s"));
  if (utsname name{}; uname(&name) == 0)
    parts.push_back(fmt::format("{} {} {}", name.sysname, first_two_numbers(name.release), name.machine));
  return text_of_list(parts, ", ");
}

std::string utc_date(std::chrono::system_clock::time_point time)
{
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday, utc.tm_hour, utc.tm_min,
                     utc.tm_sec);
}

}  // namespace berm::io
