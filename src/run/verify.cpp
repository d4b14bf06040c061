// SPDX-License-Identifier: BSD-3-Clause
#include "run/verify.hpp"

#include "core/error.hpp"
#include "input/read_case.hpp"
#include "input/reader.hpp"
#include "run/expectation.hpp"
#include "run/simulate.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace berm {
namespace {

namespace fs = std::filesystem;
using Row = std::vector<std::string>;

/// One expectation, the run that it is about, and where that run goes.
struct Claim {
  std::string example, run;
  fs::path folder;
  Expectation expectation;
};

/// The case's name, then what was changed: "case_3d, block.spacing=0.1".
std::string name_of_run(const Expectation& e)
{
  std::string name = fs::path(e.case_file).stem().string();
  for (const std::string& set : e.set) name += ", " + set;
  return name;
}

std::string as_folder(std::string name)
{
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && std::string("._-=+").find(c) == std::string::npos) c = '_';
  return name;
}

/// The claims of one example; adds the runs that they need to `runs`, by folder.
std::vector<Claim> claims_of(const std::string& example, const fs::path& output, int threads, std::vector<RunRequest>& runs)
{
  const fs::path folder = fs::path(example).lexically_normal() / "";
  Document document = parse_file(folder / "expected.toml");
  Expectations expectations;
  read(document, expectations);
  std::vector<Claim> claims;
  for (const Expectation& e : expectations.expect) {
    const std::string name = folder.parent_path().filename().string(), run = name_of_run(e);
    claims.push_back({name, run, output / name / as_folder(run), e});
    const auto same = [&](const RunRequest& other) { return other.folder == claims.back().folder; };
    if (std::none_of(runs.begin(), runs.end(), same))
      runs.push_back({read_case(folder / e.case_file, e.set), folder / e.case_file, claims.back().folder, threads});
  }
  return claims;
}

std::string number(Real value)
{
  return fmt::format("{:.5g}", value);
}

std::string expected_of(const Expectation& e)
{
  if (e.exact) return number(*e.exact);
  if (e.least && e.most) return number(*e.least) + " .. " + number(*e.most);
  return e.least ? ">= " + number(*e.least) : "<= " + number(*e.most);
}

std::string percent(Real part)
{
  return fmt::format("{:.3g} %", 100 * part);
}

Row row_of(const Claim& claim, Real value)
{
  const Expectation& e = claim.expectation;
  const std::string unit = unit_of(e), of_unit = unit.empty() ? "" : " " + unit;
  std::string what = e.quantity;
  if (what.empty()) what = fmt::format("{} {}", e.column, measure_words[static_cast<std::size_t>(e.measure)]);
  const bool relative = e.tolerance.has_value();
  const Real error = error_of(e, value);
  const std::string tolerance = relative ? percent(*e.tolerance) : e.absolute_tolerance ? number(*e.absolute_tolerance) : "";
  return {claim.example,
          claim.run,
          what,
          expected_of(e) + of_unit,
          number(value) + of_unit,
          relative ? percent(error) : number(error),
          tolerance,
          is_met(e, value) ? "met" : "MISSED",
          e.source};
}

void print(const std::vector<Row>& rows)
{
  std::vector<std::size_t> widths(rows[0].size(), 0);
  for (const Row& row : rows)
    for (std::size_t k = 0; k + 1 < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  for (const Row& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) fmt::print("{:<{}}{}", row[k], widths[k], k + 1 < row.size() ? "  " : "\n");
  }
}

}  // namespace

bool verify(const std::vector<std::string>& examples, const fs::path& output, int threads)
{
  std::vector<RunRequest> runs;
  std::vector<Claim> claims;
  for (const std::string& example : examples)
    for (Claim& claim : claims_of(example, output, threads, runs)) claims.push_back(std::move(claim));
  for (const RunRequest& run : runs)
    if (!run_case(run)) throw RunError(fmt::format("{} was interrupted", run.case_file.string()));

  std::vector<Row> rows = {{"example", "case", "quantity", "expected", "berm", "error", "tolerance", "verdict", "source"}};
  bool all_met = true;
  for (const Claim& claim : claims) {
    const Expectation& e = claim.expectation;
    const Real value =
        e.column.empty() ? evaluate(e, claim.folder / "summary.json") : evaluate(e, read_history(claim.folder / "history.csv"));
    rows.push_back(row_of(claim, value));
    all_met = all_met && is_met(e, value);
  }
  fmt::print("\n");
  print(rows);
  return all_met;
}

}  // namespace berm
