// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_test.cpp
#include "verification/problems.hpp"

#include "input/message_text.hpp"
#include "os/error.hpp"
#include "verification/quoted_pages.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::verification {
namespace {

namespace fs = std::filesystem;

using expectations::expected_file;

Example read_example(const fs::path& folder)
{
  const expectations::Expectations all = expectations::read_expectations(folder / expected_file);
  check_quotations(folder, all.expect);
  const fs::path clean = fs::absolute(folder / "").lexically_normal();
  return {clean.parent_path().filename().string(), folder, all.chapter, all.run, all.expect};
}

/// Names of the folders that hold an expected.toml.
std::vector<std::string> names_in(const fs::path& examples)
{
  std::error_code error;
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(examples, error))
    if (fs::exists(entry.path() / expected_file)) names.push_back(entry.path().filename().string());
  if (error) throw InputError(fmt::format("{}: {}; name the folder of the examples with --examples", examples.string(), error.message()));
  std::sort(names.begin(), names.end());
  return names;
}

/// The folder and, where one problem is meant, its run.
std::pair<fs::path, std::string> example_and_run(const std::string& name, const fs::path& examples)
{
  const fs::path clean = (fs::path(name) / "").lexically_normal(), path = clean.has_parent_path() ? clean.parent_path() : clean;
  for (const fs::path& folder : {path, examples / path})
    if (fs::exists(folder / expected_file)) return {folder, ""};
  const std::string example = path.parent_path().string();
  if (!example.empty() && fs::exists(examples / example / expected_file)) return {examples / example, path.filename().string()};
  const std::vector<std::string> known = names_in(examples);
  const std::string near = input::nearest(example.empty() ? name : example, known);
  throw InputError(fmt::format("{} is not an example, and no problem EXAMPLE/RUN, of {}{} (examples: {})", input::in_quotes(name),
                               examples.string(), near.empty() ? "" : fmt::format("; did you mean {}?", input::in_quotes(near)),
                               input::listed(known)));
}

using Runs = std::vector<std::pair<std::string, VerificationRun>>;

Runs::const_iterator find_run(const Runs& runs, const std::string& name)
{
  return std::find_if(runs.begin(), runs.end(), [&](const auto& entry) { return entry.first == name; });
}

/// Adds the runs of `whole` that are wanted to what is chosen of the same example already.
void add(std::vector<Example>& chosen, const Example& whole, const std::string& run, const ProblemChoice& choice)
{
  if (!run.empty() && find_run(whole.runs, run) == whole.runs.end()) {
    std::vector<std::string> known;
    for (const auto& entry : whole.runs) known.push_back(whole.name + "/" + entry.first);
    const std::string name = whole.name + "/" + run;
    throw InputError(fmt::format("there is no problem {}{}", input::in_quotes(name), input::suggestion(name, known)));
  }
  auto example = std::find_if(chosen.begin(), chosen.end(), [&](const Example& other) { return other.name == whole.name; });
  if (example == chosen.end())
    example = chosen.insert(example, {whole.name, whole.folder, whole.chapter, {}, {}});
  else if (!fs::equivalent(example->folder, whole.folder))
    throw InputError(fmt::format("{} and {} are both named {}", example->folder.string(), whole.folder.string(), whole.name));
  Runs runs;
  const bool with_long = choice.with_long || !choice.names.empty();
  for (const auto& entry : whole.runs) {
    const bool wanted = (run.empty() || entry.first == run) && (!choice.fast || entry.second.fast) && (with_long || !entry.second.is_long);
    if (wanted || find_run(example->runs, entry.first) != example->runs.end()) runs.push_back(entry);
  }
  example->runs = runs;
  example->expectations.clear();
  for (const Expectation& e : whole.expectations) {
    const std::vector<std::string> needed = runs_of(e);
    if (std::all_of(needed.begin(), needed.end(), [&](const std::string& name) { return find_run(runs, name) != runs.end(); }))
      example->expectations.push_back(e);
  }
}

/// Leaves the examples of the chapter, "" = of all, by chapter.
void take_chapter(std::vector<Example>& chosen, const std::string& chapter)
{
  const std::vector<std::string> known(expectations::chapter_words.begin(), expectations::chapter_words.end());
  const auto wanted = std::find(known.begin(), known.end(), chapter);
  if (!chapter.empty() && wanted == known.end())
    throw InputError(fmt::format("there is no chapter {}{}", input::in_quotes(chapter), input::suggestion(chapter, known)));
  std::erase_if(
      chosen, [&](const Example& example) { return !chapter.empty() && example.chapter != static_cast<Chapter>(wanted - known.begin()); });
  std::stable_sort(chosen.begin(), chosen.end(), [](const Example& a, const Example& b) { return a.chapter < b.chapter; });
}

std::string words_of_nothing(const ProblemChoice& choice)
{
  if (choice.fast) return "none of these problems is fast";
  if (!choice.chapter.empty()) return fmt::format("none of these problems is of the chapter {}", input::in_quotes(choice.chapter));
  return fmt::format("{} holds no example", choice.examples.string());
}

}  // namespace

std::vector<Example> find_problems(const ProblemChoice& choice)
{
  std::vector<Example> chosen;
  const std::vector<std::string> names = choice.names.empty() ? names_in(choice.examples) : choice.names;
  for (const std::string& name : names) {
    const auto [folder, run] =
        choice.names.empty() ? std::pair(choice.examples / name, std::string()) : example_and_run(name, choice.examples);
    add(chosen, read_example(folder), run, choice);
  }
  take_chapter(chosen, choice.chapter);
  std::erase_if(chosen, [](const Example& example) { return example.runs.empty(); });
  if (chosen.empty()) throw InputError(words_of_nothing(choice));
  return chosen;
}

}  // namespace berm::verification
