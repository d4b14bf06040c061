// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cyclic/storm.hpp"
#include "input/catalogue.hpp"
#include "material/material.hpp"

#include <filesystem>

namespace berm::cyclic {

/// What the contours are of, which accumulates from parcel to parcel.
enum class Measure { shear_strain, pore_pressure_ratio };
inline const std::vector<const char*> measure_words = {"shear_strain", "pore_pressure_ratio"};

struct ContourSettings {
  std::string table;  ///< file
  Measure of = Measure::shear_strain;
  std::optional<Real> failure;  ///< absent: the highest contour
};

enum class Order { ascending, given };

struct StormSettings {
  std::vector<Real> cycles, load;  ///< of each parcel
  Real average_load = 0;           ///< is not multiplied
  std::optional<Real> capacity;    ///< load at which the shear stress is s_u; absent: 1
  Order order = Order::ascending;
  std::string unit;  ///< SI, of the loads; "1" or "": ratios

  /// Average shear stress over s_u.
  Real average() const { return average_load / capacity.value_or(1); }
};

/// An input of berm cyclic.
struct CyclicCase {
  std::string title;
  std::vector<std::pair<std::string, material::Material>> material;  ///< none or one, whose strength is multiplied
  ContourSettings contours;
  StormSettings storm;

  Contours diagram;         ///< at the average stress of the storm
  std::size_t failure = 0;  ///< the number of its contour

  /// In their order on the contours.
  std::vector<Parcel> parcels() const;
};

void describe(Describe& d, ContourSettings& contours);
void describe(Describe& d, StormSettings& storm);
void describe(Describe& d, CyclicCase& c);

/// Reads an input of berm cyclic and its contours; overrides KEY=VALUE as for --set. Throws InputError.
CyclicCase read_cyclic_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The keys, for `berm params`.
input::Listed cyclic_catalogue();

}  // namespace berm::cyclic
