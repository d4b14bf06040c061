// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/earthwork_settings.hpp"

#include <algorithm>
#include <cmath>

namespace berm::bodies {

/// A rectangular block (2D: may be rotated) or box of material, filled with particles on its own lattice, anywhere in the
/// mesh.
struct BlockSettings {
  std::vector<Real> center, size;  ///< m, one entry a direction
  Real angle = 0;                  ///< rad, counter-clockwise; 2D only
  Real spacing = 0;                ///< m, of the lattice; rounded so that whole particles fill the block
};

/// A disk of material (2D), filled with the particles of a square lattice around its centre.
struct DiskSettings {
  std::vector<Real> center;  ///< m
  Real diameter = 0;         ///< m
  Real spacing = 0;          ///< m, of the lattice
};

/// A term of the initial velocity of the particles: v(x) = amplitude sin(wave_number . x + phase), or uniform where
/// wave_number is empty.
struct InitialVelocity {
  std::vector<Real> amplitude;    ///< m/s
  std::vector<Real> wave_number;  ///< rad/m
  Real phase = 0;                 ///< rad
};

/// Horizontal over vertical effective stress at the start: given; or by the stress history and the friction angle of the soil (Mayne and Kulhawy 1982),
///
///   K_0 = (1 - sin phi) OCR^(sin phi),   at most K_p = (1 + sin phi) / (1 - sin phi),
///
/// with one OCR or OCR = (sigma'_v + POP) / sigma'_v.
struct K0Settings {
  std::optional<Real> k0, ocr = {}, pop = {};  ///< -, -, Pa; one of them at most

  bool given() const { return k0 || ocr || pop; }
  bool by_history() const { return ocr || pop; }
  /// Of soil with this sine of its friction angle under a vertical stress, Pa; only where given.
  Real at(Real sin_friction, Real vertical_stress) const
  {
    if (k0) return *k0;
    const Real passive = (1 + sin_friction) / (1 - sin_friction);
    if (!ocr && !(vertical_stress > 0)) return *pop > 0 ? passive : 1 - sin_friction;
    const Real ratio = ocr ? *ocr : 1 + *pop / vertical_stress;
    return std::min(passive, (1 - sin_friction) * std::pow(ratio, sin_friction));
  }
};

/// A layer of another material at the start, down to the next one.
struct SoilLayerSettings {
  Real top = 0;  ///< m below the bed's surface
  std::string material;
  std::optional<Real> k0 = {};                   ///< instead of that of the body
  std::optional<Real> k0_ocr = {}, k0_pop = {};  ///< instead of k0: -, Pa
  Real sin_friction = nan;                       ///< of the material; known once a case is read

  K0Settings at_rest() const { return {k0, k0_ocr, k0_pop}; }
};

/// Input of a deformable body: its material and the part of the mesh that it fills at the start.
struct BodySettings {
  std::string material;
  std::vector<SoilLayerSettings> soil_layer;           ///< downwards, below `material`
  std::map<std::string, std::string> region_material;  ///< other materials in some regions, instead of layers
  std::vector<std::string> regions;                    ///< of the mesh, filled cell by cell
  int particles_per_cell = 0;                          ///< n^dim, in triangles also 2 n^2; 0 = 9 in triangles, 8 in tetrahedra
  std::map<std::string, int> region_particles_per_cell;
  std::optional<BlockSettings> block;  ///< instead of regions
  std::optional<DiskSettings> disk;    ///< instead of regions
  Real damping = 0;                    ///< local damping factor
  std::map<std::string, Real> region_damping;
  std::optional<Real> k0;                         ///< horizontal over vertical stress at the start; no stress at the start without it and
  std::optional<Real> k0_ocr, k0_pop;             ///< what it follows from instead: -, Pa
  Real sin_friction = nan;                        ///< of the material; known once a case is read
  std::vector<Real> initial_stress;               ///< Pa, xx, yy and zz everywhere, tension positive, instead of k0
  std::vector<InitialVelocity> initial_velocity;  ///< summed
  Real initial_angular_velocity = 0;              ///< rad/s about the centre of mass (in space: about z), added to initial_velocity
  std::vector<ExcavationSettings> excavation;
  std::vector<FillSettings> fill;

  K0Settings at_rest() const { return {k0, k0_ocr, k0_pop}; }
  /// Whether the body has the stress of a bed at rest at the start.
  bool has_k0() const { return at_rest().given(); }
  /// Horizontal over vertical stress at the start at a depth below the bed's surface, m, under a vertical stress there, Pa; empty without k0.
  std::optional<Real> k0_at(Real depth, Real vertical_stress) const
  {
    if (!has_k0()) return {};
    K0Settings here = at_rest();
    Real sine = sin_friction;
    for (const SoilLayerSettings& layer : soil_layer)
      if (depth >= layer.top) here = layer.at_rest().given() ? layer.at_rest() : at_rest(), sine = layer.sin_friction;
    return here.at(sine, vertical_stress);
  }
};

void describe(Describe& d, BlockSettings& block);
void describe(Describe& d, DiskSettings& disk);
void describe(Describe& d, SoilLayerSettings& layer);
void describe(Describe& d, InitialVelocity& velocity);
void describe(Describe& d, BodySettings& body);

}  // namespace berm::bodies
