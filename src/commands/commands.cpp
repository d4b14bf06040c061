// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "commands/commands.hpp"

#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "core/ranks.hpp"
#include "input/message_text.hpp"
#include "io/atomic_file.hpp"
#include "io/revision.hpp"
#include "io/tell.hpp"
#include "jobs/outcome.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"
#include "os/text_of_list.hpp"
#include "sandbox/sandbox.hpp"
#include "simulation/run_of_ranks.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fmt/format.h>
#include <memory>
#include <new>
#include <sstream>

namespace berm::commands {
namespace {

/// All commands, in the order in which --help lists them.
constexpr Command (*all_commands[])(CLI::App&) = {
    add_new,     add_draw, add_check,  add_run, add_report, add_export, add_fmu,  add_macro_element, add_study,  add_envelope,   add_safety,
    add_element, add_fit,  add_cyclic, add_cpt, add_sea,    add_route,  add_desk, add_verify,        add_params, add_completion, add_man};

/// What is wrong with the command line, in one line and with the nearest word that exists.
std::string words_of(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv)
{
  std::vector<std::string> commands;
  const CLI::App* command = nullptr;
  for (const CLI::App* of : app.get_subcommands([](const CLI::App*) { return true; })) commands.push_back(of->get_name());
  const std::string first = argc > 1 ? argv[1] : "";
  for (const CLI::App* of : app.get_subcommands([](const CLI::App*) { return true; }))
    if (of->get_name() == first) command = of;
  if (first.empty()) return fmt::format("a command is needed ({}); berm --help explains them", text_of_list(commands, ", "));
  if (command == nullptr && first[0] != '-')
    return fmt::format("unknown command {}{}", input::in_quotes(first), input::suggestion(first, commands));
  std::vector<std::string> options;
  for (const CLI::Option* option : (command == nullptr ? &app : command)->get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  for (int k = 1; k < argc; ++k) {
    const std::string word = std::string(argv[k]).substr(0, std::string(argv[k]).find('='));
    if (word.starts_with("--") && word.size() > 2 && std::find(options.begin(), options.end(), word) == options.end())
      return fmt::format("unknown option {}{}", input::in_quotes(word), input::suggestion(word, options));
  }
  return in_words(error);
}

/// Only what computes one problem at a time is done by several ranks.
void refuse_ranks(const std::string& command)
{
  if (Ranks::of_run().count() > 1 && command != "run" && command != "check")
    throw InputError(
        fmt::format("an MPI launcher started {} processes of berm {}, which runs as one process: start it without the launcher",
                    Ranks::of_run().count(), command));
}

int dispatch(int argc, char** argv)
{
  CLI::App app("berm pushes a pipe or cable into the seabed, drags it sideways, and computes how the soil responds.", "berm");
  app.footer("A command explains itself: berm run --help. A first run: berm run examples/bar/case.toml");
  app.formatter(std::make_shared<Help>());
  app.set_version_flag("--version", "berm " + io::version_words());
  app.require_subcommand(1);
  std::vector<Command> commands;
  for (const auto add : all_commands) commands.push_back(add(app));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    if (argc > 1 && std::string(argv[1]) == "help") return fmt::print("{}", app.help()), 0;
    throw InputError(words_of(app, error, argc, argv));
  }
  for (const Command& command : commands)
    if (command.app->parsed()) {
      refuse_ranks(command.app->get_name());
      return command.act();
    }
  return 2;
}

/// What the sandbox kept from happening, where `why` does not say it yet.
std::string words_of_sandbox(const std::string& why, const std::string& stopped)
{
  std::string words = why;
  std::istringstream lines(stopped);
  for (std::string line; std::getline(lines, line);)
    if (why.find(line) == std::string::npos) words += fmt::format("{}stopped by the sandbox: {}", words.empty() ? "" : "\n", line);
  return words + "; " + sandbox::how_to_do_without;
}

/// `why` is what was said of a failure.
int status_of_command(int argc, char** argv, std::string& why)
{
  try {
    simulation::join_ranks();
    const int status = dispatch(argc, argv);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) io::throw_errno("cannot write to the standard output");
    return status;
  } catch (const InputError& error) {
    why = error.what();
    return 2;
  } catch (const Interrupted& error) {
    why = fmt::format("{}; the same command starts again", error.what());
    return status_of(jobs::Outcome::unfinished);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    why = error.what();
    return 1;
  }
}

/// To say so may take no memory.
void say_without_memory()
{
  std::fputs("berm: out of memory; berm check CASE prints how much a run needs\n", stderr);
}

volatile std::sig_atomic_t memory_failed = 0;

void note_failed_memory()
{
  memory_failed = 1;
  throw std::bad_alloc();
}

/// Libraries ask for memory in functions that may not throw; what was thrown is not known here.
[[noreturn]] void end_without_memory()
{
  if (memory_failed == 0) std::abort();
  say_without_memory();
  std::_Exit(1);
}

}  // namespace

int run_commands(int argc, char** argv)
{
  std::set_new_handler(note_failed_memory);
  std::set_terminate(end_without_memory);
  try {
    if (const std::optional<int> status = sandbox::run_inside(argc, argv)) return *status;
    sandbox::guard_case_programs();
    std::string why;
    int status = status_of_command(argc, argv, why);
    if (const std::string stopped = sandbox::stopped(); !stopped.empty()) {
      why = words_of_sandbox(why, stopped);
      status = 1;
    }
    sandbox::leave();
    if (!why.empty()) io::tell("berm: {}\n", why);
    return simulation::leave_ranks(status, why);
  } catch (const std::bad_alloc&) {
    say_without_memory();
    std::_Exit(simulation::leave_ranks(1, "out of memory"));  // what is taken apart at the end of a program may ask for memory
  }
}

}  // namespace berm::commands
