// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"

#include "input/load_history.hpp"
#include "input/override.hpp"
#include "input/pipeline_tables.hpp"
#include "input/reader.hpp"
#include "input/structure_words.hpp"
#include "material/user_law.hpp"
#include "os/error.hpp"
#include "settings/sweeps.hpp"
#include "slices/place_slices.hpp"

#include <fmt/format.h>

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

void find_macro_element(settings::FarSoil& soil, const std::filesystem::path& folder)
{
  if (!soil.macro_element.empty()) soil.macro_element = std::filesystem::absolute(folder / soil.macro_element).lexically_normal().string();
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

CaseInFile case_of(Document document, const std::vector<std::string>& overrides)
{
  const std::filesystem::path folder = std::filesystem::path(document.file).parent_path();
  if (const Node* tests = member(document.root, "test"))
    refuse(document, *tests, "test", "this is an input of element tests, for berm element, not a case");
  for (const std::string& override : overrides) apply_override(document, override);
  CaseInFile found;
  read(document, found.settings);
  find_libraries(found.settings.material, folder);
  Places written(document);
  try {
    read_surfaces(found.settings.rigid, folder);
    for (std::size_t k = 0; k < found.settings.stage.size(); ++k) read_load_history(found.settings, k, folder);
    for (std::size_t k = 0; k < found.settings.support.size(); ++k) read_motion(found.settings, k, folder);
    if (found.settings.pipeline) {
      find_macro_element(found.settings.pipeline->far_soil, folder);
      read_pipeline_tables(*found.settings.pipeline, folder);
    }
    const std::vector<std::size_t> repeated = settings::expand_repeats(found.settings);
    written = Places(document, repeated);
    std::vector<std::size_t> origins = settings::expand_sweeps(found.settings);
    for (std::size_t& origin : origins) origin = repeated[origin];
    written = found.places = Places(std::move(document), origins);
    if (found.settings.pipeline) slices::place_slices(found.settings);
    check_structures(found.settings);
  } catch (const KeyError& error) {
    throw LocatedError(written.located(error));
  }
  return found;
}

CaseInFile case_of(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  return case_of(parse_file(file), overrides);
}

settings::Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  return case_of(file, overrides).settings;
}

settings::Case read_case_text(const std::string& file, const std::string& text, const std::vector<std::string>& overrides)
{
  return case_of(parse_text(file, text), overrides).settings;
}

}  // namespace berm::input
