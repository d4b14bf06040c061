// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/earthwork_settings.hpp"

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

/// A layer of another material at the start, down to the next one.
struct SoilLayerSettings {
  Real top = 0;  ///< m below the bed's surface
  std::string material;
  std::optional<Real> k0 = {};  ///< instead of that of the body
};

/// Input of a deformable body: its material and the part of the mesh that it fills at the start.
struct BodySettings {
  std::string material;
  std::vector<SoilLayerSettings> soil_layer;           ///< downwards, below `material`
  std::map<std::string, std::string> region_material;  ///< other materials in some regions, instead of layers
  std::vector<std::string> regions;                    ///< of the mesh, filled cell by cell
  int particles_per_cell = 0;                          ///< n^dim; 0 = 9 in triangles, 8 in tetrahedra
  std::map<std::string, int> region_particles_per_cell;
  std::optional<BlockSettings> block;  ///< instead of regions
  std::optional<DiskSettings> disk;    ///< instead of regions
  Real damping = 0;                    ///< local damping factor
  std::map<std::string, Real> region_damping;
  std::optional<Real> k0;                         ///< horizontal over vertical stress at the start; empty: no stress at the start
  std::vector<Real> initial_stress;               ///< Pa, xx, yy and zz everywhere, tension positive, instead of k0
  std::vector<InitialVelocity> initial_velocity;  ///< summed
  Real initial_angular_velocity = 0;              ///< rad/s about the centre of mass (in space: about z), added to initial_velocity
  std::vector<ExcavationSettings> excavation;
  std::vector<FillSettings> fill;

  /// Horizontal over vertical stress at the start at a depth below the bed's surface, m; empty as k0 is.
  std::optional<Real> k0_at(Real depth) const
  {
    std::optional<Real> here = k0;
    for (const SoilLayerSettings& layer : soil_layer)
      if (depth >= layer.top) here = layer.k0 ? layer.k0 : k0;
    return here;
  }
};

void describe(Describe& d, BlockSettings& block);
void describe(Describe& d, DiskSettings& disk);
void describe(Describe& d, SoilLayerSettings& layer);
void describe(Describe& d, InitialVelocity& velocity);
void describe(Describe& d, BodySettings& body);

}  // namespace berm::bodies
