// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/bands.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::uncertainty::this_file {
namespace {

constexpr Real sizes[] = {2.1, 3};

/// A run whose V and H are so much larger than 4e5 w and 3e4 u.
record::RunRecord made(Real factor, const std::string& name = "made")
{
  MadeRun run;
  run.name = name;
  run.V = [=](Real w) { return factor * 4e5 * w; };
  run.H = [=](Real u) { return factor * 3e4 * u; };
  return run.record();
}

/// Variants of first order: 1 + 0.1 size; and the coarsest at twice the speed, 1 % more.
std::vector<VariantRecord> first_order()
{
  std::vector<VariantRecord> variants;
  for (const Real size : sizes) variants.push_back({size, 1, made(1 + 0.1 * size)});
  variants.push_back({3, 2, made((1 + 0.1 * 3) * 1.01)});
  return variants;
}

TEST(Bands, of_answers_of_first_order_are_those_of_the_line)
{
  const run_folder::Uncertainty u = bands_of(made(1.1), first_order());
  const run_folder::Band* V = u.find("V_at_w_0.1D");
  ASSERT_NE(V, nullptr);
  EXPECT_NEAR(V->value, 1.1 * 800, 0.1);
  EXPECT_NEAR(V->converged, 800, 0.1);
  EXPECT_NEAR(V->extrapolation, 40, 0.1);
  EXPECT_GT(V->mesh, 0) << "what meshes are known to scatter by";
  EXPECT_NEAR(V->order, 1, 0.01);
  EXPECT_NEAR(V->speed, 0.01 * 1.3 * 800, 0.1);
  EXPECT_NEAR(V->noise, 0, 0.1) << "straight curves have none";
  EXPECT_NEAR(V->half_width, V->extrapolation + std::hypot(V->mesh, V->speed), 0.2);
}

TEST(Bands, are_there_for_answers_alone)
{
  const run_folder::Uncertainty u = bands_of(made(1.1), first_order());
  EXPECT_NE(u.find("H_end_of_drag"), nullptr);
  for (const char* name : {"V_at_w_0.1D_over_gammaD2", "w_end_of_push_over_D", "V_noise", "gap_mean"})
    EXPECT_EQ(u.find(name), nullptr) << name;
}

TEST(Bands, are_not_there_for_what_the_input_prescribes)
{
  record::RunRecord run = made(1.1);
  EXPECT_NE(bands_of(run, first_order()).find("w_end_of_push"), nullptr);
  run.settings.stage[0].until.embedment = 0.002;
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  const run_folder::Uncertainty u = bands_of(run, first_order());
  EXPECT_EQ(u.find("w_end_of_push"), nullptr);
  EXPECT_NE(u.find("V_end_of_push"), nullptr);
}

TEST(Bands, leave_out_what_a_coarser_run_has_not_and_say_which)
{
  std::vector<VariantRecord> variants = first_order();
  MadeRun run;
  run.name = "short";
  run.dragged = 0.005;
  variants[1].run = run.record();
  const run_folder::Uncertainty u = bands_of(made(1.1), variants);
  EXPECT_EQ(u.find("H_at_u_0.4D"), nullptr);
  EXPECT_NE(u.find("H_at_u_0.2D"), nullptr);
  const auto found = std::find_if(u.without.begin(), u.without.end(), [](const auto& each) { return each.first == "H_at_u_0.4D"; });
  ASSERT_NE(found, u.without.end());
  EXPECT_EQ(found->second, "short has no such number");
}

// A number that averaging makes: H of the short variant levels off at its end once it is smooth.
TEST(Bands, need_the_number_itself_in_every_run)
{
  const auto number = [](const record::RunRecord& run) {
    const bool smooth = run.folder.empty();
    std::map<std::string, RunNumber> numbers = {{"always", {1, Scatters::as_in_drags}}};
    if (smooth || run.name != "short") numbers["plateau"] = {2, Scatters::as_in_drags};
    return numbers;
  };
  record::RunRecord run = made(1.1), other = made(1.1, "short");
  run.folder = "run", other.folder = "short";
  const auto bands = bands_of(run, {{2.1, 1, run}, {3, 1, other}}, number);
  EXPECT_TRUE(std::isfinite(bands.at("always").half_width));
  EXPECT_TRUE(std::isnan(bands.at("plateau").half_width));
}

// Where a pipe lies at the start is 1.5 m in all runs, whatever their cells are.
TEST(Bands, of_a_number_that_all_runs_share_have_no_width)
{
  const auto number = [](const record::RunRecord&) { return std::map<std::string, RunNumber>{{"w_begin", {1.5, Scatters::as_in_drags}}}; };
  const run_folder::Band band = bands_of(made(1.1), {{2.1, 1, made(1.21)}, {3, 1, made(1.3)}}, number).at("w_begin");
  EXPECT_NEAR(band.converged, 1.5, 1e-12);
  EXPECT_NEAR(band.half_width, 0, 1e-12);
}

/// A drag out and back, as a storm makes it: H against the motion, twice as large on the way back.
record::RunRecord out_and_back(Real factor)
{
  record::RunRecord run = made(factor);
  run_folder::History& history = run.history;
  const auto u = std::ranges::find(history.columns, "u", &run_folder::Column::label) - history.columns.begin();
  const auto H = std::ranges::find(history.columns, "H", &run_folder::Column::label) - history.columns.begin();
  Index first = 0;
  while (history.stage[first] != "drag") ++first;
  const Index count = history.rows() - first, turn = first + count / 2;
  for (Index k = first; k < history.rows(); ++k) {
    history.values[u][k] = 1e-5 * (k < turn ? k - first : 2 * turn - first - k);
    history.values[H][k] = (k < turn ? 100 : -200) * factor;
  }
  return run;
}

TEST(Bands, do_not_average_over_a_travel_that_turns_back)
{
  const auto last_H = [](const record::RunRecord& run) {
    return std::map<std::string, RunNumber>{{"H", {run.history.by_label("H").back(), Scatters::as_in_drags}}};
  };
  const auto bands = bands_of(out_and_back(1.1), {{2.1, 1, out_and_back(1.21)}, {3, 1, out_and_back(1.3)}}, last_H);
  EXPECT_NEAR(bands.at("H").converged, -200, 1);
}

/// Why that quantity or curve has no band; "" where it is not among those without.
std::string reason(const run_folder::Uncertainty& u, const std::string& name)
{
  const auto found = std::find_if(u.without.begin(), u.without.end(), [&](const auto& each) { return each.first == name; });
  return found == u.without.end() ? "" : found->second;
}

TEST(Bands, leave_out_curves_that_a_coarser_run_has_not_and_say_which)
{
  std::vector<VariantRecord> variants = first_order();
  MadeRun run;
  run.name = "pushed alone";
  run.dragged = 0;
  variants[1].run = run.record();
  const run_folder::Uncertainty u = bands_of(made(1.1), variants);
  ASSERT_EQ(u.curves.size(), 1u);
  EXPECT_EQ(u.curves[0].chart, "V_w");
  EXPECT_EQ(reason(u, "curve V_w"), "");
  for (const char* curve : {"curve H_u", "curve w_u"}) EXPECT_EQ(reason(u, curve), "pushed alone has no such curve") << curve;
}

TEST(Bands, of_curves_lie_along_them)
{
  const run_folder::Uncertainty u = bands_of(made(1.1), first_order());
  ASSERT_EQ(u.curves.size(), 3u);
  const run_folder::CurveBand& V = u.curves[0];
  EXPECT_EQ(V.chart, "V_w");
  EXPECT_NEAR(V.x.back(), 0.002, 1e-9);
  const std::size_t middle = V.x.size() / 2;
  EXPECT_NEAR((V.low[middle] + V.high[middle]) / 2, 4e5 * V.x[middle], 1);
  EXPECT_GT(V.high[middle] - V.low[middle], 2 * 0.05 * 4e5 * V.x[middle] - 1);
  EXPECT_EQ(u.curves[1].chart, "H_u");
  EXPECT_EQ(u.curves[2].chart, "w_u");
}

/// All quantities of a run.
std::map<std::string, RunNumber> quantities(const record::RunRecord& run)
{
  std::map<std::string, RunNumber> numbers;
  for (const run_folder::Quantity& q : run.quantities) numbers[q.name] = {q.value, Scatters::as_in_drags};
  return numbers;
}

/// The noise of that quantity, which must have one.
Real noise_in(const record::RunRecord& run, const std::string& quantity)
{
  const std::map<std::string, Real> noise = noise_of(run, quantities);
  const auto found = noise.find(quantity);
  if (found != noise.end()) return found->second;
  ADD_FAILURE() << quantity << " has no noise";
  return 0;
}

// Rows that go up and down by 5 % of V in turn: a mean over some ten of them is uncertain by a few per cent, and none of smooth rows is.
TEST(Noise, of_rows_that_waver_is_seen)
{
  MadeRun run;
  run.V = [](Real w) { return 4e5 * w * (1 + 0.05 * std::sin(1e6 * w)); };
  const record::RunRecord record = run.record();
  const Real noise = noise_in(record, "V_at_w_0.1D");
  EXPECT_GT(noise, 1);
  EXPECT_LT(noise, 0.1 * 800);
  run.method = settings::Method::fem;
  EXPECT_TRUE(noise_of(run.record(), quantities).empty());
}

/// A drag whose H wavers by 5 % and changes by about `change` over its last 0.1 D: it is residual up to a change of 5 %.
record::RunRecord with_change_at_the_end(Real change)
{
  MadeRun run;
  run.H = [=](Real u) { return 300 * (1 + 0.05 * std::sin(1e6 * u)) * (1 + change * (u - 0.01) / 0.002); };
  return run.record();
}

// The largest change at which the run has a residual H: without some of its rows it has, without others it has not.
TEST(Noise, of_a_number_that_some_rows_make_is_not_known_and_it_has_no_band)
{
  Real with = 0, without = 0.2;
  ASSERT_NE(with_change_at_the_end(with).quantity("H_residual"), nullptr);
  ASSERT_EQ(with_change_at_the_end(without).quantity("H_residual"), nullptr);
  while (without - with > 1e-6) {
    const Real middle = (with + without) / 2;
    (with_change_at_the_end(middle).quantity("H_residual") != nullptr ? with : without) = middle;
  }
  const record::RunRecord run = with_change_at_the_end(with);
  EXPECT_TRUE(std::isnan(noise_in(run, "H_residual")));
  EXPECT_GT(noise_in(run, "H_end_of_drag"), 0) << "the same mean, which every drag has";
  std::vector<VariantRecord> variants;
  for (const Real size : sizes) variants.push_back({size, 1, with_change_at_the_end(0)});
  const run_folder::Uncertainty u = bands_of(run, variants);
  EXPECT_EQ(u.find("H_residual"), nullptr);
  EXPECT_EQ(reason(u, "H_residual").find("noise: "), 0u) << reason(u, "H_residual");
  EXPECT_NE(u.find("H_end_of_drag"), nullptr);
}

TEST(Bands, need_runs_of_different_cells)
{
  const std::vector<VariantRecord> one = {{1.4, 1, made(1.1)}};
  EXPECT_EQ(reason(bands_of(made(1.1), one), "V_at_w_0.1D"), "too few runs of different cells to fit a line");
}

}  // namespace
}  // namespace berm::uncertainty::this_file
