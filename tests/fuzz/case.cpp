// SPDX-License-Identifier: BSD-3-Clause
// A case file and, each after a NUL byte, overrides: refused in one line, or read, and what resolved.toml would say of it reads as the same case.
#include "target.hpp"

#include "input/read_case.hpp"
#include "input/write_case.hpp"
#include "os/error.hpp"
#include "problem/stages.hpp"
#include "settings/symmetry.hpp"

using namespace berm;

namespace {

/// The parts of a text between NUL bytes.
std::vector<std::string> parts_of(const std::string& text)
{
  std::vector<std::string> parts;
  for (std::size_t at = 0, end = 0; end != std::string::npos; at = end + 1) {
    end = text.find('\0', at);
    parts.push_back(text.substr(at, end == std::string::npos ? end : end - at));
  }
  return parts;
}

/// What is worked out of the settings alone before anything is built.
void work_out(const settings::Case& c)
{
  for (const settings::StageSettings& stage : c.stage) promise(expected_time(stage) >= 0, "a stage takes time", stage.name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::vector<std::string> overrides = parts_of(text_of(data, size));
  const std::string text = overrides.front();
  overrides.erase(overrides.begin());
  settings::Case read;
  try {
    read = input::read_case_text("case.toml", text, overrides);
  } catch (const InputError& error) {
    promise_one_line(error.what());
    return 0;
  }
  work_out(read);
  const std::string resolved = input::resolved_toml(read);
  promise(input::resolved_toml(input::read_case_text("resolved.toml", resolved)) == resolved, "resolved.toml reads as the same case",
          resolved);
  return 0;
}
