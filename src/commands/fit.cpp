// SPDX-License-Identifier: BSD-3-Clause
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "io/atomic_file.hpp"
#include "io/tell.hpp"
#include "os/error.hpp"
#include "soil_fit/fit_report.hpp"
#include "soil_fit/usual_fit.hpp"
#include "user_law/load.hpp"

#include <chrono>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::commands {
namespace {

namespace fs = std::filesystem;

struct FitOptions {
  CaseOptions common;
  std::vector<std::string> words;
  soil_fit::UsualFit usual;
  const CLI::App* app = nullptr;
};

/// The input and its text: a file, or what the words LAW TESTS.csv stand for.
std::pair<soil_fit::FitCase, std::string> input_of(FitOptions& options, const fs::path& folder)
{
  const std::string& first = options.words.front();
  if (fs::path(first).extension() == ".toml") {
    if (options.words.size() > 1) throw InputError("one input FILE.toml, or a law and its tests: LAW TESTS.csv");
    if (options.app->count("--kind") + options.app->count("--undrained") + options.app->count("--extension") + options.app->count("--k0") +
            options.app->count("--diameter") >
        0)
      throw InputError("--kind, --undrained, --extension, --k0 and --diameter are of LAW TESTS.csv: an input says it for each file, kind = "
                       "\"triaxial\", drained = false");
    return {soil_fit::read_fit_case(first, options.common.overrides), io::read_text_file(first)};
  }
  options.usual.law = first;
  options.usual.files.assign(options.words.begin() + 1, options.words.end());
  if (options.usual.files.empty()) throw InputError(fmt::format("what is {} to be fitted to? berm fit {} TESTS.csv", first, first));
  const std::string text = soil_fit::usual_fit(options.usual);
  return {soil_fit::read_fit_text((folder / "case.toml").string(), text, fs::current_path(), options.common.overrides), text};
}

int fit(FitOptions& options)
{
  messages_to_stderr();
  const fs::path folder = !options.common.output.empty() ? fs::path(options.common.output) : default_folder(options.words.back());
  if (soil_fit::holds_results(folder) && !options.common.force)
    throw InputError(
        fmt::format("{} holds the results of a fit: replace them with --force, or name another folder with -o", folder.string()));
  const auto begin = std::chrono::steady_clock::now();
  soil_fit::FitResults results;
  std::tie(results.settings, results.input) = input_of(options, folder);
  if (user_law::names_library(results.settings.material))
    throw InputError(
        fmt::format("material.{}.law: a law from a library has a list of properties, which has no keys to fit: fit one of berm's laws",
                    results.settings.material_name()));
  const std::vector<soil_fit::MeasuredTest> tests = soil_fit::read_measured(results.settings);
  for (const std::string& set : options.common.overrides)
    results.input = fmt::format("# --set {}\n", nlohmann::json(set).dump()) + results.input;
  results.soil = soil_fit::fit_soil(results.settings, tests);
  results.wall_s = std::chrono::duration<Real>(std::chrono::steady_clock::now() - begin).count();
  soil_fit::write_results(results, folder);
  fmt::print("{}", soil_fit::words_of_results(results));
  io::tell("the page is {}\n", (folder / "fit.html").string());
  return 0;
}

}  // namespace

Command add_fit(CLI::App& program)
{
  const auto options = std::make_shared<FitOptions>();
  CLI::App* app = program.add_subcommand("fit", "parameters of a soil from measured tests, with their standard errors");
  app->add_option("INPUT", options->words, "an input FILE.toml; or a law and its tests, LAW TESTS.csv..., with usual numbers and bounds")
      ->required();
  app->add_option("--set", options->common.overrides, "KEY=VALUE: replace or add a value of the input")->allow_extra_args(false);
  app->add_option("--kind", options->usual.kind, "of LAW TESTS.csv: which tests these are (default: triaxial)")
      ->check(one_of({"triaxial", "biaxial", "simple_shear", "oedometer", "isotropic", "t_bar", "ball"}));
  app->add_flag("--undrained", options->usual.undrained, "of LAW TESTS.csv: the tests are undrained");
  app->add_flag("--extension", options->usual.extends, "of LAW TESTS.csv: the tests are in extension");
  app->add_option("--k0", options->usual.k0,
                  "of LAW TESTS.csv: ratio of horizontal to vertical stress at the start of an oedometer or simple shear test");
  app->add_option("--diameter", options->usual.diameter, "of LAW TESTS.csv --kind t_bar or ball: diameter of the tool, such as \"40 mm\"");
  app->add_option("-o,--output", options->common.output,
                  "folder for the results (default: out/FOLDER/NAME of the input or of the last file)");
  app->add_flag("--force", options->common.force, "replace the results of an earlier fit in the folder");
  options->app = app;
  return {app, [options] { return fit(*options); }};
}

}  // namespace berm::commands
