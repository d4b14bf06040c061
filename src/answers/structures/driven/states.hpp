// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/driven/path.hpp"

namespace berm::driven {

/// The names of the states in the life of a pipe, in their order.
constexpr const char* state_names[] = {"touchdown", "laid", "flooded", "emptied", "operation"};

/// The body between two travels: what a spring, an axial resistance or a formula is of.
struct State {
  std::string name;    ///< one of state_names, or after_TRAVEL
  std::string origin;  ///< basis, in words: "end of stage unload, before sweep_1"
  std::string stage;   ///< of the case, at whose end it is
  Index row;           ///< of the history
  /// m, N/m: u and w of the row, forces means over the last twentieth of the stage; V where it is given that, at the end of the way down that of V_end_of_push.
  Real u, w, H, V;
  bool V_given = false;  ///< by the stage: a push by force, a drag under a vertical force
};
using States = std::vector<State>;

/// The states of a run, in the order of time:
///   touchdown     where the way down ends (the pushes before the first drag that load the body further);
///   laid          after the last drag that lays the pipe (Stage::lays);
///   flooded, emptied   where the last stage of that role ends;
///   operation     where the last stage of that role ends; without that role, where the main drag begins, under the vertical force that this holds, and
///                 of a run without a drag where it ends, or before the lifts that end it (OtherPush::lifts);
///   after_TRAVEL  where each other drag ends.
/// Empty where the history has no w.
States states_of(const record::RunRecord& run);

/// The state of this name; null where there is none.
const State* find_state(const States& states, const std::string& name);

/// A fill or an excavation at the body: what pushes and drags before it found is of soil that is no longer there, or no longer as it was.
struct SoilWork {
  std::string words;  ///< "excavation trench, in stage \"trench\""
  Index row;          ///< of the history, the first of its stage
};
/// The last that had begun at a row: its area comes within near_the_body of the body's width to the body, some time in its stage. Empty where there is none.
constexpr Real near_the_body = 2;
std::optional<SoilWork> last_soil_work(const record::RunRecord& run, Index row);

/// Whether the run tells more than a push, and drags right after it: its states have numbers of their own.
bool has_states_between(const States& states);

}  // namespace berm::driven
