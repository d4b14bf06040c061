// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"

#include "core/error.hpp"
#include "input/override.hpp"
#include "input/reader.hpp"
#include "material/user_law.hpp"
#include "problem/sweeps.hpp"

#include <charconv>
#include <fmt/format.h>
#include <fstream>

namespace berm::input {
namespace {

/// Reads the surfaces of rigid bodies, whose files lie beside the case file.
void read_surfaces(std::vector<std::pair<std::string, bodies::RigidSettings>>& rigid_bodies, const std::filesystem::path& folder)
{
  for (auto& [name, rigid] : rigid_bodies) {
    auto* surface = std::get_if<bodies::TriangulatedSettings>(&rigid.shape);
    if (surface == nullptr) continue;
    surface->file = std::filesystem::absolute(folder / surface->file).lexically_normal().string();
    try {
      read_solid(*surface);
    } catch (const InputError& error) {
      throw KeyError(fmt::format("rigid.{}.file: {}", name, error.what()));
    }
  }
}

CaseInFile case_of(Document document, const std::vector<std::string>& overrides, const std::filesystem::path& folder)
{
  if (const Node* tests = member(document.root, "test"))
    refuse(document, *tests, "test", "this is an input of element tests, for berm element, and no case");
  for (const std::string& override : overrides) apply_override(document, override);
  CaseInFile found;
  read(document, found.settings);
  find_libraries(found.settings.material, folder);
  const Places written(document);
  try {
    read_surfaces(found.settings.rigid, folder);
    for (std::size_t k = 0; k < found.settings.stage.size(); ++k) read_load_history(found.settings.stage[k], k, folder);
    found.places = Places(std::move(document), problem::expand_sweeps(found.settings));
  } catch (const KeyError& error) {
    throw InputError(written.located(error.what()));
  }
  return found;
}

}  // namespace

void find_libraries(std::vector<std::pair<std::string, material::Material>>& materials, const std::filesystem::path& folder)
{
  const auto find_library = [&](auto* law) {
    if (law != nullptr) law->library = std::filesystem::absolute(folder / law->library).lexically_normal().string();
  };
  for (auto& entry : materials) {
    find_library(entry.second.get_if<material::UserLaw<material::Interface::own>>());
    find_library(entry.second.get_if<material::UserLaw<material::Interface::umat>>());
  }
}

CaseInFile read_case_in_file(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  return case_of(parse_file(file), overrides, file.parent_path());
}

problem::Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  return case_of(parse_file(file), overrides, file.parent_path()).settings;
}

problem::Case read_case_text(const std::string& file, const std::string& text, const std::vector<std::string>& overrides)
{
  return case_of(parse_text(file, text), overrides, std::filesystem::path(file).parent_path()).settings;
}

namespace {

/// The number that a field is, without the spaces around it; empty where it is none.
std::optional<Real> number_of(std::string_view field)
{
  const auto begin = field.find_first_not_of(" \t"), end = field.find_last_not_of(" \t\r");
  if (begin == std::string_view::npos) return std::nullopt;
  field = field.substr(begin, end + 1 - begin);
  Real number = 0;
  const auto [rest, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  if (error != std::errc() || rest != field.data() + field.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

}  // namespace

void read_load_history(problem::StageSettings& stage, std::size_t stage_number, const std::filesystem::path& folder)
{
  if (stage.load_history.empty() && stage.load_times.empty()) return;
  if (!stage.load_history.empty()) {
    const std::filesystem::path file = folder / stage.load_history;
    std::ifstream lines(file);
    if (!lines) throw KeyError(fmt::format("stage[{}].load_history: {} cannot be read", stage_number, file.string()));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
      if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
      const std::size_t comma = line.find(',');
      const auto time = number_of(std::string_view(line).substr(0, comma));
      const auto factor = comma == std::string::npos ? std::nullopt : number_of(std::string_view(line).substr(comma + 1));
      if (!time && !factor && stage.load_times.empty() && comma != std::string::npos) continue;
      const auto refuse = [&](const char* why) { throw InputError(fmt::format("{}:{}: {}", file.string(), number, why)); };
      if (!time || !factor) refuse("a line of a load history is two numbers, time in s and factor: 0.5, 1.2");
      if (*time < 0) refuse("times count from the begin of the stage: 0 or more");
      if (!stage.load_times.empty() && *time <= stage.load_times.back()) refuse("times must ascend");
      stage.load_times.push_back(*time);
      stage.load_factors.push_back(*factor);
    }
    if (stage.load_times.empty() || stage.load_times.back() == 0)
      throw InputError(fmt::format("{}: has no line of two numbers, time in s (more than 0) and factor", file.string()));
    stage.load_history.clear();
  }
  stage.until.time = std::min(stage.until.time.value_or(infinity), stage.load_times.back());
}

}  // namespace berm::input
