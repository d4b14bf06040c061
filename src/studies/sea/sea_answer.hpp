// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/on_bottom_stability.hpp"
#include "formulas/sediment.hpp"
#include "sea/record.hpp"

namespace berm::sea {

/// The largest of a realisation.
struct Extremes {
  Real velocity = 0;        ///< m/s, of the waves and the current
  Real H = 0, least_V = 0;  ///< N/m; |H|
  std::size_t waves = 0;
};

/// What a sea does to a pipe on the seabed. Of the waves square to the pipe: `waves` has the factor of their directions.
struct SeaAnswer {
  Real height = 0;  ///< 4 sqrt(m_0), m
  Real direction_factor = 1;
  formulas::SeabedWaves waves;
  Real current = 0;  ///< V, m/s
  formulas::DesignOscillation design;
  Real embedment = 0;  ///< m

  formulas::LoadReductions left;
  formulas::PeakLoads peak;
  Real horizontal = 0, vertical = 0;  ///< F_Y, F_Z, N/m, of the design oscillation by DNV-RP-F109
  Real passive = 0;                   ///< F_R, N/m
  formulas::Formula stable_weight;    ///< for half a diameter, w_s, N/m; NaN on clay

  std::optional<formulas::Formula> shields,
      critical_shields;  ///< of the bed in a significant wave of all directions; of sand with a grain size

  std::vector<LoadRecord> records;
  std::vector<std::vector<LoadWave>> waves_of_record;  ///< all of them
  std::vector<Extremes> extremes;
};

/// Numbers of the sea state and of its largest oscillation: K = U T/D, M = V/U, N = U_s/(g T_u), L = w_s/(rho D/2 U_s^2).
struct Dimensionless {
  Real K, M, N, L, design_K, design_M, tau;
};
Dimensionless dimensionless(const SeaCase& c, const SeaAnswer& answer);

SeaAnswer answer_of(const SeaCase& c);

/// gamma (F_Y + mu F_Z)/(mu w_s + F_R) and gamma F_Z/w_s: at most 1 where the pipe does not move at all.
struct Utilisation {
  Real lateral, vertical;
};
Utilisation absolute_stability(const SeaCase& c, const SeaAnswer& answer);

/// Half the heights of the waves of H in classes of equal width, as parcels of berm cyclic: mean number a realisation, and the upper end of the class, N/m.
struct LoadClass {
  Real cycles, load;
};
std::vector<LoadClass> load_classes(const SeaAnswer& answer);

}  // namespace berm::sea
