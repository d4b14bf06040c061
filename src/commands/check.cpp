// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_wrong_inputs_test.cpp, tests/unit/commands/check_json_test.cpp
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "input/message_text.hpp"
#include "io/duration_text.hpp"
#include "io/tell.hpp"
#include "os/error.hpp"
#include "structures/base/errors_of_methods.hpp"
#include "structures/base/soil_words.hpp"
#include "uncertainty/variants.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace berm::commands {
namespace {

using Json = nlohmann::ordered_json;

/// What the other method for large deformations would take.
struct OtherMethod {
  settings::Method method;
  Real time = nan;      ///< wall time on one thread, s; NaN where no stage says how long it takes, or it cannot run
  std::string why_not;  ///< "" where it can run
};

OtherMethod other_method(simulation::RunRequest request)
{
  settings::Method& method = request.settings.method;
  method = method == settings::Method::mpm ? settings::Method::fem : settings::Method::mpm;
  OtherMethod other{method, nan, ""};
  try {
    other.time = expected_wall_time(request);
  } catch (const RunError& error) {
    other.why_not = error.what();
  } catch (const InputError& error) {
    other.why_not = error.what();
  }
  return other;
}

/// The same in words, and the errors of both methods.
std::vector<std::string> lines_of(const OtherMethod& other)
{
  const char* name =
      other.method == settings::Method::fem ? "by remeshed finite elements (method = \"fem\")" : "by material points (method = \"mpm\")";
  return {other.why_not.empty() ? fmt::format("{}: about {} on one thread", name, io::duration_text(other.time))
                                : fmt::format("not {}: {}", name, other.why_not),
          fmt::format("error        of V in a push into clay (examples/two_methods): elements of {}: {}; cells of {}: {}",
                      sizes_words(base::errors_of_remeshed_elements), errors_words(base::errors_of_remeshed_elements),
                      sizes_words(base::errors_of_cells), errors_words(base::errors_of_cells))};
}

/// What the bands of its results would take; empty where it has none.
std::optional<std::string> line_of_bands(const settings::Case& c)
{
  try {
    const uncertainty::VariantPlan plan = uncertainty::choose_variants(c);
    const auto [finest, coarsest] = std::ranges::minmax(plan.variants, {}, &uncertainty::Variant::size);
    return fmt::format(
        "bands        --uncertainty: {} more runs, on cells {:.2g} to {:.2g} times as large, about {:.2g} times the work of this one",
        plan.variants.size(), finest.size, coarsest.size, work_of(plan, c));
  } catch (const KeyError&) {
    return std::nullopt;
  }
}

/// What is found of a case, with what the other method takes where it asks for large deformations.
struct CheckedCase {
  simulation::Checked checked;
  std::optional<OtherMethod> other;
};

CheckedCase check_of(const simulation::RunRequest& request, const CaseOptions& options)
{
  CheckedCase of;
  {
    simulation::Context context(options.threads);  // one at a time: the other method has its own
    of.checked = check_case(request, context);
  }
  simulation::Checked& checked = of.checked;
  if (!checked.refusals.empty()) return of;
  std::vector<std::string> notes;
  for (const auto& words_of : {base::soil_words, base::k0_words, base::drainage_words})
    for (std::string& line : words_of(request.settings)) notes.push_back(std::move(line));
  checked.notes.insert(checked.notes.begin(), notes.begin(), notes.end());
  if (!checked.estimate) return of;
  if (const std::optional<std::string> line = line_of_bands(request.settings)) checked.estimate->lines.push_back(*line);
  if (request.settings.fem.large_deformation) {
    of.other = other_method(request);
    for (std::string& line : lines_of(*of.other)) checked.estimate->lines.push_back(std::move(line));
  }
  return of;
}

void print_check(const simulation::RunRequest& request, const simulation::Checked& checked)
{
  for (std::size_t k = 1; k < checked.refusals.size(); ++k) io::tell("berm: {}\n", checked.refusals[k].text());
  if (!checked.refusals.empty()) throw input::LocatedError(checked.refusals.front());
  for (const input::Located& warning : checked.warnings) io::tell("berm: warning: {}\n", warning.text());
  fmt::print("{}\n", request.case_file.string());
  for (const std::string& note : checked.notes) fmt::print("  {}\n", note);
  if (checked.failure) throw input::LocatedError(*checked.failure);
  for (const std::string& line : checked.estimate->lines) fmt::print("  {}\n", line);
}

Json finding(const char* level, const input::Located& what)
{
  Json found = Json::object({{"level", level}, {"file", what.file}, {"line", what.line}, {"key", what.key}, {"message", what.message}});
  if (what.line == 0) found["line"] = nullptr;
  if (what.key.empty()) found["key"] = nullptr;
  if (!what.override_key.empty()) found["set"] = what.override_key;
  if (!what.allowed.empty()) found["expected"] = what.allowed;
  if (const std::string near = input::nearest(what.word, what.allowed); !near.empty()) found["nearest"] = near;
  return found;
}

Json errors_of(const base::ErrorsOfSizes& errors)
{
  Json all = Json::array();
  for (const base::ErrorOfSize& error : errors) all.push_back({{"size_over_D", 1. / error.n}, {"error", error.of_V}});
  return all;
}

/// Not a number is null.
Json estimate_of(const simulation::Estimate& e, const std::optional<OtherMethod>& other)
{
  Json estimate = Json::object({{"cells", e.cells},
                                {"nodes", e.nodes},
                                {"particles", e.particles},
                                {"memory_bytes", e.memory},
                                {"time_s", e.time},
                                {"disk_bytes", e.disk},
                                {"lines", e.lines}});
  if (!other) return estimate;
  estimate["other_method"] = {{"method", other->method == settings::Method::fem ? "fem" : "mpm"}, {"time_s", other->time}};
  if (!other->why_not.empty()) estimate["other_method"]["why_not"] = other->why_not;
  estimate["errors"] = {{"fem", errors_of(base::errors_of_remeshed_elements)}, {"mpm", errors_of(base::errors_of_cells)}};
  return estimate;
}

/// A case that was read, or what is wrong with its text.
struct Read {
  std::string file;
  std::optional<simulation::RunRequest> request;
  Json findings;
};

/// Adds what act finds wrong.
template <class Act>
void find(Json& findings, const std::string& file, const Act& act)
{
  try {
    act();
  } catch (const input::LocatedError& error) {
    findings.push_back(finding("error", error.located));
  } catch (const InputError& error) {
    findings.push_back(finding("error", {.file = file, .message = error.what()}));
  }
}

Read read(CaseOptions options, const std::string& file)
{
  Read read{file, {}, Json::array()};
  options.files = {file};
  find(read.findings, file, [&] { read.request = requests(options).front(); });
  return read;
}

/// A case with what is found of it; it is wrong where that has an error.
Json check_as_json(const Read& of, const CaseOptions& options)
{
  Json findings = of.findings, estimate;
  if (of.request)
    find(findings, of.file, [&] {
      const auto [checked, other] = check_of(*of.request, options);
      for (const input::Located& refusal : checked.refusals) findings.push_back(finding("error", refusal));
      if (checked.failure) findings.push_back(finding("error", *checked.failure));
      for (const input::Located& warning : checked.warnings) findings.push_back(finding("warning", warning));
      for (const std::string& note : checked.notes) findings.push_back(finding("note", {.file = of.file, .message = note}));
      if (checked.estimate) estimate = estimate_of(*checked.estimate, other);
    });
  return Json::object({{"file", of.file}, {"findings", findings}, {"estimate", estimate}});
}

bool is_wrong(const Json& of_case)
{
  return std::ranges::any_of(of_case["findings"], [](const Json& found) { return found["level"] == "error"; });
}

int print_json(const CaseOptions& options)
{
  std::vector<Read> cases;
  for (const std::string& file : options.files) cases.push_back(read(options, file));
  // Before the first check, which starts threads.
  options.enter_sandbox(std::ranges::any_of(cases, [](const Read& one) { return one.request && brings_libraries(*one.request); }), {});
  Json all = Json::array();
  for (const Read& one : cases) all.push_back(check_as_json(one, options));
  fmt::print("{}\n", all.dump(1, ' ', false, Json::error_handler_t::replace));
  return std::ranges::any_of(all, is_wrong) ? 2 : 0;
}

}  // namespace

Command add_check(CLI::App& program)
{
  const auto options = std::make_shared<CaseOptions>();
  const auto json = std::make_shared<bool>(false);
  CLI::App* app = program.add_subcommand(
      "check",
      "validate a case and estimate time, memory and disk of a run; gmsh runs the geometry (.geo) that it names, and its laws are loaded");
  options->take_cases(*app);
  options->take_stdin(*app);
  options->take_threads(*app);
  options->take_no_programs(*app);
  options->take_sandbox(*app);
  app->add_flag("--json", *json, "print findings and estimate of each case as JSON on the standard output");
  return {app, [options, json] {
            if (*json) return print_json(*options);
            const std::vector<simulation::RunRequest> all = requests(*options);
            options->enter_sandbox(std::any_of(all.begin(), all.end(), brings_libraries), {});
            for (const simulation::RunRequest& request : all) print_check(request, check_of(request, *options).checked);
            return 0;
          }};
}

}  // namespace berm::commands
