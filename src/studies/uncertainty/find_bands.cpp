// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_uncertainty_test.cpp
#include "uncertainty/find_bands.hpp"

#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "io/tell.hpp"
#include "jobs/batch.hpp"
#include "os/error.hpp"
#include "structures/structures.hpp"
#include "uncertainty/bands.hpp"
#include "uncertainty/variants.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace berm::uncertainty {
namespace {

namespace fs = std::filesystem;

VariantPlan plan_of(const simulation::RunRequest& request)
{
  try {
    return choose_variants(request.settings);
  } catch (const KeyError& error) {
    throw input::LocatedError(request.places.located(error));
  }
}

/// Runs the variants that have no result of this case yet.
jobs::Batch run_variants(const VariantPlan& plan, const fs::path& folder, int at_once)
{
  io::make_folder(folder);
  jobs::Batch batch;
  for (const Variant& variant : plan.variants) {
    const jobs::Job job{folder / (variant.name + ".toml"), {}, io::make_inner_folder(folder, variant.name)};
    io::write_atomically(job.case_file, input::resolved_toml(variant.settings));
    batch.jobs.push_back(job);
    batch.names.push_back(variant.name);
  }
  batch.before = [&](const std::vector<jobs::Job>& there, const std::vector<jobs::Job>& to_run) {
    const auto resumed = std::ranges::count_if(to_run, &jobs::Job::resume);
    io::tell("uncertainty: {} runs with other cells{}{}\n", plan.variants.size(),
             there.empty() ? "" : fmt::format(", of which {} have their result already", there.size()),
             resumed == 0 ? "" : fmt::format(", {} resumed from a checkpoint", resumed));
  };
  run_batch(batch, {jobs::LocalProcesses{at_once}}, folder / "queue");
  return batch;
}

/// What failed first, "" where nothing did.
std::string failure_of(const jobs::Batch& batch)
{
  const auto failed = std::ranges::find(batch.ends, jobs::JobEnd::Kind::failed, &jobs::JobEnd::kind);
  if (failed == batch.ends.end()) return "";
  return fmt::format("the run {} failed: {}", batch.names[failed - batch.ends.begin()], failed->reason);
}

/// Those with grains or those without.
std::vector<VariantRecord> read_variants(const VariantPlan& plan, const fs::path& folder, bool with_grains)
{
  std::vector<VariantRecord> variants;
  for (const Variant& variant : plan.variants)
    if (variant.d50.has_value() == with_grains)
      variants.push_back({variant.size, variant.speed, structures::read_run(folder / variant.name), variant.d50});
  return variants;
}

run_folder::Uncertainty bands_from(const VariantPlan& plan, const fs::path& folder, const record::RunRecord& run)
{
  std::vector<VariantRecord> variants = read_variants(plan, folder, false), with_grain_size = read_variants(plan, folder, true);
  run_folder::Uncertainty found = bands_of(run, variants);
  variants.insert(variants.end(), with_grain_size.begin(), with_grain_size.end());
  found.grains = grains_of(run, variants);
  for (const VariantRecord& variant : variants)
    found.runs.push_back({variant.run.name, variant.size, variant.speed, variant.run.timing("wall_s")});
  found.left_out = plan.left_out;
  return found;
}

void append_to_log(const fs::path& run_folder, const std::string& words)
{
  const fs::path path = run_folder / "run.log";
  const int log = io::open_to_write(path, O_WRONLY | O_APPEND);
  const bool written = io::write_all(log, words + '\n');
  const int reason = errno;
  if (::close(log) != 0 || !written) {
    if (!written) errno = reason;
    io::throw_errno(fmt::format("cannot write {}", path.string()));
  }
}

}  // namespace

std::vector<VariantRecord> variants_of(const record::RunRecord& run)
{
  const fs::path folder = run.folder / variants_folder;
  try {
    return read_variants(choose_variants(run.settings), folder, false);
  } catch (const InputError& error) {
    throw RunError(fmt::format("the runs of its bands are not all in {}: {}", folder.string(), error.what()));
  }
}

void try_to_plan(const simulation::RunRequest& request)
{
  const VariantPlan plan = plan_of(request);
  for (const Variant& variant : plan.variants) {
    try {
      simulation::check_buildable({.settings = variant.settings, .case_file = request.case_file, .folder = request.folder});
    } catch (const InputError& error) {
      throw InputError(
          fmt::format("{}: --uncertainty: with cells {:.3g} times as large: {}", request.case_file.string(), variant.size, error.what()));
    }
  }
  io::tell("uncertainty: {} more runs, which take about {:.1f} times the work of the run itself\n", plan.variants.size(),
           work_of(plan, request.settings));
}

jobs::Outcome find_bands(const simulation::RunRequest& request, int at_once)
{
  const VariantPlan plan = plan_of(request);
  const fs::path folder = request.folder / variants_folder;
  const run_folder::RunFolder run_folder =
      run_folder::RunFolder::of_earlier_run(request.folder);  // and nobody else's until the bands are there
  const jobs::Batch batch = run_variants(plan, folder, at_once);
  record::RunRecord run = structures::read_run(request.folder);
  run_folder::Uncertainty found;
  const bool interrupted = batch.count(jobs::JobEnd::Kind::interrupted) > 0;
  if (interrupted) {
    io::tell("berm: stopped: there is no band yet; berm run --resume {} --uncertainty continues from there\n", request.folder.string());
    found.missing = "stopped before all runs that it is made of were done";
  } else if (const std::string failure = failure_of(batch); !failure.empty()) {
    io::tell("berm: there is no band: {}\n", failure);
    found.missing = failure;
  } else {
    found = bands_from(plan, folder, run);
  }
  add_to_summary(request.folder, found);
  if (interrupted) return jobs::Outcome::unfinished;
  if (!found.missing.empty()) return jobs::Outcome::failed;
  structures::structure_of(run.settings).draw_curves(run_folder, run, found.curves);
  run.summary->uncertainty = found;
  structures::write_curves(run_folder, run);
  const std::string words = words_of(found, run.settings.method);
  fmt::print("{}\n", words);
  append_to_log(request.folder, words);
  return jobs::Outcome::done;
}

}  // namespace berm::uncertainty
