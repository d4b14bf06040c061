// SPDX-License-Identifier: BSD-3-Clause
#include "envelope/envelope_table.hpp"
#include "samples/clay_footing.hpp"
#include "samples/clay_pipe.hpp"
#include "samples/history_columns.hpp"
#include "samples/program.hpp"
#include "samples/refused_probes.hpp"
#include "structures/structures.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::envelope::this_file {
namespace {

using test::refusal_of;

void expect_refusal(const settings::Case& c, const char* part, const EnvelopeSettings& how = {})
{
  const std::string refusal = refusal_of(c, how);
  EXPECT_NE(refusal.find(part), std::string::npos) << refusal;
}

/// How the middle of the base of the sample footing goes, 0.25 m below its centre: w, u and theta D over the speed.
struct BaseMotion {
  Real w, u, turn;
};

BaseMotion base_motion(const settings::StageSettings& stage)
{
  constexpr Real speed = 0.1, D = 1, arm = 0.25;
  if (stage.kind == settings::StageKind::push) return {*stage.velocity / speed, 0, 0};
  if (stage.kind == settings::StageKind::drag) return {stage.vertical_velocity.value_or(0) / speed, *stage.velocity / speed, 0};
  const settings::TurnSettings& rotation = stage.drive.rotation.velocity ? stage.drive.rotation : stage.drive.rotation_z;
  const Real theta = -rotation.velocity.value_or(0);
  return {-stage.drive.y.velocity.value_or(0) / speed, (stage.drive.x.velocity.value_or(0) - arm * theta) / speed, theta * D / speed};
}

TEST(FootingProbes, go_down_towards_sideways_turn_and_swipe)
{
  std::vector<std::string> names;
  for (const Probe& probe : choose_probes(footing(), {.directions = 3, .turns = 5})) names.push_back(probe.name);
  EXPECT_EQ(names, (std::vector<std::string>{"down", "direction_60", "direction_30", "swipe", "turn_60", "turn_40", "turn_20", "turn_0",
                                             "turn_-20", "swipe_turn", "swipe_30", "swipe_60", "swipe_90", "swipe_120", "swipe_150"}));
  EXPECT_EQ(choose_probes(footing(), {.directions = 3, .turns = 0}).size(), 4u);
  EXPECT_EQ(choose_probes(footing(), {}).size(), 10u + 1 + 5 + 1 + 5) << "turns of their own accord";
}

TEST(FootingProbes, move_the_middle_of_the_base_in_their_direction_at_the_speed_of_the_case)
{
  for (const settings::Case& c : {footing(), footing_in_space()})
    for (const Probe& probe : choose_probes(c, {.directions = 3})) {
      const BaseMotion moves = base_motion(probe.settings.stage.back());
      const Real a = probe.kind == ProbeKind::swipe ? 0 : probe.angle * pi / 180, b = probe.turn * pi / 180;
      EXPECT_NEAR(moves.w, std::sin(a), 1e-12) << probe.name;
      EXPECT_NEAR(moves.turn, std::cos(a) * std::sin(b), 1e-12) << probe.name;
      EXPECT_EQ(probe.settings.stage.back().drive.x.free, probe.free_sideways) << probe.name;
      if (!probe.free_sideways) {
        EXPECT_NEAR(moves.u, std::cos(a) * std::cos(b), 1e-12) << probe.name;
      }
      EXPECT_NEAR(*probe.settings.stage.back().until.time, 1, 1e-12);  // 0.1 D at 0.1 m/s
      ASSERT_EQ(probe.settings.stage.size(), probe.kind == ProbeKind::swipe ? 2u : 1u) << probe.name;
      if (probe.kind == ProbeKind::swipe) {
        EXPECT_EQ(base_motion(probe.settings.stage[0]).w, 1) << "a swipe pushes first";
      }
    }
}

TEST(FootingProbes, turn_a_footing_of_finite_elements_without_mass_and_ask_for_one_where_there_is_inertia)
{
  EXPECT_GT(choose_probes(footing(), {})[0].settings.rigid[0].second.mass, 0);
  expect_refusal(footing_in_space({"rigid.footing.mass=0"}), "rigid.footing.mass: is needed");
  EXPECT_EQ(refusal_of(footing_in_space()), "");
}

TEST(FootingProbes, are_refused_where_the_geometry_the_symmetry_or_the_body_allow_no_rotation)
{
  EXPECT_EQ(refusal_of(footing()), "");
  settings::Case around = footing();
  around.geometry = settings::Geometry::axisymmetric;
  expect_refusal(around, "geometry: around an axis");
  expect_refusal(around, "\"space\"");
  settings::Case quarter = footing_in_space();
  quarter.symmetry = {"x", "z"};
  expect_refusal(quarter, "symmetry = [\"z\"]");
  expect_refusal(clay(), "a pipe has no moments", {.turns = 3});
  expect_refusal(footing({"rigid.footing.center=[-2.2, 0.25]"}), "beyond a wall");
  expect_refusal(footing({"rigid.footing.center=[0, 0.35]"}), "lies 0.1 m above the bed");
  expect_refusal(footing({"rigid.footing.angle=\"5 deg\""}), "flat, level base");
  expect_refusal(footing({"gravity=[\"-10 m/s^2\", 0]"}), "gravity along -y");
}

run_folder::History history_of(const std::vector<Real>& u, const std::vector<Real>& w, const std::vector<Real>& angle,
                               const std::vector<Real>& V, const std::vector<Real>& H, const std::vector<Real>& M)
{
  run_folder::History history;
  history.columns = columns_named({"u_m", "w_m", "angle_rad", "V_N_m", "H_N_m", "M_Nm_m"});
  history.values = {u, w, angle, V, H, M};
  history.stage.assign(u.size(), "probe");
  history.stage[0] = "rest";
  return history;
}

TEST(FootingTable, takes_moments_about_the_middle_of_the_base_and_its_own_travel)
{
  // Clockwise by 0.02 about a base that stays: the centre, 0.25 m above it, goes to the right, and the right corner is the lowest.
  const Real theta = 0.02, moved = 0.25 * std::sin(theta), lowered = 0.5 * std::sin(theta);
  const Real end = 5 + 0.25 * (4 * std::cos(theta) + 8 * std::sin(theta));
  const Real halfway = end / 2 - 0.25 * (2 * std::cos(theta / 2) + 9 * std::sin(theta / 2));  // so that M about the base is a straight line
  const run_folder::History history =
      history_of({0, moved / 2, moved}, {0, lowered / 2, lowered}, {0, -theta / 2, -theta}, {10, 9, 8}, {0, 2, 4}, {0, halfway, 5});
  Probe probe{"probe", ProbeKind::direction, 0, {}, "probe", 90, false};
  probe.settings.method = settings::Method::fem;
  const ProbeResult small = result_of(probe, history, {1, 0, 0.25});
  EXPECT_NEAR(small.end.M, 5 + 4 * 0.25, 1e-12) << "small strain keeps the arms";
  EXPECT_NEAR(small.end.w, 0, 1e-12);
  EXPECT_NEAR(small.growth, 1 - (halfway + 2 * 0.25 + 6) / 2 / 6, 1e-3) << "between the last two rows, whose travel is theta D";
  probe.settings.method = settings::Method::mpm;
  EXPECT_NEAR(result_of(probe, history, {1, 0, 0.25}).end.M, end, 1e-3) << "the travel is not quite even";
}

/// Loads of the material point method are averaged over 0.4 mm here, and 20 N/m act at the start.
TEST(FootingTable, takes_the_first_motion_from_rows_as_they_are)
{
  constexpr Real k = 2e6, yields_at = 1e-4, V_start = 20;
  std::vector<Real> w, V;
  for (int row = 0; row <= 400; ++row) w.push_back(5e-5 * row / 5), V.push_back(V_start + k * std::min(w.back(), yields_at));
  const std::vector<Real> none(w.size(), 0);
  Probe probe{"down", ProbeKind::direction, 90, {}, "probe"};
  probe.settings.method = settings::Method::mpm;
  const ProbeResult result = result_of(probe, history_of(none, w, none, V, none, none), {1, 0, 0.25});
  ASSERT_TRUE(result.first);
  EXPECT_NEAR(result.first->load.V, k * result.first->w, 1e-9 * k);
  EXPECT_LT(result.first->w, 0.3 * yields_at);
  EXPECT_EQ(result.first->u, 0);
}

EnvelopeRow row_of(const Probe& probe, EnvelopePoint end, std::vector<EnvelopePoint> path = {})
{
  return {probe, "finished", {end, 0, nan, nan, std::move(path)}};
}

TEST(FootingTable, keeps_largest_loads_of_sideways_and_turning_probes_apart)
{
  const Probe down{"down", ProbeKind::direction, 90, {}, ""}, swipe{"swipe", ProbeKind::swipe, nan, {}, ""},
      turn{"turn_0", ProbeKind::direction, 0, {}, "", 90, true}, both{"swipe_30", ProbeKind::swipe, nan, {}, "", 30, false};
  const std::vector<EnvelopeRow> rows = {row_of(down, {8, 0, 0, 0}), row_of(swipe, {4, 2, 0, 0}), row_of(turn, {3, 0, 0, 1}),
                                         row_of(both, {2, 3, 0, 1.5}, {{8, 0, 0, 0}, {6, 1, 0, 0.5}, {2, 3, 0, 1.5}})};
  const EnvelopeExtremes extremes = extremes_of(rows);
  EXPECT_EQ(extremes.V_max, 8);
  EXPECT_EQ(extremes.H_max, 2) << "without rotation";
  EXPECT_EQ(extremes.M_max, 1) << "without H";
  EXPECT_EQ(extremes.V_at_M_max, 3);
  EXPECT_EQ(extremes.M_largest, 1.5);
  EXPECT_EQ(extremes.H_at_M_largest, 3);
  const std::vector<EnvelopePoint> section = section_at(4, rows);
  ASSERT_EQ(section.size(), 1u) << "the other has no path";
  EXPECT_EQ(section[0].H, 2);
  EXPECT_EQ(section[0].M, 1);
  const std::string csv = envelope_csv(rows, true);
  EXPECT_TRUE(csv.starts_with("probe,kind,angle_deg,V_N_m,H_N_m,V_over_Vmax,H_over_Hmax,w_m,growth,unbalance,overstress,state,turn_deg,"
                              "free_sideways,M_Nm_m,M_over_Mmax\n"))
      << csv;
  EXPECT_NE(csv.find("\nturn_0,direction,0,3,0,0.375,0,0,0,,,finished,90,1,1,1\n"), std::string::npos) << csv;
  EXPECT_TRUE(envelope_csv(rows, true, 3).starts_with("probe,kind,angle_deg,V_N,H_N,"));
}

TEST(FootingFormulas, are_those_of_a_strip_on_uniform_clay_and_say_where_they_do_not_hold)
{
  const auto published = [](const settings::Case& c) { return structures::structure_of(c).published_envelope(c, {{}, {}, nan}); };
  const auto number = [](const base::PublishedEnvelope& envelope, const std::string& name) {
    for (const base::PublishedNumber& known : envelope.numbers)
      if (known.name == name) return known.formula;
    return formulas::Formula{nan, {}, false};
  };
  const base::PublishedEnvelope tied = published(footing());
  EXPECT_EQ(tied.unit, 10e3);
  EXPECT_NEAR(number(tied, "V_max").value, (2 + pi) * 10e3, 1e-6);
  EXPECT_NEAR(number(tied, "H_max").value, 10e3, 1e-6);
  EXPECT_NEAR(number(tied, "M_max_arc").value, 6.90e3, 5);
  EXPECT_TRUE(number(tied, "M_max_arc").valid);
  // Green's curve ends at Vmax, begins where the base slides at any V, and has its corner at half of it.
  const base::PublishedCurve& green = tied.curves.front();
  EXPECT_NEAR(green.V.back(), (2 + pi) * 10e3, 1e-6);
  EXPECT_NEAR(green.H.back(), 0, 1e-6);
  EXPECT_NEAR(green.V[1], (1 + pi / 2) * 10e3, 1e-6);
  EXPECT_EQ(green.V[0], 0);
  EXPECT_NEAR(green.H[0], 10e3, 1e-6);

  const base::PublishedEnvelope half = published(footing({"contact.base.scheme=musl_coupled", "contact.base.adhesion=5e3"}));
  EXPECT_NEAR(number(half, "H_max").value, 5e3, 1e-6);
  EXPECT_TRUE(std::isnan(number(half, "M_max_arc").value)) << "it parts from the clay";
  EXPECT_FALSE(number(published(footing({"rigid.footing.center=[0, 0.05]"})), "V_max").valid) << "0.2 m deep";
  const base::PublishedEnvelope square = published(footing_in_space());
  EXPECT_EQ(square.unit, 10e3);
  EXPECT_TRUE(std::isnan(number(square, "V_max").value));
  EXPECT_NEAR(number(square, "H_max").value, 10e3, 1e-6);
  EXPECT_NE(published(footing({"material.clay.cohesion_gradient=10e3"})).remark, "");
}

/// The curve of a code with this beginning of its title.
const base::PublishedCurve& code_curve(const base::PublishedEnvelope& envelope, const std::string& begin)
{
  for (const base::PublishedCurve& curve : envelope.curves)
    if (curve.of_code && curve.title.starts_with(begin)) return curve;
  throw std::runtime_error("no curve " + begin);
}

TEST(FootingFormulas, have_the_surface_of_the_code_in_all_three_planes)
{
  const auto published = [](const settings::Case& c) { return structures::structure_of(c).published_envelope(c, {{}, {}, nan}); };
  const base::PublishedEnvelope strip = published(footing());  // B = 1 m, s_u = 10 kPa
  const base::PublishedCurve &VH = code_curve(strip, "ISO 19901-4 ["), &VM = code_curve(strip, "ISO 19901-4, effective"),
                             &HM = code_curve(strip, "ISO 19901-4, V = 0.5");
  EXPECT_NEAR(VH.V.front(), 5.14 * 10e3, 1e-6);
  EXPECT_NEAR(VH.V[VH.V.size() - 2], 0.5 * 5.14 * 10e3, 1e-6) << "where it slides";
  EXPECT_NEAR(VH.H.back(), 10e3, 1e-6);
  EXPECT_EQ(VH.V.back(), 0);
  // M = V (1 - V/V_max) B/2: largest at half of V_max.
  EXPECT_NEAR(*std::ranges::max_element(VM.M), 5.14 * 10e3 / 8, 1e-6);
  EXPECT_NEAR(VM.M.back(), 0, 1e-9);
  // At V = V_max/2 without H e = B/4; it slides at H = s_u B.
  EXPECT_NEAR(*std::ranges::max_element(HM.M), 0.5 * 5.14 * 10e3 / 4, 1);
  EXPECT_NEAR(HM.H.back(), 10e3, 1);
  EXPECT_NEAR(HM.M.back(), 0, 1);
  // On a square of 1 m V_max is 1.18 times that.
  const base::PublishedEnvelope square = published(footing_in_space());
  EXPECT_NEAR(code_curve(square, "ISO 19901-4 [").V.front(), 1.18 * 5.14 * 10e3, 1e-6);
  // 0.2 m deep: d_c = 0.3 atan 0.2, and passive and active resistance of 4 s_u z.
  const base::PublishedCurve deep = code_curve(published(footing({"rigid.footing.center=[0, 0.05]"})), "ISO 19901-4 [");
  EXPECT_NEAR(deep.H.back(), 10e3 + 4 * 10e3 * 0.2, 1e-6);
  EXPECT_NEAR(deep.V.front(), (1 + 0.3 * std::atan(0.2)) * 5.14 * 10e3, 10) << "the clay of the sample has no weight to speak of";
}

/// The base carries as much shear as the clay and parts from it. Elements of B/20 at the base widen it by a part d: wip_footing has 1.3 % with B/50 at a smooth edge, to first order, and a
/// rough one has two jumps of the stress there: 8 % at most. V grows with 1 + d, M with its square. H is that of the interface, within Newton's tolerance.
TEST(FootingEnvelope, of_a_rough_strip_on_clay_is_that_of_Green_and_above_that_on_its_effective_width)
{
  const TemporaryFolder folder;
  folder.write("footing.toml", coarse_footing);
  const Ended ended = run_program(folder.path(),
                                  {"envelope", "footing.toml", "-o", "found", "--points", "2", "--turns", "1", "--threads", "2", "--travel",
                                   "0.05", "--set", "contact.base.scheme=musl_coupled", "--set", "contact.base.adhesion=10e3"},
                                  {with_pictures()});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const auto summary = nlohmann::json::parse(text_of_file(folder / "found/summary.json"));
  const auto value = [&](const char* name) { return summary["quantities"][name]["value"].get<Real>(); };
  constexpr Real wider = 1.08;
  EXPECT_GT(value("V_max_over_unit"), 0.995 * (2 + pi));
  EXPECT_LT(value("V_max_over_unit"), wider * (2 + pi));
  EXPECT_NEAR(value("H_max_over_unit"), 1, 0.005);
  EXPECT_GT(value("M_max_over_unit_D"), (2 + pi) / 8);
  EXPECT_LT(value("M_max_over_unit_D"), wider * wider * (2 + pi) / 8);
  for (const char* file : {"envelope.png", "moments.png", "sections.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / "found" / file)) << file;
  EXPECT_NE(ended.err.find("no macro-element of the footing: no probe rotates it while both its edges move down"), std::string::npos)
      << ended.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "found/redwin.txt"));
}

}  // namespace
}  // namespace berm::envelope::this_file
