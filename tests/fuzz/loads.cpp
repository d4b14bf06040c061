// SPDX-License-Identifier: BSD-3-Clause
// Tables over time that a case names. The first byte of an input says what the rest is: f a load history of factors, r the same that runs three times, c one of
// columns in the plane, a around an axis, s in space, m the motion of a support. Refused in one line, or the case with it reads back as the same case.
#include "target.hpp"

#include "input/load_history.hpp"
#include "input/read_case.hpp"
#include "input/write_case.hpp"
#include "problem/stages.hpp"

#include <fmt/format.h>

using namespace berm;

namespace {

constexpr const char* table = "table.csv";

/// A body that a stage drives over clay; `box` the mesh and gravity, `fixed` the directions of its base.
std::string case_text(const std::string& box, const char* rigid, const char* fixed, const char* kind)
{
  return fmt::format(R"({}
material.clay = {{law = "mohr_coulomb", density = 900, young_modulus = 7e6, poisson_ratio = 0.25, cohesion = 2e3, friction_angle = 0}}
body.clay = {{material = "clay", regions = ["box"]}}
rigid.pipe = {{{}, diameter = 0.2, mass = 30}}
contact.skin = {{body = "clay", rigid = "pipe", friction_angle = 0.4}}
support.base = {{boundary = "bottom", fixed = [{}]}}
stage = [{{name = "storm", kind = "{}", until.time = 1, force = 4}}]
)",
                     box, rigid, fixed, kind);
}

const std::string square = "gravity = [0, -10]\nmesh = {kind = \"box\", size = [1, 1], cells = [4, 4]}";
const std::string in_plane = case_text(square, R"(shape = "circle", center = [0.5, 1.1])", R"("x", "y")", "drag");
const std::string around_axis =
    case_text("geometry = \"axisymmetric\"\n" + square, R"(shape = "circle", center = [0, 1.1])", R"("x", "y")", "push");
const std::string in_space =
    case_text("geometry = \"space\"\ngravity = [0, -10, 0]\nmesh = {kind = \"box\", size = [1, 1, 1], cells = [2, 2, 2]}",
              R"(shape = "sphere", center = [0.5, 1.1, 0.5])", R"("x", "y", "z")", "drag");

/// A case whose only stage, or the motion of whose base, has the table.
settings::Case with_table(const std::string& settings, char kind)
{
  settings::Case c = input::read_case_text("case.toml", settings);
  settings::StageSettings& stage = c.stage[0];
  if (kind == 'm') {
    boundary::MotionSettings motion;
    motion.table = table;
    motion.stages = {stage.name};
    c.support[0].second.motion = motion;
    return c;
  }
  stage.load_history = table;
  if (kind == 'r') stage.load_repeat = 3;
  if (kind != 'f' && kind != 'r') stage.force.reset();
  return c;
}

const settings::Case& case_of(char kind)
{
  static const settings::Case factors = with_table(in_plane, 'f'), repeated = with_table(in_plane, 'r'),
                              columns = with_table(in_plane, 'c'), axis = with_table(around_axis, 'a'), space = with_table(in_space, 's'),
                              motion = with_table(in_plane, 'm');
  switch (kind) {
  case 'r':
    return repeated;
  case 'c':
    return columns;
  case 'a':
    return axis;
  case 's':
    return space;
  case 'm':
    return motion;
  default:
    return factors;
  }
}

void promise_times(const std::vector<Real>& times)
{
  for (std::size_t k = 0; k < times.size(); ++k)
    promise(std::isfinite(times[k]) && (k == 0 || times[k] >= times[k - 1]), "times ascend", fmt::format("{}", times[k]));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const MemoryFolder folder;
  const auto [kind, text] = kind_and_text(data, size, 'f');
  folder.hold(table, text);
  settings::Case c = case_of(kind);
  bool is_read = false;
  may_be_refused([&, &kind = kind] {
    if (kind == 'm')
      input::read_motion(c, 0, folder.path());
    else
      input::read_load_history(c, 0, folder.path());
    is_read = true;
  });
  if (!is_read) return 0;
  if (kind == 'm')
    promise_times(c.support[0].second.motion->times);
  else
    promise_times(c.stage[0].load_times);
  promise(expected_time(c.stage[0]) >= 0, "a stage takes time", "");
  const std::string resolved = input::resolved_toml(c);
  promise(input::resolved_toml(input::read_case_text("resolved.toml", resolved)) == resolved, "resolved.toml reads as the same case",
          resolved);
  return 0;
}
