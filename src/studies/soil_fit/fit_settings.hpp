// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "element/element_settings.hpp"
#include "input/document.hpp"

#include <map>

namespace berm::soil_fit {

/// A key of the material that is looked for.
struct FreeKey {
  std::string key;        ///< of [material.NAME]: "friction_angle"
  Real from = 0, to = 0;  ///< SI
  std::string unit;       ///< SI, "1" of a bare number
};

/// A free key as a number from 0 to 1 between its bounds, by its logarithm where they are a factor of 20 or more apart; and what the value changes with that number.
Real value_at(const FreeKey& free, Real x);
Real place_of(const FreeKey& free, Real value);
Real slope_of(const FreeKey& free, Real value);

/// A full-flow penetrometer that was moved down and up over a depth, deep in clay.
struct Penetrometer {
  Real diameter = 0;           ///< m
  std::optional<Real> area;    ///< m2, that a force is over; empty: of a ball its cross-section
  Real resistance_factor = 0;  ///< N, resistance over s_u of clay that neither softens nor has a rate effect
  Real passage_strain = 0;     ///< xi_T, the plastic shear strain that one passage leaves in the clay on average
  Real zero_shift = 0;         ///< Pa, of the resistance where nothing resists; it is taken off
};
// N of both tools is that of a roughness of 0.4: Randolph and Houlsby (1984); ball_factor of formulas/penetrometer.hpp.
struct TBar : Penetrometer {
  static constexpr const char* word = "t_bar";
  TBar() { resistance_factor = 10.5, passage_strain = 3.7; }
};
struct Ball : Penetrometer {
  static constexpr const char* word = "ball";
  Ball() { resistance_factor = 12.9, passage_strain = 3.3; }
};

using MeasuredKind =
    std::variant<element::Triaxial, element::Biaxial, element::SimpleShear, element::Isotropic, element::Oedometer, TBar, Ball>;

/// Null of a laboratory test; and the laboratory test, empty of a penetrometer.
const Penetrometer* penetrometer_of(const MeasuredKind& kind);
std::optional<element::TestKind> laboratory_test(const MeasuredKind& kind);
/// Its word in the input.
const char* word_of(const MeasuredKind& kind);

/// Tests of one kind in one file.
struct MeasuredFile {
  std::string name;  ///< of its tests, before their own names
  std::string file;
  MeasuredKind kind;                           ///< its start stress may be left to the file
  std::string test;                            ///< heading of the column that names the tests; "": the file is one test
  std::vector<std::string> tests;              ///< those that are taken; empty: all
  std::vector<std::string> held_out;           ///< of these, those that are computed and not fitted
  std::map<std::string, std::string> columns;  ///< "HEADING (UNIT)" by what it holds (Reading)
  std::map<std::string, std::string>
      specimen;                        ///< keys of the material that each specimen has of its own: heading of the column, first row
  Real weight = 1;                     ///< of each test
  std::optional<Real> largest_strain;  ///< rows beyond this driven strain are not compared
  std::optional<Real> strain_rate;     ///< 1/s
};

/// An input of berm fit.
struct FitCase {
  std::string title;
  std::vector<std::pair<std::string, material::Material>> material;  ///< one; the values of the free keys are where the search begins
  std::vector<FreeKey> free;
  std::vector<MeasuredFile> measured;
  int starts = 4;             ///< of the search: from the material, and from other places within the bounds
  Real largest_step = 0.001;  ///< strain of a step between two rows, at most

  input::Document document;      ///< that it was read from
  std::filesystem::path folder;  ///< that files are seen from

  const std::string& material_name() const { return material.front().first; }
};

void describe(Describe& d, TBar& bar);
void describe(Describe& d, Ball& ball);
void describe(Describe& d, FreeKey& free);
void describe(Describe& d, MeasuredFile& measured);
void describe(Describe& d, FitCase& c);

/// Reads an input of berm fit; overrides KEY=VALUE as for --set. Throws InputError.
FitCase read_fit_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});
/// The same of a text that berm has written (usual_fit.hpp); files are seen from `folder`.
FitCase read_fit_text(const std::string& file, const std::string& text, const std::filesystem::path& folder,
                      const std::vector<std::string>& overrides = {});

/// Keys of the material and their values, SI.
using Values = std::map<std::string, Real>;

/// The material with these values. Throws InputError where they do not fit together.
material::Material material_with(const FitCase& c, const Values& values);

/// The value of a key in the input, SI. Throws InputError where the material has no such number.
Real value_in(const FitCase& c, const FreeKey& free);

/// The keys beside the materials, for `berm params`.
input::Listed fit_catalogue();

}  // namespace berm::soil_fit
