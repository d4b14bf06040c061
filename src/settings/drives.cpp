// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/stages_test.cpp
#include "settings/drives.hpp"

#include <algorithm>

namespace berm::settings {
namespace {

using By = FreedomDrive::By;

void set(FreedomDrive& drive, const FreedomSettings& settings)
{
  if (settings.velocity) drive = {By::velocity, *settings.velocity, 0, true};
  if (settings.force) drive = {By::force, *settings.force};
  if (settings.hold) drive = {By::hold, 0};
  if (settings.free) drive = {By::free, 0};
  if (settings.spring && !settings.force && !settings.hold) drive = {By::force, 0};
  drive.spring = settings.spring.value_or(0);
}

void set(FreedomDrive& drive, const TurnSettings& settings)
{
  if (settings.velocity) drive = {By::velocity, *settings.velocity, 0, true};
  if (settings.moment) drive = {By::force, *settings.moment};
  if (settings.fixed) drive = {By::velocity, 0};
  if (settings.free) drive = {By::free, 0};
  if (settings.spring && !settings.moment) drive = {By::force, 0};
  drive.spring = settings.spring.value_or(0);
}

template <int dim>
void set_rotations(const StageSettings& stage, StageDrives<dim>& drives)
{
  if constexpr (dim == 2) {
    set(drives[2], stage.drive.rotation);
  } else {
    set(drives[3], stage.drive.rotation_x);
    set(drives[4], stage.drive.rotation_y);
    set(drives[5], stage.drive.rotation_z);
  }
}

}  // namespace

template <int dim>
StageDrives<dim> drives_of(const StageSettings& stage, const Axes<dim>& axes, bool turns)
{
  StageDrives<dim> drives;
  for (int d = dim; d < bodies::freedoms<dim>; ++d) drives[d].by = turns ? By::free : By::velocity;
  const auto along_axis = [&](FreedomDrive& drive, const std::optional<Real>& velocity, const std::optional<Real>& force, Real sign) {
    if (velocity)
      drive = {By::velocity, sign * *velocity, 0, true};
    else if (force)
      drive = {By::force, sign * *force};
  };
  const Real down = -axes.sign;
  FreedomDrive& vertical = drives[axes.up];
  if (settings::drives(stage.kind)) set_rotations<dim>(stage, drives);
  switch (stage.kind) {
  case StageKind::push:
    along_axis(vertical, stage.velocity, stage.force, down);
    break;
  case StageKind::drag:
  case StageKind::sweep:
    for (FreedomDrive& drive : drives) drive.named = true;
    along_axis(drives[axes.along], stage.velocity, stage.force, 1);
    if (stage.vertical_velocity)
      vertical = {By::velocity, down * *stage.vertical_velocity, 0, true};
    else if (stage.vertical == Vertical::hold)
      vertical = stage.vertical_force ? FreedomDrive{By::force, down * *stage.vertical_force} : FreedomDrive{By::hold, 0};
    break;
  case StageKind::drive: {
    const FreedomSettings* settings[3] = {&stage.drive.x, &stage.drive.y, &stage.drive.z};
    for (int d = 0; d < dim; ++d) set(drives[d], *settings[d]);
    break;
  }
  case StageKind::pipeline:  // stands still until the line moves it
  case StageKind::geostatic:
  case StageKind::free:
    break;
  }
  for (std::size_t k = 0; k < load_columns.size(); ++k) {
    if (stage.loads.columns[k].empty()) continue;
    if (load_columns[k].quantity == LoadQuantity::water) {
      drives[axes.along] = {By::force, 1, 0, true};
      drives[axes.up] = {By::force, down, 0, true};
      continue;
    }
    const auto [freedom, sign] = freedom_of<dim>(load_columns[k].along, axes);
    if (freedom != none)
      drives[freedom] = {load_columns[k].quantity == LoadQuantity::force ? By::force : By::velocity, sign, drives[freedom].spring, true};
  }
  return drives;
}

template <int dim>
LoadedFreedom freedom_of(LoadAlong along, const Axes<dim>& axes)
{
  const int turn = static_cast<int>(along) - static_cast<int>(LoadAlong::rotation_x);
  switch (along) {
  case LoadAlong::horizontal:
    return {axes.along, 1};
  case LoadAlong::downwards:
    return {axes.up, -axes.sign};
  case LoadAlong::x:
    return {0, 1};
  case LoadAlong::y:
    return {1, 1};
  case LoadAlong::z:
    return {dim == 3 ? 2 : none, 1};
  case LoadAlong::rotation:
    return {dim == 2 ? 2 : none, 1};
  case LoadAlong::rotation_x:
  case LoadAlong::rotation_y:
  case LoadAlong::rotation_z:
    break;
  case LoadAlong::water:
  case LoadAlong::temperature:
  case LoadAlong::far_temperature:
  case LoadAlong::pressure:
  case LoadAlong::weight:
  case LoadAlong::lateral:
  case LoadAlong::pull:
    return {none, 1};
  }
  return {dim == 3 ? 3 + turn : none, 1};
}

template <int dim>
int load_column_of(const StageSettings& stage, const Axes<dim>& axes, int freedom)
{
  for (std::size_t k = 0; k < load_columns.size(); ++k)
    if (const LoadColumn& column = load_columns[k];
        !stage.loads.columns[k].empty() &&
        (column.quantity == LoadQuantity::water ? freedom == axes.along || freedom == axes.up
                                                : freedom_of<dim>(column.along, axes).freedom == freedom))
      return static_cast<int>(k);
  return none;
}

template <int dim>
bool has_force(const StageDrives<dim>& drives)
{
  return std::any_of(drives.begin(), drives.begin() + dim,
                     [](const FreedomDrive& d) { return d.by == By::force || d.by == By::hold || d.by == By::free; });
}

template <int dim>
bool has_moment(const StageDrives<dim>& drives)
{
  return std::any_of(drives.begin() + dim, drives.end(), [](const FreedomDrive& d) { return d.by == By::force || d.by == By::free; });
}

template LoadedFreedom freedom_of(LoadAlong, const Axes<2>&);
template LoadedFreedom freedom_of(LoadAlong, const Axes<3>&);
template int load_column_of(const StageSettings&, const Axes<2>&, int);
template int load_column_of(const StageSettings&, const Axes<3>&, int);
template StageDrives<2> drives_of(const StageSettings&, const Axes<2>&, bool);
template StageDrives<3> drives_of(const StageSettings&, const Axes<3>&, bool);
template bool has_force<2>(const StageDrives<2>&);
template bool has_force<3>(const StageDrives<3>&);
template bool has_moment<2>(const StageDrives<2>&);
template bool has_moment<3>(const StageDrives<3>&);

}  // namespace berm::settings
