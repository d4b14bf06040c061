// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sanity/sanity.hpp"
#include "sanity/scene.hpp"

namespace berm::sanity {

// One question each. A question looks at a scene and adds what it finds; it says nothing where it does not apply.

// Single numbers.
void are_numbers_usual(const Scene& s, Findings& found);

// Where things are.
void does_the_driven_body_touch_soil(const Scene& s, Findings& found);
void does_a_pushed_pipe_begin_at_the_surface(const Scene& s, Findings& found);
void is_the_body_smaller_than_the_mesh(const Scene& s, Findings& found);
void do_bodies_at_each_other_touch(const Scene& s, Findings& found);
void do_rigid_bodies_pass_through_each_other(const Scene& s, Findings& found);
void do_motions_fit_a_half(const Scene& s, Findings& found);
void does_the_path_stay_in_the_mesh(const Scene& s, Findings& found);
void does_the_path_stay_on_fine_cells(const Scene& s, Findings& found);
void are_cells_small_enough(const Scene& s, Findings& found);
void is_the_body_two_cells_thick(const Scene& s, Findings& found);
void do_fine_cells_reach_the_ends(const Scene& s, Findings& found);
void do_walls_cut_a_body(const Scene& s, Findings& found);
void are_walls_far_enough(const Scene& s, Findings& found);
void is_the_wall_beyond_the_plastic_zone(const Scene& s, Findings& found);
void is_the_bed_held(const Scene& s, Findings& found);
void is_the_surface_where_the_bed_ends(const Scene& s, Findings& found);
void does_soil_fill_the_bed(const Scene& s, Findings& found);
void is_there_soil_at_a_watch(const Scene& s, Findings& found);

// A mesh from a file.
void is_the_mesh_what_its_file_says(const Scene& s, Findings& found);
void is_the_mesh_in_metres(const Scene& s, Findings& found);
void are_coordinates_resolved(const Scene& s, Findings& found);

// Forces along the depth of a body.
void are_depth_slices_thicker_than_cells(const Scene& s, Findings& found);
void do_slices_slide_without_jolts(const Scene& s, Findings& found);

// Ground that is not level.
void does_the_ground_stand(const Scene& s, Findings& found);
void do_excavations_stand(const Scene& s, Findings& found);
void does_the_body_fit_the_ground(const Scene& s, Findings& found);

// Earthworks.
void do_excavations_find_soil(const Scene& s, Findings& found);
void do_fills_lie_in_the_mesh(const Scene& s, Findings& found);
void do_bodies_fit_into_trenches(const Scene& s, Findings& found);
void are_earthworks_done_while_the_body_rests(const Scene& s, Findings& found);
void do_loads_keep_their_soil(const Scene& s, Findings& found);

// The soil.
void does_gravity_point_down(const Scene& s, Findings& found);
void is_the_soil_a_soil(const Scene& s, Findings& found);
void do_cells_resolve_the_random_soil(const Scene& s, Findings& found);
void is_the_strength_by_stress_that_of_clay(const Scene& s, Findings& found);
void does_the_strength_grow_as_that_of_clay(const Scene& s, Findings& found);
void is_the_stiffness_that_of_soil(const Scene& s, Findings& found);
void is_the_strain_rate_smooth(const Scene& s, Findings& found);
void is_softening_free_of_the_cells(const Scene& s, Findings& found);
void are_bands_as_wide_as_the_soil_makes_them(const Scene& s, Findings& found);
void what_inertia_do_layers_get(const Scene& s, Findings& found);
void is_all_soil_used(const Scene& s, Findings& found);
void does_the_soil_bear_its_initial_stress(const Scene& s, Findings& found);
void does_pressure_shake_the_clay(const Scene& s, Findings& found);
void is_the_interface_weaker_than_the_soil(const Scene& s, Findings& found);
void is_tension_that_of_clay(const Scene& s, Findings& found);
void may_the_sand_rest(const Scene& s, Findings& found);
void do_tractions_press(const Scene& s, Findings& found);

// The stages.
void can_the_limits_be_reached(const Scene& s, Findings& found);
void is_the_drive_slow(const Scene& s, Findings& found);
void is_the_load_history_slow(const Scene& s, Findings& found);
void is_a_breakout_run_in_real_time(const Scene& s, Findings& found);
void does_the_drive_begin_gently(const Scene& s, Findings& found);
void is_there_time_for_equilibrium(const Scene& s, Findings& found);
void is_the_mass_that_of_a_pipe(const Scene& s, Findings& found);
void is_the_mass_that_of_the_weight(const Scene& s, Findings& found);
void is_damping_small(const Scene& s, Findings& found);
void are_forces_those_of_soil(const Scene& s, Findings& found);
void do_forces_press_down(const Scene& s, Findings& found);

void check_names(const Scene& s, Findings& found);

// Supports that move or give way.
void is_the_motion_resolved(const Scene& s, Findings& found);
void does_the_soil_stay_at_what_moves(const Scene& s, Findings& found);
void do_boundaries_that_absorb_bear_what_comes(const Scene& s, Findings& found);

// The roles of stages.
void check_role_order(const Scene& s, Findings& found);
void are_roles_those_of_what_stages_do(const Scene& s, Findings& found);
void are_weights_those_of_one_pipe(const Scene& s, Findings& found);
void check_result_stage_is_named(const Scene& s, Findings& found);

// The water.
void is_the_soil_as_heavy_as_in_water(const Scene& s, Findings& found);
void does_water_have_time_to_flow(const Scene& s, Findings& found);
void does_the_soil_keep_its_weight(const Scene& s, Findings& found);
void is_the_head_there_when_soil_rests(const Scene& s, Findings& found);

// The line of a pipeline.
void is_the_laid_pipe_as_heavy_as_the_line(const Scene& s, Findings& found);
void is_the_line_laid_by_its_weight(const Scene& s, Findings& found);
void is_the_line_a_pipe(const Scene& s, Findings& found);
void does_the_line_go_beyond_its_slices(const Scene& s, Findings& found);
void does_the_case_fit_the_line_on_springs(const Scene& s, Findings& found);

// The run.
void does_it_take_days(const Scene& s, Findings& found);
void does_it_fit_on_the_disk(const Scene& s, Findings& found);
void is_the_history_fine_enough(const Scene& s, Findings& found);
void is_every_key_used(const Scene& s, Findings& found);

}  // namespace berm::sanity
