// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/summary_test.cpp
#include "run_folder/json_file.hpp"

#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::run_folder {

nlohmann::ordered_json read_json(const std::filesystem::path& file, std::uintmax_t most)
{
  using Json = nlohmann::ordered_json;
  const auto refuse = [&](const std::string& why) { throw RunError(fmt::format("{} is damaged: {}", file.string(), why)); };
  const auto look_at = [&](int, Json::parse_event_t, Json& part) {
    if (part.is_string() && has_control_character(part.get_ref<const std::string&>())) refuse("a text in it holds a control character");
    return true;
  };
  const auto [text, fault] = read_file(file, most);
  if (!fault.empty()) throw RunError(fmt::format("{}: {}", file.string(), fault));
  try {
    return Json::parse(text, look_at);
  } catch (const Json::parse_error& error) {
    refuse(fmt::format("byte {} is not JSON", error.byte));
  } catch (const Json::exception&) {
    refuse("a number in it is too large");
  }
  return {};
}

}  // namespace berm::run_folder
