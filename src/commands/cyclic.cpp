// SPDX-License-Identifier: BSD-3-Clause
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "cyclic/cyclic_report.hpp"
#include "io/atomic_file.hpp"
#include "io/tell.hpp"
#include "os/error.hpp"

#include <chrono>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::commands {
namespace {

int cyclic_strength(const CaseOptions& options)
{
  namespace fs = std::filesystem;
  messages_to_stderr();
  const fs::path file = options.files.front(), folder = !options.output.empty() ? fs::path(options.output) : default_folder(file);
  if (io::holds_page(folder, cyclic::page_file, "berm cyclic") && !options.force)
    throw InputError(
        fmt::format("{} holds results of berm cyclic: replace them with --force, or name another folder with -o", folder.string()));
  const auto begin = std::chrono::steady_clock::now();
  cyclic::CyclicResults results;
  results.settings = cyclic::read_cyclic_case(file, options.overrides);
  for (const std::string& set : options.overrides) results.input += fmt::format("# --set {}\n", nlohmann::json(set).dump());
  results.input += io::read_text_file(file);
  try {
    results.strength = cyclic::strength_in(results.settings.diagram, results.settings.parcels(), results.settings.failure);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
  results.wall_s = std::chrono::duration<Real>(std::chrono::steady_clock::now() - begin).count();
  cyclic::write_results(results, folder);
  fmt::print("{}", cyclic::words_of_results(results));
  io::tell("the page is {}\n", (folder / cyclic::page_file).string());
  return 0;
}

}  // namespace

Command add_cyclic(CLI::App& program)
{
  const auto options = std::make_shared<CaseOptions>();
  CLI::App* app = program.add_subcommand("cyclic", "cyclic strength of clay for a storm, by contours of cyclic tests");
  app->add_option("INPUT", options->files, "an input FILE.toml: a storm as parcels of cycles, and a table of contours")
      ->required()
      ->expected(1);
  app->add_option("--set", options->overrides, "KEY=VALUE: replace or add a value of the input")->allow_extra_args(false);
  app->add_option("-o,--output", options->output, "folder for the results (default: out/FOLDER/NAME of the input)");
  app->add_flag("--force", options->force, "replace earlier results in the folder");
  return {app, [options] { return cyclic_strength(*options); }};
}

}  // namespace berm::commands
