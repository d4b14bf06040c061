// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "core/field_info.hpp"
#include "core/tensor.hpp"
#include "material/pore_water.hpp"

#include <concepts>
#include <string>

namespace berm::material {

/// A law with its parameters: its word in the input, and its number of state variables per particle.
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
  law.water;
};

/// Strength of undisturbed soil at a negligible strain rate: shear strength = cohesion cos(friction_angle) - mean stress
/// sin(friction_angle), tension positive.
struct Strength {
  Real cohesion = 0;                            ///< Pa, at the bed's surface; the undrained strength where friction_angle is 0
  Real cohesion_gradient = 0;                   ///< Pa/m, increase with depth below the surface
  Real friction_angle = 0, dilation_angle = 0;  ///< rad
};

/// The elastic constants of the input.
struct YoungPoisson {
  Real young_modulus = 0;  ///< Pa
  Real poisson_ratio = 0;

  /// G, Pa.
  Real shear_modulus() const { return young_modulus / (2 * (1 + poisson_ratio)); }
};

// Queries of a law, with their defaults; a law overrides one by a function of the same name, declared beside it.

/// Name for display: "Mohr-Coulomb".
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

/// The number of state variables per particle of a law or a prepared one: state_size, which is the most that a law can have, unless it says less.
template <class L>
constexpr int state_count(const L&)
{
  return L::state_size;
}

/// Name, label and unit of each state variable.
template <Law L>
std::vector<FieldInfo> state_fields(const L&)
{
  static_assert(L::state_size == 0, "a law with state variables must name them");
  return {};
}

/// Writes the state variables of soil at rest under this stress, Pa, y being vertical; `state` comes with zeros.
template <Law L>
void initial_state(const L&, const SymTensor<3>& /*stress*/, Real* /*state*/)
{
}

/// Checks beyond the range of a single key, for the table at this path ("material.sand").
template <Law L>
void check(Describe&, const std::string&, const L&)
{
}

/// Whether the law has a yield surface.
template <Law L>
bool yields(const L&)
{
  return true;
}

/// Empty where the strength is not of this form.
template <Law L>
std::optional<Strength> strength_at_rest(const L&)
{
  return {};
}

/// Maximum (s1 - s3)/2, Pa, at this (s1 + s3)/2 and state; empty where the law does not define it. s1 and s3 are the largest
/// and the smallest principal stress, tension positive.
template <Law L>
std::optional<Real> shear_strength(const L&, Real /*middle*/, const Real* /*state*/)
{
  return {};
}

/// The law with all of its strength divided by a factor, at the same stiffness; empty where it does not say which of its parameters are strength.
template <Law L>
std::optional<L> with_strength_over(const L& law, Real /*factor*/)
{
  return yields(law) ? std::optional<L>() : law;
}

/// Whether plastic shearing dilates.
template <Law L>
bool dilates(const L&)
{
  return false;
}

/// The law with a dilation angle of zero, for soil at its maximum volume.
template <Law L>
L without_dilation(const L& law)
{
  return law;
}

/// Whether plastic flow is non-associated.
template <Law L>
bool non_associated(const L&)
{
  return false;
}

/// The width of the soil's shear bands, m; empty where it is not given, or where the law does not localise.
template <Law L>
std::optional<Real> band_width(const L&)
{
  return {};
}

/// The law of soil with grains of this d50, m, whose shear bands have their width; the law itself where it needs none.
template <Law L>
L with_grain_size(const L& law, Real /*d50*/)
{
  return law;
}

/// The law with which cells of this size, m (Mesh::size), carry what shear bands of the soil's own width carry.
template <Law L>
L regularised_for(const L& law, Real /*size*/)
{
  return law;
}

/// The associated law that replaces this one in an increment that begins with this stress.
template <Law L>
L associated(const L& law, const SymTensor<2>& /*stress*/)
{
  return law;
}

/// Whether the strength depends on the strain rate.
template <Law L>
bool is_rate_dependent(const L&)
{
  return false;
}

/// The law with its strain rate averaged over a time (s), unless it has one of its own.
template <Law L>
L with_rate_smoothing(const L& law, Real /*time*/)
{
  return law;
}

/// Gives soil at rest a share (0 to 1) of what it lost by remoulding back.
template <Law L>
void recover(const L&, Real /*share*/, Real* /*state*/)
{
}

}  // namespace berm::material
