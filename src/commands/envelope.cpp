// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_test.cpp
#include "envelope/envelope.hpp"

#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "input/read_case.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"

#include <fmt/format.h>

namespace berm::commands {

Command add_envelope(CLI::App& program)
{
  struct Options : CaseOptions {
    envelope::EnvelopeSettings how;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* app =
      program.add_subcommand("envelope", "find the yield envelope of the pipe (V-H) or footing (V-H-M) of a case, at its position");
  options->take_cases(*app);
  options->take_jobs(*app);
  options->take_runner(*app);
  app->add_option("-o,--output", options->output, "folder for the envelope and its runs (default: out/envelope/CASE)");
  app->add_option("--points", options->how.directions,
                  "directions between straight down and 45 degrees upwards, of a footing between straight down and sideways (default: 10)")
      ->check(whole_number_within(2, 50));
  app->add_option("--turns", options->how.turns, "of a footing: directions with rotation, and swipes with it (default: 5; 0: V-H only)")
      ->check(whole_number_within(0, 50));
  app->add_option("--travel", options->how.travel, "travel of each probe divided by the diameter (default: 0.1)")
      ->check(number_within({1e-3, 1}));
  return {app, [options] {
            catch_interrupts();
            messages_to_stderr();
            if (options->files.size() > 1)
              throw InputError(fmt::format("an envelope is for one case, and {} are given", options->files.size()));
            const std::filesystem::path file = options->files[0], folder = options->output.empty()
                                                                               ? std::filesystem::path("out/envelope") / file.stem()
                                                                               : std::filesystem::path(options->output);
            auto [settings, places] = input::case_of(file, options->overrides);
            try {
              return status_of(envelope::find_envelope({std::move(settings), file, folder, options->how, options->runner(), places}));
            } catch (const KeyError& error) {
              throw input::LocatedError(places.located(error));
            }
          }};
}

}  // namespace berm::commands
