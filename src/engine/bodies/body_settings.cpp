// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_inputs_test.cpp
#include "bodies/body_settings.hpp"

namespace berm::bodies {

void describe(Describe& d, BlockSettings& block)
{
  d.value("center", block.center, {.meaning = "centre of the block", .unit = "m", .required = true});
  d.value("size", block.size, {.meaning = "lengths of the block's sides", .unit = "m", .range = positive, .required = true});
  d.value("angle", block.angle, {.meaning = "rotation of the block, counter-clockwise", .unit = "rad", .range = {-pi, pi}});
  d.value("spacing", block.spacing, {.meaning = "distance between its particles", .unit = "m", .range = positive, .required = true});
}

void describe(Describe& d, DiskSettings& disk)
{
  d.value("center", disk.center, {.meaning = "centre of the disk", .unit = "m", .required = true});
  d.value("diameter", disk.diameter, {.meaning = "diameter of the disk", .unit = "m", .range = positive, .required = true});
  d.value("spacing", disk.spacing,
          {.meaning = "distance between its particles; their volumes are scaled so that they sum up to that of the disk",
           .unit = "m",
           .range = positive,
           .required = true});
}

void describe(Describe& d, SoilLayerSettings& layer)
{
  d.value("top", layer.top,
          {.meaning = "depth of its top below the seabed at the start", .unit = "m", .range = positive, .required = true});
  d.value("material", layer.material, {.meaning = "name of its [material.NAME]", .required = true});
  d.value("k0", layer.k0,
          {.meaning = "ratio of horizontal to vertical stress at the start in it; left out, that of the body", .range = {0, 5}});
  d.value("k0_ocr", layer.k0_ocr, {.meaning = "instead of k0: overconsolidation ratio from which it follows", .range = {1, 100}});
  d.value("k0_pop", layer.k0_pop,
          {.meaning = "instead of k0: pre-overburden pressure from which it follows", .unit = "Pa", .range = not_negative});
}

void describe(Describe& d, InitialVelocity& velocity)
{
  d.value("amplitude", velocity.amplitude, {.meaning = "velocity of the particles at the start", .unit = "m/s", .required = true});
  d.value("wave_number", velocity.wave_number,
          {.meaning = "makes it a standing wave: amplitude times sin(wave_number . x + phase)", .unit = "rad/m"});
  d.value("phase", velocity.phase, {.meaning = "phase of the wave", .unit = "rad"});
}

void describe(Describe& d, BodySettings& body)
{
  d.value("material", body.material, {.meaning = "name of its [material.NAME]", .required = true});
  d.value("region_material", body.region_material,
          {.meaning = "names of other materials with the same law in some regions, by the region's name"});
  d.value("regions", body.regions, {.meaning = "regions of the mesh that it fills at the start"});
  d.value("particles_per_cell", body.particles_per_cell,
          {.meaning = "particles per cell at the start: n^2 or 2 n^2 (1, 2, 4, 8, 9, 16, 18 ...) in triangles, n^3 (1, 8, 27 ...) in "
                      "tetrahedra; 0 = 9 or 8",
           .range = {0, 400}});
  d.value("region_particles_per_cell", body.region_particles_per_cell,
          {.meaning = "particles per cell in some regions, by the region's name", .range = {1, 400}});
  d.optional_table("block", body.block, {.meaning = "a block of particles on a lattice of its own, instead of regions"});
  d.optional_table("disk", body.disk, {.meaning = "a disk of particles on a lattice of its own, instead of regions; 2D only"});
  d.value("damping", body.damping,
          {.meaning = "local damping: fraction of a node's unbalanced force that opposes its velocity", .range = {0, 1}});
  d.value("region_damping", body.region_damping, {.meaning = "local damping in some regions, by the region's name", .range = {0, 1}});
  d.value("k0", body.k0,
          {.meaning = "ratio of horizontal to vertical stress at the start, which is that of a level bed below `surface`, or as "
                      "`initial_state` says; absent = no stress",
           .range = {0, 5}});
  d.value("k0_ocr", body.k0_ocr,
          {.meaning = "instead of k0: overconsolidation ratio, of soil with a friction angle: k0 = (1 - sin phi) OCR^sin phi, at most "
                      "(1 + sin phi)/(1 - sin phi)",
           .range = {1, 100}});
  d.value("k0_pop", body.k0_pop,
          {.meaning = "instead of k0: pre-overburden pressure, by which the past vertical stress exceeded the present one: OCR = (sigma'_v "
                      "+ POP)/sigma'_v",
           .unit = "Pa",
           .range = not_negative});
  d.value("initial_stress", body.initial_stress,
          {.meaning = "stresses xx, yy and zz at the start, the same everywhere, tension positive; instead of k0", .unit = "Pa"});
  d.value("initial_angular_velocity", body.initial_angular_velocity,
          {.meaning =
               "angular velocity about its centre of mass (in space: about z) at the start, counter-clockwise; added to initial_velocity",
           .unit = "rad/s"});
  d.array("soil_layer", body.soil_layer,
          {.meaning = "layers of other materials with the same law, downwards: each from its upper edge to the next one"});
  d.array("initial_velocity", body.initial_velocity, {.meaning = "velocity at the start; several terms are summed"});
  d.array("excavation", body.excavation, {.meaning = "soil that a stage removes"});
  d.array(
      "fill", body.fill,
      {.meaning =
           "soil that a stage places, at rest, inside a polygon, where there is neither soil nor rigid body. It becomes part of the body"});
}

}  // namespace berm::bodies
