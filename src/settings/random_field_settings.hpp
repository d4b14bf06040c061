// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <array>

namespace berm::settings {

struct Case;

constexpr const char* stiffness_word = "young_modulus";  ///< of the property that is no strength
constexpr const char* friction_word = "friction_angle";  ///< of the property whose tangent varies
constexpr const char* density_word = "density";          ///< of the property that gives the weight

/// How the correlation of the logarithm falls with distance.
enum class Correlation { markov, gaussian };

/// Values that are known on a vertical.
struct SoundingSettings {
  Real x = 0, z = 0;               ///< m
  std::vector<Real> depth, value;  ///< m below the bed's surface; Pa
};

/// A strength, stiffness or density of a material, or the tangent of its friction angle, that varies at random about its value in the case.
struct RandomFieldSettings {
  std::string material, property;
  Real coefficient_of_variation = 0;
  std::optional<Real> correlation_length_x, correlation_length_depth, correlation_length_z;  ///< m; empty: the same all along
  Correlation correlation = Correlation::markov;
  std::optional<Real> averaging_length;  ///< m; empty: values at points
  int seed = 1;
  std::vector<SoundingSettings> sounding;

  bool of_friction() const { return property == friction_word; }
  bool of_density() const { return property == density_word; }
  /// Whether it is cut into classes, each a material of its own.
  bool by_classes() const { return of_friction() || of_density(); }
  /// The standard deviation of the logarithm of a lognormal variable: sqrt(ln(1 + V^2)).
  Real log_deviation() const { return std::sqrt(std::log1p(coefficient_of_variation * coefficient_of_variation)); }
  /// Along x, depth and z.
  std::array<std::optional<Real>, 3> lengths() const { return {correlation_length_x, correlation_length_depth, correlation_length_z}; }
};

void describe(Describe& d, SoundingSettings& sounding);
void describe(Describe& d, RandomFieldSettings& field);

/// Refuses fields of what no material has, and lengths and soundings that do not fit.
void check_random_fields(Describe& d, const Case& c);

}  // namespace berm::settings
