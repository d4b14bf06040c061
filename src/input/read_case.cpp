// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"

#include "input/load_history.hpp"
#include "input/override.hpp"
#include "input/reader.hpp"
#include "problem/sweeps.hpp"

namespace berm::input {
namespace {

problem::Case case_of(Document document, const std::vector<std::string>& overrides, const std::filesystem::path& folder)
{
  for (const std::string& override : overrides) apply_override(document, override);
  problem::Case read_into;
  read(document, read_into);
  for (problem::StageSettings& stage : read_into.stage) read_load_history(stage, folder);
  problem::expand_sweeps(read_into);
  return read_into;
}

}  // namespace

problem::Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  return case_of(parse_file(file), overrides, file.parent_path());
}

problem::Case read_case_text(const std::string& file, const std::string& text, const std::vector<std::string>& overrides)
{
  return case_of(parse_text(file, text), overrides, std::filesystem::path(file).parent_path());
}

}  // namespace berm::input
