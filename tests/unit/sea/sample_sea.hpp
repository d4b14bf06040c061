// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sea/sea_answer.hpp"

namespace berm::sea {

/// A cable of 0.25 m on sand in 30 m of water, H_s = 4.5 m, T_p = 10 s.
inline SeaCase sample_sea()
{
  SeaCase c;
  c.sea.spectrum = Jonswap{{4.5, 10}, 3.3};
  c.sea.depth = 30;
  c.sea.duration = 3600;
  c.pipe = {.diameter = 0.25, .weight = 400, .embedment = 0.01, .drag = 0.9, .inertia = 3.29, .lift = 1.1, .mass = {}};
  c.bed = {.friction = 0.6, .unit_weight = 9e3, .grain_size = {}, .permeable = true};
  c.record = {.seeds = 1, .waves = 5, .step = 0.5};
  c.spectrum = formulas::WaveSpectrum::jonswap(4.5, 10, 3.3);
  c.peakedness = 3.3;
  return c;
}

}  // namespace berm::sea
