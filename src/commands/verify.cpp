// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_test.cpp
#include "verification/verify.hpp"

#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "os/interrupt.hpp"
#include "os/text_of_list.hpp"

#include <fmt/format.h>

namespace berm::commands {

Command add_verify(CLI::App& program)
{
  struct Options : CaseOptions {
    verification::ProblemChoice problems;
    bool list = false, requirements = false, quote = false;
  };
  const auto options = std::make_shared<Options>();
  options->output = "out/verification";
  CLI::App* app = program.add_subcommand("verify", "run examples and compare their results with what they expect");
  app->add_option("NAME", options->problems.names, "examples, problems (EXAMPLE/RUN) or folders that hold an expected.toml (default: all)");
  app->add_flag("--list", options->list, "list the problems and run nothing");
  app->add_flag("--requirements", options->requirements,
                "print the requirements of the problems and the results of their last runs, and run nothing");
  CLI::Option* fast = app->add_flag("--fast", options->problems.fast, "fast problems only");
  app->add_flag("--long", options->problems.with_long, "long problems, too, which otherwise run only when named")->excludes(fast);
  app->add_option("--chapter", options->problems.chapter,
                  fmt::format("one chapter of the book: {}", text_of_list(expectations::chapter_words, ", ")));
  app->add_flag("--force", options->force, "rerun problems that have a result already");
  app->add_flag("--quote", options->quote, "update the numbers of the runs in the pages that quote them");
  app->add_option("--examples", options->problems.examples, "folder of the examples (default: examples)");
  app->add_option("-o,--output", options->output, "folder for the book and its runs (default: out/verification)");
  options->take_jobs(*app);
  options->take_runner(*app);
  return {app, [options] {
            if (options->list) return list_problems(options->problems), 0;
            if (options->requirements) return list_requirements(options->problems, options->output), 0;
            catch_interrupts();
            messages_to_stderr();
            return status_of(verification::verify({options->problems, options->output, options->runner(), options->force, options->quote}));
          }};
}

}  // namespace berm::commands
