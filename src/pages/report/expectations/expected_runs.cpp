// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/expectations/claims_section_test.cpp
#include "report/expectations/expected_runs.hpp"

#include <algorithm>

namespace berm::report {

using expectations::Expectation;

ExpectedRuns::ExpectedRuns(const std::vector<record::RunRecord>& runs, const expectations::Expectations& expected)
{
  for (const record::RunRecord& run : runs)
    if (const std::string name = name_of(run, expected); !name.empty())
      runs_.push_back({name, &run, structures::structure_of(run.settings).details(run)});
}

const ExpectedRun* ExpectedRuns::find(const std::string& name) const
{
  const auto found = std::find_if(runs_.begin(), runs_.end(), [&](const ExpectedRun& run) { return run.name == name; });
  return found == runs_.end() ? nullptr : &*found;
}

bool ExpectedRuns::have(const Expectation& e) const
{
  const std::vector<std::string> needed = runs_of(e);
  return std::all_of(needed.begin(), needed.end(), [&](const std::string& name) { return find(name) != nullptr; });
}

expectations::ExpectationResult ExpectedRuns::compare(const Expectation& e, const ExpectedRun& run) const
{
  const auto named = [&](const std::string& name) -> const ExpectedRun& { return name == run.name ? run : *find(name); };
  return compare_with_numbers(e, {[&](const std::string& name, const expectations::Observable& observable) {
                                    return evaluate(observable, *named(name).record, named(name).details);
                                  },
                                  [&](const std::string& name, const std::string& quantity) {
                                    return expectations::band_of(quantity, named(name).record->summary);
                                  }});
}

}  // namespace berm::report
