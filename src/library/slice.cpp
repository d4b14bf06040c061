// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/interfaces/slice.c
#include <berm/berm.hpp>
#include <berm/slice.h>

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <mutex>

/// A run of the case, and the stage that its caller drives.
struct berm_slice {
  berm::Run run;
  std::string stage;
};

namespace berm {
namespace {

thread_local std::string last_message;
std::mutex one_at_a_time;  ///< as slices share the process's messages

/// Does what may throw, and gives the code.
template <class Act>
int code_of(const Act& act)
{
  const std::lock_guard lock(one_at_a_time);
  try {
    act();
    return BERM_SLICE_OK;
  } catch (const InputError& error) {
    last_message = error.what();
    return BERM_SLICE_INPUT;
  } catch (const std::exception& error) {
    last_message = error.what();
    return BERM_SLICE_FAILED;
  }
}

void need(const void* pointer, const char* what)
{
  if (pointer == nullptr) throw InputError(fmt::format("{} is null", what));
}

RigidBodyNow body_of(const berm_slice& slice)
{
  return slice.run.rigid_bodies()[0];
}

void take_step(berm_slice& slice, const double velocity[3], double dt, double force[3])
{
  Run& run = slice.run;
  if (slice.stage.empty()) throw InputError("the slice is not laid: call berm_slice_lay first");
  for (int k = 0; k < 3; ++k)
    if (std::isinf(velocity[k])) throw InputError("velocity: it must be finite, or NaN to keep the present velocity");
  if (!(dt > 0 && std::isfinite(dt))) throw InputError(fmt::format("dt: {} s: it must be more than 0", dt));
  constexpr Freedom freedoms[] = {Freedom::x, Freedom::y, Freedom::rotation};
  for (int k = 0; k < 3; ++k)
    if (!std::isnan(velocity[k])) run.drive_by_velocity(freedoms[k], velocity[k]);
  const RigidBodyNow before = body_of(slice);
  const double from = run.time(), to = from + dt;
  // A time step that ends at `to` but for rounding is taken as it is: one that is shorter by that would leave a rest of nothing but rounding.
  constexpr double rounding = 1e-9;
  for (double rest = dt; rest > rounding * std::min(run.time_step(), dt); rest = to - run.time()) {
    run.limit_time_step((1 + rounding) * rest);
    if (!run.step() || run.stage() != slice.stage)
      throw RunError(fmt::format("stage {} ended at {:.6g} s: a longer until.time allows more steps", slice.stage, run.time()));
  }
  run.limit_time_step(std::numeric_limits<double>::infinity());  // the next caller's dt may be longer
  const RigidBodyNow after = body_of(slice);
  const double time = run.time() - from;
  for (int d = 0; d < 2; ++d) force[d] = (after.impulse[d] - before.impulse[d]) / time;
  force[2] = (after.angular_impulse[2] - before.angular_impulse[2]) / time;
}

}  // namespace
}  // namespace berm

int berm_slice_open(const char* case_file, int count, const char* const* set, berm_slice** slice)
{
  return berm::code_of([&] {
    berm::need(case_file, "case_file");
    berm::need(slice, "slice");
    berm::RunOptions options;
    if (count > 0) berm::need(set, "set");
    for (int k = 0; k < count; ++k) {
      berm::need(set[k], "set[k]");
      options.set.emplace_back(set[k]);
    }
    berm::Run run(case_file, options);
    if (run.dimension() != 2 || run.is_axisymmetric() || run.rigid_bodies().size() != 1)
      throw berm::InputError(fmt::format("{}: a slice is in plane strain and has one rigid body", case_file));
    *slice = new berm_slice{std::move(run), ""};
  });
}

int berm_slice_lay(berm_slice* slice, const char* stage)
{
  return berm::code_of([&] {
    berm::need(slice, "slice");
    berm::need(stage, "stage");
    while (slice->run.stage() != stage)
      if (!slice->run.step()) throw berm::InputError(fmt::format("the case ends without a stage \"{}\"", stage));
    slice->stage = stage;
  });
}

int berm_slice_step(berm_slice* slice, const double velocity[3], double dt, double force[3])
{
  return berm::code_of([&] {
    berm::need(slice, "slice");
    berm::need(velocity, "velocity");
    berm::need(force, "force");
    berm::take_step(*slice, velocity, dt, force);
  });
}

int berm_slice_now(const berm_slice* slice, berm_slice_state* now)
{
  return berm::code_of([&] {
    berm::need(slice, "slice");
    berm::need(now, "now");
    const berm::RigidBodyNow body = berm::body_of(*slice);
    *now = {slice->run.time(), {body.centre[0], body.centre[1]}, body.displacement[0],
            body.embedment,    {body.force[0], body.force[1]},   slice->run.contact_mass()};
  });
}

int berm_slice_clone(berm_slice* slice, berm_slice** copy)
{
  return berm::code_of([&] {
    berm::need(slice, "slice");
    berm::need(copy, "copy");
    *copy = new berm_slice{slice->run.clone(), slice->stage};
  });
}

void berm_slice_close(berm_slice* slice)
{
  const std::lock_guard lock(berm::one_at_a_time);
  delete slice;
}

const char* berm_slice_message()
{
  return berm::last_message.c_str();
}
