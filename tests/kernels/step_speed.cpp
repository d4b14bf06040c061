// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/step_speed.hpp"

#include "core/ranks.hpp"
#include "core/timer.hpp"
#include "io/atomic_file.hpp"
#include "io/scratch_folder.hpp"
#include "kernels/roofline_kernel.hpp"
#include "material/laws.hpp"
#include "mpm/divide.hpp"
#include "mpm/step.hpp"
#include "samples/anisotropic_clay.hpp"
#include "samples/critical_state_soils.hpp"
#include "simulation/memory.hpp"
#include "user_law/loaded_law.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <malloc.h>
#include <nlohmann/json.hpp>
#include <numeric>
#include <omp.h>

namespace berm::bench {
namespace {

using Clock = std::chrono::steady_clock;

material::MohrCoulomb sand(Real density)
{
  material::MohrCoulomb law;
  law.density = density;
  law.young_modulus = 7e6;
  law.poisson_ratio = 0.25;
  law.friction_angle = 35 * degree;
  return law;
}

/// Clay of 20 kPa, which is Tresca's, and the same that softens and knows its rate.
material::MohrCoulomb tresca()
{
  material::MohrCoulomb law = sand(877);
  law.friction_angle = 0;
  law.cohesion = 20e3;
  law.poisson_ratio = 0.49;
  return law;
}

material::Clay clay()
{
  material::Clay law;
  law.density = 877;
  law.young_modulus = tresca().young_modulus;
  law.poisson_ratio = 0.49;
  law.undrained_strength = 20e3;
  law.sensitivity = 3;
  law.ductility = 20;
  law.rate_parameter = 0.1;
  law.reference_rate = 1e-5;
  return law;
}

/// Normally consolidated kaolin under its K0.
material::ModifiedCamClay cam_clay()
{
  material::ModifiedCamClay law;
  law.density = 877;
  law.critical_friction_angle = 23 * degree;
  law.compression_index = 0.2;
  law.swelling_index = 0.04;
  law.void_ratio = 1.2;
  law.poisson_ratio = 0.3;
  law.max_pressure = 2e5;
  return law;
}

/// Medium dense sand.
material::NorSand norsand()
{
  material::NorSand law;
  law.density = 877;
  law.critical_friction_angle = 32 * degree;
  law.critical_void_ratio = 0.9;
  law.critical_line_slope = 0.03;
  law.volumetric_coupling = 0.3;
  law.dilatancy = 3.5;
  law.hardening_modulus = 150;
  law.state_parameter = -0.05;
  law.rigidity = 300;
  law.poisson_ratio = 0.2;
  law.max_pressure = 2e5;
  return law;
}

material::Hypoplastic hypoplastic()
{
  material::Hypoplastic law = sample_hypoplastic();
  law.density = 877;
  law.max_pressure = 2e5;
  return law;
}

/// Medium dense sand.
material::HardeningSoil hardening_soil()
{
  material::HardeningSoil law;
  law.density = 877;
  law.cohesion = 100;
  law.friction_angle = 36 * degree;
  law.dilation_angle = 4 * degree;
  law.secant_modulus = law.oedometer_modulus = 25e6;
  law.unloading_modulus = 75e6;
  law.stiffness_exponent = 0.5;
  law.poisson_ratio = 0.2;
  law.max_pressure = 2e5;
  return law;
}

/// The strength of clay(), in triaxial compression.
material::NgiAdp ngi_adp()
{
  material::NgiAdp law = sample_ngi_adp(0);
  law.density = 877;
  return law;
}

settings::StageSettings endless(settings::StageKind kind)
{
  settings::StageSettings stage;
  stage.name = "bench";
  stage.kind = kind;
  stage.until.time = infinity;
  return stage;
}

/// A circle of 20 mm that is pushed into the centrifuge's bed, with cells of near_size around it.
settings::Case probe_in_sand(Real near_size)
{
  settings::Case c;
  c.gravity = {0, -50 * standard_gravity};
  mesh::SeabedMesh mesh;
  mesh.length = 0.65;
  mesh.depth = 0.14;
  mesh.headroom = 0.03;
  mesh.near_size = near_size;
  mesh.near_left = -0.03;
  mesh.near_right = 0.05;
  mesh.near_depth = 0.02;
  mesh.near_height = 0.012;
  c.mesh = mesh;
  c.material = {{"sand", sand(877)}};
  bodies::BodySettings body;
  body.material = "sand";
  body.regions = {"near", "bed"};
  body.region_particles_per_cell = {{"bed", 4}};
  body.damping = 0.02;
  body.k0 = 0.5;
  c.body = {{"sand", body}};
  bodies::RigidSettings probe;
  probe.shape = bodies::CircleSettings{{0, 0.01}, 0.02};
  c.rigid = {{"probe", probe}};
  contact::ContactSettings contact;
  contact.body = "sand";
  contact.rigid = "probe";
  contact.friction_angle = 23.33 * degree;
  c.contact = {{"skin", contact}};
  c.support = {{"base", {"base", {"x", "y"}}}, {"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}};
  settings::StageSettings push = endless(settings::StageKind::push);
  push.velocity = 0.1;
  c.stage = {push};
  return c;
}

/// The same probe in soil of another law.
settings::Case probe_in(const material::Material& soil)
{
  settings::Case c = probe_in_sand(0.001);
  c.material.front().second = soil;
  return c;
}

/// The same probe in sand that does not dilate, with water that stays in its pores or flows through them.
settings::Case probe_in_water(material::Drainage drainage)
{
  material::MohrCoulomb soil = sand(877);
  soil.inertia_density = 1900;
  soil.dilation_angle = 0;
  soil.water.emplace();
  soil.water->drainage = drainage;
  soil.water->water_depth = 100;
  if (drainage == material::Drainage::consolidation) {
    soil.water->porosity = 0.4;
    soil.water->permeability = 1e-4;
  }
  return probe_in(soil);
}

/// A column of sand that collapses over a rigid floor: all of it moves and yields.
settings::Case column(Real particles)
{
  settings::Case c;
  c.gravity = {0, -standard_gravity};
  // The column, 1 wide and 2 high, is a sixth of a mesh of 6 x 2.
  const Real per_side = std::round(std::sqrt(particles / 9 / 2 / 2));
  mesh::BoxMesh mesh;
  mesh.size = {6, 2.25};
  mesh.cells = {6 * per_side, std::round(2.25 * per_side)};
  c.mesh = mesh;
  c.material = {{"sand", sand(1600)}};
  bodies::BodySettings body;
  body.material = "sand";
  bodies::BlockSettings block;
  block.center = {0.5, 1};
  block.size = {1, 2};
  block.spacing = 1 / per_side / std::sqrt(18.);
  body.block = block;
  c.body = {{"sand", body}};
  bodies::RigidSettings floor;
  floor.shape = bodies::HalfPlaneSettings{{0, 0}, {0, 1}};
  c.rigid = {{"floor", floor}};
  contact::ContactSettings contact;
  contact.body = "sand";
  contact.rigid = "floor";
  contact.friction_angle = 0.5;
  c.contact = {{"floor", contact}};
  c.support = {{"left", {"left", {"x"}}}, {"bottom", {"bottom", {"y"}}}, {"right", {"right", {"x"}}}};
  c.stage = {endless(settings::StageKind::free)};
  return c;
}

/// The same mesh, particles and laws around the axis that the left wall is.
settings::Case around_axis(settings::Case c)
{
  c.geometry = settings::Geometry::axisymmetric;
  return c;
}

/// A ball in the probe's bed around its axis, with a fine zone as large as the probe's.
settings::Case ball_in_sand(Real near_size)
{
  settings::Case c = around_axis(probe_in_sand(near_size));
  auto& mesh = std::get<mesh::SeabedMesh>(c.mesh);
  mesh.left = 0;
  mesh.near_left = 0;
  mesh.near_right = 0.08;
  c.support = {{"base", {"base", {"x", "y"}}}, {"right", {"right", {"x"}}}};
  return c;
}

/// The same in space: 0.5 wide, 1 high, 0.25 deep in a mesh of 1.5 x 1.125 x 0.25, eight particles in each sixth of a cube.
settings::Case column_in_space(Real particles)
{
  settings::Case c = column(particles);
  c.geometry = settings::Geometry::space;
  c.gravity.push_back(0);
  const Real per_side = std::round(std::cbrt(particles / 8 / 6 / (2 * 4 * 1)));  // cubes along the depth, 0.25
  mesh::BoxMesh mesh;
  mesh.size = {1.5, 1.125, 0.25};
  mesh.cells = {6 * per_side, std::round(4.5 * per_side), per_side};
  c.mesh = mesh;
  bodies::BlockSettings block;
  block.center = {0.25, 0.5, 0.125};
  block.size = {0.5, 1, 0.25};
  block.spacing = 0.25 / per_side / std::cbrt(48.);
  c.body[0].second.block = block;
  c.rigid[0].second.shape = bodies::HalfPlaneSettings{{0, 0, 0}, {0, 1, 0}};
  c.support.push_back({"back", {"back", {"z"}}});
  c.support.push_back({"front", {"front", {"z"}}});
  return c;
}

/// Linear elasticity as a law of the user's own: what a call costs beside the same law in the program (elastic_D20).
extern "C" void elastic_umat(double* stress, double*, double* ddsdde, double*, double*, double*, double*, double*, double*, double*,
                             const double*, const double* dstran, const double*, const double*, const double*, const double*, const double*,
                             const double*, const char*, const int*, const int*, const int* ntens, const int*, const double* props,
                             const int*, const double*, const double*, double*, const double*, const double*, const double*, const int*,
                             const int*, const int*, const int*, const int*, const int*, std::size_t)
{
  const double shear = props[0] / (2 * (1 + props[1])), lame = 2 * shear * props[1] / (1 - 2 * props[1]);
  for (int a = 0; a < *ntens; ++a)
    for (int b = 0; b < *ntens; ++b) {
      double& entry = ddsdde[a + *ntens * b];
      entry = (a < 3 && b < 3 ? lame : 0) + (a == b ? (a < 3 ? 2 : 1) * shear : 0);
      stress[a] += entry * dstran[b];
    }
}

settings::Case elastic_probe()
{
  settings::Case c = probe_in_sand(0.001);
  const material::MohrCoulomb law = sand(877);
  material::LinearElastic elastic;
  elastic.density = law.density;
  elastic.young_modulus = law.young_modulus;
  elastic.poisson_ratio = law.poisson_ratio;
  c.material[0].second = elastic;
  return c;
}

settings::Case probe_in_umat()
{
  settings::Case c = elastic_probe();
  const auto& elastic = c.material[0].second.get<material::LinearElastic>();
  material::UserLaw<material::Interface::umat> law;
  law.density = elastic.density;
  law.young_modulus = elastic.young_modulus;
  law.poisson_ratio = elastic.poisson_ratio;
  law.can_yield = false;
  const user_law::Constants constants{"sand", {law.young_modulus, law.poisson_ratio}, 0};
  law.loaded = std::make_shared<user_law::LoadedLaw>(user_law::Umat{elastic_umat}, constants, "the law of umat_D20", false);
  c.material[0].second = law;
  return c;
}

struct BenchProblem {
  const char* name;
  settings::Case (*make)();
};

constexpr BenchProblem problems[] = {
    {"probe_D10", [] { return probe_in_sand(0.002); }},
    {"probe_D20", [] { return probe_in_sand(0.001); }},
    {"probe_D40", [] { return probe_in_sand(0.0005); }},
    {"column_1e5", [] { return column(1e5); }},
    {"tresca_D20", [] { return probe_in(tresca()); }},
    {"clay_D20", [] { return probe_in(clay()); }},
    {"cam_clay_D20", [] { return probe_in(cam_clay()); }},
    {"norsand_D20", [] { return probe_in(norsand()); }},
    {"hypoplastic_D20", [] { return probe_in(hypoplastic()); }},
    {"hardening_soil_D20", [] { return probe_in(hardening_soil()); }},
    {"ngi_adp_D20", [] { return probe_in(ngi_adp()); }},
    {"undrained_D20", [] { return probe_in_water(material::Drainage::undrained); }},
    {"flow_D20", [] { return probe_in_water(material::Drainage::consolidation); }},
    {"elastic_D20", elastic_probe},
    {"umat_D20", probe_in_umat},
    {"column_1e6", [] { return column(1e6); }},
    {"column_1e7", [] { return column(1e7); }},
    {"ball_D20", [] { return ball_in_sand(0.001); }},
    {"column_axis_1e5", [] { return around_axis(column(1e5)); }},
    {"space_1e5", [] { return column_in_space(1e5); }},
    {"space_1e6", [] { return column_in_space(1e6); }},
};

/// What a step must move and compute at least, by count.
struct Demand {
  Real bytes, flops;  ///< a particle-step
};

// About, counted in the code: additions and multiplications of one lane that holds a particle, and of one cell.
constexpr Real flops_of_moments = 44, flops_of_motion = 34, flops_of_stress = 54;  // mpm/moments.cpp; mpm/move_kernel.hpp, elastic
// Of a cell, in the same places.
constexpr Real flops_of_corners = 13, flops_of_forces = 36, flops_of_momentum = 96, flops_of_fields = 128;

/// Bytes: every array once for each pass that reads or writes it; blocks of particles are read and written once, since their moments are summed while they are in
/// the cache. Flops of soil at yield are more, and those in space were not counted.
template <int dim>
Demand demand_of(const bodies::Particles<dim>& particles, const mpm::BodyGrid<dim>& grid)
{
  constexpr Real flops_of_lane = flops_of_moments + flops_of_motion + flops_of_stress;
  constexpr Real flops_of_cell = flops_of_corners + flops_of_forces + flops_of_momentum + flops_of_fields;
  constexpr int corners = dim + 1;
  Real blocks = 0;
  for (const Index cell : particles.occupied()) blocks += std::ceil(static_cast<Real>(particles.count_in(cell)) / lanes);
  const Real cells = static_cast<Real>(particles.occupied().size()), nodes = static_cast<Real>(grid.nodes.size());
  const Real of_block = static_cast<Real>(2 * sizeof(bodies::Block<dim>) + 2 * sizeof(StoredLanes) * particles.extra_size());
  Real of_cell = 4 * sizeof(mpm::Moments<dim>) + 6 * corners * sizeof(mpm::CornerSums<dim>) + 3 * sizeof(mesh::Gradients<dim>) +
                 5 * corners * sizeof(Index) + 4 * sizeof(Real);
  Real of_node = 2 * sizeof(Real) + 6 * sizeof(Vec<dim>);
  if (grid.water.flows()) {
    of_cell +=
        4 * sizeof(mpm::WaterCell) + 2 * corners * sizeof(mpm::WaterAtCorner<dim>) + 2 * sizeof(mpm::VolumeChange) + 2 * sizeof(Real);
    of_node += 2 * sizeof(mpm::WaterAtNode<dim>) + 6 * sizeof(Vec<dim>) + 2 * sizeof(mpm::ImpermeableFlux);
  }
  const Real count = static_cast<Real>(particles.size());
  const Real bytes = (blocks * of_block + cells * of_cell + nodes * of_node) / count;
  return {bytes, dim == 2 ? flops_of_lane + cells * flops_of_cell / count : nan};
}

/// A number for the table, or a dash where there is none.
std::string shown(Real number, int decimals)
{
  return std::isnan(number) ? "-" : fmt::format("{:.{}f}", number, decimals);
}

/// Of what the ranks measure each for themselves at the same time.
Real sum_of_ranks(Real of_rank)
{
  const std::vector<Real> all = Ranks::of_run().all_of(of_rank);
  return std::accumulate(all.begin(), all.end(), Real(0));
}

/// The cells are divided among the ranks while this lives.
template <int dim>
struct Division {
  explicit Division(problem::Problem<dim>& problem) { mpm::divide(problem.model, problem.state); }
  ~Division() { Ranks::of_run().unite(); }
  Division(const Division&) = delete;
  Division& operator=(const Division&) = delete;
};

/// A loop of berm's step, ns a particle-step, and the kernel's loop of that label where it has one.
struct LoopRow {
  std::string label;
  Real time;
  std::optional<Real> of_kernel;
};

/// All of them; the loops without a counterpart are what the physics needs beside.
struct LoopTable {
  std::vector<LoopRow> rows;
  Real shared = 0, of_kernel = 0, beside = 0;  ///< sums: of loops with a counterpart, of these counterparts, of the others

  LoopTable(const std::vector<Timing>& loops, BigIndex particle_steps, const roofline::RooflineRun& kernel, BigIndex particles)
  {
    for (const Timing& loop : loops) {
      LoopRow& row = rows.emplace_back(loop.label, loop.seconds * 1e9 / static_cast<Real>(particle_steps));
      const auto same = std::find_if(kernel.loops.begin(), kernel.loops.end(), [&](const Timing& k) { return k.label == loop.label; });
      if (same != kernel.loops.end()) row.of_kernel = same->seconds * 1e9 / static_cast<Real>(particles * kernel.steps);
      (row.of_kernel ? shared : beside) += row.time;
      of_kernel += row.of_kernel.value_or(0);
    }
  }

  void print() const
  {
    const auto line = [](const std::string& label, Real time, Real of_kernel) {
      fmt::print("    {:<32} {:>8.2f} {:>8}\n", label, time, shown(of_kernel, 2));
    };
    fmt::print("    {:<32} {:>8} {:>8}\n", "ns a particle-step", "step", "kernel");
    for (const LoopRow& row : rows) line(row.label, row.time, row.of_kernel.value_or(nan));
    line("= loops that the kernel has", shared, of_kernel);
    line("= loops that the kernel lacks", beside, nan);
  }
  nlohmann::ordered_json json() const
  {
    auto list = nlohmann::ordered_json::array();
    for (const LoopRow& row : rows) {
      list.push_back({{"label", row.label}, {"ns_per_particle_step", row.time}});
      if (row.of_kernel) list.back()["kernel_ns_per_particle_step"] = *row.of_kernel;
    }
    return list;
  }
};

template <int dim>
nlohmann::ordered_json measure_speed(const char* name, const settings::Case& c, simulation::Context& context, Real bandwidth, Real seconds)
{
  const io::ScratchFolder scratch;
  const Real memory_before = simulation::memory_of_data();
  problem::Problem<dim> problem = problem::build<dim>(c, ".", scratch.path().string());
  const BigIndex particles = problem.state.particles[0].size();
  const Division<dim> division(problem);
  ::malloc_trim(0);  // as a run does
  mpm::Workspace<dim> workspace(problem.model, problem.state);
  Ranks& ranks = Ranks::of_run();
  const auto step_for = [&](Real min, BigIndex min_steps) {
    const Clock::time_point start = Clock::now();
    Real passed = 0;
    constexpr BigIndex steps_of_ranks = 16;  // between two looks at the clock, on which they must agree
    for (BigIndex k = 0; k < min_steps || passed < min; ++k) {
      step(problem.model, problem.state, workspace);
      if (ranks.divided() && k % steps_of_ranks != 0) continue;
      passed = ranks.largest(std::chrono::duration<Real>(Clock::now() - start).count());
    }
    return ranks.divided() ? ranks.largest(std::chrono::duration<Real>(Clock::now() - start).count()) : passed;
  };
  step_for(seconds / 6, 16);  // warm-up
  context.timings().clear();
  const BigIndex before = problem.state.step;
  const auto traffic = [&] { return ranks.divided() ? ranks.messenger()->traffic() : Traffic(); };
  const Traffic traffic_before = traffic();
  const Real wall = step_for(seconds, 32);
  const BigIndex steps = problem.state.step - before;
  const Real speed = static_cast<Real>(particles * steps) / wall;
  const Traffic traffic_after = traffic();
  const Real memory = sum_of_ranks(simulation::memory_of_data() - memory_before) / static_cast<Real>(particles);

  const bodies::Particles<dim>& body = problem.state.particles[0];
  const std::vector<Timing> loops = context.timings().table();
  const auto run_kernel = [&] { return roofline::run_roofline_kernel(problem.model.mesh, body, seconds / 3); };
  const auto speed_of = [](const roofline::RooflineRun& run) { return sum_of_ranks(run.particle_steps_per_s()); };
  const roofline::RooflineRun kernel = run_kernel();
  const Real kernel_speed = speed_of(kernel);
  const auto all_of = [](BigIndex of_rank) { return sum_of_ranks(static_cast<Real>(of_rank)); };
  const LoopTable table(loops, particles * steps, kernel, particles);
  const Real ceiling = 1e9 / (1e9 / speed - table.shared + table.of_kernel);  // loops of the kernel as fast as there
  const Demand demand = demand_of(body, workspace.grids[0]);

  fmt::print("{:<12} {:>10} {:>9} {:>7} {:>8} {:>9.2f} {:>9} {:>8} {:>8} {:>6.0f} {:>6} {:>9.2f} {:>9.0f}\n", name, particles,
             problem.model.mesh.cell_count(), steps,
             ranks.count() == 1 ? fmt::format("{}", context.threads()) : fmt::format("{}x{}", ranks.count(), context.threads()),
             speed / 1e6, shown(kernel_speed / 1e6, 1), shown(speed / kernel_speed, 2), shown(speed / ceiling, 2), demand.bytes,
             shown(demand.flops, 0), speed * demand.bytes / bandwidth, memory);
  table.print();
  nlohmann::ordered_json result = {{"name", name},
                                   {"particles", particles},
                                   {"cells", problem.model.mesh.cell_count()},
                                   {"steps", steps},
                                   {"ranks", ranks.count()},
                                   {"threads", context.threads()},
                                   {"wall_s", wall},
                                   {"particle_steps_per_s", speed},
                                   {"particles_per_occupied_cell", all_of(kernel.particles) / all_of(kernel.cells)},
                                   {"lanes_per_particle", all_of(kernel.lanes) / all_of(kernel.particles)},
                                   {"kernel_particle_steps_per_s", kernel_speed},
                                   {"share_of_kernel", speed / kernel_speed},
                                   {"ceiling_particle_steps_per_s", ceiling},
                                   {"share_of_ceiling", speed / ceiling},
                                   {"bytes_per_particle_step", demand.bytes},
                                   {"flops_per_particle_step", demand.flops},
                                   {"share_of_bandwidth", speed * demand.bytes / bandwidth},
                                   {"memory_bytes_per_particle", memory},
                                   {"loops", table.json()}};
  if (ranks.count() == 1) {
    if (context.threads() == 1) return result;
    omp_set_num_threads(1);
    const BigIndex first = problem.state.step;
    const Real wall_alone = step_for(seconds, 32);
    const Real alone = static_cast<Real>(particles * (problem.state.step - first)) / wall_alone, kernel_alone = speed_of(run_kernel());
    omp_set_num_threads(context.threads());
    fmt::print("    {} threads are {:.2f} times as fast as one, those of the bare kernel {:.2f} times\n", context.threads(), speed / alone,
               kernel_speed / kernel_alone);
    result["over_one_thread"] = speed / alone;
    result["kernel_over_one_thread"] = kernel_speed / kernel_alone;
    return result;
  }
  const auto of_rank = [&](auto Traffic::*part) {
    return sum_of_ranks(static_cast<Real>(traffic_after.*part - traffic_before.*part)) / ranks.count();
  };
  const auto of_step = [&](auto Traffic::*part) { return of_rank(part) / static_cast<Real>(steps); };
  const Real in_messages = of_rank(&Traffic::seconds) * 1e9 / static_cast<Real>(particles * steps);
  const Real letters = of_step(&Traffic::letters), letter_bytes = of_step(&Traffic::letter_bytes);
  const Real gathers = of_step(&Traffic::gathers), gathered_bytes = of_step(&Traffic::gathered_bytes);
  fmt::print(
      "    a rank and step: {:.1f} messages to others, of {:.1f} KiB in all; {:.1f} in which all tell all, {:.1f} KiB in all; {:.2f} ns a "
      "particle-step in the loops above\n",
      letters, letter_bytes / 1024, gathers, gathered_bytes / 1024, in_messages);
  result["message_ns_per_particle_step"] = in_messages;
  result["messages_per_step"] = letters;
  result["message_bytes_per_step"] = letter_bytes;
  result["gathers_per_step"] = gathers;
  result["gathered_bytes_per_step"] = gathered_bytes;
  return result;
}

}  // namespace

std::vector<std::string> problem_names()
{
  std::vector<std::string> names;
  for (const BenchProblem& problem : problems) names.emplace_back(problem.name);
  return names;
}

void measure_steps(const std::vector<std::string>& names, const std::string& json_file, simulation::Context& context, Real seconds)
{
  constexpr BigIndex triad_bytes = 300'000'000;
  const Real bandwidth = sum_of_ranks(roofline::triad_bandwidth(triad_bytes, seconds / 6));
  fmt::print(
      "triad bandwidth {:.1f} GB/s; kernel: the bare passes of a step over the same particles in the same cells; ceiling: a step whose "
      "loops are as fast as those of the kernel, where it has them\n",
      bandwidth / 1e9);
  fmt::print("{:<12} {:>10} {:>9} {:>7} {:>8} {:>9} {:>9} {:>8} {:>8} {:>6} {:>6} {:>9} {:>9}\n", "", "", "", "", "", "10^6", "kernel,",
             "share of", "share of", "", "", "share of", "memory,");
  fmt::print("{:<12} {:>10} {:>9} {:>7} {:>8} {:>9} {:>9} {:>8} {:>8} {:>6} {:>6} {:>9} {:>9}\n", "problem", "particles", "cells", "steps",
             "threads", "p-steps/s", "10^6", "kernel", "ceiling", "bytes", "flops", "bandwidth", "B/particle");
  nlohmann::ordered_json table = {
      {"version", BERM_VERSION}, {"triad_bytes_per_s", bandwidth}, {"problems", nlohmann::ordered_json::array()}};
  for (const BenchProblem& problem : problems) {
    if (!names.empty() && std::find(names.begin(), names.end(), problem.name) == names.end()) continue;
    const settings::Case c = problem.make();
    table["problems"].push_back(c.dimension() == 2 ? measure_speed<2>(problem.name, c, context, bandwidth, seconds)
                                                   : measure_speed<3>(problem.name, c, context, bandwidth, seconds));
  }
  if (!json_file.empty() && Ranks::of_run().is_first()) io::write_atomically(json_file, table.dump(2) + "\n");
}

}  // namespace berm::bench
