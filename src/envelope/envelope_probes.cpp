// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_test.cpp
#include "envelope/envelope_probes.hpp"

#include "core/error.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::envelope {
namespace {

constexpr Real steepest = 90, flattest = -45;  // degrees below the horizontal

bool drives(const problem::StageSettings& stage)
{
  return stage.kind == problem::StageKind::push || stage.kind == problem::StageKind::drag;
}

/// The first stage that drives the body.
std::vector<problem::StageSettings>::const_iterator first_drive(const problem::Case& c)
{
  return std::find_if(c.stage.begin(), c.stage.end(), drives);
}

std::string unused_name(std::string name, const std::vector<problem::StageSettings>& stages)
{
  while (std::any_of(stages.begin(), stages.end(), [&](const problem::StageSettings& stage) { return stage.name == name; }))
    name += "_probe";
  return name;
}

/// Makes the stages of the probes of one case.
class ProbeMaker {
public:
  ProbeMaker(const problem::Case& c, Real travel) : case_(c), travel_(travel)
  {
    const auto first = first_drive(c);
    if (first == c.stage.end() || !first->velocity || *first->velocity == 0)
      throw KeyError("stage: an envelope needs a push or a drag by velocity in the case, whose speed its probes take");
    drive_.rigid = first->rigid;
    drive_.damping = first->damping;
    drive_.ramp = first->ramp;
    speed_ = std::abs(*first->velocity);
    case_.stage.erase(case_.stage.begin() + (first - c.stage.begin()), case_.stage.end());
  }

  Probe direction(Real angle) const
  {
    Probe probe{angle == steepest ? "down" : fmt::format("direction_{:.4g}", angle), ProbeKind::direction, angle, case_, ""};
    problem::StageSettings stage = drive_for("probe");
    if (angle == steepest) {
      stage.kind = problem::StageKind::push;
      stage.velocity = speed_;
    } else {
      stage.kind = problem::StageKind::drag;
      stage.velocity = speed_ * std::cos(angle * degree);
      stage.vertical_velocity = speed_ * std::sin(angle * degree);
    }
    add(probe, stage);
    return probe;
  }

  Probe swipe() const
  {
    Probe probe{"swipe", ProbeKind::swipe, nan, case_, ""};
    problem::StageSettings push = drive_for("push"), drag = drive_for("swipe");
    push.kind = problem::StageKind::push;
    drag.kind = problem::StageKind::drag;
    drag.vertical = problem::Vertical::fixed;
    push.velocity = drag.velocity = speed_;
    add(probe, push);
    add(probe, drag);
    return probe;
  }

private:
  problem::StageSettings drive_for(const char* name) const
  {
    problem::StageSettings stage = drive_;
    stage.name = unused_name(name, case_.stage);
    stage.until.time = travel_ / speed_ + stage.ramp / 2;
    return stage;
  }
  static void add(Probe& probe, const problem::StageSettings& stage)
  {
    probe.settings.stage.push_back(stage);
    probe.stage = stage.name;
  }

  problem::Case case_;
  Real travel_, speed_ = 0;  ///< m, m/s
  problem::StageSettings drive_;
};

}  // namespace

base::EmbeddedBody embedded_body(const problem::Case& c)
{
  return structures::structure_of(c).embedded(c);
}

std::vector<Probe> choose_probes(const problem::Case& c, const EnvelopeSettings& settings)
{
  const ProbeMaker maker(c, settings.travel * embedded_body(c).width);
  std::vector<Probe> probes;
  for (int k = 0; k < settings.directions; ++k)
    probes.push_back(maker.direction(steepest - (steepest - flattest) * k / (settings.directions - 1)));
  probes.push_back(maker.swipe());
  return probes;
}

}  // namespace berm::envelope
