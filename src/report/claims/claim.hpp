// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/error.hpp"
#include "report/claims/test_run.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

namespace berm::report {

/// What one run says of a claim.
struct ClaimEvidence {
  std::string run;
  text::Standing standing;
  std::string words;
};

/// A claim of the paper and what the runs say of it.
struct Claim {
  std::string statement, where;
  std::vector<ClaimEvidence> findings;
  std::string why;                                              ///< said where there are findings
  std::string missing = "No run here came so far as to tell.";  ///< said where there are none
};

/// Adds what `find(run)` says of each run, a std::optional<Finding>; a run whose frames are damaged says nothing.
template <class Find>
void add_findings(Claim& claim, const TestRuns& runs, const Find& find)
{
  for (const TestRun& run : runs) try {
      if (const std::optional<ClaimEvidence> finding = find(run)) claim.findings.push_back(*finding);
    } catch (const RunError&) {
      continue;  // the film of the run says which frame
    }
}

// How near is near: the paper gives its numbers with one or two digits, and berm's own depend on the mesh by some 10 %.
constexpr Real near_enough = 0.15, not_far = 0.4;

/// By the distance from the published value: good within near_enough, fair within not_far. Neither number may be NaN.
text::Standing standing_of(Real value, Real published);
text::Standing standing_if(bool holds);

/// A length for sentences.
std::string diameters(const TestRun& run, Real length);  ///< "0.25 D"

/// The claims of the paper about push and drag, and about contact, as the runs of the material point method find them.
std::vector<Claim> claims_of_the_drag(const TestRuns& mpm);
std::vector<Claim> claims_of_contact(const TestRuns& mpm);
/// The claims about finite elements around a pipe wished in place, beside the material point method.
std::vector<Claim> claims_of_finite_elements(const TestRuns& mpm, const TestRuns& fem);

}  // namespace berm::report
