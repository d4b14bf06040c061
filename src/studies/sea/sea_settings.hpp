// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "formulas/waves.hpp"
#include "input/catalogue.hpp"

#include <filesystem>

namespace berm::sea {

/// Of JONSWAP and of Pierson and Moskowitz.
struct WindSea {
  Real height = 0, period = 0;  ///< H_s, m; T_p, s
};
struct Jonswap : WindSea {
  std::optional<Real> peakedness;  ///< absent: by T_p/sqrt(H_s)
};
struct PiersonMoskowitz : WindSea {};
struct SpectrumTable {
  std::string table;  ///< file
};

struct SeaState {
  std::variant<Jonswap, PiersonMoskowitz, SpectrumTable> spectrum;
  Real depth = 0;                 ///< m
  Real direction = pi / 2;        ///< rad, of the waves to the pipe's axis
  std::optional<Real> spreading;  ///< s of cos^s; absent: long-crested
  Real duration = 10800;          ///< s
  Real water_density = 1025;      ///< kg/m3
};

struct Current {
  Real velocity = 0, height = 0;  ///< m/s; m above the seabed
  Real direction = pi / 2;        ///< rad, to the pipe's axis
  Real roughness = 0;             ///< z_0, m
};

struct Pipe {
  Real diameter = 0, weight = 0;         ///< m; submerged, N/m
  std::optional<Real> embedment;         ///< m
  Real drag = 0, inertia = 0, lift = 0;  ///< C_D, C_M, C_L of Morison's equation
};

struct Bed {
  Real friction = 0;                ///< coefficient
  std::optional<Real> unit_weight;  ///< N/m3, submerged, of sand
  bool permeable = false;
  Real trench_depth = 0, trench_angle = 0;  ///< m, rad
  Real safety_factor = 1;                   ///< on loads
};

struct Record {
  int seeds = 10;
  int waves = 20;            ///< the largest, in each table of waves
  std::optional<Real> step;  ///< s
};

/// An input of berm sea.
struct SeaCase {
  std::string title;
  SeaState sea;
  std::optional<Current> current;
  Pipe pipe;
  Bed bed;
  Record record;

  std::optional<formulas::WaveSpectrum> spectrum;  ///< as read
  Real peakedness = 1;                             ///< of it; 1 of a table
};

void describe(Describe& d, SeaCase& c);

/// Reads an input of berm sea and the table of its spectrum; overrides KEY=VALUE as for --set. Throws InputError.
SeaCase read_sea_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The keys, for `berm params`.
input::Listed sea_catalogue();

}  // namespace berm::sea
