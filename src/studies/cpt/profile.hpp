// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/cpt/profile_test.cpp
// A sounding as a profile of soil behaviour, and as layers.
#pragma once

#include "site/strength.hpp"

#include <optional>

namespace berm::cpt {

struct Choice {
  Real N_kt = 14;
  site::Correlation correlation = site::Correlation::kulhawy_mayne;
  Real thinnest = 0.2;  ///< m, of a layer
};

/// A row of the sounding that has I_c, SI. B_q is NaN without u_2; s_u is NaN in sand (I_c < 2.60); D_r, phi and E are NaN in other soil.
struct Reading {
  Real depth, q_t, f_s, u_2, B_q, Q_tn, F_r, I_c, gamma, sigma_v0, effective_stress, D_r, s_u, phi, E;
  int zone;
};

/// Rows [first, last) of the profile.
struct Layer {
  Real top, base;
  std::size_t first, last;
  int zone;  ///< of most of its depth
  bool sand() const { return zone >= 5; }
};

struct Profile {
  std::vector<Reading> rows;
  std::vector<Layer> layers;
  std::vector<std::string> doubts;
};

/// Total stress is the sum of the unit weights from the seabed down, each row's up to the row above; 11 kN/m3 at least, which is soft clay. A layer is a run of one zone, from half-way to
/// the rows around it; the thinnest, while thinner than the choice says, joins the neighbour of nearer mean I_c. Throws InputError where the sounding has no f_s, or no row I_c.
Profile profile_of(const site::Sounding& sounding, const Choice& choice);

/// Mean and standard deviation of a quantity over the rows of a layer that have it; NaN without any.
struct Mean {
  Real value, deviation;
};
Mean mean_of(const Profile& profile, const Layer& layer, Real Reading::*quantity);

}  // namespace berm::cpt
