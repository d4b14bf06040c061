// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace berm::test {

/// A case without fault, which every wrong input spoils in one place. Its first line is line 1.
constexpr std::string_view good_case = R"(title = "a pipe on sand"
gravity = [0, "-1 gravity"]
surface = 0.0

[mesh]
kind = "box"
size = ["2 m", "1 m"]
cells = [20, 10]

[material.sand]
law = "mohr_coulomb"
density = "1800 kg/m^3"
young_modulus = "7 MPa"
poisson_ratio = 0.3
friction_angle = "35 deg"
dilation_angle = "5 deg"

[material.rubber]
law = "linear_elastic"
density = 1100
young_modulus = 2e6
poisson_ratio = 0.4

[body.bed]
material = "sand"
regions = ["box"]
particles_per_cell = 9
region_damping = {box = 0.05}

[rigid.pipe]
shape = "circle"
center = [1.0, "1.4 m"]
diameter = "0.8 m"
mass = "430 kg/m"

[contact.pipe_on_bed]
body = "bed"
rigid = "pipe"
friction_angle = "20 deg"
scheme = "musl_double"

[support.base]
boundary = "bottom"
fixed = ["x", "y"]

[[stage]]
name = "push"
kind = "push"
velocity = "0.1 m/s"
until = {embedment = "80 mm"}

[[stage]]
name = "drag"
kind = "drag"
velocity = "0.1 m/s"
ramp = 0.1

[stage.until]
displacement = "0.4 m"
time = 20

[watch.tip]
body = "bed"
point = [1.0, 0.9]

[output]
frame_time = "0.5 s"
)";

/// One fault, and what the message must say of it.
struct WrongInput {
  const char* name;
  std::string_view replaced, by;       ///< the first place in good_case where `replaced` stands becomes `by`
  int line;                            ///< the line that the message must name; 0 = none
  std::vector<std::string> says;       ///< parts of the message
  std::vector<std::string> overrides;  ///< KEY=VALUE, as for --set
};

/// For the messages of GoogleTest.
inline void PrintTo(const WrongInput& wrong, std::ostream* stream)
{
  *stream << wrong.name;
}

inline std::string text_of(const WrongInput& wrong)
{
  std::string text(good_case);
  if (!wrong.replaced.empty()) text.replace(text.find(wrong.replaced), wrong.replaced.size(), wrong.by);
  return text;
}

inline const std::vector<WrongInput>& wrong_inputs()
{
  static const std::vector<WrongInput> all = {
      // Keys.
      {"misspelt_key",
       "friction_angle = \"35 deg\"",
       "friction_angel = \"35 deg\"",
       15,
       {"material.sand.friction_angel", "unknown key", "did you mean \"friction_angle\"?", "allowed: law, density"},
       {}},
      {"misspelt_key_at_the_top", "gravity =", "gravty =", 2, {"gravty", "did you mean \"gravity\"?", "title"}, {}},
      {"key_without_a_near_one", "surface = 0.0", "colour = 0.0", 3, {"colour", "unknown key", "allowed: title, method, geometry"}, {}},
      {"misspelt_table", "[output]", "[ouput]", 66, {"ouput", "unknown table", "did you mean \"output\"?"}, {}},
      {"misspelt_table_with_a_name", "[support.base]", "[suport.base]", 42, {"suport", "did you mean \"support\"?"}, {}},
      {"misspelt_key_in_a_stage", "ramp = 0.1", "rmap = 0.1", 56, {"stage.drag.rmap", "did you mean \"ramp\"?"}, {}},
      {"displacements_from_the_first_stage",
       "kind = \"push\"",
       "kind = \"push\"\nzero_displacements = true",
       49,
       {"stage.push.zero_displacements", "it is for a later stage"},
       {}},
      {"misspelt_key_in_an_inner_table",
       "displacement = \"0.4 m\"",
       "displacment = \"0.4 m\"",
       59,
       {"stage.drag.until.displacment", "did you mean \"displacement\"?", "allowed: time, real_time, displacement, embedment"},
       {}},
      {"misspelt_key_in_an_inline_table",
       "{embedment",
       "{embedmant",
       50,
       {"stage.push.until.embedmant", "did you mean \"embedment\"?"},
       {}},
      {"key_of_another_alternative",
       "poisson_ratio = 0.4",
       "poisson_ratio = 0.4\ncohesion = 0",
       23,
       {"material.rubber.cohesion", "law = \"mohr_coulomb\"", "law = \"linear_elastic\"", "allowed: law, density"},
       {}},
      {"key_of_another_shape",
       "diameter = \"0.8 m\"",
       "diameter = \"0.8 m\"\nnormal = [0, 1]",
       34,
       {"rigid.pipe.normal", "shape = \"half_plane\"", "center, diameter"},
       {}},
      {"key_twice", "young_modulus = \"7 MPa\"", "density = 1800\nyoung_modulus = \"7 MPa\"", 13, {"density"}, {}},
      {"table_twice", "[output]", "[mesh]", 66, {"mesh"}, {}},
      // What is missing.
      {"key_missing",
       "friction_angle = \"35 deg\"\n",
       "",
       10,
       {"material.sand.friction_angle", "missing in [material.sand]", "an angle", "\"35 deg\""},
       {}},
      {"key_missing_in_a_stage",
       "kind = \"push\"\n",
       "",
       46,
       {"stage.push.kind", "missing in [stage.push]", "allowed: geostatic, push, drag, free"},
       {}},
      {"list_missing", "center = [1.0, \"1.4 m\"]\n", "", 30, {"rigid.pipe.center", "missing", "a list of numbers", "\"20 mm\""}, {}},
      {"table_missing", "[mesh]\nkind = \"box\"\nsize = [\"2 m\", \"1 m\"]\ncells = [20, 10]\n", "", 1, {"mesh", "[mesh] is missing"}, {}},
      {"law_missing", "law = \"mohr_coulomb\"\n", "", 10, {"material.sand.law", "missing", "linear_elastic, mohr_coulomb"}, {}},
      {"nothing_at_all", good_case, "", 1, {"mesh"}, {}},
      {"until_missing", "until = {embedment = \"80 mm\"}\n", "", 46, {"stage.push.until", "at least one of time"}, {}},
      // Units and kinds.
      {"wrong_dimension",
       "diameter = \"0.8 m\"",
       "diameter = \"3 kg\"",
       33,
       {"rigid.pipe.diameter", "\"3 kg\"", "wrong dimension", "a length", "\"20 mm\"", "\"0.8 m\""},
       {}},
      {"wrong_dimension_in_a_list", "\"1.4 m\"", "\"1.4 s\"", 32, {"rigid.pipe.center[1]", "wrong dimension", "a length"}, {}},
      {"unknown_unit",
       "\"7 MPa\"",
       "\"7 MPaa\"",
       13,
       {"material.sand.young_modulus", "unknown unit \"MPaa\"", "a pressure or stress", "\"20 kPa\""},
       {}},
      {"text_without_a_number", "\"7 MPa\"", "\"stiff\"", 13, {"young_modulus", "\"stiff\"", "does not begin with a number"}, {}},
      {"decimal_comma", "\"0.1 m/s\"", "\"0,1 m/s\"", 49, {"stage.push.velocity", "decimal comma"}, {}},
      {"angle_for_a_bare_number",
       "poisson_ratio = 0.3",
       "poisson_ratio = \"0.3 deg\"",
       14,
       {"poisson_ratio", "wrong dimension", "a dimensionless number"},
       {}},
      {"nan", "surface = 0.0", "surface = nan", 3, {"surface", "finite"}, {}},
      {"infinity", "surface = 0.0", "surface = inf", 3, {"surface", "finite"}, {}},
      {"number_beyond_64_bits", "surface = 0.0", "surface = 99999999999999999999", 3, {"not valid TOML"}, {}},
      {"number_that_is_not_finite", "surface = 0.0", "surface = \"1e999 m\"", 3, {"surface", "is not a finite number"}, {}},
      {"control_character", "\"a pipe on sand\"", "\"a pipe \\u001b[2J\"", 1, {"title", "control character"}, {}},
      {"control_character_beyond_ascii", "\"a pipe on sand\"", "\"a pipe \\u009b2J\"", 1, {"title", "control character"}, {}},
      {"nul_in_a_text", "\"a pipe on sand\"", "\"a \\u0000 pipe\"", 1, {"title", "control character"}, {}},
      {"rows_without_number",
       "frame_time = \"0.5 s\"",
       "history_time = 1e-30",
       67,
       {"output.history_time", "rows of history.csv", "at most 1e+10"},
       {}},
      {"frames_without_number", "\"0.5 s\"", "1e-30", 67, {"output.frame_time", "frames", "at most 1e+05"}, {}},
      {"frames_of_travel_without_number",
       "frame_time = \"0.5 s\"",
       "frame_travel = 1e-30",
       67,
       {"output.frame_travel", "at most 1e+05"},
       {}},
      {"truth_for_a_number", "ramp = 0.1", "ramp = true", 56, {"stage.drag.ramp", "a time", "not true"}, {}},
      {"number_for_a_text", "boundary = \"bottom\"", "boundary = 3", 43, {"support.base.boundary", "text in quotes", "the number 3"}, {}},
      {"date_for_a_number", "ramp = 0.1", "ramp = 2024-01-01", 56, {"stage.drag.ramp", "not a date"}, {}},
      {"lone_number_for_a_list",
       "gravity = [0, \"-1 gravity\"]",
       "gravity = -9.81",
       2,
       {"gravity", "must be a list of numbers", "not the number -9.81"},
       {}},
      {"lone_text_for_a_list",
       "fixed = [\"x\", \"y\"]",
       "fixed = \"x\"",
       44,
       {"support.base.fixed", "must be a list of texts", "not the text \"x\""},
       {}},
      {"list_for_a_number", "diameter = \"0.8 m\"", "diameter = [0.8]", 33, {"rigid.pipe.diameter", "a length", "not an array"}, {}},
      {"part_of_a_whole_number",
       "particles_per_cell = 9",
       "particles_per_cell = 9.5",
       27,
       {"body.bed.particles_per_cell", "whole number"},
       {}},
      {"huge_whole_number",
       "particles_per_cell = 9",
       "particles_per_cell = 9000000000",
       27,
       {"body.bed.particles_per_cell", "from 0 to 400"},
       {}},
      {"number_for_a_table", "{box = 0.05}", "0.05", 28, {"body.bed.region_damping", "table from names to numbers"}, {}},
      {"text_for_a_table", "[output]\nframe_time = \"0.5 s\"", "[watch.other]\nbody = 3", 67, {"watch.other.body", "text in quotes"}, {}},
      {"table_instead_of_tables_in_a_row",
       "[[stage]]\nname = \"push\"\nkind = \"push\"\nvelocity = \"0.1 m/s\"\nuntil = {embedment = \"80 mm\"}\n\n[[stage]]",
       "[stage]",
       46,
       {"stage", "[[stage]]", "not a table"},
       {}},
      {"material_without_a_name", "[material.rubber]", "[material]", 19, {"material.law", "[material.NAME]"}, {}},
      // Ranges and words.
      {"number_out_of_range",
       "poisson_ratio = 0.3",
       "poisson_ratio = 0.6",
       14,
       {"material.sand.poisson_ratio", "from 0 to 0.495", "it is 0.6"},
       {}},
      {"quantity_out_of_range", "\"0.8 m\"", "\"-800 mm\"", 33, {"rigid.pipe.diameter", "more than 0 m", "\"-800 mm\" is -0.8 m"}, {}},
      {"degrees_taken_for_radians", "\"35 deg\"", "35", 15, {"material.sand.friction_angle", "60 deg", "write \"35 deg\""}, {}},
      {"angle_out_of_range",
       "\"20 deg\"",
       "\"95 deg\"",
       39,
       {"contact.pipe_on_bed.friction_angle", "from 0 to 89.9 deg (0 to 1.569 rad)", "1.65806 rad"},
       {}},
      {"number_by_name_out_of_range", "{box = 0.05}", "{box = 5}", 28, {"body.bed.region_damping.box", "from 0 to 1"}, {}},
      {"unknown_word",
       "scheme = \"musl_double\"",
       "scheme = \"musl_duoble\"",
       40,
       {"contact.pipe_on_bed.scheme", "did you mean \"musl_double\"?", "allowed: musl_coupled, musl_double, musl_single"},
       {}},
      {"unknown_law",
       "\"mohr_coulomb\"",
       "\"mohr_columb\"",
       11,
       {"material.sand.law", "did you mean \"mohr_coulomb\"?", "linear_elastic, mohr_coulomb"},
       {}},
      {"number_for_a_word", "kind = \"push\"", "kind = 1", 48, {"stage.push.kind", "word in quotes", "geostatic, push, drag, free"}, {}},
      {"empty_name", "name = \"push\"", "name = \"\"", 47, {"name", "must not be empty"}, {}},
      {"empty_name_of_a_table", "[material.rubber]", "[material.\"\"]", 18, {"material.", "is not a valid name"}, {}},
      {"odd_name_of_a_table", "[material.rubber]", "[material.\"a.b\"]", 18, {"\"a.b\"", "is not a valid name"}, {}},
      {"empty_text", "material = \"sand\"", "material = \"\"", 25, {"body.bed.material", "must not be empty"}, {}},
      // What must fit together.
      {"unknown_material",
       "material = \"sand\"",
       "material = \"snad\"",
       25,
       {"body.bed.material", "there is no [material.snad]", "did you mean \"sand\"?", "allowed: sand, rubber"},
       {}},
      {"unknown_direction",
       "fixed = [\"x\", \"y\"]",
       "fixed = [\"x\", \"z\"]",
       44,
       {"support.base.fixed", "\"z\" is not a direction", "allowed: x, y"},
       {}},
      {"unknown_body_watched", "body = \"bed\"\npoint", "body = \"bad\"\npoint", 63, {"watch.tip.body", "did you mean \"bed\"?"}, {}},
      {"unknown_region", "{box = 0.05}", "{bx = 0.05}", 28, {"body.bed.region_damping.bx", "did you mean \"box\"?"}, {}},
      {"three_numbers_in_a_plane", "point = [1.0, 0.9]", "point = [1.0, 0.9, 0]", 64, {"watch.tip.point", "needs 2 numbers"}, {}},
      {"two_stages_of_one_name", "name = \"drag\"", "name = \"push\"", 53, {"stage.push.name", "another stage has this name"}, {}},
      {"velocity_and_force", "ramp = 0.1", "force = \"1 kN/m\"", 52, {"stage.drag", "either velocity or force"}, {}},
      {"two_ways_to_fill_a_body",
       "regions = [\"box\"]",
       "regions = [\"box\"]\ndisk = {center = [1, 0.5], diameter = 0.5, spacing = 0.1}",
       24,
       {"body.bed", "needs one of regions = [...], [body.bed.block] and [body.bed.disk]"},
       {}},
      {"disk_of_a_few_particles",
       "regions = [\"box\"]",
       "disk = {center = [1, 0.5], diameter = 0.5, spacing = 0.3}",
       26,
       {"body.bed.disk.spacing", "less than half the diameter"},
       {"body.bed.region_damping={}"}},
      {"two_stresses_at_the_start",
       "regions = [\"box\"]",
       "regions = [\"box\"]\ninitial_stress = [0, \"-1 kPa\", 0]\nk0 = 0.5",
       27,
       {"body.bed.initial_stress", "cannot be combined with k0"},
       {}},
      {"stress_of_two_numbers",
       "regions = [\"box\"]",
       "regions = [\"box\"]\ninitial_stress = [0, \"-1 kPa\"]",
       27,
       {"body.bed.initial_stress", "needs 3 numbers, xx, yy and zz, and has 2"},
       {}},
      {"phase_without_a_wave",
       "regions = [\"box\"]",
       "regions = [\"box\"]\ninitial_velocity = [{amplitude = [1, 0], phase = \"90 deg\"}]",
       27,
       {"body.bed.initial_velocity[0].phase", "needs a wave_number"},
       {}},
      {"polygon_that_crosses_itself",
       "shape = \"circle\"\ncenter = [1.0, \"1.4 m\"]\ndiameter = \"0.8 m\"",
       "shape = \"polygon\"\nx = [0, 1, 0, 1]\ny = [0, 1, 1, 0]",
       32,
       {"rigid.pipe.x", "must not cross or touch"},
       {}},
      {"polygon_with_two_corners",
       "shape = \"circle\"\ncenter = [1.0, \"1.4 m\"]\ndiameter = \"0.8 m\"",
       "shape = \"polygon\"\nx = [0, 1]\ny = [0, 1]",
       32,
       {"rigid.pipe.x", "three corners or more, and has 2"},
       {}},
      {"polygon_without_a_y",
       "shape = \"circle\"\ncenter = [1.0, \"1.4 m\"]\ndiameter = \"0.8 m\"",
       "shape = \"polygon\"\nx = [0, 1, 1]\ny = [0, 1]",
       33,
       {"rigid.pipe.y", "has 2 numbers, and x has 3"},
       {}},
      {"half_plane_that_turns",
       "shape = \"circle\"\ncenter = [1.0, \"1.4 m\"]\ndiameter = \"0.8 m\"",
       "shape = \"half_plane\"\nrotation = \"free\"\npoint = [0, 1]\nnormal = [0, 1]",
       32,
       {"rigid.pipe.rotation", "a half-plane cannot rotate"},
       {}},
      {"weightless_body_that_turns",
       "mass = \"430 kg/m\"",
       "rotation = \"free\"",
       34,
       {"rigid.pipe.rotation", "needs a mass or a moment_of_inertia"},
       {"stage.drag.vertical=fixed"}},
      {"drag_that_is_fixed_and_moves_vertically",
       "",
       "",
       0,
       {"stage.drag.vertical_velocity", "cannot be combined with vertical = \"fixed\""},
       {"stage.drag.vertical=fixed", "stage.drag.vertical_velocity=1"}},
      {"weightless_body_that_moves_freely", "mass = \"430 kg/m\"", "motion = \"free\"", 34, {"rigid.pipe.motion", "needs a mass"}, {}},
      {"thrown_body_that_is_not_free",
       "mass = \"430 kg/m\"",
       "mass = \"430 kg/m\"\nvelocity = [0, -1]",
       35,
       {"rigid.pipe.velocity", "is that of a free body", "add motion = \"free\""},
       {}},
      {"thrown_body_that_is_driven_first",
       "mass = \"430 kg/m\"",
       "mass = \"430 kg/m\"\nmotion = \"free\"\nvelocity = [0, -1]",
       36,
       {"rigid.pipe.velocity", "that stage drives the body", "let one of kind \"free\" come first"},
       {}},
      {"thrown_body_in_one_direction",
       "",
       "",
       0,
       {"rigid.pipe.velocity", "needs two components"},
       {"rigid.pipe.motion=free", "rigid.pipe.velocity=[1]"}},
      {"repeat_of_no_load_history",
       "",
       "",
       0,
       {"stage.push.load_repeat", "is for a load history, and there is none"},
       {"stage.push.load_repeat=2"}},
      {"displacement_that_does_not_begin_at_0",
       "velocity = \"0.1 m/s\"",
       "load_times = [0, 1]\nloads.w_displacement = [\"1 mm\", \"2 mm\"]",
       50,
       {"stage.push.loads.w_displacement", "its first row must be 0 at the time 0", "take its first value from all"},
       {}},
      {"moment_on_a_body_without_inertia",
       "kind = \"drag\"\nvelocity = \"0.1 m/s\"",
       "kind = \"drive\"\ndrive.rotation.moment = 5",
       52,
       {"stage.drag", "a moment rotates [rigid.pipe]", "needs a mass or a moment_of_inertia"},
       {"rigid.pipe.mass=0"}},
      {"traction_without_a_size",
       "[[stage]]",
       "[traction.load]\nboundary = \"top\"\n\n[[stage]]",
       46,
       {"traction.load", "needs either stress or pressure, and not both"},
       {}},
      {"traction_of_two_sizes",
       "[[stage]]",
       "[traction.load]\nboundary = \"top\"\npressure = 1\nstress = [0, 1]\n\n[[stage]]",
       46,
       {"traction.load", "needs either stress or pressure, and not both"},
       {}},
      {"traction_of_three_numbers_in_a_plane",
       "[[stage]]",
       "[traction.load]\nboundary = \"top\"\nstress = [0, 1, 0]\n\n[[stage]]",
       48,
       {"traction.load.stress", "needs 2 numbers, one per direction, and has 3"},
       {}},
      {"traction_of_a_force",
       "[[stage]]",
       "[traction.load]\nboundary = \"top\"\nstress = [0, \"1 kN\"]\n\n[[stage]]",
       48,
       {"traction.load.stress", "1 kN"},
       {}},
      {"traction_in_a_range_of_no_length",
       "[[stage]]",
       "[traction.load]\nboundary = \"top\"\npressure = 1\nx_range = [1, 1]\n\n[[stage]]",
       49,
       {"traction.load.x_range", "needs 2 numbers, the smaller one first"},
       {}},
      {"traction_with_a_negative_ramp",
       "[[stage]]",
       "[traction.load]\nboundary = \"top\"\npressure = 1\nramp = \"-1 s\"\n\n[[stage]]",
       49,
       {"traction.load.ramp", "0 s"},
       {}},
      {"traction_in_an_unknown_stage",
       "[[stage]]",
       "[traction.load]\nboundary = \"top\"\npressure = 1\nstages = [\"psuh\"]\n\n[[stage]]",
       49,
       {"traction.load.stages", "there is no stage \"psuh\"", "did you mean \"push\"?"},
       {}},
      {"traction_with_the_name_of_a_body",
       "[[stage]]",
       "[traction.bed]\nboundary = \"top\"\npressure = 1\n\n[[stage]]",
       46,
       {"traction.bed", "a [body.NAME] or [watch.NAME] has this name"},
       {}},
      {"support_in_an_unknown_stage",
       "fixed = [\"x\", \"y\"]",
       "fixed = [\"x\", \"y\"]\nstages = [\"drga\"]",
       45,
       {"support.base.stages", "there is no stage \"drga\"", "did you mean \"drag\"?", "allowed: push, drag"},
       {}},
      {"less_inertia_than_weight",
       "young_modulus = \"7 MPa\"",
       "inertia_density = \"1700 kg/m^3\"\nyoung_modulus = \"7 MPa\"",
       13,
       {"material.sand.inertia_density", "less than the density that gives the weight"},
       {}},
      {"layer_of_an_unknown_material",
       "{box = 0.05}",
       "{box = 0.05}\nsoil_layer = [{top = 0.2, material = \"snad\"}]",
       29,
       {"body.bed.soil_layer", "material", "there is no [material.snad]", "did you mean \"sand\"?"},
       {}},
      {"layer_of_another_law",
       "{box = 0.05}",
       "{box = 0.05}\nsoil_layer = [{top = 0.2, material = \"rubber\"}]",
       29,
       {"body.bed.soil_layer", "\"linear_elastic\"", "\"mohr_coulomb\"", "all materials of a body need one law"},
       {}},
      {"layers_upside_down",
       "{box = 0.05}",
       "{box = 0.05}\nsoil_layer = [{top = 0.2, material = \"sand\"}, {top = 0.1, material = \"sand\"}]",
       29,
       {"body.bed.soil_layer", "top", "deeper than that of the layer above"},
       {}},
      {"material_of_an_unknown_region",
       "{box = 0.05}",
       "{box = 0.05}\nregion_material = {bx = \"sand\"}",
       29,
       {"body.bed.region_material.bx", "the body does not fill this region", "allowed: box"},
       {}},
      {"unknown_material_of_a_region",
       "{box = 0.05}",
       "{box = 0.05}\nregion_material = {box = \"snad\"}",
       29,
       {"body.bed.region_material.box", "there is no [material.snad]"},
       {}},
      {"number_for_the_material_of_a_region",
       "{box = 0.05}",
       "{box = 0.05}\nregion_material = {box = 3}",
       29,
       {"body.bed.region_material.box", "must be a text in quotes"},
       {}},
      {"layer_with_k0_in_a_body_without",
       "[material.rubber]\nlaw = \"linear_elastic\"\ndensity = 1100",
       "[material.rubber]\nlaw = \"mohr_coulomb\"\nfriction_angle = 0\ndensity = 1100\ninertia_density = 2200",
       0,
       {"body.bed.soil_layer", "needs body.bed.k0"},
       {"body.bed.soil_layer=[{top = 0.2, material = \"rubber\", k0 = 0.5}]"}},
      {"profile_of_one_depth",
       "young_modulus = \"7 MPa\"",
       "profile = {depth = [0], young_modulus = [7e6]}",
       13,
       {"material.sand.profile.depth", "needs two depths"},
       {}},
      {"profile_that_goes_up",
       "young_modulus = \"7 MPa\"",
       "profile = {depth = [0, 2, 1], young_modulus = [7e6, 8e6, 9e6]}",
       13,
       {"material.sand.profile.depth", "larger than the one before"},
       {}},
      {"profile_with_a_value_too_few",
       "young_modulus = \"7 MPa\"",
       "profile = {depth = [0, 1], young_modulus = [7e6]}",
       13,
       {"material.sand.profile.young_modulus", "a value for each of the 2 depths, and has 1"},
       {}},
      {"stiffness_given_twice",
       "young_modulus = \"7 MPa\"",
       "young_modulus = \"7 MPa\"\nprofile = {depth = [0, 1], young_modulus = [6e6, 8e6]}",
       13,
       {"material.sand.young_modulus", "is given by profile.young_modulus: leave it out"},
       {}},
      {"gravity_loading_of_nothing",
       "surface = 0.0",
       "initial_state = \"gravity_loading\"",
       3,
       {"initial_state", "is for bodies with k0, and there is none"},
       {}},
      {"unknown_initial_state",
       "surface = 0.0",
       "initial_state = \"gravity\"",
       3,
       {"initial_state", "did you mean \"gravity_loading\"?", "allowed: automatic, level_ground, gravity_loading"},
       {}},
      // No TOML.
      {"bracket_without_its_pair", "[mesh]", "[mesh", 5, {"not valid TOML", "']'"}, {}},
      {"parser_gives_up", "[output]", "[&", 66, {"not valid TOML"}, {}},
      {"quote_not_closed", "\"0.5 s\"", "\"0.5 s", 67, {"is a quote left open?"}, {}},
      {"value_without_quotes", "\"0.5 s\"", "0.5 s", 67, {"are written in quotes"}, {}},
      // Overrides.
      {"override_of_an_unknown_key",
       "",
       "",
       0,
       {"--set material.sand.frction_angle: ", "unknown key", "did you mean \"friction_angle\"?"},
       {"material.sand.frction_angle=0.5"}},
      {"override_of_an_unknown_material",
       "",
       "",
       0,
       {"--set material.snad.friction_angle: ", "there is no [material.snad]", "did you mean \"sand\"?"},
       {"material.snad.friction_angle=0.5"}},
      {"override_of_an_unknown_stage",
       "",
       "",
       0,
       {"--set stage.darg.ramp: ", "no stage named \"darg\"", "did you mean \"drag\"?", "push, drag"},
       {"stage.darg.ramp=1"}},
      {"override_through_a_number", "", "", 0, {"--set surface.level: ", "surface is the number 0"}, {"surface.level=1"}},
      {"override_of_the_wrong_dimension", "", "", 0, {"--set rigid.pipe.diameter: \"3 kg\"", "a length"}, {"rigid.pipe.diameter=3 kg"}},
      {"override_out_of_range", "", "", 0, {"--set rigid.pipe.diameter: must be more than 0 m"}, {"rigid.pipe.diameter=0"}},
      {"override_without_a_value", "", "", 0, {"--set rigid.pipe.diameter: ", "KEY=VALUE"}, {"rigid.pipe.diameter"}},
      {"override_with_an_empty_part", "", "", 0, {"--set rigid..diameter: ", "empty part"}, {"rigid..diameter=1"}},
      {"override_of_every_table_with_an_unknown_key",
       "",
       "",
       0,
       {"--set material.*.densty: material.sand.densty: unknown key", "did you mean \"density\"?"},
       {"material.*.densty=1"}},
      {"override_of_every_table_where_there_is_none", "", "", 0, {"--set mesh.*.size: ", "no table in mesh"}, {"mesh.*.size=1"}},
      {"override_of_every_table_itself", "", "", 0, {"--set material.*: ", "a key must follow it"}, {"material.*=1"}},
      {"override_with_broken_toml", "", "", 0, {"--set gravity: ", "not valid TOML"}, {"gravity=[0, -1 gravity]"}},
  };
  return all;
}

}  // namespace berm::test
