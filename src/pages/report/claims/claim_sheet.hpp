// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/claims/test_conditions.hpp"
#include "report/claims/test_run.hpp"
#include "structures/base/published_point.hpp"

#include <filesystem>

namespace berm::report {

/// Which runs a finding is made of, or stands beside.
struct RunSelection {
  problem::Method method = problem::Method::mpm;
  std::optional<Real> drag_from, drag_to;  ///< D, embedment with which the drag begins (within 0.01 D), displacement that it reaches
  TestConditions conditions;
};

/// A number that a run gives, and what it should be.
struct ClaimValue {
  std::string name;
  std::size_t observable = 0;  ///< place in claim_observables()
  std::optional<Real> at;
  std::string quantity;           ///< of summary.json, for the observable of this name
  bool of_beside = false;         ///< of the run beside
  std::optional<Real> per;        ///< the number is over this
  std::string over;               ///< value over which it is; forces of two runs each over their unit weight
  bool percent = false;           ///< how it is shown
  std::string words, without;     ///< "{}" stands for the number; said where there is none, which else ends the finding
  std::optional<Real> counts_as;  ///< number that is judged where there is none
  std::optional<Real> published, min, max;
  std::string more_than;    ///< value that it exceeds
  bool partly = false;      ///< what it is if it is not so: partly reproduced, or not
  std::string met, missed;  ///< said as a reason where all runs meet it, or one does not
};

/// What is told of each run of a selection.
struct ClaimFinding {
  RunSelection runs;
  std::optional<RunSelection> beside;  ///< the first such run is compared with
  std::vector<std::string> alike;      ///< parameters in which both runs are alike
  std::string words;                   ///< with {NAME} for values and {beside} for the run's name
  std::vector<ClaimValue> values;
};

/// What published forces are read as: per metre run of the model, or of the prototype that it stands for.
enum class ClaimScale { model, prototype };

/// A published claim.
struct Claim {
  std::string statement, where;
  ClaimScale scale = ClaimScale::model;
  std::vector<ClaimFinding> findings;
  std::string why, why_of_several;  ///< with {NAME least}, {NAME most} and, of two, {NAME ratio} over the runs
  std::string missing = "No run here came so far as to tell.";
};

/// claims.toml: what was published of a test.
struct ClaimSheet {
  std::string title = "Published claims", source;
  Real near = 0.15, off = 0.4;  ///< largest |number / published - 1| of what is reproduced, and partly
  TestConditions test;
  std::vector<Claim> claims;
  base::PublishedPoints points;
};

constexpr const char* claims_file = "claims.toml";

void describe(Describe& d, TestConditions& conditions);
void describe(Describe& d, RunSelection& runs);
void describe(Describe& d, ClaimValue& value);
void describe(Describe& d, ClaimFinding& finding);
void describe(Describe& d, Claim& claim);
void describe(Describe& d, ClaimSheet& sheet);

/// Whether a claim is judged by a published force, which has a scale.
bool judges_a_force(const Claim& claim);

/// Reads the claims of a test. Throw InputError with file, line and key.
ClaimSheet read_claims(const std::filesystem::path& file);
ClaimSheet read_claims_text(const std::string& file, const std::string& text);

/// The part of a text in braces that come first, and what stands around them; empty where there are none.
struct Placeholder {
  std::string before, name, after;
};
std::optional<Placeholder> first_placeholder(const std::string& text);

}  // namespace berm::report
