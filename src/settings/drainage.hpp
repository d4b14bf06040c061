// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::settings {

/// How fast the soil of a body whose water flows consolidates.
struct Consolidation {
  std::string material;
  Real depth;     ///< m below the surface, where its stiffness is taken
  Real modulus;   ///< M, Pa: of one-dimensional compression of the skeleton, from the stress at the start
  Real c_v;       ///< m2/s, coefficient of consolidation
  Real density;   ///< kg/m3, of the saturated soil, which has the inertia
  Real strength;  ///< Pa, shear strength there, undisturbed; 0 where it has none

  /// Speed of pressure waves in the skeleton, m/s.
  Real wave() const { return std::sqrt(modulus / density); }
};

/// Whether water flows through the pores of a body (by name; "": of any).
bool has_flowing_water(const Case& c, const std::string& name = "");

/// The part of a real time that a stage at rest lasts in a run: real over modelled permeability of the soil whose water flows; empty where that is not given or
/// differs from material to material.
std::optional<Real> part_of_real_time(const Case& c);

/// The shear strength of undisturbed soil at a depth (m) under a vertical stress, Pa; empty where it does not yield.
std::optional<Real> strength_under(const material::Material& material, Real depth, Real pressure);

/// c_v = k / (gamma_w (1/M + n/K_w)) of each body whose water flows, at a depth below its surface, m.
std::vector<Consolidation> consolidation_of(const Case& c, Real depth);

/// A stage against the flow of the water, by the width D of the body, m.
struct StageDrainage {
  std::size_t stage;
  bool moves;   ///< whether a body is moved
  Real number;  ///< v D / c_v of a stage that moves a body; T = c_v t / D^2 of one that rests, NaN where the input does not say how long
};

// v D / c_v, c_v of soil that does not yield: to 5 % drained below the one and undrained above the other (examples/pipe_consolidation).
constexpr Real drained_up_to = 0.01, undrained_from = 30;

/// Density v^2 over the strength of the soil that a body moves through at v: inertia is small up to the one, and counts above the other.
constexpr Real small_inertia = 0.003, large_inertia = 0.03;

/// How much the inertia of the soil counts in a stage of an explicit run, whose time is scaled.
struct StageInertia {
  enum class Measure {
    strength,  ///< density v^2 over the strength, of a stage that moves a body
    wave,      ///< v over the speed of waves, of one in soil without a strength
    rest       ///< the time in which a wave crosses the body over that in which half of the pressure goes (T = 0.1), of a stage at rest
  };
  static constexpr Real largest_at_rest = 0.1;  ///< up to here the soil consolidates as it does in nature; of waves, too
  Measure measure;
  Real part;

  bool is_small() const
  {
    return part <= (measure == Measure::strength ? small_inertia : measure == Measure::wave ? 0.03 : largest_at_rest);
  }
  bool is_large() const { return part > (measure == Measure::strength ? large_inertia : largest_at_rest); }
};

/// Inertia in a stage; empty in finite elements, which have none.
std::optional<StageInertia> inertia_in(const Case& c, const StageDrainage& stage, const Consolidation& soil, Real width);

/// All stages but geostatic ones, load histories and sweeps.
std::vector<StageDrainage> drainage_of_stages(const Case& c, Real width, Real c_v);

}  // namespace berm::settings
