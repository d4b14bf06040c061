// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/elasticity.hpp"
#include "material/law_queries.hpp"
#include "material/shansep.hpp"

#include <any>
#include <concepts>
#include <string>
#include <utility>
#include <vector>

namespace berm::material {

constexpr int max_state = 33;  ///< state variables that a law may have, with the excess pore pressure

/// A law with its parameters. What does not look into it needs no header of a law, and is not compiled again where one changes; what does includes that law's
/// header (get, get_if) or all of them (visit of material/laws.hpp).
class Material {
public:
  Material();
  template <Law L>
  Material(L law) : law_(std::move(law))
  {
  }

  /// The law of this type; null, or an exception, where it is another.
  template <Law L>
  const L* get_if() const
  {
    return std::any_cast<L>(&law_);
  }
  template <Law L>
  L* get_if()
  {
    return std::any_cast<L>(&law_);
  }
  template <Law L>
  const L& get() const
  {
    return std::any_cast<const L&>(law_);
  }
  template <Law L>
  L& get()
  {
    return std::any_cast<L&>(law_);
  }

  bool operator==(const Material& other) const;

private:
  std::any law_;
};

/// A law with precomputed constants, one of a closed list (material/laws.hpp).
struct PreparedMaterial;

void describe(Describe& d, Material& material);

/// Checks beyond the range of a single key, for the table at `path` ("material.sand"): those of the law, and density <=
/// inertia_density.
void check(Describe& d, const std::string& path, const Material& material);

/// The law with precomputed constants.
PreparedMaterial prepare(const Material& material);

/// Density that gives the weight, kg/m3.
Real density(const Material& material);

/// Density that gives the inertia, kg/m3.
Real inertia_density(const Material& material);

/// The same soil with another density that gives the inertia, kg/m3.
Material with_inertia_density(Material material, Real density);

/// The same soil that is so many times as heavy, its inertia too.
Material with_density_times(Material material, Real factor);

/// Elastic moduli, of effective stress.
Elasticity elasticity(const Material& material);
YoungPoisson young_poisson(const Material& material);

/// P-wave modulus M, Pa, of the skeleton and of the water in its pores; sqrt(M / inertia density) is the speed of pressure waves where the water stays there.
Real p_wave_modulus(const Material& material);

/// Stress over strain, Pa, of the skeleton where it is compressed along the second axis alone, by a millionth from this effective stress; of the elastic constants
/// where that is none.
Real oedometer_modulus(const Material& material, const SymTensor<3>& stress);

/// Number of state variables per particle: those of the law, and the excess pore pressure where there is one.
int state_size(const Material& material);

// Water in the pores (material/undrained.hpp).
std::optional<PoreWater> pore_water(const Material& material);
bool has_pore_pressure(const Material& material);
/// Of soil whose water flows; else empty.
std::optional<Hydraulics> hydraulics(const Material& material);
/// K_w / n, Pa; 0 where the soil has no excess pore pressure.
Real water_stiffness(const Material& material);
/// Which of the state variables is the excess pore pressure, Pa, compression positive; none where the soil has none.
int pore_pressure_index(const Material& material);
/// The same soil, from which water flows freely.
Material drained(Material material);
/// stress + p I of a soil with this state: the stress itself where the soil has no excess pore pressure. Pa, tension positive.
template <int dim>
SymTensor<dim> effective_stress(const Material& material, SymTensor<dim> stress, const Real* state)
{
  if (const int index = pore_pressure_index(material); index != none)
    for (int k = 0; k < 3; ++k) stress[k] += state[index];
  return stress;
}

/// The law's word in the input.
const char* law_word(const Material& material);
/// Whether both have the same law.
bool same_law(const Material& material, const Material& other);

// The queries of law_queries.hpp.
std::string law_name(const Material& material);
std::vector<FieldInfo> state_fields(const Material& material);
void initial_state(const Material& material, const SymTensor<3>& stress, Real* state);
bool yields(const Material& material);
std::optional<Strength> strength_at_rest(const Material& material);
std::optional<Real> shear_strength(const Material& material, Real middle, const Real* state);
std::optional<Material> with_strength_over(const Material& material, Real factor);
bool is_rate_dependent(const Material& material);
Material with_rate_smoothing(const Material& material, Real time);
void recover(const Material& material, Real share, Real* state);
std::optional<Real> band_width(const Material& material);
Material with_grain_size(const Material& material, Real d50);
Material regularised_for(const Material& material, Real size);
bool dilates(const Material& material);
Material without_dilation(const Material& material);

// Variation with depth (material/depth_profile.hpp).
bool varies(const Material& material);
Material at_depth(const Material& material, Real depth, Real weight_above = 0);
/// Of a law whose strength follows from the vertical stress; else null.
const Shansep* shansep(const Material& material);
std::vector<Real> local_values(const Material& material);
std::vector<FieldInfo> local_fields(const Material& material);
Material with_local_values(const Material& material, const Real* own);

bool non_associated(const Material& material);
Material associated(const Material& material, const SymTensor<2>& stress);

}  // namespace berm::material
