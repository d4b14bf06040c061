// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/quality/indicators.hpp"

#include <functional>

namespace berm::report {

/// One thing that tells whether a run can be trusted.
struct TrustMeasure {
  const char* what;
  const Limit* limit;  ///< null: it is told, not judged
  std::function<bool(const pipe::RunRecord&)> applies;
  std::function<Real(const pipe::RunRecord&)> value;
  std::function<std::string(const pipe::RunRecord&, Real)> words;    ///< of a value that is known
  std::function<std::string(const pipe::RunRecord&, Real)> warning;  ///< where it is not good, as a sentence without its full stop
  std::string (*limit_words)(Real);                                  ///< a limit in the unit of the value
};

/// What is looked at in runs of a method, in the order of the page.
const std::vector<TrustMeasure>& trust_measures(problem::Method method);

}  // namespace berm::report
