// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/interface_test.cpp
#include "settings/interface.hpp"

#include "bodies/particles.hpp"
#include "core/names.hpp"
#include "material/linear_elastic.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {
namespace {

constexpr unsigned unseen = everywhere & ~to_frame;

/// Calls visit(contact number, settings) for each contact of a body that remembers.
template <class Visit>
void for_contacts_of(const Case& c, const std::string& body, const Visit& visit)
{
  for (Index k = 0; k < static_cast<Index>(c.contact.size()); ++k)
    if (c.contact[k].second.body == body) visit(k, c.contact[k].second);
}

}  // namespace

std::optional<Real> undrained_strength(const material::Material& soil)
{
  const std::optional<material::Strength> strength = strength_at_rest(soil);
  if (!strength || strength->friction_angle != 0) return {};
  return strength->cohesion;
}

std::vector<FieldInfo> memory_fields(const Case& c, const std::string& body)
{
  std::vector<FieldInfo> fields;
  for_contacts_of(c, body, [&](Index k, const contact::ContactSettings& contact) {
    if (contact.tension > 0) fields.push_back({fmt::format("bond_{}", k), "bond to " + contact.rigid, "", 1, unseen});
    if (softens(contact)) fields.push_back({fmt::format("slip_{}", k), "slip along " + contact.rigid, "m", 1, unseen});
  });
  return fields;
}

InterfaceMemory memory_of(const Case& c, Index contact)
{
  const std::string& name = c.contact[contact].second.body;
  int next = 0;
  for (const FieldInfo& field : particle_extra(soil_of(c, c.body[index_of(c.body, name)].second))) next += field.components;
  InterfaceMemory found;
  for_contacts_of(c, name, [&](Index k, const contact::ContactSettings& settings) {
    const int bond = settings.tension > 0 ? next++ : none, slip = softens(settings) ? next++ : none;
    if (k == contact) found = {bond, slip};
  });
  return found;
}

void check_interface(Describe& d, const Case& c, const std::string& path, const contact::ContactSettings& contact)
{
  const auto needs_particles = [&](bool wanted, const std::string& key) {
    if (!wanted) return;
    d.check(contact.other_body.empty(), path + key, "is for contact with a rigid body");
    d.check(rules_of(contact.scheme).completes, path + ".scheme", fmt::format("{} is for \"musl_coupled\" only", key.substr(1)),
            {"musl_coupled"});
    d.check(contact.detection == contact::Detection::automatic || contact.detection == contact::Detection::particle, path + ".detection",
            fmt::format("{} is for \"particle\" only, the default at a rigid body", key.substr(1)), {"automatic", "particle"});
  };
  needs_particles(contact.tension > 0, ".tension");
  needs_particles(contact.adhesion_factor > 0, ".adhesion_factor");
  needs_particles(softens(contact), ".adhesion_sensitivity");
  needs_particles(!contact.soil.empty(), ".soil");
  needs_particles(contact.particle_rim == contact::ParticleRim::worn, ".particle_rim");
  d.check(contact.adhesion_factor == 0 || contact.adhesion == 0, path + ".adhesion_factor",
          "cannot be combined with adhesion: give the adhesion in Pa, or as a fraction of the strength of the soil");
  d.check(!softens(contact) || contact.adhesion > 0 || contact.adhesion_factor > 0, path + ".adhesion_sensitivity",
          "needs an adhesion that falls: adhesion or adhesion_factor");
  d.check(softens(contact) == (contact.adhesion_ductility > 0), path,
          "needs both adhesion_sensitivity (more than 1) and adhesion_ductility (more than 0), or neither");
  const Index body = index_of(c.body, contact.body);
  if (body == none || index_of(c.material, c.body[body].second.material) == none) return;
  const BodySoil soil = soil_of(c, c.body[body].second);
  d.check(contact.particle_rim == contact::ParticleRim::whole || soil.materials.front().get_if<material::LinearElastic>() == nullptr,
          path + ".particle_rim",
          fmt::format("[body.{}] is elastic and does not flow: its particles keep their width in contact", contact.body), {"whole"});
  for (std::size_t k = 0; k < soil.materials.size(); ++k) {
    const auto beside =
        std::find_if(contact.soil.begin(), contact.soil.end(), [&](const auto& own) { return own.material == soil.names[k]; });
    const bool own = beside != contact.soil.end();
    d.check(
        !((own ? beside->adhesion_factor : contact.adhesion_factor) > 0) || undrained_strength(soil.materials[k]),
        own ? fmt::format("{}.soil[{}].adhesion_factor", path, beside - contact.soil.begin()) : path + ".adhesion_factor",
        fmt::format("is a fraction of the undrained strength of the soil, and [material.{}] of [body.{}] has none: it needs a law with an "
                    "undrained_strength, or with friction_angle = 0; else give the adhesion in Pa",
                    soil.names[k], contact.body));
  }
  for (std::size_t k = 0; k < contact.soil.size(); ++k) {
    const contact::SoilInterfaceSettings& beside = contact.soil[k];
    const std::string item = fmt::format("{}.soil[{}]", path, k);
    d.check(among(beside.material, soil.names), item + ".material",
            fmt::format("[body.{}] has no such material, or one that equals another", contact.body), soil.names);
    d.check(soil.materials.size() > 1, item, fmt::format("[body.{}] has one material: give it in [contact] itself", contact.body));
    d.check(beside.adhesion == 0 || beside.adhesion_factor == 0, item + ".adhesion_factor",
            "cannot be combined with adhesion: give the adhesion in Pa, or as a fraction of the strength of the soil");
    for (std::size_t other = 0; other < k; ++other)
      d.check(contact.soil[other].material != beside.material, item + ".material", "is given twice");
  }
  for (const std::string& side : {contact.body, contact.other_body}) {
    const Index b = index_of(c.body, side);
    if (b == none || index_of(c.material, c.body[b].second.material) == none || contact.friction_angle == 0) continue;
    if (!has_pore_pressure(soil_of(c, c.body[b].second).materials.front())) continue;
    const std::string why =
        fmt::format("friction acts on the effective normal stress, and the soil of [body.{}] has excess pore pressure", side);
    d.check(contact.other_body.empty(), path + ".friction_angle",
            why + ": that is for contact with a rigid body; between two bodies take friction_angle = 0 and, if there is one, adhesion");
    d.check(c.method == Method::mpm || hydraulics(soil_of(c, c.body[b].second).materials.front()), path + ".friction_angle",
            why + ": finite elements have its pressure at the surface with water.drainage = \"consolidation\" only; with another take "
                  "friction_angle = 0");
    d.check(contact.detection == contact::Detection::automatic || contact.detection == contact::Detection::particle, path + ".detection",
            why + ": that is for \"particle\" only, the default at a rigid body", {"automatic", "particle"});
  }
  int numbers = 0;
  for (const FieldInfo& field : particle_extra(soil_of(c, c.body[body].second))) numbers += field.components;
  for (const FieldInfo& field : memory_fields(c, contact.body)) numbers += field.components;
  d.check(
      numbers <= bodies::Particle<2>::max_extra, path,
      fmt::format("[body.{}] has too many contacts with a history (tension, adhesion_sensitivity): its particles would keep {} numbers, "
                  "and there is room for {}",
                  contact.body, numbers, bodies::Particle<2>::max_extra));
}

}  // namespace berm::settings
