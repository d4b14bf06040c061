// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/export_test.cpp
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "io/atomic_file.hpp"
#include "io/log.hpp"
#include "os/error.hpp"
#include "springs/line_formats.hpp"
#include "structures/structures.hpp"
#include "study/study_settings.hpp"
#include "workbook/workbook.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace berm::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char *xlsx = "xlsx", *imperial = "imperial";

struct Options {
  std::vector<std::string> folders;
  std::string format = "table", units, output;
  springs::Selection selection;
  std::optional<Real> interface_degrees;
};

/// What is written, and where.
struct Job {
  std::string name;
  fs::path from, folder = {};
  bool chosen = false;                    ///< the folder, by berm: inside of what is exported
  std::vector<std::string> missing = {};  ///< what is not written, and why
  springs::ExportFiles files = {};
  std::optional<springs::Design> drawn = {};
};

template <class List>
const auto* find_format(const List& formats, const std::string& name)
{
  const auto* found = std::find_if(std::begin(formats), std::end(formats), [&](const auto& format) { return format.name == name; });
  return found == std::end(formats) ? nullptr : found;
}

/// What chooses and changes springs is for formats that have them.
void refuse_without_effect(const Options& options)
{
  const bool has_springs = find_format(springs::formats, options.format) != nullptr;
  if (!options.units.empty() && options.format != xlsx)
    throw InputError("--units is for --to xlsx: the files of other programs have their own units");
  if (has_springs) return;
  if (!options.selection.state.empty() || !options.selection.travels.empty())
    throw InputError(fmt::format("--state and --travels choose springs: they cannot be combined with --to {}", options.format));
  if (options.selection.clay.strength_ratio || options.selection.clay.interface_angle)
    throw InputError(
        fmt::format("--strength-ratio and --interface-angle are of axial springs: they cannot be combined with --to {}", options.format));
}

/// What goes out of one folder.
std::vector<Job> jobs_from(const std::string& from, Options& options)
{
  std::vector<Job> jobs;
  if (options.format == xlsx) {
    const std::string name = fs::canonical(from).filename().string();
    const workbook::Units units = options.units == imperial ? workbook::Units::imperial : workbook::Units::si;
    jobs.push_back({.name = name, .from = from, .files = {{name + ".xlsx", xlsx_of(workbook::sheets_of(from, units))}}});
    return jobs;
  }
  if (const springs::LineFormat* format = find_format(springs::line_formats, options.format)) {
    const record::RunRecord run = structures::read_run(from);
    jobs.push_back({.name = run.name, .from = from, .files = format->files(run)});
    return jobs;
  }
  const springs::Format& format = *find_format(springs::formats, options.format);
  options.selection.whole_life = format.whole_life && options.selection.state.empty();
  for (springs::Design& design : springs::designs_in(from, options.selection)) {
    check_taken(design, format);
    springs::ExportFiles files = format.files(design);
    jobs.push_back(
        {.name = design.name, .from = from, .missing = design.best.missing, .files = std::move(files), .drawn = std::move(design)});
  }
  return jobs;
}

/// All are read before the first is written. Each goes to OUTPUT, or DIR/export; several to folders there that are named like them.
std::vector<Job> jobs_of(Options& options)
{
  std::vector<Job> jobs;
  for (const std::string& from : options.folders) {
    if (!fs::is_directory(from))
      throw InputError(fmt::format("{} is not a folder: berm export takes run folders and outputs of berm study", from));
    for (Job& job : jobs_from(from, options)) {
      job.chosen = options.output.empty();
      job.folder = job.chosen ? fs::path(from) / "export" : fs::path(options.output);
      jobs.push_back(std::move(job));
    }
  }
  std::map<fs::path, std::size_t> in_folder;
  for (const Job& job : jobs) ++in_folder[job.folder];
  std::set<fs::path> taken;
  for (Job& job : jobs) {
    if (in_folder[job.folder] > 1) job.folder /= study::as_file_name(job.name);
    if (!taken.insert(job.folder).second)
      throw InputError(fmt::format("{} and another would both be written to {}", job.from.string(), job.folder.string()));
  }
  return jobs;
}

void write(const Job& job)
{
  for (const std::string& line : job.missing) io::warn("{}: {}", job.name, line);
  if (job.chosen)
    io::make_inner_folder(job.folder.parent_path(), job.folder.filename());
  else
    io::make_folder(job.folder);
  for (const springs::ExportFile& file : job.files) {
    io::write_atomically(job.folder / file.name, file.text);
    fmt::print("{}\n", (job.folder / file.name).string());
  }
  if (job.drawn)
    for (const std::string& picture : draw_springs(*job.drawn, job.folder)) fmt::print("{}\n", (job.folder / picture).string());
}

}  // namespace

Command add_export(CLI::App& program)
{
  const auto options = std::make_shared<Options>();
  CLI::App* app = program.add_subcommand("export", "write the springs of runs, or low, best and high of a study, for pipeline programs; or "
                                                   "the results of a pipeline on slices, as tables");
  app->add_option("DIR", options->folders, "run folders, or outputs of berm study with a sample")->required();
  std::string words;
  std::vector<std::string> names;
  const auto list = [&](const auto& formats) {
    for (const auto& format : formats) {
      names.emplace_back(format.name);
      words += fmt::format("{}{}: {}", words.empty() ? "" : "; ", format.name, format.meaning);
    }
  };
  list(springs::formats), list(springs::line_formats);
  names.emplace_back(xlsx), words += "; xlsx: the numbers and all tables of a folder of any command, one sheet per table";
  app->add_option("--to", options->format, words + " (default: table)")->check(one_of(names));
  app->add_option("--units", options->units, "of --to xlsx: SI, or imperial (ft, lbf, lbf/ft ...) (default: SI)")
      ->check(one_of({"SI", imperial}));
  app->add_option("--state", options->selection.state,
                  "state of the pipe: touchdown, laid, flooded, emptied, operation, after_DRAG (default: operation, else touchdown)");
  app->add_option("--travels", options->selection.travels, "drags, separated by commas (default: those in that state)")
      ->delimiter(',')
      ->transform([](const std::string& name) { return CLI::detail::trim_copy(name); });
  springs::AxialClay& clay = options->selection.clay;
  CLI::Option* ratio = app->add_option("--strength-ratio", clay.strength_ratio,
                                       "s_u/sigma'_v of the normally consolidated clay at the pipe: axial resistance after consolidation")
                           ->check(number_within({0.01, 2}));
  app->add_option("--ocr-exponent", clay.exponent, "its exponent m of OCR^m, with OCR from V of the flooded pipe (default: 0)")
      ->needs(ratio)
      ->check(number_within({0, 2}));
  app->add_option("--consolidation", clay.consolidation, "its degree of consolidation U (default: 1)")
      ->needs(ratio)
      ->check(number_within({0, 1}));
  app->add_option("--interface-angle", options->interface_degrees,
                  "drained friction angle of pipe and clay, deg: the axial resistance after many cycles")
      ->check(number_within({1, 50}));
  app->add_option("-o,--output", options->output, "folder for the files (default: DIR/export)");
  return {app, [options] {
            messages_to_stderr();
            if (options->interface_degrees) options->selection.clay.interface_angle = *options->interface_degrees * degree;
            refuse_without_effect(*options);
            for (const Job& job : jobs_of(*options)) write(job);
            return 0;
          }};
}

}  // namespace berm::commands
