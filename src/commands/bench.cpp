// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_wrong_inputs_test.cpp
#include "benchmark/benchmark.hpp"
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "commands/option_values.hpp"

namespace berm::commands {

Command add_bench(CLI::App& program)
{
  struct Options : CaseOptions {
    std::vector<std::string> names;
    std::string json;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* app = program.add_subcommand("bench", "measure the speed on fixed problems");
  app->add_option("NAME", options->names, "problems (default: all)")->check(one_of(benchmark::bench_names()));
  app->add_option("--json", options->json, "also write the table to this file");
  options->take_threads(*app);
  return {app, [options] {
            simulation::Context context(options->threads);
            benchmark::run_bench(options->names, options->json, context);
            return 0;
          }};
}

}  // namespace berm::commands
