// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/body_settings.hpp"
#include "material/material.hpp"
#include "settings/random_field.hpp"

#include <memory>

namespace berm::settings {

struct Case;

/// A layer of a body at the start, down to the next one.
struct SoilLayer {
  Real top;  ///< m below the bed's surface
  Index material;
};

/// A property of a material of a body that varies at random.
struct SoilField {
  std::string path;  ///< "random_field.NAME"
  RandomFieldSettings settings;
  Index material;                                  ///< of the body
  std::size_t place;                               ///< of the property among material::local_values; of a field by classes not used
  bool with_stiffness = false;                     ///< the stiffness follows the strength, by a rigidity index
  std::shared_ptr<const RandomField> values = {};  ///< once the mesh is known (make_random_fields)
  Index first_class = none;                        ///< of a field by classes: the first of its materials (make_random_fields)
};

/// The materials of a body, which all have one law, and where each of them lies at the start.
struct BodySoil {
  std::vector<material::Material> materials;  ///< each once; the first is that of what no layer or region names
  std::vector<std::string> names;             ///< of their tables
  std::vector<SoilLayer> layers = {};         ///< downwards, below the first material
  std::map<std::string, Index> of_region = {};
  Real gravity = 0;                                   ///< m/s2, size
  std::optional<Real> vertical_stress_at_start = {};  ///< Pa, compression positive, where it is the same everywhere
  std::vector<Index> of_fill = {};                    ///< by place in BodySettings::fill
  std::vector<SoilField> fields = {};

  /// The number of the material in a region of the mesh and at a depth (m) below the bed's surface.
  Index material_index_at(const std::string& region, Real depth) const;
  /// The same at a place: where friction angle or density vary at random that of its class.
  Index material_index_at(const std::string& region, const SoilPlace& place) const;
  /// The material there, with its strength and stiffness: where they vary at random with their means.
  material::Material at(const std::string& region, Real depth) const;
  /// The same with those of the place.
  material::Material at(const std::string& region, const SoilPlace& place) const;
  /// Of a fill so far below its top, m, under its own weight.
  material::Material in_fill(Index material, Real depth) const;
  /// Mass of the soil above a depth over area, kg/m2, that gives the weight: of the layers; in bodies without layers of the material there alone.
  Real mass_above(const std::string& region, Real depth) const;
  /// The same on the vertical of a place, where the density may vary at random; none above the bed's surface.
  Real mass_above(const std::string& region, const SoilPlace& place) const;
  /// Vertical effective stress at the start there, Pa, compression positive, of the weight above or as the input gives it.
  Real vertical_stress(const std::string& region, Real depth) const;
  /// The same on the vertical of a place, where the density may vary at random.
  Real vertical_stress(const std::string& region, const SoilPlace& place) const;
};

/// One material everywhere.
BodySoil soil_of_one(const material::Material& material, const std::string& name = "");

/// The soil that a case asks for in a body; equal materials become one. In the material point method a body has one density over inertia density, that of its first
/// material: the inertia densities of the others follow, where water does not flow.
BodySoil soil_of(const Case& c, const bodies::BodySettings& body);

/// Whether a law of Mohr and Coulomb has a friction angle, which may vary at random.
bool has_friction(const material::Material& material);

/// Draws the random fields of a body for the part of the bed between two places; what their soundings know has its mean by the depth. A material whose friction angle or density
/// varies gets classes, materials of its name with tan(phi) or density a tenth of a standard deviation of its logarithm apart; where both vary, each class of the first has those of the
/// second. Throws KeyError.
void make_random_fields(BodySoil& soil, const SoilPlace& lower, const SoilPlace& upper);

/// Whether the particles of a body differ in strength, stiffness or material: then each keeps its own.
bool varies(const BodySoil& soil);

/// What these particles keep, after the state variables of the law: strength, stiffness, and the material's number where there are several.
std::vector<FieldInfo> local_fields(const BodySoil& soil);
std::vector<Real> local_values(const BodySoil& soil, const std::string& region, const SoilPlace& place);
std::vector<Real> local_values(const BodySoil& soil, Index material, const material::Material& there);

/// The material of a particle, from its extra numbers.
const material::Material& material_of(const BodySoil& soil, const Real* extra);
/// Where its number is among them; none where there is one material.
int material_index_offset(const BodySoil& soil);

/// All extra fields of a body's particles: those of its law, then what each keeps of its own.
std::vector<FieldInfo> particle_extra(const BodySoil& soil);

/// The names of the materials that a body, its layers, regions and fills have.
std::vector<std::string> materials_of(const bodies::BodySettings& body);
/// Whether a body names the material.
bool is_used(const Case& c, const std::string& material);

/// Refuses layers, regions and fills that do not fit together.
void check_soil(Describe& d, const Case& c, const std::string& path, const bodies::BodySettings& body);

/// Gives a body and its layers the friction angles from which their K0 follows, and refuses K0 by the stress history of soil that has none.
void find_k0(Describe& d, const Case& c, const std::string& path, bodies::BodySettings& body);

/// Throws InputError where strength or stiffness at a depth (m) that a body reaches are none.
void refuse_no_strength(const BodySoil& soil, const std::string& region, Real depth, const std::string& body);

/// What a time step takes of the soils of a body together: speed of pressure waves (m/s), inertia density (kg/m3), and their product; the largest K and 2G over this
/// density (m2/s2), K with the water that stays in the pores.
struct SoilWaves {
  Real fastest = 0, slowest = infinity;
  Real mean_speed = 0, mean_density = 0, mean_impedance = 0, min_density = infinity;
  Real bulk = 0, shear = 0;
};
SoilWaves waves_of(const material::Material& material);

}  // namespace berm::settings
