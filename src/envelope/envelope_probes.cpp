// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_test.cpp
#include "envelope/envelope_probes.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::envelope {
namespace {

constexpr Real steepest = 90, flattest = -45;  // degrees below the horizontal

bool drives(const problem::StageSettings& stage)
{
  return stage.kind == problem::StageKind::push || stage.kind == problem::StageKind::drag;
}

/// The first stage that drives the pipe.
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
      throw InputError("stage: an envelope needs a push or a drag by velocity in the case, whose speed its probes take");
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
      stage.velocity = speed_ * std::cos(angle * pi / 180);
      stage.vertical_velocity = speed_ * std::sin(angle * pi / 180);
    }
    add(probe, stage);
    return probe;
  }

  Probe swipe() const
  {
    Probe probe{"swipe", ProbeKind::swipe, std::numeric_limits<Real>::quiet_NaN(), case_, ""};
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

EmbeddedPipe embedded_pipe(const problem::Case& c)
{
  if (c.dimension != 2) throw InputError("dimension: an envelope is that of a pipe in plane strain; it needs dimension = 2");
  const auto drive = first_drive(c);
  const Index main = drive != c.stage.end() && !drive->rigid.empty() ? problem::place_of(c.rigid, drive->rigid)
                     : c.rigid.empty()                               ? none
                                                                     : 0;
  if (main == none) throw InputError("rigid: an envelope needs a pipe: a rigid body with shape = \"circle\"");
  const auto& [name, rigid] = c.rigid[main];
  const auto* circle = std::get_if<bodies::CircleSettings>(&rigid.shape);
  if (circle == nullptr) throw InputError(fmt::format("rigid.{}.shape: an envelope is that of a pipe; it needs \"circle\"", name));
  const EmbeddedPipe pipe{circle->diameter, c.surface - (circle->center[1] - circle->diameter / 2)};
  if (!(pipe.embedment > 0))
    throw InputError(
        fmt::format("rigid.{}.center: the lowest point of the pipe lies {:g} m above the bed; an envelope needs a pipe that lies in it",
                    name, -pipe.embedment));
  if (const auto* seabed = std::get_if<mesh::SeabedMesh>(&c.mesh)) {
    const mesh::SeabedLayout layout = layout_of(*seabed);
    if (circle->center[0] - pipe.diameter / 2 < layout.left || circle->center[0] + pipe.diameter / 2 > layout.right)
      throw InputError(fmt::format("rigid.{}.center: the pipe reaches beyond a wall of the mesh; an envelope needs the whole pipe", name));
  }
  return pipe;
}

std::vector<Probe> choose_probes(const problem::Case& c, const EnvelopeSettings& settings)
{
  const ProbeMaker maker(c, settings.travel * embedded_pipe(c).diameter);
  std::vector<Probe> probes;
  for (int k = 0; k < settings.directions; ++k)
    probes.push_back(maker.direction(steepest - (steepest - flattest) * k / (settings.directions - 1)));
  probes.push_back(maker.swipe());
  return probes;
}

}  // namespace berm::envelope
