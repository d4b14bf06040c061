// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <array>

namespace berm::contact {

/// Algorithm of contact within a step (docs/theory/soil_and_contact.md, Contact); steps as in the paper, section 2.
enum class Scheme {
  musl_coupled,  ///< modified update stress last, one impulse over both corrections: step 8 completes that of step 4
  musl_double,   ///< two independent corrections, as published: accelerations in step 4, re-mapped velocities in step 8
  musl_single,   ///< one correction, in step 4
  hybrid_usl,    ///< step 4; nodes in contact then move and strain with that velocity (update stress last), all others as in musl_single
  usf,           ///< update stress first: the velocities before the step, which strain, and those after it, which move
  tied           ///< one velocity field where the gap is closed: neither slip nor separation
};

/// What a scheme does. All contacts of a case have the same `stress_first`.
struct SchemeRules {
  const char* word;                   ///< of the input
  bool completes = false;             ///< step 8 completes the impulse of step 4 (at nodes: keeps closed points together)
  bool corrects_velocities = false;   ///< step 8 corrects what step 4 has not completed
  bool moves_with_predicted = false;  ///< nodes in contact move and strain with the velocity of step 4
  bool stress_first = false;          ///< the step is that of update stress first
  bool tied = false;
};

/// A row a scheme, in their order.
constexpr std::array scheme_rules{
    SchemeRules{.word = "musl_coupled", .completes = true, .corrects_velocities = true},
    SchemeRules{.word = "musl_double", .corrects_velocities = true},
    SchemeRules{.word = "musl_single"},
    SchemeRules{.word = "hybrid_usl", .moves_with_predicted = true},
    SchemeRules{.word = "usf", .corrects_velocities = true, .stress_first = true},
    SchemeRules{.word = "tied", .corrects_velocities = true, .tied = true},
};

constexpr const SchemeRules& rules_of(Scheme scheme)
{
  return scheme_rules[static_cast<std::size_t>(scheme)];
}

/// How contact between two bodies is detected.
enum class Detection {
  automatic,  ///< particle at a rigid body, gap between deformable ones
  gap,        ///< nodes: the approach velocity is limited by the gap between the nearest particles
  overlap,    ///< nodes to which particles of both bodies contribute, as published
  distance,   ///< nodes whose nearest particles touch
  particle    ///< particles at the surface of a rigid body instead of nodes, with the rule for the gap
};

/// Where the rim of a particle is, at which it touches a rigid body.
enum class ParticleRim {
  whole,  ///< half its width from its centre
  worn    ///< there while its soil lies as it was placed, and nearer to the centre as that is sheared
};

/// What a contact is beside one of the soils of a body.
struct SoilInterfaceSettings {
  std::string material;
  Real friction_angle = 0;   ///< rad
  Real adhesion = 0;         ///< Pa
  Real adhesion_factor = 0;  ///< of the undrained strength of the soil beside the interface, instead of `adhesion`
};

/// Frictional contact of a deformable body with a rigid one or another deformable one.
struct ContactSettings {
  std::string body;
  std::string rigid, other_body;  ///< one of the two; the other is empty
  Real friction_angle = 0;        ///< rad
  Real adhesion = 0;              ///< Pa
  Real adhesion_factor = 0;       ///< of the undrained strength of the soil beside the interface, instead of `adhesion`
  Real adhesion_sensitivity = 1;  ///< adhesion before sliding over that after much of it
  Real adhesion_ductility = 0;    ///< m, slip that takes 95 % of what is lost
  Real tension = 0;               ///< Pa, tensile normal stress that a bonded interface carries; infinite: it never parts
  Scheme scheme = Scheme::musl_coupled;
  Detection detection = Detection::automatic;
  Real gap_closing_steps = 20;              ///< T: a gap closes over this many steps of default length
  bool drained = false;                     ///< the water of consolidating soil crosses the surface of the rigid body
  std::vector<SoilInterfaceSettings> soil;  ///< beside materials of the body that differ from the rest
  ParticleRim particle_rim = ParticleRim::whole;
};

void describe(Describe& d, SoilInterfaceSettings& soil);
void describe(Describe& d, ContactSettings& contact);

/// Whether adhesion falls with slip.
inline bool softens(const ContactSettings& contact)
{
  return contact.adhesion_sensitivity > 1;
}

}  // namespace berm::contact
