// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <vector>

namespace berm::test {

/// A case of berm new in which the first `replaced` has become `by`.
struct SenselessTemplate {
  const char *name, *kind, *replaced, *by;
  const char *key, *says;  ///< of the line that berm check must print, and a part of it
  bool refused = false;    ///< else warned of
};

/// For the messages of GoogleTest.
inline void PrintTo(const SenselessTemplate& input, std::ostream* stream)
{
  *stream << input.name;
}

inline const std::vector<SenselessTemplate>& senseless_templates()
{
  static const std::vector<SenselessTemplate> all = {
      {"steel_of_206_megapascal", "lateral-buckle", "206 GPa", "206 MPa", "pipeline.young_modulus", "usual values are 500 MPa to 450 GPa"},
      {"steel_that_expands_a_percent_by_degree", "lateral-buckle", "1.17e-5", "1.17e-2", "pipeline.expansion", "usual values are"},
      {"heat_of_a_furnace", "lateral-buckle", "\"20 K\"", "\"2000 K\"", "stage.heat.pipeline.temperature", "usual values are"},
      {"pressure_of_10_pascal", "lateral-buckle", "pipeline.temperature = \"20 K\"",
       "pipeline.temperature = \"20 K\"\npipeline.pressure = \"10 Pa\"", "stage.heat.pipeline.pressure",
       "usual values are 10 kPa to 200 MPa"},
      {"friction_of_6", "lateral-buckle", "friction = 0.6, mobil", "friction = 6, mobil", "pipeline.far_soil.friction", "is that intended"},
      {"springs_that_give_way_by_metres", "lateral-buckle", "mobilisation = \"5 mm\"", "mobilisation = \"5 m\"",
       "pipeline.far_soil.mobilisation", "usual values are"},
      {"wall_of_half_a_millimetre", "lateral-buckle", "wall = \"15 mm\"", "wall = \"0.5 mm\"", "pipeline.wall", "of the diameter"},
      {"wall_of_more_than_the_weight", "lateral-buckle", "wall = \"15 mm\"", "wall = \"40 mm\"", "pipeline.submerged_weight",
       "the steel wall alone"},
      {"pipe_lighter_than_its_steel", "lateral-buckle", "mass = \"330 kg/m\"", "mass = \"33 kg/m\"", "rigid.pipe.mass",
       "steel of the wall alone"},
      {"imperfection_steeper_than_the_line_bends", "lateral-buckle", "amplitude = \"1 m\"", "amplitude = \"20 m\"",
       "pipeline.imperfection.amplitude", "a slope of", true},
      {"line_that_ends_behind_its_slices", "lateral-buckle", "length = \"1500 m\"", "length = \"80 m\"", "pipeline.length",
       "beyond the last slice"},
      {"line_laid_by_13_times_its_weight", "lateral-buckle", "force = \"2.5 kN/m\"", "force = \"20 kN/m\"", "stage.lay.force",
       "times the submerged weight"},
      {"trench_above_the_bed", "trench-and-backfill", "\"-0.6 m\", \"-0.6 m\", \"0.2 m\", \"0.2 m\"",
       "\"0.6 m\", \"0.6 m\", \"0.8 m\", \"0.8 m\"", "body.bed.excavation.trench", "digs nothing"},
      {"trench_out_of_the_mesh", "trench-and-backfill", "[\"-0.24 m\", \"0.24 m\", \"0.24 m\", \"-0.24 m\"]",
       "[\"-0.24 m\", \"2.4 m\", \"2.4 m\", \"-0.24 m\"]", "body.bed.excavation.trench", "beyond the mesh"},
      {"trench_through_the_base", "trench-and-backfill", "\"-0.6 m\", \"-0.6 m\", \"0.2 m\", \"0.2 m\"",
       "\"-1.7 m\", \"-1.7 m\", \"0.2 m\", \"0.2 m\"", "body.bed.excavation.trench", "through the base"},
      {"trench_narrower_than_its_cable", "trench-and-backfill", "[\"-0.24 m\", \"0.24 m\", \"0.24 m\", \"-0.24 m\"]",
       "[\"-0.08 m\", \"0.08 m\", \"0.08 m\", \"-0.08 m\"]", "body.bed.excavation.trench", "wider than the body"},
      {"trench_that_is_dug_while_the_cable_is_lifted", "trench-and-backfill", "stage = \"trench\"", "stage = \"lift\"",
       "body.bed.excavation.trench.stage", "a stage of its own"},
      {"upright_trench_in_sand", "trench-and-backfill", "cohesion = \"4 kPa\"", "cohesion = 0", "body.bed.excavation.trench",
       "steeper than the friction angle"},
      {"trench_deeper_than_its_silt_stands", "trench-and-backfill", "cohesion = \"4 kPa\"", "cohesion = \"0.4 kPa\"",
       "body.bed.excavation.trench", "does not stand"},
      {"fill_where_soil_is", "trench-and-backfill", "y = [\"-0.7 m\", \"-0.7 m\", 0, 0]",
       "y = [\"-1.5 m\", \"-1.5 m\", \"-0.8 m\", \"-0.8 m\"]", "body.bed.fill.backfill", "places no soil"},
      {"weight_that_acts_upwards", "trench-and-backfill", "\"-120 N/m\"", "\"120 N/m\"", "stage.trench.drive.y.force",
       "a weight is less than 0"},
      {"trench_from_which_a_force_may_not_come", "trench-and-backfill", "until.time = \"2 s\"", "# until.time = \"2 s\"",
       "stage.trench.until", "may never be reached"},
      {"cable_that_sinks_through_the_base", "trench-and-backfill", "until.displacement = \"0.56 m\"\nuntil.time = \"2 s\"",
       "until.displacement = \"5.6 m\"", "stage.trench.until.displacement", "where the mesh ends", true},
      {"load_on_soil_that_is_dug", "trench-and-backfill", "[support.left]",
       "[traction.rock]\nboundary = \"surface\"\npressure = \"2 kPa\"\n[support.left]", "body.bed.excavation.trench", "removes the soil",
       true},
      {"pore_water_deeper_than_the_sea", "trench-and-backfill", "water.water_depth = \"100 m\"", "water.water_depth = \"100 km\"",
       "material.silt.water.water_depth", "usual values are"},
      {"clay_tighter_than_any", "consolidation", "1e-9 m/s", "1e-15 m/s", "material.silty_clay.water.real_permeability",
       "usual values are"},
      {"rotation_across_the_plane_of_symmetry", "pile", "drive.rotation_z.free", "drive.rotation_x.free",
       "stage.push_over.drive.rotation_x", "its own mirror image", true},
      {"rotation_of_the_body_about_the_upright_axis", "pile", "drive.rotation_z.free = true", "drive.rotation_y.free = true",
       "stage.push_over.drive.rotation_y", "its own mirror image", true},
      {"operation_heavier_than_touchdown", "flowline-in-sensitive-clay", "force = \"1.2 kN/m\"", "force = \"12 kN/m\"",
       "stage.unload.force", "1 to 3 times its submerged weight"},
      {"flooded_by_motions_of_laying", "flowline-in-sensitive-clay", "role = \"lay\"", "role = \"flooded\"", "stage.lay.role",
       "only the weight of a pipe changes"},
      {"clay_of_2_megapascal", "flowline-in-sensitive-clay", "undrained_strength = \"2 kPa\"", "undrained_strength = \"2 MPa\"",
       "material.clay.undrained_strength", "usual values are 0 Pa to 500 kPa"},
      {"strength_that_grows_by_megapascal", "flowline-in-sensitive-clay", "\"1.5 kPa/m\"", "\"1.5 MPa/m\"",
       "material.clay.undrained_strength_gradient", "times the submerged unit weight"},
      {"strength_that_grows_by_150_kilopascal", "flowline-in-sensitive-clay", "\"1.5 kPa/m\"", "\"150 kPa/m\"",
       "material.clay.undrained_strength_gradient", "times the submerged unit weight"},
      {"sensitivity_of_300", "flowline-in-sensitive-clay", "sensitivity = 3 ", "sensitivity = 300 ", "material.clay.sensitivity",
       "usual values are 1 to 50"},
      {"ductility_of_2000", "flowline-in-sensitive-clay", "ductility = 20 ", "ductility = 2000 ", "material.clay.ductility",
       "usual values are"},
      {"undrained_clay_that_is_compressed", "flowline-in-sensitive-clay", "poisson_ratio = 0.45", "poisson_ratio = 0.05",
       "material.clay.poisson_ratio", "usual values are"},
      {"rigidity_index_of_1", "flowline-in-sensitive-clay", "rigidity_index = 100", "rigidity_index = 1", "material.clay.rigidity_index",
       "is 1, and gives"},
      {"flowline_above_the_bed", "flowline-in-sensitive-clay", "center = [0, \"0.2 m\"]", "center = [0, \"0.225 m\"]", "rigid.flowline",
       "above the seabed"},
      {"lay_motions_of_a_hair", "flowline-in-sensitive-clay", "amplitude = \"40 mm\"", "amplitude = \"0.04 mm\"", "stage.lay.amplitude",
       "of the width of the body"},
      {"flowline_of_150_tonnes", "flowline-in-sensitive-clay", "mass = \"150 kg/m\"", "mass = \"150 t/m\"", "rigid.flowline.mass",
       "keeps moving by its inertia"},
      {"cable_lighter_than_its_weight", "storm-on-a-cable", "mass = \"140 kg/m\"", "mass = \"6 kg/m\"", "rigid.cable.mass",
       "less than its submerged weight"},
      {"sand_of_50_kilopascal", "storm-on-a-cable", "cohesion = \"50 Pa\"", "cohesion = \"50 kPa\"", "material.sand.cohesion",
       "is the unit right"},
      {"consolidation_of_milliseconds", "consolidation", "until.real_time = \"12 h\"", "until.real_time = \"12 ms\"",
       "stage.consolidate.until.real_time", "usual values are"},
      {"water_as_soft_as_air", "consolidation", "water.porosity = 0.5", "water.porosity = 0.5\nwater.bulk_modulus = \"2.2 kPa\"",
       "material.silty_clay.water.bulk_modulus", "usual values are"},
      {"layer_that_grows_by_megapascal", "layers", "cohesion_gradient = \"1.5 kPa/m\"", "cohesion_gradient = \"1.5 MPa/m\"",
       "material.soft_clay.cohesion_gradient", "times the submerged unit weight"},
      {"mudmat_above_the_bed", "footing", "center = [0, \"0.5 m\"]", "center = [0, \"0.8 m\"]", "rigid.mudmat", "above the seabed"},
      {"t_bar_above_the_bed", "t-bar", "center = [0, \"20 mm\"]", "center = [0, \"25 mm\"]", "rigid.bar", "above the seabed"},
      {"fill_in_the_air", "trench-and-backfill", "y = [\"-0.7 m\", \"-0.7 m\", 0, 0]", "y = [\"0.1 m\", \"0.1 m\", \"0.3 m\", \"0.3 m\"]",
       "body.bed.fill.backfill", "is above the soil"},
      {"cable_that_sinks_without_mass", "trench-and-backfill", "mass = \"60 kg/m\"", "mass = \"6 kg/m\"", "rigid.cable.mass",
       "less than its submerged weight"},
      {"suction_of_a_gigapascal", "anchor", "tension = \"none\"", "tension = \"1 GPa\"", "contact.skin.tension", "usual values are"},
      {"weight_of_operation_above_that_of_laying", "pipe-in-sand", "force = \"3 kN/m\"", "force = \"30 kN/m\"", "stage.unload.force",
       "1 to 3 times its submerged weight"},
      {"drag_of_millimetres", "pipe-in-sand", "until.displacement = \"1.5 m\"", "until.displacement = \"1.5 mm\"",
       "stage.drag.until.displacement", "of the width of the body"},
  };
  return all;
}

}  // namespace berm::test
