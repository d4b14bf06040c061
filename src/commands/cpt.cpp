// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/python/test_program.py
#include "start/cpt.hpp"
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "cpt/cpt_report.hpp"
#include "io/atomic_file.hpp"
#include "io/log.hpp"
#include "io/tell.hpp"
#include "os/error.hpp"

#include <fmt/format.h>

namespace berm::commands {
namespace {

struct CptOptions {
  std::string file, location, phi, output;
  Real N_kt = start::usual_N_kt, thinnest = cpt::Choice{}.thinnest;
  bool force = false;
};

int layers_of_sounding(const CptOptions& options)
{
  namespace fs = std::filesystem;
  messages_to_stderr();
  const fs::path folder = options.output.empty() ? default_folder(options.file) : fs::path(options.output);
  if (io::holds_page(folder, cpt::page_file, "berm cpt") && !options.force)
    throw InputError(
        fmt::format("{} holds results of berm cpt: replace them with --force, or name another folder with -o", folder.string()));
  cpt::CptResults results{
      site::read_sounding(options.file, options.location), {options.N_kt, start::usual_correlation, options.thinnest}, {}};
  if (options.phi == "robertson-campanella") results.choice.correlation = site::Correlation::robertson_campanella;
  results.profile = cpt::profile_of(results.sounding, results.choice);
  for (const std::string& doubt : results.profile.doubts) io::warn("{}: {}", options.file, doubt);
  cpt::write_results(results, folder);
  fmt::print("{}", cpt::words_of_results(results));
  io::tell("the page is {}\n", (folder / cpt::page_file).string());
  return 0;
}

}  // namespace

Command add_cpt(CLI::App& program)
{
  const auto options = std::make_shared<CptOptions>();
  CLI::App* app = program.add_subcommand("cpt", "layers of a cone penetration test: soil behaviour type, unit weight, strength, stiffness");
  app->add_option("FILE", options->file, "a file of AGS 4 (.ags), GEF (.gef) or a table (.csv), with sleeve friction")->required();
  app->add_option("--location", options->location, "which sounding of an AGS file: LOCA_ID, with several tests LOCA_ID/SCPG_TESN");
  app->add_option("--n-kt", options->N_kt, "cone factor of clay, s_u = (q_t - sigma_v0) / N_kt (default: 14)")
      ->check(number_within({start::least_N_kt, start::most_N_kt}));
  app->add_option("--phi", options->phi, "correlation of sand (default: kulhawy-mayne)")
      ->check(one_of({"kulhawy-mayne", "robertson-campanella"}));
  app->add_option("--thinnest", options->thinnest, "thickness in m below which a layer joins a neighbour (default: 0.2)")
      ->check(number_within({0, 100}));
  app->add_option("-o,--output", options->output, "folder for the results (default: out/FOLDER/NAME of the sounding)");
  app->add_flag("--force", options->force, "replace earlier results in the folder");
  return {app, [options] { return layers_of_sounding(*options); }};
}

}  // namespace berm::commands
