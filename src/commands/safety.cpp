// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/safety/find_safety_test.cpp
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "input/read_case.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"
#include "safety/find_safety.hpp"

#include <fmt/format.h>

namespace berm::commands {
namespace {

/// Throws InputError where the options of the search contradict each other.
void check_search(const safety::SearchSettings& how)
{
  if (!(how.low < how.high))
    throw InputError(
        fmt::format("--low {} is not below --high {}: the search starts between them, with --low the smaller", how.low, how.high));
}

}  // namespace

Command add_safety(CLI::App& program)
{
  struct Options : CaseOptions {
    safety::SearchSettings how;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* app =
      program.add_subcommand("safety", "find the factor of safety of a case: by how much its strength can be reduced until the soil fails");
  options->take_cases(*app);
  options->take_jobs(*app);
  options->take_runner(*app);
  app->add_option("-o,--output", options->output, "folder for the answer and its trials (default: out/safety/CASE)");
  const CLI::Validator factors = number_within({safety::min_factor, safety::max_factor});
  app->add_option("--low", options->how.low, "lower factor of the search (default: 1)")->check(factors);
  app->add_option("--high", options->how.high, "upper factor of the search (default: 2)")->check(factors);
  app->add_option("--tolerance", options->how.tolerance, "largest difference of the two final factors (default: 0.01)")
      ->check(number_within({safety::smallest_tolerance, 0.5}));
  return {app, [options] {
            catch_interrupts();
            messages_to_stderr();
            if (options->files.size() > 1)
              throw InputError(fmt::format("a factor of safety is for one case, and {} are given", options->files.size()));
            check_search(options->how);
            const std::filesystem::path file = options->files[0];
            const std::filesystem::path folder =
                options->output.empty() ? std::filesystem::path("out/safety") / file.stem() : std::filesystem::path(options->output);
            std::vector<std::string> overrides = options->overrides;
            overrides.push_back(fmt::format("safety.factor={}", options->how.low));
            auto [settings, places] = input::case_of(file, overrides);
            try {
              return status_of(safety::find_safety({std::move(settings), file, folder, options->how, options->runner()}));
            } catch (const KeyError& error) {
              throw input::LocatedError(places.located(error));
            }
          }};
}

}  // namespace berm::commands
