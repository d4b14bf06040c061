// SPDX-License-Identifier: BSD-3-Clause
#include "study/study.hpp"

#include "input/message_text.hpp"
#include "input/read_case.hpp"
#include "io/atomic_file.hpp"
#include "io/duration_text.hpp"
#include "io/log.hpp"
#include "io/tell.hpp"
#include "jobs/batch.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "run_folder/summary.hpp"
#include "structures/driven/known_names.hpp"
#include "structures/other_bodies.hpp"
#include "structures/structures.hpp"
#include "study/estimates.hpp"
#include "study/study_report.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <new>

namespace berm::study {
namespace {

namespace fs = std::filesystem;

std::string name_of(const std::vector<std::string>& names)
{
  return text_of_list(names, ", ");
}

/// The next combination, the last axis first; false after the last one.
bool advance(std::vector<std::size_t>& choice, const Study& study)
{
  for (std::size_t k = choice.size(); k-- > 0;) {
    const std::size_t count = k == 0 ? study.cases.size() : study.axis[k - 1].value.size();
    if (++choice[k] < count) return true;
    choice[k] = 0;
  }
  return false;
}

/// The [[skip]] that leaves these out, or null.
const StudySkip* skip_of(const Study& study, const std::vector<std::string>& names)
{
  const auto name_along = [&](const std::string& key) {
    for (std::size_t k = 0; k < study.axis.size(); ++k)
      if (study.axis[k].name == key) return names[k + 1];
    return names[0];
  };
  for (const StudySkip& skip : study.skip)
    if (std::all_of(skip.where.begin(), skip.where.end(), [&](const auto& entry) { return name_along(entry.first) == entry.second; }))
      return &skip;
  return nullptr;
}

/// Of the main rigid body, where it is a circle; else 0.
Real diameter_of(const settings::Case& settings)
{
  const Index main = main_rigid(settings);
  const std::optional<bodies::DiskOutline> pipe = main == none ? std::nullopt : bodies::pipe_section(settings.rigid[main].second.shape);
  return pipe ? 2 * pipe->radius : 0;
}

/// The file and line of a table from which the change comes that a message is about, and the message without "--set "; empty where it is about none.
std::string at_its_place(const Study& study, const StudyRow& row, const std::string& message)
{
  for (std::size_t k = 0; k < study.axis.size(); ++k) {
    const StudyValue& value = study.axis[k].value[row.choice[k + 1]];
    for (const std::string& set : value.set)
      if (const std::string begin = "--set "; !value.place.empty() && message.starts_with(begin + set.substr(0, set.find('=')) + ": "))
        return value.place + ": " + message.substr(begin.size());
  }
  return "";
}

settings::Case read_row(const fs::path& file, const Study& study, const StudyRow& row)
{
  try {
    return input::case_of(row.job.case_file, row.job.set).settings;
  } catch (const InputError& error) {
    const std::string which = fmt::format("{}: {}", file.string(), name_of(row.names)), place = at_its_place(study, row, error.what());
    throw InputError(place.empty() ? fmt::format("{}: {}", which, error.what()) : fmt::format("{} ({})", place, which));
  }
}

/// Throws InputError where a measure of a row asks for a quantity that its run cannot have, of a structure whose quantities are known before the run.
void check_measures(const fs::path& file, const Study& study, const StudyRow& row, const settings::Case& settings)
{
  std::vector<std::string> known = structures::quantity_names_of(settings);
  if (known.empty()) return;
  for (std::string& name : run_folder::check_and_timing_names()) known.push_back(std::move(name));
  for (std::size_t k = 0; k < study.measure.size(); ++k) {
    const StudyMeasure& measure = study.measure[k];
    const std::string name = driven::without_number(measure.observable.quantity);
    if (name.empty() || !is_wanted(measure, row) || std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw InputError(fmt::format("{}: measure[{}].quantity: a run of {} has no {}{}", file.string(), k, name_of(row.names),
                                 input::in_quotes(measure.observable.quantity), input::suggestion(name, known)));
  }
}

/// The numbers of a row; says once for each measure why it has none.
void take_numbers(StudyRow& row, Study& study, std::vector<std::string>& told)
{
  for (StudyMeasure& measure : study.measure) {
    row.numbers.push_back(nan);
    if (row.end.kind != jobs::JobEnd::Kind::finished || !is_wanted(measure, row)) continue;
    try {
      const expectations::Reading reading = evaluate(measure.observable, row.job.folder);
      row.numbers.back() = measure.scale * reading.value;
      if (measure.unit.empty()) measure.unit = reading.unit;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      if (std::find(told.begin(), told.end(), measure.name) != told.end()) continue;
      told.push_back(measure.name);
      io::warn("{}: \"{}\" stays empty: {}", name_of(row.names), measure.name, error.what());
    }
  }
}

}  // namespace

StudyPlan plan_study(const fs::path& file, const fs::path& output)
{
  StudyPlan plan{read_study(file), {}, {}};
  const Study& study = plan.study;
  std::vector<std::size_t> choice(1 + study.axis.size(), 0);
  do {
    StudyRow row;
    row.choice = choice;
    const StudyCase& c = study.cases[choice[0]];
    row.names = {c.name};
    row.job.case_file = (file.parent_path() / c.file).lexically_normal();
    row.job.set = c.set;
    std::string folder = as_file_name(c.name);
    for (std::size_t k = 0; k < study.axis.size(); ++k) {
      const StudyValue& value = study.axis[k].value[choice[k + 1]];
      row.names.push_back(value.name);
      row.job.set.insert(row.job.set.end(), value.set.begin(), value.set.end());
      folder += '.';
      folder += as_file_name(value.name);
    }
    constexpr std::size_t most = 240;  // a file beside it has some more
    if (folder.size() > most)
      throw InputError(fmt::format("{}: {}: the name of its run folder would be longer than {} bytes: choose shorter names", file.string(),
                                   input::shortened(name_of(row.names), most), most));
    row.job.folder = output / "runs" / folder;
    if (const StudySkip* skip = skip_of(study, row.names)) {
      plan.skipped.push_back({row.names, skip->why});
      continue;
    }
    const settings::Case settings = read_row(file, study, row);
    row.diameter = diameter_of(settings);
    check_measures(file, study, row, settings);
    plan.rows.push_back(row);
  } while (advance(choice, study));
  if (plan.rows.empty()) throw InputError(fmt::format("{}: all combinations of the study are skipped", file.string()));
  warn_of_small_sample(file, study);
  return plan;
}

jobs::Outcome run_study(StudyPlan& plan, const fs::path& output, const jobs::Runner& runner)
{
  if (plan.study.sample) {
    io::make_folder(output);
    io::write_atomically(output / "samples.csv", samples_csv(*sample_of(plan.study)));
  }
  const fs::path runs = io::make_inner_folder(output, "runs");
  jobs::Batch batch;
  for (const StudyRow& row : plan.rows) {
    io::make_inner_folder(runs, row.job.folder.filename());
    batch.jobs.push_back(row.job);
    batch.names.push_back(name_of(row.names));
  }
  run_batch(batch, runner, output / "queue");
  for (std::size_t k = 0; k < plan.rows.size(); ++k) plan.rows[k].end = batch.ends[k];
  std::vector<std::string> told;
  for (StudyRow& row : plan.rows) take_numbers(row, plan.study, told);
  write_study_report(plan, output);
  std::vector<fs::path> finished;
  for (const StudyRow& row : plan.rows)
    if (row.end.kind == jobs::JobEnd::Kind::finished) finished.push_back(row.job.folder);
  if (const std::string units = jobs::mixed_vector_units(finished); !units.empty()) io::warn("{}", units);
  if (const std::size_t failed = batch.count(jobs::JobEnd::Kind::failed); failed > 0)
    io::tell("berm: {} of {} runs failed; the table says why\n", failed, plan.rows.size());
  tell_of_rest(batch);
  io::tell("the results are {}\n", (output / "results.md").string());
  return batch.outcome();
}

}  // namespace berm::study
