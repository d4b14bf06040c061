// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_test.cpp
#include "envelope/envelope_probes.hpp"

#include "os/error.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::envelope {
namespace {

constexpr Real steepest = 90, flattest = -45;            // degrees below the horizontal
constexpr Real steepest_turn = 60, flattest_turn = -20;  // of a footing that turns
constexpr int usual_turns = 5;

bool drives(const settings::StageSettings& stage)
{
  return stage.kind == settings::StageKind::push || stage.kind == settings::StageKind::drag;
}

/// The first stage that drives the body.
std::vector<settings::StageSettings>::const_iterator first_drive(const settings::Case& c)
{
  return std::find_if(c.stage.begin(), c.stage.end(), drives);
}

std::string unused_name(std::string name, const std::vector<settings::StageSettings>& stages)
{
  while (std::any_of(stages.begin(), stages.end(), [&](const settings::StageSettings& stage) { return stage.name == name; }))
    name += "_probe";
  return name;
}

/// Makes the stages of the probes of one case.
class ProbeMaker {
public:
  ProbeMaker(const settings::Case& c, const base::EmbeddedBody& body, Real travel) : case_(c), body_(body), travel_(travel * body.width)
  {
    const auto first = first_drive(c);
    if (first == c.stage.end() || !first->velocity || *first->velocity == 0)
      throw KeyError("stage: an envelope needs a push or a drag by velocity in the case, whose speed its probes take");
    drive_.rigid = first->rigid;
    drive_.damping = first->damping;
    drive_.ramp = first->ramp;
    speed_ = std::abs(*first->velocity);
    case_.stage.erase(case_.stage.begin() + (first - c.stage.begin()), case_.stage.end());
    if (body.arm) prepare_turning(main_rigid(c));
  }

  Probe direction(Real angle) const
  {
    Probe probe{angle == steepest ? "down" : fmt::format("direction_{:.4g}", angle), ProbeKind::direction, angle, case_, ""};
    settings::StageSettings stage = drive_for("probe");
    if (angle == steepest) {
      stage.kind = settings::StageKind::push;
      stage.velocity = speed_;
    } else {
      stage.kind = settings::StageKind::drag;
      stage.velocity = speed_ * std::cos(angle * degree);
      stage.vertical_velocity = speed_ * std::sin(angle * degree);
    }
    add(probe, stage);
    return probe;
  }

  Probe swipe() const
  {
    Probe probe{"swipe", ProbeKind::swipe, nan, case_, ""};
    settings::StageSettings push = drive_for("push"), drag = drive_for("swipe");
    push.kind = settings::StageKind::push;
    drag.kind = settings::StageKind::drag;
    drag.vertical = settings::Vertical::fixed;
    push.velocity = drag.velocity = speed_;
    add(probe, push);
    add(probe, drag);
    return probe;
  }

  /// Down and turning, free to move sideways.
  Probe turn(Real angle) const
  {
    Probe probe{fmt::format("turn_{:.4g}", angle), ProbeKind::direction, angle, case_, "", 90, true};
    add(probe, turning("probe", angle, 90, true));
    return probe;
  }

  /// A push, then sideways and turning at that depth: for 90 degrees and free sideways turning alone.
  Probe swipe(Real turn, bool free_sideways) const
  {
    Probe probe{free_sideways ? "swipe_turn" : fmt::format("swipe_{:.4g}", turn), ProbeKind::swipe, nan, case_, "", turn, free_sideways};
    settings::StageSettings push = drive_for("push");
    push.kind = settings::StageKind::push;
    push.velocity = speed_;
    add(probe, push);
    add(probe, turning("swipe", 0, turn, free_sideways));
    return probe;
  }

private:
  /// The displacements are those of the point that moments are about; the body's centre lies above it, and is driven.
  settings::StageSettings turning(const char* name, Real angle, Real turn, bool free_sideways) const
  {
    settings::StageSettings stage = drive_for(name);
    stage.kind = settings::StageKind::drive;
    const Real flat = speed_ * std::cos(angle * degree), clockwise = flat * std::sin(turn * degree) / body_.width;
    if (angle != 0) stage.drive.y.velocity = -speed_ * std::sin(angle * degree);
    if (free_sideways)
      stage.drive.x.free = true;
    else
      stage.drive.x.velocity = flat * std::cos(turn * degree) + clockwise * *body_.arm;
    (case_.dimension() == 2 ? stage.drive.rotation : stage.drive.rotation_z).velocity = -clockwise;
    return stage;
  }
  /// A footing turns when a probe says so, and one that moves freely has inertia, which finite elements do not know.
  void prepare_turning(Index footing)
  {
    auto& [name, rigid] = case_.rigid[footing];
    rigid.rotation = bodies::Rotation::fixed;
    if (rigid.mass > 0) return;
    if (case_.method == settings::Method::mpm)
      throw KeyError(fmt::format("rigid.{}.mass: is needed: probes that rotate the footing leave it free to move laterally", name));
    rigid.mass = 1;
  }
  settings::StageSettings drive_for(const char* name) const
  {
    settings::StageSettings stage = drive_;
    stage.name = unused_name(name, case_.stage);
    stage.until.time = travel_ / speed_ + stage.ramp / 2;
    return stage;
  }
  static void add(Probe& probe, const settings::StageSettings& stage)
  {
    probe.settings.stage.push_back(stage);
    probe.stage = stage.name;
  }

  settings::Case case_;
  base::EmbeddedBody body_;
  Real travel_, speed_ = 0;  ///< m, m/s
  settings::StageSettings drive_;
};

}  // namespace

base::EmbeddedBody embedded_body(const settings::Case& c)
{
  return structures::structure_of(c).embedded(c);
}

std::vector<Probe> choose_probes(const settings::Case& c, const EnvelopeSettings& settings)
{
  const base::EmbeddedBody body = embedded_body(c);
  if (settings.turns && !body.arm) throw KeyError("rigid: a pipe has no moments to search: --turns is for a footing");
  const ProbeMaker maker(c, body, settings.travel);
  std::vector<Probe> probes;
  const int n = settings.directions;
  for (int k = 0; k < n; ++k)
    probes.push_back(maker.direction(body.arm ? steepest * (n - k) / n : steepest - (steepest - flattest) * k / (n - 1)));
  probes.push_back(maker.swipe());
  if (!body.arm) return probes;
  const int turns = settings.turns.value_or(usual_turns);
  for (int k = 0; k < turns; ++k)
    probes.push_back(maker.turn(turns == 1 ? 0 : steepest_turn - (steepest_turn - flattest_turn) * k / (turns - 1)));
  if (turns > 0) probes.push_back(maker.swipe(90, true));
  for (int k = 1; k <= turns; ++k) probes.push_back(maker.swipe(Real(180) * k / (turns + 1), false));
  return probes;
}

}  // namespace berm::envelope
