// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "simulation/results.hpp"

#include "fem/blas.hpp"
#include "io/atomic_file.hpp"
#include "io/host_info.hpp"
#include "io/log.hpp"
#include "run_folder/build.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::simulation {
namespace {

std::string words_of(const run_folder::RunTiming& timing, const run_folder::MpmCounts& counts)
{
  return fmt::format("{} steps of {} particles, {:.1f} million particle-steps/s", timing.steps, counts.particles,
                     particle_steps_per_s(timing, counts) / 1e6);
}
std::string words_of(const run_folder::RunTiming& timing, const run_folder::FemCounts& counts)
{
  return fmt::format("{} steps of {} nodes, {} iterations", timing.steps, counts.nodes, counts.iterations);
}

/// Ranks have about the same, but for the first, which makes the frames.
std::string words_of_memory(const std::vector<Real>& ranks)
{
  const auto mebibytes = [](Real bytes) { return fmt::format("{:.0f}", bytes / (1 << 20)); };
  if (ranks.size() == 1) return mebibytes(ranks[0]) + " MiB";
  const auto [least, most] = std::minmax_element(ranks.begin() + 1, ranks.end());
  return fmt::format("{} MiB on the first rank, {} to {} on the {} other{}", mebibytes(ranks[0]), mebibytes(*least), mebibytes(*most),
                     ranks.size() - 1, ranks.size() == 2 ? "" : "s");
}

void print_timings(const run_folder::RunTiming& timing)
{
  std::string table = fmt::format("{:<32} {:>10} {:>8}\n", "time by loop", "s", "part");
  for (const Timing& loop : timing.loops)
    table += fmt::format("{:<32} {:>10.3f} {:>7.1f}%\n", loop.label, loop.seconds, 100 * loop.seconds / timing.wall_s);
  const auto line = [&](const char* what, Real seconds) {
    table += fmt::format("{:<32} {:>10.3f} {:>7.1f}%\n", what, seconds, 100 * seconds / timing.wall_s);
  };
  table += fmt::format("{:<32} {:>10} {:>8}\n", "time by part", "s", "part");
  line("steps", timing.parts.steps);
  line("rows of the history", timing.parts.rows);
  line("frames", timing.parts.frames);
  line("checkpoints", timing.parts.checkpoints);
  line("files, beside the steps", timing.parts.beside);
  line("processor time", timing.processors_s);
  const std::string all = std::visit([&](const auto& counts) { return words_of(timing, counts); }, timing.counts);
  table += fmt::format("{:<32} {:>10.3f}          {} on {} thread{}\n", "all", timing.wall_s, all, timing.threads,
                       timing.threads == 1 ? "" : "s");
  table += fmt::format("{:<32} {}", "memory at most", words_of_memory(timing.memory));
  io::info("{}", table);
}

}  // namespace

std::string write_results(const RunRequest& request, EndedRun ended, const AfterRun& after, const std::vector<std::string>& warnings,
                          const run_folder::RunTiming& timing)
{
  const run_folder::RunFolder& folder = ended.folder;
  io::sync_file(folder.file("history.csv"));  // a summary that says "finished" must not outlive it
  Answers answers;
  if (after.answers) answers = after.answers(ended);
  run_folder::Summary summary;
  summary.quantities = std::move(answers.quantities);
  summary.force_measure = std::move(answers.force_measure);
  summary.timing = timing;
  summary.text = {{"title", request.settings.title},
                  {"case", request.case_file.filename().string()},
                  {"version", BERM_VERSION},
                  {"machine", io::host_description()},
                  {"date", io::utc_date(std::chrono::system_clock::now())}};
  for (auto& entry : run_folder::this_build()) summary.text.push_back(std::move(entry));
  if (request.settings.method == settings::Method::fem) summary.text.emplace_back("blas_kernel", fem::blas_kernel());
  for (auto& entry : answers.text) summary.text.push_back(std::move(entry));
  summary.checks = ended.checks;
  summary.warnings = warnings;
  summary.invalid = std::move(answers.invalid);
  summary.write(folder.file("summary.json"));
  for (const std::filesystem::path& names : {folder.path(), folder.file("frames")}) io::sync_file(names);  // before the checkpoints go

  for (const auto& draw : after.drawings) draw(ended);
  print_timings(timing);
  return answers.key_results;
}

}  // namespace berm::simulation
