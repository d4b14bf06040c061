// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_wrong_inputs_test.cpp
#include "commands/case_options.hpp"
#include "commands/command.hpp"

#include <algorithm>

namespace berm::commands {

Command add_check(CLI::App& program)
{
  const auto options = std::make_shared<CaseOptions>();
  CLI::App* app = program.add_subcommand(
      "check", "validate a case and print what a run would take; gmsh runs the geometry (.geo) that it names, and its laws are loaded");
  options->take_cases(*app);
  options->take_threads(*app);
  options->take_no_programs(*app);
  options->take_sandbox(*app);
  return {app, [options] {
            const std::vector<simulation::RunRequest> all = requests(*options);
            options->enter_sandbox(std::any_of(all.begin(), all.end(), brings_programs), {});
            simulation::Context context(options->threads);
            for (const simulation::RunRequest& request : all) check_case(request, context);
            return 0;
          }};
}

}  // namespace berm::commands
