// SPDX-License-Identifier: BSD-3-Clause
#include "commands/page_command.hpp"
#include "sea/sea_report.hpp"

#include <chrono>

namespace berm::commands {
namespace {

std::string sea_state(const CaseOptions& options, const std::string& text, const std::filesystem::path& folder)
{
  const auto begin = std::chrono::steady_clock::now();
  sea::SeaResults results{
      .settings = sea::read_sea_case(options.files.front(), options.overrides), .input = text, .answer = {}, .moved = {}};
  results.answer = sea::answer_of(results.settings);
  results.moved = sea::displacements_of(results.settings, results.answer);
  results.wall_s = std::chrono::duration<Real>(std::chrono::steady_clock::now() - begin).count();
  sea::write_results(results, folder);
  return sea::words_of_results(results);
}

}  // namespace

Command add_sea(CLI::App& program)
{
  return add_page_command(program, {.name = "sea",
                                    .meaning = "loads of a sea state on a pipe on the seabed, and on-bottom stability by DNV-RP-F109",
                                    .input = "an input FILE.toml: sea state, current, pipe and seabed",
                                    .page = sea::page_file,
                                    .make = sea_state});
}

}  // namespace berm::commands
