// SPDX-License-Identifier: BSD-3-Clause
#include "structures/pipe/published.hpp"

#include "formulas/pipe_in_clay.hpp"

#include "samples/made_run.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::pipe::this_file {
namespace {

using Kind = ComparedState::Kind;

const ComparedState* state_at(const PublishedValues& values, Kind kind, Real travel)
{
  const auto found = std::find_if(values.states.begin(), values.states.end(), [&](const ComparedState& state) {
    return state.kind == kind && std::abs((kind == Kind::drag || kind == Kind::peak ? state.u : state.w) - travel) < 1e-6;
  });
  return found == values.states.end() ? nullptr : &*found;
}

/// The first comparison with a source whose name begins so and whose remark holds `about`.
const Comparison* by(const ComparedState* state, const std::string& work, const std::string& about = "")
{
  if (state == nullptr) return nullptr;
  for (const Comparison& c : state->comparisons)
    if (std::string(c.published.source.work).starts_with(work) && c.about.find(about) != std::string::npos) return &c;
  return nullptr;
}

bool says(const PublishedValues& values, const std::string& words)
{
  return std::any_of(values.remarks.begin(), values.remarks.end(),
                     [&](const std::string& remark) { return remark.find(words) != std::string::npos; });
}

constexpr const char* characteristics = "characteristics, associated flow, table";
constexpr const char* merifield = "Merifield, White and Randolph 2008";

TEST(published, formulas_are_out_of_their_range_on_ground_that_is_not_level)
{
  record::RunRecord run = MadeRun{}.record();
  const PublishedValues level = published_beside(driven::DrivenRun(run));
  run.ground.line.corners = {Vec<2>(-0.3, -0.03), Vec<2>(0.3, 0.03)};
  const PublishedValues sloping = published_beside(driven::DrivenRun(run));
  EXPECT_FALSE(says(level, "level bed"));
  EXPECT_TRUE(says(sloping, "All formulas here are for a level bed."));
  EXPECT_TRUE(says(sloping, "rises and falls by 0.4 D")) << "4 D times the slope of a tenth";
  ASSERT_FALSE(sloping.states.empty());
  ASSERT_EQ(sloping.states.size(), level.states.size());
  int valid = 0;
  for (std::size_t k = 0; k < level.states.size(); ++k)
    for (std::size_t n = 0; n < level.states[k].comparisons.size(); ++n) {
      valid += level.states[k].comparisons[n].published.valid;
      EXPECT_FALSE(sloping.states[k].comparisons[n].published.valid);
      EXPECT_EQ(sloping.states[k].comparisons[n].published.source.range, std::string("a level bed"));
    }
  EXPECT_GT(valid, 0);
}

TEST(published, a_push_into_sand_stands_beside_what_carries_it)
{
  const PublishedValues values = published_beside(driven::DrivenRun(MadeRun{}.record()));
  const ComparedState* state = state_at(values, Kind::end_of_push, 0.002);
  const Comparison* exact = by(state, characteristics);
  ASSERT_NE(exact, nullptr);
  EXPECT_NEAR(exact->berm, 800, 1e-6);
  EXPECT_NEAR(exact->published.value, 5.915 * 430e3 * 4e-4, 1e-3);
  EXPECT_NEAR(exact->ratio(), 800 / (5.915 * 172), 1e-6);
  EXPECT_TRUE(exact->published.valid);
  const Comparison* embedment = by(state, "Verley and Sotberg 1994");
  ASSERT_NE(embedment, nullptr);
  EXPECT_EQ(embedment->unit, Comparison::Unit::length);
  EXPECT_NEAR(embedment->berm, 0.002, 1e-9);
  EXPECT_NEAR(embedment->published.value, 0.02 * 0.037 * std::pow(800 / 172., 2. / 3), 1e-9);
  EXPECT_NE(by(state, "DNVGL-RP-F114 (2019)", "Vesic"), nullptr);
  EXPECT_EQ(state_at(values, Kind::push, 0.002), nullptr);  // the same point once more
}

TEST(published, a_drag_through_sand_is_compared_where_H_is_largest_with_the_w_and_V_that_the_run_found)
{
  MadeRun made;
  made.sunk = [](Real u) { return u / 2; };
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  // H grows to the end, u = 0.5 D: H = 300 N/m, w = 7 mm, V = 800 N/m. By hand, with delta = 23.333 deg: Kp = 2.31143, Fp = Kp 430e3 0.007^2/2 = 24.3509 N/m,
  // H = 24.3509 + 0.431358 (800 - 0.431358 x 24.3509) = 364.906 N/m; with Rankine's Kp of the sand, 3.69017, 376.73 N/m.
  const ComparedState* end = state_at(values, Kind::peak, 0.01);
  const Comparison* code = by(end, "DNVGL-RP-F114", "Kp with δ");
  ASSERT_NE(code, nullptr);
  EXPECT_EQ(end->point, ComparedState::Point::largest);
  EXPECT_NEAR(code->berm, 300, 1e-6);
  EXPECT_NEAR(code->published.value, 364.906, 0.01);
  EXPECT_NEAR(code->ratio(), 300 / 364.906, 1e-4);
  EXPECT_NEAR(by(end, "DNVGL-RP-F114", "Kp with φ")->published.value, 376.73, 0.01);
  EXPECT_EQ(by(end, "DNVGL-RP-F114", "Kp with φ")->published.source.label, formulas::Label::recalled);
  EXPECT_EQ(state_at(values, Kind::drag, 0.006), nullptr) << "its formulas are those of breakout";
}

// By hand at w = 2 mm, where the drag begins: Fp = 2.31143 x 430e3 x 0.002^2/2 = 1.9878 N/m, H = 1.9878 + 0.431358 (800 - 0.431358 x 1.9878) = 346.70.
TEST(published, a_drag_through_sand_without_a_peak_is_compared_where_it_begins_to_slide)
{
  MadeRun made;
  made.H = [](Real u) { return std::min(250 * u / 2e-4, 250 + 1e4 * u); };
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  const ComparedState* onset = state_at(values, Kind::peak, 0);
  ASSERT_NE(onset, nullptr);
  EXPECT_EQ(onset->point, ComparedState::Point::onset);
  EXPECT_NEAR(by(onset, "DNVGL-RP-F114", "Kp with δ")->berm, 250, 1e-6);
  EXPECT_NEAR(by(onset, "DNVGL-RP-F114", "Kp with δ")->published.value, 346.70, 0.01);
}

// V rises from 100 N/m to the 800 N/m that are held over the first 0.05 D of the drag of 0.5 D: 765 N/m in the mean.
TEST(published, at_the_onset_of_sliding_V_is_that_of_the_drag_and_not_that_of_its_first_row)
{
  MadeRun made;
  made.H = [](Real u) { return std::min(250 * u / 2e-4, 250 + 1e4 * u); };
  record::RunRecord run = made.record();
  for (Index k = 0; k < run.history.rows(); ++k)
    if (const Real u = run.history.values[1][k]; run.history.stage[k] == "drag")
      run.history.values[4][k] = 100 + 700 * std::min(1., u / 0.001);
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  const PublishedValues values = published_beside(driven::DrivenRun(run));
  const ComparedState* onset = state_at(values, Kind::peak, 0);
  ASSERT_NE(onset, nullptr);
  EXPECT_NEAR(onset->V, 765, 5);
}

TEST(published, a_drag_through_sand_with_a_peak_is_compared_there)
{
  // A peak of 250 N/m at u = 4 mm, w = 4 mm. By hand: Fp = 2.31143 x 430e3 x 0.004^2/2 = 7.9513 N/m, H = 7.9513 + 0.431358 (800 - 0.431358 x 7.9513) = 351.558.
  MadeRun made;
  made.sunk = [](Real u) { return u / 2; };
  made.H = [](Real u) { return u < 0.004 ? 62500 * u : std::max(150., 250 - 5e4 * (u - 0.004)); };
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  const auto peak =
      std::find_if(values.states.begin(), values.states.end(), [](const ComparedState& state) { return state.kind == Kind::peak; });
  ASSERT_NE(peak, values.states.end());
  EXPECT_EQ(peak->point, ComparedState::Point::peak);
  EXPECT_NEAR(peak->u, 0.004, 1e-4);
  const Comparison* code = by(&*peak, "DNVGL-RP-F114");
  ASSERT_NE(code, nullptr);
  EXPECT_NEAR(code->berm, 250, 8);  // averaged over 0.01 D to either side, which cuts 0.0002 x 6e4 off
  EXPECT_NEAR(code->published.value, 351.558, 0.5);
}

TEST(published, characteristics_are_out_of_range_where_the_sand_is_not_associated)
{
  MadeRun made;
  made.law.dilation_angle = 0;
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  const Comparison* exact = by(state_at(values, Kind::end_of_push, 0.002), characteristics);
  ASSERT_NE(exact, nullptr);
  EXPECT_FALSE(exact->published.valid);
  EXPECT_TRUE(says(values, "ψ = 0°"));
  EXPECT_FALSE(says(published_beside(driven::DrivenRun(MadeRun{}.record())), "associated"));
}

TEST(published, breakout_of_the_code_is_for_the_embedment_at_which_the_drag_begins)
{
  const PublishedValues values = published_beside(driven::DrivenRun(MadeRun{}.record()));
  const Comparison* mean = by(state_at(values, Kind::breakout, 0.002), "DNVGL-RP-F114", "BE");
  ASSERT_NE(mean, nullptr);
  EXPECT_TRUE(std::isnan(mean->berm));  // H grows to the end
  EXPECT_NEAR(mean->published.value, 0.02 * (0.02 + 0.25 * 0.1), 1e-9);
}

TEST(published, breakout_of_the_code_is_not_for_the_embedment_of_the_push_where_the_pipe_rose_before_the_drag)
{
  record::RunRecord run = MadeRun{}.record();
  const auto last = std::find(run.history.stage.begin(), run.history.stage.end(), "drag") - run.history.stage.begin() - 1;
  run.history.stage[last] = "unload";
  run.history.values[2][last] = 0.0015;  // w
  const PublishedValues values = published_beside(driven::DrivenRun(run));
  EXPECT_NE(state_at(values, Kind::breakout, 0.0015), nullptr);
  EXPECT_EQ(state_at(values, Kind::breakout, 0.002), nullptr);
}

MadeRun clay_run(Real pushed_to)
{
  MadeRun made;
  made.law = MadeRun::clay_law();
  made.contact.friction_angle = 0;
  made.pushed_to = pushed_to;
  made.held_V = 50;
  made.V = [](Real w) { return 20 * std::sqrt(w / 0.01) * 4; };
  return made;
}

TEST(published, clay_gets_the_formulas_for_clay)
{
  const PublishedValues values = published_beside(driven::DrivenRun(clay_run(0.002).record()));
  const ComparedState* push = state_at(values, Kind::end_of_push, 0.002);
  EXPECT_EQ(by(push, characteristics), nullptr);
  // Smooth slip lines at 0.1 D carry 2.713 D s_u; on top comes what the displaced clay weighs, 430e3 x 0.163501 R^2.
  const Comparison* smooth = by(push, "slip lines, weightless clay");
  ASSERT_NE(smooth, nullptr);
  EXPECT_NEAR(smooth->published.value, 2.713 * 20 + 430e3 * 0.163501e-4, 0.02);
  EXPECT_TRUE(smooth->published.valid);
  EXPECT_NEAR(smooth->berm, 80 * std::sqrt(0.2), 0.1);
  EXPECT_NE(by(push, "DNVGL-RP-F114 (2019)", "model 1"), nullptr);
  EXPECT_NE(by(push, "DNV-RP-F114", "model 2"), nullptr);
  EXPECT_NE(by(push, "Merifield, White and Randolph 2009"), nullptr);
  EXPECT_TRUE(says(values, "weight of the clay"));
  const Comparison* apex = by(state_at(values, Kind::drag, 0.006), merifield, "apex");
  ASSERT_NE(apex, nullptr);
  EXPECT_NEAR(apex->published.value, 20 * 2.72 * std::pow(0.25, 0.78), 1e-6);
  EXPECT_NE(by(state_at(values, Kind::drag, 0.006), merifield, "envelope at the run's V"), nullptr);
}

TEST(published, the_clay_envelope_is_taken_at_V_less_the_weight_of_the_displaced_clay)
{
  // At u = 0.3 D, w = 0.25 D, smooth: b1 = 0.8 x 0.95, b2 = 0.35 x 2.25, so that the apex is at 0.76/1.5475 of V_max. A quarter of the depth is a segment of
  // 60 deg to either side: (pi/3 - sqrt(3)/4) R^2.
  MadeRun made = clay_run(0.002);
  made.held_V = 0.76 / 1.5475 * 20 * 5.66 * std::pow(0.25, 0.32) + 430e3 * (pi / 3 - std::sqrt(3) / 4) * 1e-4;
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  const ComparedState* drag = state_at(values, Kind::drag, 0.006);
  const Comparison *at_V = by(drag, merifield, "envelope at the run's V"), *apex = by(drag, merifield, "apex");
  ASSERT_NE(at_V, nullptr);
  EXPECT_NEAR(at_V->published.value, apex->published.value, 1e-9);
}

TEST(published, clay_at_07_D_is_out_of_range)
{
  const PublishedValues values = published_beside(driven::DrivenRun(clay_run(0.014).record()));
  const Comparison* half = by(state_at(values, Kind::push, 0.01), merifield);
  const Comparison* deeper = by(state_at(values, Kind::end_of_push, 0.014), merifield);
  ASSERT_NE(half, nullptr);
  ASSERT_NE(deeper, nullptr);
  EXPECT_TRUE(half->published.valid);
  EXPECT_FALSE(deeper->published.valid);
  EXPECT_NE(by(state_at(values, Kind::push, 0.01), formulas::murff_source.work), nullptr);
  EXPECT_EQ(by(state_at(values, Kind::end_of_push, 0.014), formulas::murff_source.work), nullptr);
}

TEST(published, a_pipe_tied_to_clay_is_rough)
{
  MadeRun made = clay_run(0.002);
  made.contact.scheme = contact::Scheme::tied;
  made.gravity_level = 0;
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  const Comparison* rough = by(state_at(values, Kind::end_of_push, 0.002), merifield);
  ASSERT_NE(rough, nullptr);
  EXPECT_NEAR(rough->published.value, 20 * 7.40 * std::pow(0.1, 0.40), 1e-6);
  EXPECT_EQ(by(state_at(values, Kind::end_of_push, 0.002), "slip lines, weightless clay"), nullptr);
}

TEST(published, clay_with_friction_at_the_pipe_has_no_formula_for_H)
{
  MadeRun made = clay_run(0.002);
  made.contact.friction_angle = 0.3;
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  EXPECT_EQ(state_at(values, Kind::drag, 0.006), nullptr);
  EXPECT_EQ(by(state_at(values, Kind::end_of_push, 0.002), merifield), nullptr);
  EXPECT_NE(by(state_at(values, Kind::end_of_push, 0.002), "DNV-RP-F114", "model 2"), nullptr);
  EXPECT_TRUE(says(values, "friction"));
}

TEST(published, a_run_wished_in_place_takes_the_w_that_it_began_with)
{
  MadeRun made;
  made.method = settings::Method::fem;
  made.first_w = made.pushed_to = 0.002;
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  const ComparedState* drag = state_at(values, Kind::peak, 0.01);
  ASSERT_NE(drag, nullptr);
  EXPECT_NEAR(drag->w, 0.002, 1e-12);  // whatever it sank by: small strains leave it where it was
  EXPECT_EQ(state_at(values, Kind::push, 0.002), nullptr);
  EXPECT_TRUE(says(values, "wished in place: the pipe lies at w = 0.1 D"));
  EXPECT_TRUE(says(published_beside(driven::DrivenRun(MadeRun{}.record())), "pushed in from the surface"));
}

TEST(published, a_push_of_the_finite_element_method_is_compared_at_its_end_and_first_w)
{
  MadeRun made;
  made.method = settings::Method::fem;
  made.first_w = 0.002;
  made.pushed_to = 0.0056;
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  EXPECT_EQ(state_at(values, Kind::push, 0.005), nullptr);
  const Comparison* exact = by(state_at(values, Kind::end_of_push, 0.002), characteristics);
  ASSERT_NE(exact, nullptr);
  EXPECT_NEAR(exact->berm, 4e5 * 0.0056, 1e-6);
  EXPECT_NEAR(exact->published.value, 5.915 * 172, 1e-3);
}

TEST(published, a_push_is_compared_where_it_ends_and_not_where_it_begins)
{
  // By MPM from 0.1 D to 0.12 D: V at 0.1 D is that of a pipe that has not met the soil yet.
  MadeRun made = clay_run(0.0024);
  made.first_w = 0.002;
  made.settles = false;
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  EXPECT_EQ(state_at(values, Kind::push, 0.002), nullptr);
  ASSERT_NE(state_at(values, Kind::end_of_push, 0.0024), nullptr);
  EXPECT_NE(by(state_at(values, Kind::end_of_push, 0.0024), merifield), nullptr);
}

TEST(published, the_end_of_a_push_stands_for_the_points_beside_it)
{
  const PublishedValues values = published_beside(driven::DrivenRun(clay_run(0.00516).record()));  // 0.258 D, beside 0.25 D
  EXPECT_NE(state_at(values, Kind::push, 0.002), nullptr);
  EXPECT_EQ(state_at(values, Kind::push, 0.005), nullptr);
  EXPECT_NE(state_at(values, Kind::end_of_push, 0.00516), nullptr);
  EXPECT_NE(state_at(published_beside(driven::DrivenRun(clay_run(0.0054).record())), Kind::push, 0.005), nullptr);
}

TEST(published, without_a_history_the_case_tells_where_a_push_begins)
{
  MadeRun made = clay_run(0.0024);
  made.first_w = 0.002;
  made.settles = false;
  record::RunRecord run = made.record();
  run.history = {};
  EXPECT_EQ(state_at(published_beside(driven::DrivenRun(run)), Kind::push, 0.002), nullptr);
  EXPECT_TRUE(says(published_beside(driven::DrivenRun(run)), "wished in place at w = 0.1 D"));
}

TEST(published, forces_of_half_a_pipe_are_doubled)
{
  MadeRun made;
  made.left = 0;
  const PublishedValues values = published_beside(driven::DrivenRun(made.record()));
  const Comparison* exact = by(state_at(values, Kind::end_of_push, 0.002), characteristics);
  ASSERT_NE(exact, nullptr);
  EXPECT_NEAR(exact->berm, 1600, 1e-6);
  EXPECT_NEAR(by(state_at(values, Kind::peak, 0.01), "DNVGL-RP-F114")->berm, 600, 1e-6);
  EXPECT_TRUE(says(values, "half of the pipe"));
}

// c cot(35 deg) of 4 % of gamma' D, that of the templates for sand, and of 6 %.
TEST(published, formulas_leave_out_a_little_cohesion_of_sand_and_say_so)
{
  const PublishedValues clean = published_beside(driven::DrivenRun(MadeRun{}.record()));
  for (const Real part : {0.04, 0.06}) {
    MadeRun damp;
    damp.law.cohesion = part * 430e3 * 0.02 * std::tan(damp.law.friction_angle);
    const PublishedValues values = published_beside(driven::DrivenRun(damp.record()));
    ASSERT_FALSE(values.states.empty());
    ASSERT_EQ(values.states.size(), clean.states.size());
    for (std::size_t k = 0; k < values.states.size(); ++k)
      for (std::size_t n = 0; n < values.states[k].comparisons.size(); ++n) {
        const formulas::Formula &with = values.states[k].comparisons[n].published, &without = clean.states[k].comparisons[n].published;
        EXPECT_DOUBLE_EQ(with.value, without.value);
        EXPECT_EQ(with.valid, part < 0.05 && without.valid);
        if (part > 0.05) {
          EXPECT_EQ(with.source.range, std::string("c cot φ up to 5 % of γ' D"));
        }
      }
    EXPECT_TRUE(says(values, part < 0.05 ? "up to 0.05 its effect is less" : "beyond 0.05 the formulas are out of range"));
  }
  EXPECT_FALSE(says(clean, "without cohesion"));
}

TEST(published, what_is_no_whole_pipe_has_no_formulas)
{
  record::RunRecord run = MadeRun{}.record();
  run.settings.rigid[0].second.shape = bodies::BoxSettings{{0, 0.01}, {0.02, 0.02}, 0};
  const PublishedValues values = published_beside(driven::DrivenRun(run));
  EXPECT_TRUE(values.states.empty());
  EXPECT_TRUE(says(values, "not a circle"));
  MadeRun cut;
  cut.left = 0.005;
  EXPECT_TRUE(says(published_beside(driven::DrivenRun(cut.record())), "a wall of the mesh cuts"));
  MadeRun mixed;
  mixed.law.cohesion = 1000;
  EXPECT_TRUE(says(published_beside(driven::DrivenRun(mixed.record())), "neither clay"));
  mixed.law.cohesion = 0;
  mixed.law.cohesion_gradient = 1e6;
  EXPECT_TRUE(says(published_beside(driven::DrivenRun(mixed.record())), "neither clay")) << "20 kPa a diameter below";
}

}  // namespace
}  // namespace berm::pipe::this_file
