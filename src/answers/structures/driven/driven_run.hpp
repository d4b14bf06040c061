// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/base/structure.hpp"
#include "structures/driven/quantities.hpp"

namespace berm::driven {

/// A run as that of a pipe: the record, which must outlive it, with what its results are measured by.
struct DrivenRun {
  explicit DrivenRun(const record::RunRecord& run, std::size_t number_on_page = 0) : record(run), number(number_on_page) {}

  const record::RunRecord& record;
  const std::string& name = record.name;
  const settings::Case& settings = record.settings;
  const run_folder::History& history = record.history;
  const std::vector<run_folder::Quantity>& quantities = record.quantities;
  record::RunEnd end = record.end;
  BodyScale scale = base::body_scale(record);
  Stages stages = stages_of(settings);
  std::size_t number;  ///< on the page, which gives its colour

  /// What its quantities tell.
  Results results() const { return results_of(quantities, scale, stages); }
};

using DrivenRuns = std::vector<DrivenRun>;

/// The runs of a page as those of driven bodies.
inline DrivenRuns driven_runs(const base::Runs& runs)
{
  DrivenRuns all;
  for (const auto& [record, number] : runs) all.emplace_back(*record, number);
  return all;
}

}  // namespace berm::driven
