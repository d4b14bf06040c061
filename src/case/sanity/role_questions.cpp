// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

using settings::StageKind;
using settings::StageRole;
using settings::StageSettings;

/// The roles that come in an order, in that; sweeps may come anywhere.
constexpr std::pair<StageRole, const char*> life[] = {{StageRole::touchdown, "touchdown"}, {StageRole::lay, "lay"},
                                                      {StageRole::flooded, "flooded"},     {StageRole::emptied, "emptied"},
                                                      {StageRole::operation, "operation"}, {StageRole::breakout, "breakout"}};

/// The place of a role in that order; none for one that has none.
Index place_in_life(StageRole role)
{
  const auto found = std::find_if(std::begin(life), std::end(life), [&](const auto& of) { return of.first == role; });
  return found == std::end(life) ? none : static_cast<Index>(found - std::begin(life));
}

bool is_drag(const Scene& s, std::size_t k)
{
  const StageSettings& stage = s.c.stage[k];
  if (stage.kind == StageKind::drag) return stage.velocity != Real(0);
  return stage.kind == StageKind::drive && s.ways[k].axis[s.along].moves;
}

/// The drag whose resistance is the answer where no stage has the role operation or breakout: the first that does not lay the pipe, else the last.
std::optional<std::size_t> drag_of_the_answers(const Scene& s)
{
  std::optional<std::size_t> last;
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    if (!is_drag(s, k)) continue;
    last = k;
    if (s.c.stage[k].role != StageRole::lay) return k;
  }
  return last;
}

/// What table programs (pandas, R) read as a missing value.
constexpr const char* missing_values[] = {"NA", "N/A", "NULL", "NaN", "None", "n/a", "nan", "null", "<NA>", "#NA", "#N/A", "-nan", "-NaN"};

}  // namespace

void check_names(const Scene& s, Findings& found)
{
  for (std::size_t k = 0; k < s.c.stage.size(); ++k)
    for (const char* word : missing_values)
      if (s.c.stage[k].name == word)
        found.warn(stage_key(k, "name"),
                   fmt::format("is \"{}\", which table programs such as pandas read as a missing value: in the stage column of history.csv "
                               "the stage would have no name; take another",
                               word));
}

void check_role_order(const Scene& s, Findings& found)
{
  Index last = none;
  std::string of_stage;
  for (std::size_t k = 0; k < s.c.stage.size(); ++k) {
    const Index place = place_in_life(s.c.stage[k].role);
    if (place == none) continue;
    if (last != none && place < last)
      return found.warn(stage_key(k, "role"),
                        fmt::format("is \"{}\", and stage \"{}\" before it is \"{}\": the order for a pipe is touchdown, lay, flooded, "
                                    "emptied, operation and breakout; change the role of one of the two",
                                    life[place].second, of_stage, life[last].second));
    last = place;
    of_stage = s.c.stage[k].name;
  }
}

void are_roles_those_of_what_stages_do(const Scene& s, Findings& found)
{
  for (std::size_t k = 0; k < s.c.stage.size(); ++k) {
    const StageRole role = s.c.stage[k].role;
    const Index place = place_in_life(role);
    const bool only_a_weight = role == StageRole::flooded || role == StageRole::emptied;
    if (place == none || !only_a_weight || !is_drag(s, k)) continue;
    found.warn(stage_key(k, "role"),
               fmt::format("is \"{}\", and the stage moves the body along the seabed: {} only the weight of a pipe changes; motions during "
                           "laying have the role \"lay\", later ones \"sweep\" or \"breakout\"",
                           life[place].second, role == StageRole::flooded ? "flooding" : "emptying"));
  }
}

void are_weights_those_of_one_pipe(const Scene& s, Findings& found)
{
  constexpr Real much = 3;  // largest V of laying over weight in water is 1 to 3, and a flooded pipe weighs up to 3 times an empty one
  Real largest = 0;
  std::string of_stage;
  const char* unit = s.c.force_dimension() == 2 ? "N/m" : "N";
  for (std::size_t k = 0; k < s.c.stage.size(); ++k) {
    const StageSettings& stage = s.c.stage[k];
    const bool push = stage.kind == StageKind::push;
    const char* key = stage.vertical_force ? "vertical_force" : stage.force ? "force" : "until.force";
    const std::optional<Real> V = stage.vertical_force ? stage.vertical_force
                                  : !push              ? std::nullopt
                                  : stage.force        ? stage.force
                                                       : stage.until.force;
    if (!V || has_load_history(stage)) continue;
    const bool before_drag = push && stage.force && stage.role == StageRole::automatic && k + 1 < s.c.stage.size() && is_drag(s, k + 1);
    const bool weight = stage.role == StageRole::operation || stage.role == StageRole::emptied || before_drag;
    if (weight && largest > 0 && *V > much * largest)
      found.warn(stage_key(k, key),
                 fmt::format("is {:.3g} {}, and the largest V before is {:.3g} {} in stage \"{}\": at touchdown the contact force of a "
                             "pipe is 1 to 3 times its submerged weight; is the unit of either right?",
                             *V, unit, largest, unit, of_stage));
    if (*V > largest) largest = *V, of_stage = stage.name;
  }
}

void check_result_stage_is_named(const Scene& s, Findings& found)
{
  const std::vector<StageSettings>& stages = s.c.stage;
  const auto has_role = [](const StageSettings& stage) { return stage.role != StageRole::automatic; };
  const auto says = [](const StageSettings& stage) { return stage.role == StageRole::operation || stage.role == StageRole::breakout; };
  const auto first = std::find_if(stages.begin(), stages.end(), has_role);
  const std::optional<std::size_t> answers = drag_of_the_answers(s);
  if (first == stages.end() || !answers || std::any_of(stages.begin(), stages.end(), says)) return;
  if (stages[*answers].role == StageRole::sweep) return;
  found.warn(stage_key(static_cast<std::size_t>(first - stages.begin()), "role"),
             fmt::format("is given, so the roles of other stages are not guessed, and none of them is operation or breakout: the key "
                         "results are those of stage \"{}\"; give the role \"breakout\" to it, or to the stage whose results you want",
                         stages[*answers].name));
}

}  // namespace berm::sanity
