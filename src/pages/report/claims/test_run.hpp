// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/structures.hpp"

namespace berm::report {

/// A run of a test, whose record must outlive it, as claims look at it.
struct TestRun {
  explicit TestRun(const record::RunRecord& run);

  const record::RunRecord& record;
  base::BodyScale scale;
  std::unique_ptr<base::ObservedRun> observed;  ///< by the run's structure, which has observables
};

using TestRuns = std::vector<TestRun>;

/// What a claim may be about: the observables of all structures, and last a quantity of summary.json.
const base::Observables& claim_observables();
const std::vector<const char*>& observable_words();
bool is_quantity(const base::Observable& observable);

/// The SI unit of what is measured: lengths are bare numbers, of D.
const char* unit_of(base::ObservableUnit unit);

/// A number as sentences have it: "0.25 D", "1.2 kN/m".
std::string words_of(base::ObservableUnit unit, Real value);

/// The number that a run gives; NaN where it has none. Throws RunError where a frame is damaged.
Real evaluate(const base::Observable& observable, std::optional<Real> at, const std::string& quantity, const TestRun& run);

}  // namespace berm::report
