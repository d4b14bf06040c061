// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/export_test.cpp
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "springs/formats.hpp"
#include "study/study_settings.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <spdlog/spdlog.h>

namespace berm::commands {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> folders;
  std::string format = "table", output;
  springs::Selection selection;
};

/// What is written, and where.
struct Job {
  springs::Design design;
  fs::path from, folder;
};

/// All are read before the first is written. Each goes to OUTPUT, or DIR/export; several to folders there that are named like them.
std::vector<Job> jobs_of(const Options& options, const springs::Format& format)
{
  std::vector<Job> jobs;
  for (const std::string& from : options.folders) {
    if (!fs::is_directory(from))
      throw InputError(fmt::format("{} is no folder: berm export takes run folders and outputs of berm study", from));
    for (springs::Design& design : springs::designs_in(from, options.selection)) {
      check_taken(design, format);
      jobs.push_back({std::move(design), from, options.output.empty() ? fs::path(from) / "export" : fs::path(options.output)});
    }
  }
  std::map<fs::path, std::size_t> in_folder;
  for (const Job& job : jobs) ++in_folder[job.folder];
  std::set<fs::path> taken;
  for (Job& job : jobs) {
    if (in_folder[job.folder] > 1) job.folder /= study::as_file_name(job.design.name);
    if (!taken.insert(job.folder).second)
      throw InputError(fmt::format("{} and another would both be written to {}", job.from.string(), job.folder.string()));
  }
  return jobs;
}

void write(const springs::Design& design, const springs::Format& format, const fs::path& folder)
{
  for (const std::string& line : design.best.missing) spdlog::warn("{}: {}", design.name, line);
  io::make_folder(folder);
  for (const springs::ExportFile& file : format.files(design)) {
    io::write_atomically(folder / file.name, file.text);
    fmt::print("{}\n", (folder / file.name).string());
  }
  for (const std::string& picture : draw_springs(design, folder)) fmt::print("{}\n", (folder / picture).string());
}

}  // namespace

Command add_export(CLI::App& program)
{
  const auto options = std::make_shared<Options>();
  CLI::App* app = program.add_subcommand("export", "write the springs of runs, or low, best and high of a study, for pipeline programs");
  app->add_option("DIR", options->folders, "run folders, or outputs of berm study with a sample")->required();
  std::string words;
  std::vector<std::string> names;
  for (const springs::Format& format : springs::formats) {
    names.emplace_back(format.name);
    words += fmt::format("{}{}: {}", words.empty() ? "" : "; ", format.name, format.meaning);
  }
  app->add_option("--to", options->format, words + " (default: table)")->check(CLI::IsMember(names));
  app->add_option("--state", options->selection.state,
                  "state of the pipe: touchdown, laid, flooded, emptied, operation, after_DRAG (default: operation, else touchdown)");
  app->add_option("--travels", options->selection.travels, "drags, with commas between them (default: those in that state)")
      ->delimiter(',')
      ->transform([](const std::string& name) { return CLI::detail::trim_copy(name); });
  app->add_option("-o,--output", options->output, "folder for the files (default: DIR/export)");
  return {app, [options] {
            messages_to_stderr();
            const auto* format = std::find_if(std::begin(springs::formats), std::end(springs::formats),
                                              [&](const springs::Format& one) { return one.name == options->format; });
            options->selection.whole_life = format->whole_life && options->selection.state.empty();
            for (const Job& job : jobs_of(*options, *format)) write(job.design, *format, job.folder);
            return 0;
          }};
}

}  // namespace berm::commands
