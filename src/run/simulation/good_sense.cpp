// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "simulation/good_sense.hpp"

#include "io/atomic_file.hpp"
#include "io/tell.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "simulation/checkpoints.hpp"

#include <fmt/format.h>
#include <sstream>

namespace berm::simulation {
namespace {

namespace fs = std::filesystem;

fs::path warnings_in(const fs::path& run_folder)
{
  return checkpoints_in(run_folder) / "warnings.txt";
}

}  // namespace

Diagnostics diagnose(const sanity::Scene& scene)
{
  Diagnostics doubts;
  for (const sanity::Finding& finding : sanity::ask(scene))
    (finding.severity == sanity::Severity::refuse ? doubts.refusals : doubts.warnings)
        .push_back(scene.places.located(finding.key, finding.message));
  return doubts;
}

void throw_refusals(const Diagnostics& doubts)
{
  for (std::size_t k = 1; k < doubts.refusals.size(); ++k) io::tell("berm: {}\n", doubts.refusals[k].text());
  if (!doubts.refusals.empty()) throw input::LocatedError(doubts.refusals.front());
}

std::vector<std::string> warnings_of(const sanity::Scene& scene)
{
  const Diagnostics doubts = diagnose(scene);
  throw_refusals(doubts);
  std::vector<std::string> warnings;
  for (const input::Located& warning : doubts.warnings) warnings.push_back(warning.text());
  return warnings;
}

Real free_disk(const fs::path& folder)
{
  std::error_code error;
  fs::path there = fs::absolute(folder, error).lexically_normal();
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  const fs::space_info space = fs::space(there, error);
  return error || space.capacity == 0 ? infinity : static_cast<Real>(space.available);  // /proc has no size
}

void note_warnings(const fs::path& run_folder, const std::vector<std::string>& warnings)
{
  io::write_atomically(warnings_in(run_folder), warnings.empty() ? "" : fmt::format("{}\n", text_of_list(warnings, "\n")));
}

std::vector<std::string> noted_warnings(const fs::path& run_folder)
{
  std::vector<std::string> warnings;
  std::error_code error;
  std::istringstream lines(fs::exists(warnings_in(run_folder), error) ? io::read_text_file(warnings_in(run_folder)) : "");
  for (std::string line; std::getline(lines, line);) warnings.push_back(one_line(line));
  return warnings;
}

}  // namespace berm::simulation
