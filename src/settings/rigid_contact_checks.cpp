// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/rigid_contact_test.cpp
#include "settings/rigid_contact_checks.hpp"

#include "core/names.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {
bool may_move(const Case& c, const std::string& rigid)
{
  return c.rigid[index_of(c.rigid, rigid)].second.motion == bodies::Motion::free ||
         std::any_of(c.stage.begin(), c.stage.end(), [&](const StageSettings& stage) {
           return drives(stage.kind) && rigid == (stage.rigid.empty() ? c.rigid.front().first : stage.rigid);
         });
}

void check_rigid_contacts(Describe& d, const Case& c)
{
  const std::vector<std::string> names = names_of(c.rigid);
  d.check(c.rigid_contact.size() <= max_rigid_contacts, "rigid_contact", fmt::format("there may be {} at most", max_rigid_contacts));
  for (const auto& [name, contact] : c.rigid_contact) {
    const std::string path = "rigid_contact." + name;
    check_name(d, path + ".rigid", contact.rigid, "rigid", names);
    check_name(d, path + ".other_rigid", contact.other_rigid, "rigid", names);
    d.check(contact.rigid != contact.other_rigid, path + ".other_rigid", "a body is in no contact with itself");
    d.check(c.method == Method::mpm, path,
            "is for the material point method: in finite elements rigid bodies have no contact with each other");
    d.check(c.geometry != Geometry::axisymmetric, path,
            "is for plane strain and space: around an axis bodies do not move towards each other");
    d.check(index_of(c.body, name) == none && index_of(c.watch, name) == none && index_of(c.traction, name) == none &&
                index_of(c.contact, name) == none && index_of(c.rigid, name) == none,
            path, "another table has this name, and columns of the history begin with it");
    for (const auto& [other, again] : c.rigid_contact)
      d.check(&again == &contact || !joins(again, contact.rigid, contact.other_rigid), path,
              fmt::format("is between the same bodies as [rigid_contact.{}]", other));
    for (const std::string& rigid : {contact.rigid, contact.other_rigid})
      for (std::size_t k = 0; k < c.stage.size(); ++k)
        d.check(c.stage[k].drive.point.empty() || c.stage[k].rigid != rigid, fmt::format("stage[{}].drive.point", k),
                fmt::format("cannot be combined with [rigid_contact.{}]: drive the body at its centre", name));
  }
}

}  // namespace berm::settings
