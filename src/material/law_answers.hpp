// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "core/field_info.hpp"
#include "core/tensor.hpp"

#include <concepts>
#include <string>

namespace berm::material {

/// A law as the user gives it: its word in the input, and how many numbers of its own a particle keeps.
template <class L>
concept Law = requires(const L& law)
{
  {
    L::word
    } -> std::convertible_to<const char*>;
  {
    L::state_size
    } -> std::convertible_to<int>;
  law.density;
  law.inertia_density;
};

/// The strength of soil that was never sheared, slowly: shear strength = cohesion cos(friction_angle) - mean stress sin(friction_angle).
struct Strength {
  Real cohesion = 0;                            ///< Pa, at the bed's surface; the undrained strength where friction_angle is 0
  Real cohesion_gradient = 0;                   ///< Pa/m, growth with the depth below the surface
  Real friction_angle = 0, dilation_angle = 0;  ///< rad
};

/// The moduli as the user knows them.
struct YoungPoisson {
  Real young_modulus = 0;  ///< Pa
  Real poisson_ratio = 0;
};

// What a law is asked. These are the answers of a law that does not answer itself; one that does has a function of the same name, declared beside it.

/// What people call the law: "Mohr-Coulomb".
template <Law L>
std::string law_name(const L&)
{
  std::string name = L::word;
  for (char& c : name)
    if (c == '_') c = ' ';
  return name;
}

template <Law L>
YoungPoisson young_poisson(const L& law)
{
  return {law.young_modulus, law.poisson_ratio};
}

/// Of each number that a particle keeps: name, label, unit.
template <Law L>
std::vector<FieldInfo> state_fields(const L&)
{
  static_assert(L::state_size == 0, "a law whose particles keep numbers names them");
  return {};
}

/// What no range of a single key can say, for the table at this path ("material.sand").
template <Law L>
void check(Describe&, const std::string&, const L&)
{
}

/// Whether the law's strength has a limit, as that of soil has.
template <Law L>
bool yields(const L&)
{
  return true;
}

/// Empty where the strength is none of cohesion and friction.
template <Law L>
std::optional<Strength> strength_at_rest(const L&)
{
  return {};
}

/// The largest (s1 - s3)/2, Pa, at this (s1 + s3)/2, for what the law keeps; empty where the law cannot say. s1 and s3 are the largest and the smallest
/// principal stress.
template <Law L>
std::optional<Real> shear_strength(const L&, Real /*middle*/, const Real* /*state*/)
{
  return {};
}

/// Whether shearing at yield makes the volume grow.
template <Law L>
bool dilates(const L&)
{
  return false;
}

/// What becomes of the law once the soil cannot grow any further.
template <Law L>
L without_dilation(const L& law)
{
  return law;
}

/// The key of the parameter by which the law changes with depth; empty where it is the same at all depths.
template <Law L>
std::string depth_key(const L&)
{
  return "";
}

/// The law at a depth (m) below the bed's surface.
template <Law L>
L at_depth(const L& law, Real /*depth*/)
{
  return law;
}

/// Whether plastic flow is not along the gradient of the yield function.
template <Law L>
bool non_associated(const L&)
{
  return false;
}

/// The law whose flow is associated, which stands for this one in an increment that begins with this stress.
template <Law L>
L associated(const L& law, const SymTensor<2>& /*stress*/)
{
  return law;
}

}  // namespace berm::material
