// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "formulas/waves.hpp"
#include "input/catalogue.hpp"
#include "macro_element/parameters.hpp"
#include "settings/water_loads.hpp"

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
  std::optional<Real> mass;              ///< kg/m, with contents, displaced water and added mass; absent: mass_in_water
};

struct Bed {
  Real friction = 0;                ///< coefficient
  std::optional<Real> unit_weight;  ///< N/m3, submerged, of sand
  std::optional<Real> grain_size;   ///< m, median, of sand
  bool permeable = false;
  Real trench_depth = 0, trench_angle = 0;  ///< m, rad
  Real safety_factor = 1;                   ///< on loads
};

/// What finds the displacement of the pipe.
struct Soil {
  std::string macro_element;         ///< file
  std::optional<Real> laying_force;  ///< N/m; absent: the submerged weight
  std::vector<std::string> runs;     ///< folders, of runs through a table of the largest waves
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
  std::optional<Soil> soil;
  Record record;

  std::optional<formulas::WaveSpectrum> spectrum;  ///< as read
  Real peakedness = 1;                             ///< of it; 1 of a table
  std::optional<macro_element::Parameters> macro_element;
  std::filesystem::path folder;  ///< that its files are named from
};

void describe(Describe& d, SeaCase& c);

/// The coefficients of the water on its pipe.
settings::WaterSettings water_of(const SeaCase& c);

/// Reads an input of berm sea and the table of its spectrum; overrides KEY=VALUE as for --set. Throws InputError.
SeaCase read_sea_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The keys, for `berm params`.
input::Listed sea_catalogue();

}  // namespace berm::sea
