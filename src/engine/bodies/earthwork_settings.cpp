// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/earthworks_test.cpp
#include "bodies/earthwork_settings.hpp"

namespace berm::bodies {
namespace {

void describe_common(Describe& d, EarthworkSettings& work, const char* order)
{
  d.value("name", work.name, {.meaning = "its name, in the log, the history and on the page", .required = true});
  d.value("stage", work.stage, {.meaning = "name of the stage that it starts with", .required = true});
  describe(d, work.area);
  d.value("z_range", work.z_range, {.meaning = "in space: range of z, its lower and upper end; absent: all along z", .unit = "m"});
  d.value("lifts", work.lifts, {.meaning = order, .range = {1, 1000}});
  d.value("duration", work.duration,
          {.meaning = "time over which the lifts are spread evenly, the first as the stage starts; lifts that are left when the stage ends "
                      "follow at once",
           .unit = "s",
           .range = not_negative});
}

}  // namespace

void describe(Describe& d, ExcavationSettings& excavation)
{
  describe_common(d, excavation, "equal steps of height in which soil is removed, from the top down");
}

void describe(Describe& d, FillSettings& fill)
{
  describe_common(d, fill, "equal steps of height in which soil is placed, from the bottom up");
  d.value("material", fill.material, {.meaning = "name of its [material.NAME], with the law of the body's", .required = true});
  d.value("k0", fill.k0,
          {.meaning = "ratio of horizontal to vertical stress under its own weight when it is placed; absent: it is placed without stress",
           .range = {0, 5}});
}

}  // namespace berm::bodies
