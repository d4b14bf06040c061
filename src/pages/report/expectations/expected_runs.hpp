// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "expectations/expectation_result.hpp"
#include "structures/structures.hpp"

namespace berm::report {

/// A run of the page of which an expected.toml tells, with its name there.
struct ExpectedRun {
  std::string name;
  const record::RunRecord* record;
  base::RunDetails details;
};

/// An expected.toml and those runs of a page, in their order, that it tells of.
class ExpectedRuns {
public:
  ExpectedRuns(const std::vector<record::RunRecord>& runs, const expectations::Expectations& expected);

  const std::vector<ExpectedRun>& runs() const { return runs_; }
  /// Whether all runs that an expectation needs are there.
  bool have(const expectations::Expectation& e) const;
  /// Compares what is expected of `run` with what it gives; of another run that it needs the first is taken.
  expectations::ExpectationResult compare(const expectations::Expectation& e, const ExpectedRun& run) const;

private:
  const ExpectedRun* find(const std::string& name) const;

  std::vector<ExpectedRun> runs_;
};

}  // namespace berm::report
