// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "input/catalogue.hpp"

#include <filesystem>

namespace berm::route {

/// A line of the same pipe all along.
struct Pipe {
  Real diameter = 0, wall = 0;         ///< m
  std::optional<Real> steel_diameter;  ///< m; absent: no coating
  Real young_modulus = 207e9, poisson_ratio = 0.3, expansion = 1.17e-5;
  Real laying = 0, operation = 0;  ///< N/m, submerged weights: empty as it is laid, with its content
  std::optional<Real> flooded;     ///< N/m; absent: it is not flooded
  Real lay_tension = 0;            ///< N, effective, on the bed
  std::optional<Real> lay_factor;  ///< largest V of laying over the weight; absent: by F114
};

/// What holds the ends of the line.
enum class Ends { free, anchored };

/// Temperature and pressure since laying, by KP: one number each, or as many as KPs.
struct Operation {
  std::vector<Real> kp, temperature, pressure;  ///< m, K, Pa
  Ends ends = Ends::free;
};

/// Low, best and high, or the best alone.
using Estimates3 = std::vector<Real>;

/// A part of the route with one soil.
struct Section {
  std::string name;
  Real from = 0, to = 0;  ///< m
  std::string run;        ///< folder of a run, or of a study with a sample, whose springs it has
  Estimates3 strength;    ///< s_u at the seabed, Pa; empty: sand
  Real gradient = 0;      ///< Pa/m
  Real unit_weight = 0;   ///< N/m3, submerged
  Estimates3 sensitivity = {1};
  Estimates3 adhesion_factor;                  ///< alpha
  Estimates3 strength_ratio;                   ///< (s_u/sigma'_v)_nc of the interface
  Real exponent = 0, consolidation = 1;        ///< m of OCR^m; U
  Estimates3 friction_angle, interface_angle;  ///< rad
  std::optional<Real> cover;                   ///< m, above the crown of a buried line
  Real prop_height = 0;                        ///< m
  std::optional<Real> curve_radius;            ///< m

  bool is_clay() const { return !strength.empty(); }
};

/// An input of berm route.
struct RouteCase {
  std::string title;
  Pipe pipe;
  Operation operation;
  std::vector<Section> section;
  std::filesystem::path folder;  ///< of the file
};

void describe(Describe& d, RouteCase& c);

/// Reads an input of berm route; overrides KEY=VALUE as for --set. Throws InputError.
RouteCase read_route_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The keys, for `berm params`.
input::Listed route_catalogue();

}  // namespace berm::route
