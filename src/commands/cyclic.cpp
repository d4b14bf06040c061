// SPDX-License-Identifier: BSD-3-Clause
#include "commands/page_command.hpp"
#include "cyclic/cyclic_report.hpp"
#include "os/error.hpp"

#include <chrono>
#include <fmt/format.h>

namespace berm::commands {
namespace {

std::string cyclic_strength(const CaseOptions& options, const std::string& text, const std::filesystem::path& folder)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::string& file = options.files.front();
  cyclic::CyclicResults results{.settings = cyclic::read_cyclic_case(file, options.overrides), .input = text, .strength = {}};
  try {
    results.strength = cyclic::strength_in(results.settings.diagram, results.settings.parcels(), results.settings.failure);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
  results.wall_s = std::chrono::duration<Real>(std::chrono::steady_clock::now() - begin).count();
  cyclic::write_results(results, folder);
  return cyclic::words_of_results(results);
}

}  // namespace

Command add_cyclic(CLI::App& program)
{
  return add_page_command(program, {.name = "cyclic",
                                    .meaning = "cyclic strength of clay for a storm, by contours of cyclic tests",
                                    .input = "an input FILE.toml: a storm as parcels of cycles, and a table of contours",
                                    .page = cyclic::page_file,
                                    .make = cyclic_strength});
}

}  // namespace berm::commands
