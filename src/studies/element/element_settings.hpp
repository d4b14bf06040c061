// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "input/catalogue.hpp"
#include "material/material.hpp"

#include <filesystem>

namespace berm::element {

/// The effective stress at which a test begins (of a total-stress law: the total one), compression positive, Pa: isotropic, or vertical and k0 times that
/// horizontally.
struct StartStress {
  std::optional<Real> confining_stress = {}, vertical_stress = {}, k0 = {};

  Real vertical() const { return confining_stress ? *confining_stress : vertical_stress.value_or(0); }
  Real horizontal() const { return confining_stress ? *confining_stress : vertical_stress.value_or(0) * k0.value_or(0); }
};

/// Which way the specimen is deformed axially.
enum class Direction { compression, extension };

/// A cylinder whose radial total stress is held.
struct Triaxial {
  static constexpr const char* word = "triaxial";
  StartStress start;
  bool drained = true;
  Direction direction = Direction::compression;
  bool reconsolidated =
      false;  ///< undrained: before each cycle but the first q is taken back to 0, undrained, and p' to that of the start, drained
};

/// Plane strain; the lateral total stress is held.
struct Biaxial {
  static constexpr const char* word = "biaxial";
  StartStress start;
  bool drained = true;
  Direction direction = Direction::compression;
};

/// No strain in the horizontal directions; the vertical total stress is held.
struct SimpleShear {
  static constexpr const char* word = "simple_shear";
  StartStress start;
  bool drained = true;
};

/// The same stress in all directions, drained; by mean stresses.
struct Isotropic {
  static constexpr const char* word = "isotropic";
  StartStress start;
  std::vector<Real> stress_path;  ///< Pa, compression positive
};

/// No horizontal strain, drained; by vertical strains, or by vertical stresses.
struct Oedometer {
  static constexpr const char* word = "oedometer";
  StartStress start;
  std::vector<Real> stress_path;  ///< Pa, compression positive; empty: strain_path
};

using TestKind = std::variant<Triaxial, Biaxial, SimpleShear, Isotropic, Oedometer>;

/// A laboratory test of one specimen.
struct TestSettings {
  std::string name, material;
  Real depth = 0;  ///< m, below the bed's surface, where the specimen is from
  TestKind kind;
  std::vector<Real>
      strain_path;  ///< axial strains, in simple shear shear strains, that are reached one after the other; in `direction` positive
  int cycles = 1;   ///< times that the path is followed
  int steps = 200;  ///< from one entry of the path to the next
  std::optional<Real> strain_rate;  ///< 1/s; empty: none is defined
};

/// An input of berm element.
struct ElementCase {
  std::string title;
  std::string materials_from;  ///< a case whose materials are tested, too
  std::vector<std::pair<std::string, material::Material>> material;
  std::vector<TestSettings> test;

  std::vector<std::pair<std::string, material::Material>> borrowed;  ///< those of materials_from
};

void describe(Describe& d, TestSettings& test);

/// All parameters, then what must fit together.
void describe(Describe& d, ElementCase& c);

/// The materials of an input, without the rest.
struct MaterialsOfCase {
  std::vector<std::pair<std::string, material::Material>> material;
};
void describe(Describe& d, MaterialsOfCase& c);

void describe(Describe& d, Triaxial& kind);
void describe(Describe& d, Biaxial& kind);
void describe(Describe& d, SimpleShear& kind);
void describe(Describe& d, Oedometer& kind);
void describe(Describe& d, Isotropic& kind);

/// The word of a kind in the input: "triaxial".
const char* kind_word(const TestKind& kind);

const StartStress& start_of(const TestKind& kind);

/// The stresses that a test reaches in turn, Pa, compression positive; empty where it goes by strains.
const std::vector<Real>& stress_path_of(const TestKind& kind);

/// 1, in extension -1: of an axial strain, compression positive, over one in the direction of the test.
Real sense(const TestKind& kind);

/// Whether the specimen is only compressed, without failing: oedometer and isotropic tests.
bool is_compression(const TestKind& kind);

/// Whether water can leave the specimen.
bool drained(const TestKind& kind);

/// Whether the specimen is consolidated again between the cycles.
bool reconsolidated(const TestKind& kind);

/// Whether a law knows total stresses alone: its strength is undrained, and no pore pressure follows from it.
bool knows_total_stress_alone(const material::Material& material);

/// The material of a test at the depth of its specimen, without the water in its pores: the test says where it goes.
material::Material material_of(const ElementCase& c, const TestSettings& test);

/// Reads an input of berm element; overrides KEY=VALUE as for --set, those of a material of materials_from go there. Throws InputError.
ElementCase read_element_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The keys beside the materials, for `berm params`.
input::Listed element_catalogue();

/// The whole input as TOML, with every default filled in and the materials of materials_from in it, in SI units.
std::string resolved_toml(const ElementCase& c);

}  // namespace berm::element
