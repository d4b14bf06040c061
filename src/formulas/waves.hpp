// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

#include <vector>

// Linear waves over a flat seabed, and the water that they and a current move there.

namespace berm::formulas {

/// The variance density of the sea's elevation over the angular frequency.
class WaveSpectrum {
public:
  /// JONSWAP with significant wave height H_s (m), peak period T_p (s) and peakedness gamma, scaled so that its variance is H_s^2/16:
  ///
  ///   S ~ w^-5 exp(-5/4 (w_p/w)^4) gamma^exp(-((w - w_p)/(sigma w_p))^2 / 2),   sigma = 0.07 to w_p, 0.09 beyond.
  ///
  /// gamma = 1 is the spectrum of Pierson and Moskowitz. [Hasselmann and others 1973]
  static WaveSpectrum jonswap(Real height, Real period, Real peakedness);
  /// Straight between rows of ascending angular frequency (rad/s) and density (m2 s/rad), zero outside.
  static WaveSpectrum table(std::vector<Real> frequency, std::vector<Real> density);

  Real density(Real frequency) const;  ///< m2 s/rad
  /// rad/s: of the largest density, and the frequencies between which it has its variance but for 0.03 %.
  Real peak() const { return peak_; }
  Real first() const { return first_; }
  Real last() const { return last_; }

private:
  Real peak_ = 0, first_ = 0, last_ = 0, scale_ = 1, peakedness_ = 1;
  std::vector<Real> frequency_, density_;
};

/// H_s = 4 sqrt(m_0), m.
Real height_of(const WaveSpectrum& spectrum);

/// gamma by T_p/sqrt(H_s) (s, m): 5 to 3.6, 1 from 5 on, exp(5.75 - 1.15 T_p/sqrt(H_s)) between. [fit: DNV-RP-F109]
Formula wave_peakedness(Real height, Real period);

/// k, 1/m, of a wave of angular frequency w (rad/s) in water of a depth (m): w^2 = g k tanh(k d).
Real wave_number(Real frequency, Real depth);

/// w/sinh(k d), 1/s: amplitude of the velocity at the seabed over that of the elevation.
Real velocity_at_seabed(Real frequency, Real depth);

/// Waves at the seabed: U_s = 2 sqrt(M_0), T_u = 2 pi sqrt(M_0/M_2), M_n the moments of the spectrum of the velocity.
struct SeabedWaves {
  Real velocity = 0;  ///< U_s, m/s, significant amplitude
  Real period = 0;    ///< T_u, s, mean between upward zero crossings
};
SeabedWaves waves_at_seabed(const WaveSpectrum& spectrum, Real depth);

/// The part of the velocity square to the pipe, root mean square: waves whose main direction has an angle (rad) to the pipe's axis, directions spread by cos^s around it
/// between -90 and 90 deg: R^2 = ((s + 1) sin^2 + cos^2)/(s + 2). s infinite: no spreading. [exact]
Real wave_direction_factor(Real angle, Real spreading);

/// The largest oscillation of a sea state of a duration (s): with tau = duration/T_u
/// U* = U_s/2 (sqrt(2 ln tau) + 0.5772/sqrt(2 ln tau)), the mean of the largest amplitude; T* = k T_u, k = k_t - 5 (k_t - 1) T_n/T_u where T_n/T_u <= 0.2, else 1,
/// k_t = 1.25, 1.21, 1.17 at gamma 1, 3.3, 5 and straight between, T_n = sqrt(depth/g). NaN for tau <= e.
struct DesignOscillation {
  Formula velocity, period;  ///< m/s, s
};
/// [fit: DNV-RP-F109]
DesignOscillation design_oscillation(const SeabedWaves& waves, Real duration, Real depth, Real peakedness);

/// Mean of a current over the height of a pipe on the seabed, m/s: with the velocity V_r at a height z_r over a bed of roughness z_0 (m)
/// V = V_r ((1 + z_0/D) ln(1 + D/z_0) - 1)/ln(1 + z_r/z_0) sin(angle), angle to the pipe's axis. [fit: DNV-RP-F109; exact for the logarithmic profile ln(1 + z/z_0)]
Formula current_on_pipe(Real velocity, Real height, Real roughness, Real angle, Real diameter);

}  // namespace berm::formulas
