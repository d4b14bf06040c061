// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/claims/claims_test.cpp
#include "report/claims/test_run.hpp"

#include "text/quantity_words.hpp"

#include <fmt/format.h>

namespace berm::report {

TestRun::TestRun(const record::RunRecord& run)
    : record(run),
      scale(base::body_scale(run)),
      observed(structures::structure_of(run.settings).observed(run))
{
}

const base::Observables& claim_observables()
{
  static const base::Observables observables = [] {
    base::Observables all;
    for (const base::Structure* structure : structures::all_structures()) {
      const base::Observables own = structure->observables();
      all.insert(all.end(), own.begin(), own.end());
    }
    all.push_back({"quantity", base::ObservableUnit::number, base::ObservableUnit::none, false});
    return all;
  }();
  return observables;
}

const std::vector<const char*>& observable_words()
{
  static const std::vector<const char*> words = [] {
    std::vector<const char*> all;
    for (const base::Observable& observable : claim_observables()) all.push_back(observable.word);
    return all;
  }();
  return words;
}

bool is_quantity(const base::Observable& observable)
{
  return &observable == &claim_observables().back();
}

const char* unit_of(base::ObservableUnit unit)
{
  return unit == base::ObservableUnit::force ? "N/m" : "";
}

std::string words_of(base::ObservableUnit unit, Real value)
{
  switch (unit) {
  case base::ObservableUnit::length:
    return fmt::format("{:.3g} D", value);
  case base::ObservableUnit::area:
    return fmt::format("{:.3g} D²", value);
  case base::ObservableUnit::force:
    return text::force_words(value, 2);
  default:
    return fmt::format("{:.2g}", value);
  }
}

Real evaluate(const base::Observable& observable, std::optional<Real> at, const std::string& quantity, const TestRun& run)
{
  if (!is_quantity(observable)) return run.observed->value(observable.word, at);
  const run_folder::Quantity* found = run.record.quantity(quantity);
  return found == nullptr ? nan : found->value;
}

}  // namespace berm::report
