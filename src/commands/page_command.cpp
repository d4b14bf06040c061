// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/cyclic_test.cpp
#include "commands/page_command.hpp"

#include "io/atomic_file.hpp"
#include "io/tell.hpp"
#include "os/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::commands {
namespace {

int make_page(const PageCommand& command, const CaseOptions& options)
{
  namespace fs = std::filesystem;
  messages_to_stderr();
  const fs::path file = options.files.front(), folder = !options.output.empty() ? fs::path(options.output) : default_folder(file);
  const std::string program = std::string("berm ") + command.name;
  if (io::holds_page(folder, command.page, program) && !options.force)
    throw InputError(
        fmt::format("{} holds results of {}: replace them with --force, or name another folder with -o", folder.string(), program));
  std::string text;
  for (const std::string& set : options.overrides) text += fmt::format("# --set {}\n", nlohmann::json(set).dump());
  text += io::read_text_file(file);
  fmt::print("{}", command.make(options, text, folder));
  io::tell("the page is {}\n", (folder / command.page).string());
  return 0;
}

}  // namespace

Command add_page_command(CLI::App& program, const PageCommand& command)
{
  const auto options = std::make_shared<CaseOptions>();
  CLI::App* app = program.add_subcommand(command.name, command.meaning);
  app->add_option("INPUT", options->files, command.input)->required()->expected(1);
  app->add_option("--set", options->overrides, "KEY=VALUE: replace or add a value of the input")->allow_extra_args(false);
  app->add_option("-o,--output", options->output, "folder for the results (default: out/FOLDER/NAME of the input)");
  app->add_flag("--force", options->force, "replace earlier results in the folder");
  return {app, [command, options] { return make_page(command, *options); }};
}

}  // namespace berm::commands
