// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/claims/claim_sheet.hpp"
#include "text/html.hpp"

namespace berm::report {

/// A number that was taken of a run.
struct ClaimNumber {
  std::string name;
  Real value;
  base::ObservableUnit unit;
  const TestRun* run;
  std::optional<text::Standing> standing;  ///< where there is something that it should be
};

/// What one run says of a claim.
struct ClaimEvidence {
  std::string run, words;
  text::Standing standing;
  std::vector<ClaimNumber> numbers;
};

/// What the runs of a test say of a claim, finding by finding; a run whose frames are damaged says nothing.
std::vector<ClaimEvidence> evidence_of(const Claim& claim, const ClaimSheet& sheet, const TestRuns& runs);

/// How the claim is judged in view of that: its why, why_of_several, met and missed, with their numbers.
std::string reasons_of(const Claim& claim, const std::vector<ClaimEvidence>& evidence);

}  // namespace berm::report
