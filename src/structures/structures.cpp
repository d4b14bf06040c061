// SPDX-License-Identifier: BSD-3-Clause
#include "structures/structures.hpp"

#include "input/message_text.hpp"
#include "os/error.hpp"
#include "structures/anchor/anchor.hpp"
#include "structures/ball/ball.hpp"
#include "structures/cone/cone.hpp"
#include "structures/footing/footing.hpp"
#include "structures/generic/generic.hpp"
#include "structures/lateral/shaft.hpp"
#include "structures/line/line.hpp"
#include "structures/pile/pile.hpp"
#include "structures/pipe/pipe.hpp"
#include "structures/skirt/skirt.hpp"
#include "structures/t_bar/t_bar.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::structures {
namespace {

std::vector<std::string> all_words()
{
  std::vector<std::string> words = {"automatic"};
  for (const base::Structure* structure : all_structures()) words.emplace_back(structure->word());
  return words;
}

/// Throws KeyError where the input names a structure that there is not, or not in this geometry.
void check_structures(const problem::Case& c)
{
  for (const auto& [name, rigid] : c.rigid) {
    const std::string& word = rigid.structure;
    const auto refuse = [&, &of = name](const std::string& why, const std::vector<std::string>& allowed) {
      throw KeyError(fmt::format("rigid.{}.structure: {}{}", of, why, input::suggestion(word, allowed)));
    };
    if (word == "automatic") continue;
    const auto found = std::ranges::find(all_structures(), word, &base::Structure::word);
    if (found == all_structures().end()) refuse(fmt::format("{} is not one of its words", input::in_quotes(word)), all_words());
    const bool in_plane = c.geometry == problem::Geometry::plane_strain;
    if ((*found)->geometries() == base::Geometries::round && in_plane)
      refuse("is round: it needs geometry = \"axisymmetric\" or \"space\"; in plane strain a body is a bar or a strip",
             {"t_bar", "footing", "pipe"});
    if ((*found)->geometries() == base::Geometries::plane && !in_plane)
      refuse("is pushed across itself: it needs geometry = \"plane_strain\"", {"ball", "pipe"});
  }
}

input::Listed& child(input::Listed& table, const std::string& key)
{
  return *std::ranges::find(table.children, key, &input::Listed::key);
}

}  // namespace

const std::vector<const base::Structure*>& all_structures()
{
  static const penetration::Penetration cone(cone::reading()), ball(ball::reading()), t_bar(t_bar::reading());
  static const lateral::Shaft pile(pile::reading());
  static const skirt::Skirt skirt;
  static const footing::Footing footing;
  static const anchor::Anchor anchor;
  static const pipe::Pipe pipe;
  static const line::Line line;
  static const generic::Generic generic;
  static const std::vector<const base::Structure*> all = {&cone, &ball, &t_bar, &pile, &skirt, &footing, &anchor, &line, &pipe, &generic};
  return all;
}

const base::Structure& structure_of(const problem::Case& c)
{
  const std::vector<const base::Structure*>& all = all_structures();
  return **std::find_if(all.begin(), all.end(), [&](const base::Structure* structure) { return structure->applies_to(c); });
}

input::CaseInFile read_case(input::Document document, const std::vector<std::string>& overrides)
{
  input::CaseInFile found = input::case_of(std::move(document), overrides);
  try {
    check_structures(found.settings);
  } catch (const KeyError& error) {
    throw input::LocatedError(found.places.located(error));
  }
  return found;
}

input::CaseInFile read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  return read_case(input::parse_file(file), overrides);
}

input::Listed case_catalogue()
{
  input::Listed all = input::catalogue_of<problem::Case>();
  input::Listed& structure = child(child(all, "rigid"), "structure");
  structure.kind = input::Listed::Kind::word;
  structure.words = all_words();
  structure.default_text = structure.words.front();
  structure.default_value = structure.default_text;
  return all;
}

base::Runs runs_of(const base::Structure& structure, const std::vector<record::RunRecord>& runs)
{
  base::Runs found;
  for (std::size_t number = 0; number < runs.size(); ++number)
    if (&structure_of(runs[number].settings) == &structure) found.push_back({&runs[number], number});
  return found;
}

record::RunRecord read_run(const std::filesystem::path& folder)
{
  record::RunRecord run = record::read_run(folder);
  if (!run.summary && run.history.rows() > 0) run.quantities = structure_of(run.settings).quantities(run, {});
  return run;
}

}  // namespace berm::structures
