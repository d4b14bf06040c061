// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/sanity.hpp"

#include "sanity/questions.hpp"
#include "settings/drainage.hpp"
#include "settings/stage.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

/// All questions, in the order in which their answers are shown.
constexpr void (*questions[])(const Scene&, Findings&) = {does_gravity_point_down,
                                                          are_numbers_usual,
                                                          is_the_mesh_in_metres,
                                                          are_coordinates_resolved,
                                                          is_the_mesh_what_its_file_says,
                                                          does_the_driven_body_touch_soil,
                                                          does_a_pushed_pipe_begin_at_the_surface,
                                                          is_the_body_smaller_than_the_mesh,
                                                          do_bodies_at_each_other_touch,
                                                          do_rigid_bodies_pass_through_each_other,
                                                          can_the_limits_be_reached,
                                                          do_motions_fit_a_half,
                                                          does_the_path_stay_in_the_mesh,
                                                          is_the_surface_where_the_bed_ends,
                                                          is_the_bed_held,
                                                          does_the_path_stay_on_fine_cells,
                                                          are_cells_small_enough,
                                                          is_the_body_two_cells_thick,
                                                          are_depth_slices_thicker_than_cells,
                                                          do_slices_slide_without_jolts,
                                                          do_fine_cells_reach_the_ends,
                                                          do_walls_cut_a_body,
                                                          are_walls_far_enough,
                                                          is_the_wall_beyond_the_plastic_zone,
                                                          does_soil_fill_the_bed,
                                                          is_there_soil_at_a_watch,
                                                          does_the_ground_stand,
                                                          do_excavations_stand,
                                                          does_the_body_fit_the_ground,
                                                          do_excavations_find_soil,
                                                          do_fills_lie_in_the_mesh,
                                                          do_bodies_fit_into_trenches,
                                                          are_earthworks_done_while_the_body_rests,
                                                          do_loads_keep_their_soil,
                                                          is_the_soil_a_soil,
                                                          do_cells_resolve_the_random_soil,
                                                          is_the_soil_as_heavy_as_in_water,
                                                          is_the_strength_by_stress_that_of_clay,
                                                          does_the_strength_grow_as_that_of_clay,
                                                          is_the_stiffness_that_of_soil,
                                                          is_the_strain_rate_smooth,
                                                          is_softening_free_of_the_cells,
                                                          are_bands_as_wide_as_the_soil_makes_them,
                                                          what_inertia_do_layers_get,
                                                          is_all_soil_used,
                                                          does_the_soil_bear_its_initial_stress,
                                                          does_pressure_shake_the_clay,
                                                          is_the_interface_weaker_than_the_soil,
                                                          is_tension_that_of_clay,
                                                          may_the_sand_rest,
                                                          do_tractions_press,
                                                          is_the_drive_slow,
                                                          is_the_load_history_slow,
                                                          is_a_breakout_run_in_real_time,
                                                          does_the_drive_begin_gently,
                                                          is_there_time_for_equilibrium,
                                                          is_the_mass_that_of_a_pipe,
                                                          is_the_mass_that_of_the_weight,
                                                          is_damping_small,
                                                          are_forces_those_of_soil,
                                                          do_forces_press_down,
                                                          is_the_motion_resolved,
                                                          does_the_soil_stay_at_what_moves,
                                                          do_boundaries_that_absorb_bear_what_comes,
                                                          check_names,
                                                          check_role_order,
                                                          are_roles_those_of_what_stages_do,
                                                          are_weights_those_of_one_pipe,
                                                          check_result_stage_is_named,
                                                          does_water_have_time_to_flow,
                                                          does_the_soil_keep_its_weight,
                                                          is_the_head_there_when_soil_rests,
                                                          is_the_laid_pipe_as_heavy_as_the_line,
                                                          is_the_line_laid_by_its_weight,
                                                          is_the_line_a_pipe,
                                                          does_the_line_go_beyond_its_slices,
                                                          does_the_case_fit_the_line_on_springs,
                                                          does_it_take_days,
                                                          does_it_fit_on_the_disk,
                                                          is_the_history_fine_enough,
                                                          is_every_key_used};

}  // namespace

std::vector<Finding> ask(const Scene& scene)
{
  Findings found;
  for (const auto question : questions) question(scene, found);
  std::vector<Finding> all;
  const auto place_of = [&](const Finding& one) { return scene.places.located(one.key, one.message).text(); };
  for (const Finding& one : found.all())  // drags of one sweep have their keys from one place
    if (std::none_of(all.begin(), all.end(), [&](const Finding& other) { return place_of(other) == place_of(one); })) all.push_back(one);
  std::stable_partition(all.begin(), all.end(), [](const Finding& f) { return f.severity == Severity::refuse; });
  return all;
}

Real disk_of(const Scene& s)
{
  constexpr Real bytes_of_row = 400;
  Real frames = 1;
  for (std::size_t k = 0; k < s.stages.size(); ++k) {
    const Real time = expected_time(s.stages[k]);
    frames += 1;
    if (s.c.output.frame_time) frames += std::floor(time / *s.c.output.frame_time);
    Real travel = 0;
    for (const Move& move : s.ways[k].axis) travel += (move.end - move.begin) * (move.end - move.begin);
    if (s.c.output.frame_travel) frames += std::floor(std::sqrt(travel) / *s.c.output.frame_travel);
  }
  const Real rows = s.c.output.history_time ? expected_time(s.stages) / *s.c.output.history_time : 1000;
  return frames * s.cost.frame_bytes + rows * bytes_of_row;
}

std::string words_of_bytes(Real bytes)
{
  return bytes >= 1e9 ? fmt::format("{:.1f} GB", bytes / 1e9) : fmt::format("{:.0f} MB", std::ceil(bytes / 1e6));
}

std::string words_of(Real value, const char* unit)
{
  const bool small = std::abs(value) < 0.1 && value != 0;
  if (small && (std::string(unit) == "m" || std::string(unit) == "s" || std::string(unit) == "m/s"))
    return fmt::format("{:.3g} m{}", 1000 * value, unit);
  return fmt::format("{:.3g} {}", value, unit);
}

std::string place_words(Real metres)
{
  const bool far = std::abs(metres) >= 1000;
  return fmt::format("{:.{}g} m", metres, far ? 4 + static_cast<int>(std::log10(std::abs(metres))) : 4);
}

std::string stage_key(std::size_t stage, const std::string& key)
{
  return fmt::format("stage[{}]{}{}", stage, key.empty() ? "" : ".", key);
}

Real rounded_down(Real value)
{
  const Real ten = std::pow(10, std::floor(std::log10(value) + 1e-12));
  return std::floor(value / ten + 1e-9) * ten;
}

Real rounded_up(Real value)
{
  const Real ten = std::pow(10, std::floor(std::log10(value) + 1e-12));
  return std::ceil(value / ten - 1e-9) * ten;
}

Real unit_weight_of(const Scene& s, Index body)
{
  return density(s.material_of(body)) * s.gravity;
}

std::optional<Real> strength_at_depth_of(const Scene& s, Index body, Real width)
{
  return settings::strength_under(s.material_at(body, width), width, s.weight_above(body, width));
}

std::string strength_key(const material::Material& material)
{
  const std::vector<FieldInfo> own = local_fields(material);
  return own.size() > 1 ? own.front().name : "cohesion";
}

bool is_by_force(const settings::StageSettings& stage)
{
  using settings::StageKind;
  const settings::DriveSettings& d = stage.drive;
  if (stage.loads.has_force()) return true;
  if (stage.kind == StageKind::drive) return d.x.force || d.y.force || d.z.force || d.x.hold || d.y.hold || d.z.hold;
  const bool holds = stage.kind == StageKind::drag && stage.vertical == settings::Vertical::hold && !stage.vertical_velocity;
  return drives(stage.kind) && (stage.force || holds);
}

}  // namespace berm::sanity
