// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"

#include "input/override.hpp"
#include "input/reader.hpp"

namespace berm::input {
namespace {

problem::Case case_of(Document document, const std::vector<std::string>& overrides)
{
  for (const std::string& override : overrides) apply_override(document, override);
  problem::Case read_into;
  read(document, read_into);
  return read_into;
}

}  // namespace

problem::Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  return case_of(parse_file(file), overrides);
}

problem::Case read_case_text(const std::string& file, const std::string& text, const std::vector<std::string>& overrides)
{
  return case_of(parse_text(file, text), overrides);
}

}  // namespace berm::input
