// SPDX-License-Identifier: BSD-3-Clause
#include "commands/commands.hpp"

#include "benchmark/benchmark.hpp"
#include "commands/side_by_side.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/threads.hpp"
#include "envelope/envelope.hpp"
#include "input/parameters.hpp"
#include "input/read_case.hpp"
#include "io/atomic_file.hpp"
#include "report/page/report.hpp"
#include "simulation/resume.hpp"
#include "simulation/simulate.hpp"
#include "study/study.hpp"
#include "verification/verify.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <new>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace berm::commands {
namespace {

namespace fs = std::filesystem;

/// All cases are read before the first one runs, so that a wrong one costs nothing. One case goes to `output` itself, several to folders in it
/// that are named like their files.
std::vector<simulation::RunRequest> requests(const std::vector<std::string>& files, const std::string& output,
                                             const std::vector<std::string>& overrides, int threads)
{
  std::vector<simulation::RunRequest> all;
  for (const std::string& file : files) {
    const fs::path name = fs::path(file).stem();
    const fs::path folder = output.empty() ? fs::path("out") / name : files.size() == 1 ? fs::path(output) : fs::path(output) / name;
    for (const simulation::RunRequest& other : all)
      if (other.folder == folder)
        throw InputError(fmt::format("{} and {} would both be written to {}", other.case_file.string(), file, folder.string()));
    all.push_back({input::read_case(file, overrides), file, folder, threads});
  }
  return all;
}

/// One case after the other, each on all threads; cases of finite elements, which hardly gain by threads, side by side behind them.
int run_all(const std::vector<simulation::RunRequest>& all, const std::vector<std::string>& overrides, int threads)
{
  catch_interrupts();
  // A case that does not fit its mesh is refused before the first one runs.
  if (all.size() > 1)
    for (const simulation::RunRequest& request : all) try_to_build(request);
  std::vector<simulation::RunRequest> fem;
  std::copy_if(all.begin(), all.end(), std::back_inserter(fem),
               [](const simulation::RunRequest& r) { return r.settings.method == problem::Method::fem; });
  const bool side_by_side = fem.size() > 1 && threads > 1;
  for (const simulation::RunRequest& request : all) {
    if (side_by_side && request.settings.method == problem::Method::fem) continue;
    if (!run_case(request)) return 1;
  }
  return !side_by_side || run_side_by_side(fem, overrides, threads) ? 0 : 1;
}

int resume(const fs::path& folder, int threads)
{
  const std::optional<simulation::RunRequest> request = simulation::run_to_go_on_with(folder, threads);
  if (!request) return fmt::print("the run in {} is finished\n", folder.string()), 0;
  catch_interrupts();
  return run_case(*request) ? 0 : 1;
}

/// All studies are read before the first one runs. One study goes to `output` itself, several to folders in it that are named like their folders, or
/// like their files where these are not study.toml.
int study_all(const std::vector<std::string>& studies, const std::string& output, int at_once)
{
  std::vector<std::pair<study::StudyPlan, fs::path>> plans;
  for (const std::string& study : studies) {
    const fs::path file = fs::is_directory(study) ? fs::path(study) / "study.toml" : fs::path(study),
                   whole = fs::absolute(file).lexically_normal();
    const fs::path name = file.filename() == "study.toml" ? whole.parent_path().filename() : file.stem();
    const fs::path folder = output.empty()        ? fs::path("out/study") / name
                            : studies.size() == 1 ? fs::path(output)
                                                  : fs::path(output) / name;
    for (const auto& other : plans)
      if (other.second == folder) throw InputError(fmt::format("{} and another study would both be written to {}", study, folder.string()));
    plans.emplace_back(study::plan_study(file, folder), folder);
  }
  for (auto& [plan, folder] : plans)
    if (!run_study(plan, folder, at_once)) return 1;
  return 0;
}

int envelope_of(const std::vector<std::string>& files, const std::string& output, const std::vector<std::string>& overrides,
                const envelope::EnvelopeSettings& how, int at_once)
{
  if (files.size() > 1) throw InputError(fmt::format("an envelope is that of one case, and here are {}", files.size()));
  const fs::path file = files[0], folder = output.empty() ? fs::path("out/envelope") / file.stem() : fs::path(output);
  return envelope::find_envelope({input::read_case(file, overrides), file, folder, how, at_once}) ? 0 : 1;
}

/// Messages of commands that write no run.log.
void messages_to_stderr()
{
  spdlog::set_default_logger(spdlog::stderr_color_st("berm"));
  spdlog::set_pattern("%l: %v");
}

int dispatch(int argc, char** argv)
{
  CLI::App app("berm pushes a pipe or cable into the seabed, drags it sideways, and says how the soil answers.", "berm");
  app.set_version_flag("--version", "berm " BERM_VERSION);
  app.require_subcommand(1);

  std::vector<std::string> files, overrides, names;
  std::string output, json, unfinished;
  verification::ProblemChoice problems;
  int threads = 0;
  bool markdown = false, list = false;

  const auto takes_cases = [&](CLI::App* command) {
    command
        ->add_option("--set", overrides,
                     "set a parameter: material.sand.friction_angle=\"40 deg\"; stages by their names; * for every name")
        ->take_all()
        ->allow_extra_args(false);
    return command->add_option("CASE", files, "case files (TOML)")->required();
  };
  const auto takes_threads = [&](CLI::App* command) {
    command->add_option("--threads", threads, "threads to use (default: all processors)")->check(CLI::Range(1, 1024));
  };
  const auto takes_jobs = [&](CLI::App* command) {
    command->add_option("--threads", threads, "runs at a time, each on one thread (default: all processors)")->check(CLI::Range(1, 1024));
  };
  CLI::App* run = app.add_subcommand("run", "run cases");
  CLI::Option* cases = takes_cases(run)->required(false);
  takes_threads(run);
  run->add_option("-o,--output", output, "run folder; of several cases: the folder that theirs go into (default: out/)");
  run->add_option("--resume", unfinished, "go on with the run in this folder from its last checkpoint, instead of running a CASE")
      ->excludes(cases)
      ->excludes("--set")
      ->excludes("--output");
  CLI::App* check = app.add_subcommand("check", "validate a case and tell what a run would take");
  takes_cases(check);
  takes_threads(check);
  CLI::App* params = app.add_subcommand("params", "list all parameters of a case file");
  params->add_flag("--markdown", markdown, "as Markdown");
  CLI::App* bench = app.add_subcommand("bench", "measure the speed on fixed problems");
  bench->add_option("NAME", names, "problems (default: all)")->check(CLI::IsMember(benchmark::bench_names()));
  bench->add_option("--json", json, "also write the table to this file");
  takes_threads(bench);
  CLI::App* verify_command = app.add_subcommand("verify", "run examples and compare their results with what they expect");
  verify_command->add_option("NAME", problems.names,
                             "examples, problems (EXAMPLE/RUN) or folders that hold an expected.toml (default: all)");
  verify_command->add_flag("--list", list, "list the problems and run nothing");
  verify_command->add_flag("--fast", problems.fast, "fast problems only");
  verify_command->add_option("--examples", problems.examples, "folder of the examples (default: examples)");
  verify_command->add_option("-o,--output", output, "folder for the book and its runs (default: out/verification)");
  verify_command->add_option("--threads", threads, "runs at a time, each on one thread (default: all processors)")
      ->check(CLI::Range(1, 1024));
  CLI::App* study_command = app.add_subcommand("study", "run a matrix of cases and make a table and figures of it");
  study_command->add_option("STUDY", files, "study files, or folders that hold a study.toml")->required();
  study_command->add_option("-o,--output", output,
                            "folder for the results; of several studies: the folder that theirs go into (default: out/study)");
  takes_jobs(study_command);

  envelope::EnvelopeSettings envelope;
  CLI::App* envelope_command = app.add_subcommand("envelope", "find the V-H yield envelope of the pipe of a case, where it lies");
  takes_cases(envelope_command);
  takes_jobs(envelope_command);
  envelope_command->add_option("-o,--output", output, "folder for the envelope and its runs (default: out/envelope/CASE)");
  envelope_command->add_option("--points", envelope.directions, "directions between straight down and 45 degrees upwards (default: 10)")
      ->check(CLI::Range(2, 50));
  envelope_command->add_option("--travel", envelope.travel, "travel of each probe over the diameter (default: 0.1)")
      ->check(CLI::Range(1e-3, 1.));

  report::ReportRequest report;
  CLI::App* report_command = app.add_subcommand("report", "write one page, report.html, that shows what runs found");
  report_command->add_option("DIR", report.folders, "run folders, or folders that hold run folders")->required();
  report_command->add_option("-o,--output", report.output, "the page's file (default: report.html in the folder that holds the runs)");
  report_command->add_flag("--figures", report.figures,
                           "also draw the curves and mechanisms as SVG and PNG, in report_figures beside the page");

  try {
    app.parse(argc, argv);
    if (run->parsed() && files.empty() && unfinished.empty()) throw CLI::RequiredError("CASE or --resume");
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  if (params->parsed()) {
    fmt::print("{}", markdown ? input::parameter_page() : input::parameter_table());
    return 0;
  }
  if (bench->parsed()) {
    benchmark::run_bench(names, json, use_threads(threads));
    return 0;
  }
  if (report_command->parsed()) {
    messages_to_stderr();
    for (const fs::path& file : write_report(report)) fmt::print("{}\n", fs::proximate(file).string());
    return 0;
  }
  if (verify_command->parsed() || study_command->parsed() || envelope_command->parsed()) {
    const int at_once = threads > 0 ? threads : processor_count();
    if (list) return list_problems(problems), 0;
    catch_interrupts();
    messages_to_stderr();
    if (envelope_command->parsed()) return envelope_of(files, output, overrides, envelope, at_once);
    if (study_command->parsed()) return study_all(files, output, at_once);
    return verification::verify({problems, output.empty() ? "out/verification" : output, at_once}) ? 0 : 1;
  }
  if (run->parsed() && !unfinished.empty()) return resume(unfinished, use_threads(threads));
  const std::vector<simulation::RunRequest> all = requests(files, output, overrides, use_threads(threads));
  if (run->parsed()) return run_all(all, overrides, all.front().threads);
  for (const simulation::RunRequest& request : all) check_case(request);
  return 0;
}

}  // namespace

int run_commands(int argc, char** argv)
{
  try {
    const int status = dispatch(argc, argv);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) io::throw_errno("cannot write to the standard output");
    return status;
  } catch (const InputError& error) {
    fmt::print(stderr, "berm: {}\n", error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "berm: the machine has no more memory for this; berm check CASE tells how much a run needs\n");
    return 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "berm: {}\n", error.what());
    return 1;
  }
}

}  // namespace berm::commands
