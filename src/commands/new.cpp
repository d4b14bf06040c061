// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/new_test.cpp
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "io/atomic_file.hpp"
#include "io/log.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "site/sounding.hpp"
#include "start/cpt.hpp"
#include "start/soils.hpp"

#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace berm::commands {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
  std::string kind, file, size = "normal", soil, cpt, location, phi;
  std::optional<Real> N_kt;
  bool soils = false, json = false;
};

void list_kinds()
{
  std::string group;
  for (const start::Kind& one : start::kinds()) {
    if (one.group != group) fmt::print("{}\n", one.group);
    group = one.group;
    fmt::print("  {:<28} {}\n", one.name, one.question);
  }
  fmt::print("berm new KIND [FILE] writes one of them.\n");
}

nlohmann::ordered_json kinds_as_json()
{
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const start::Kind& one : start::kinds())
    all.push_back({{"kind", one.name},
                   {"title", one.title},
                   {"group", one.group},
                   {"question", one.question},
                   {"sizes", start::sizes},
                   {"soils", start::soils_for(one)},
                   {"sounding", start::takes_sounding(one.text)},
                   {"example", one.example}});
  return all;
}

/// The line by which editors find the schema of a case, which lies where this program was built or installed; "" where it does not.
std::string schema_line()
{
  std::error_code error;
  const fs::path folder = fs::canonical("/proc/self/exe", error).parent_path();
  for (const char* share : {"../share", "share"})
    if (const fs::path schema = (folder / share / "berm" / "case.schema.json").lexically_normal(); fs::exists(schema, error)) {
      std::string url = "file://";
      for (const char c : schema.string())
        url += std::isalnum(static_cast<unsigned char>(c)) || std::string_view("/._-~").find(c) != std::string_view::npos
                   ? std::string(1, c)
                   : fmt::format("%{:02X}", static_cast<unsigned char>(c));
      return fmt::format("#:schema {}\n", url);
    }
  return "";
}

void list_soils()
{
  for (const start::Soil& one : start::soils())
    fmt::print("  {:<24} {}\n  {:24} {}\n  {:24} {}\n", one.name, one.title, "", one.source, "", one.trust);
  fmt::print("berm new KIND --soil NAME writes a case with one of them.\n");
}

nlohmann::ordered_json soils_as_json()
{
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const start::Soil& one : start::soils())
    all.push_back({{"soil", one.name}, {"material", one.material}, {"title", one.title}, {"source", one.source}, {"trust", one.trust}});
  return all;
}

const std::vector<std::pair<std::string, site::Correlation>> correlations = {
    {"kulhawy-mayne", site::Correlation::kulhawy_mayne}, {"robertson-campanella", site::Correlation::robertson_campanella}};

std::vector<std::string> names_of_correlations()
{
  std::vector<std::string> all;
  for (const auto& [name, correlation] : correlations) all.push_back(name);
  return all;
}

/// The case with the strength of a sounding; says which of its rows count, and what is doubted.
std::string with_sounding(const NewOptions& options, const start::Kind& kind, const std::string& text)
{
  start::CptChoice choice = {options.N_kt, {}};
  for (const auto& [name, correlation] : correlations)
    if (name == options.phi) choice.correlation = correlation;
  const site::Sounding sounding = site::read_sounding(options.cpt, options.location);
  start::CptCase written = start::with_cpt(kind, text, sounding, choice);
  fmt::print("{}; {}\n", site::rows_of(sounding), sounding.corrected);
  for (const std::string& doubt : written.doubts) io::warn("{}: {}", sounding.file, doubt);
  return std::move(written.text);
}

void write_case(const NewOptions& options)
{
  const start::Kind& kind = start::kind_called(options.kind);
  for (const auto& [given, option] :
       {std::pair(!options.location.empty(), "--location"), {!options.phi.empty(), "--phi"}, {options.N_kt.has_value(), "--n-kt"}})
    if (given && options.cpt.empty()) throw InputError(fmt::format("{} goes with --cpt FILE", option));
  std::string text = start::at_size(kind, options.size);
  if (!options.soil.empty()) text = start::with_soil(kind, text, options.soil);
  if (!options.cpt.empty()) text = with_sounding(options, kind, text);
  const fs::path path = options.file.empty() ? fs::path(kind.name + ".toml") : fs::path(options.file);
  if (fs::exists(fs::symlink_status(path))) throw InputError(fmt::format("{} already exists: name another file", path.string()));
  io::write_atomically(path, schema_line() + text);
  fmt::print("{0} is written. Change what is marked with <-, then\n  berm check {0}\n  berm run {0} -o out/{1}\n  berm report out/{1}\n",
             path.string(), path.stem().string());
}

/// Writes a case, or lists what there is where none is named.
int act(const NewOptions& options)
{
  messages_to_stderr();
  if (!options.kind.empty() && (options.soils || options.json))
    throw InputError("berm new KIND writes a case: --soils and --json list what there is, without a KIND");
  if (!options.kind.empty())
    write_case(options);
  else if (options.json)
    fmt::print("{}\n", (options.soils ? soils_as_json() : kinds_as_json()).dump(2));
  else
    options.soils ? list_soils() : list_kinds();
  return 0;
}

std::vector<std::string> names_of_kinds()
{
  std::vector<std::string> all;
  for (const start::Kind& one : start::kinds()) all.push_back(one.name);
  return all;
}

}  // namespace

Command add_new(CLI::App& program)
{
  const auto options = std::make_shared<NewOptions>();
  CLI::App* app = program.add_subcommand("new", "write a commented case to start from; without a KIND, list the kinds");
  app->add_option("KIND", options->kind, "the kind of case")->type_name(fmt::format("{{{}}}", text_of_list(names_of_kinds(), ",")));
  app->add_option("FILE", options->file, "file to write (default: KIND.toml here)");
  app->add_option("--size", options->size, "size of the cells, and speed (default: normal)")
      ->type_name(fmt::format("{{{}}}", text_of_list(start::sizes, ",")));
  app->add_option("--soil", options->soil, "a soil of `berm new --soils`, instead of the clay or the sand of the kind");
  app->add_option("--cpt", options->cpt, "strength from a cone penetration test: a file of AGS 4 (.ags), GEF (.gef) or a table (.csv)")
      ->type_name("FILE");
  app->add_option("--location", options->location, "which sounding of an AGS file: LOCA_ID, with several tests LOCA_ID/SCPG_TESN");
  app->add_option("--n-kt", options->N_kt, "cone factor of clay, s_u = (q_t - sigma_v0) / N_kt (default: 14)")
      ->check(number_within({start::least_N_kt, start::most_N_kt}));
  app->add_option("--phi", options->phi, "correlation of sand (default: kulhawy-mayne)")->check(one_of(names_of_correlations()));
  app->add_flag("--soils", options->soils, "list the soils that have names, with their sources");
  app->add_flag("--json", options->json, "list as JSON");
  return {app, [options] { return act(*options); }};
}

}  // namespace berm::commands
