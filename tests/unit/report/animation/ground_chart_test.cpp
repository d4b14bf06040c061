// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/ground_chart.hpp"

#include "samples/sample_film_run.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

/// Two elements in a row, each of two triangles, from x = 0 to 0.4 m and from y = -0.2 m to the surface: the nodes of a grid of 5 x 3, whose column i is raised by heave[i].
run_folder::Frame<2> raised(const std::array<Real, 5>& heave, Real time)
{
  std::vector<run_folder::FrameParticle<2>> nodes;
  for (int k = 0; k < 15; ++k) {
    run_folder::FrameParticle<2> p{{}, 0, Vec<2>::Zero(), {}, 0};
    const int row = k / 5;
    p.particle.x = Vec<2>(0.1 * (k % 5), -0.2 + 0.1 * row + (row == 2 ? heave[k % 5] : 0));
    p.particle.id = k;
    nodes.push_back(p);
  }
  run_folder::Frame<2> frame = frame_of(nodes);
  frame.time = time;
  frame.triangles = {{0, 2, 12, 1, 7, 6}, {0, 12, 10, 6, 11, 5}, {2, 4, 14, 3, 9, 8}, {2, 14, 12, 8, 13, 7}};
  return frame;
}

/// A run of finite elements whose stage "settle" ends at 1 s, and "drag" at 2 s; the ground has risen by 10 mm in the middle of the first, by 20 mm at the end of the second.
struct RemeshedRun {
  SampleFilmRun<2> sample{1};

  RemeshedRun()
  {
    record::RunRecord& run = sample.run;
    run.settings.method = settings::Method::fem;
    run.settings.fem.large_deformation = true;
    run.history.columns = columns_named({"time_s", "u_m", "w_m"});
    run.history.values = {{0, 0.5, 1, 1.5, 2}, {0, 0, 0, 0.01, 0.02}, {0, 0, 0, 0, 0}};
    run.history.stage = {"settle", "settle", "settle", "drag", "drag"};
    run_folder::FrameWriter<2> writer(sample.folder / "frames", make_box<2>(std::get<mesh::BoxMesh>(run.settings.mesh)));
    writer.write(raised({}, 0));
    writer.write(raised({0, 0.005, 0, 0, 0}, 0.5));
    writer.write(raised({0, 0.01, 0, 0, 0}, 1));
    writer.write(raised({0, 0.01, 0.02, 0, 0}, 2));
  }
};

TEST(ground, is_drawn_at_the_start_and_at_the_ends_of_stages)
{
  RemeshedRun made;
  made.sample.run.settings.rigid.clear();  // without a body all of it is shown
  const std::optional<base::Chart> chart = ground_chart(made.sample.run);
  ASSERT_TRUE(chart);
  EXPECT_EQ(chart->title, "Ground at the ends of stages");
  ASSERT_EQ(chart->curves.size(), 3u);
  const base::Curve &start = chart->curves[0], &settled = chart->curves[1], &dragged = chart->curves[2];
  EXPECT_EQ(start.name, "start");
  EXPECT_EQ(settled.name, "settle");
  EXPECT_EQ(dragged.name, "drag");
  EXPECT_EQ(start.rows, std::vector<Index>(5, 0));
  EXPECT_EQ(settled.rows, std::vector<Index>(5, 2));
  EXPECT_EQ(dragged.rows, std::vector<Index>(5, 4));
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(dragged.x[k], 0.1 * k, 1e-12);
  EXPECT_NEAR(settled.y[1], 0.01, 1e-12);
  EXPECT_NEAR(dragged.y[2], 0.02, 1e-12);
}

TEST(ground, is_drawn_beside_the_path_of_the_body)
{
  const RemeshedRun made;  // from u = 0 to D = 0.02 m: up to 0.07 m, where the first point is
  const std::optional<base::Chart> chart = ground_chart(made.sample.run);
  ASSERT_TRUE(chart);
  EXPECT_EQ(chart->curves.back().x.size(), 1u);
}

TEST(ground, of_many_stages_is_drawn_at_the_ends_of_some)
{
  RemeshedRun made;
  record::RunRecord& run = made.sample.run;
  run_folder::FrameWriter<2> writer(made.sample.folder / "frames", make_box<2>(std::get<mesh::BoxMesh>(run.settings.mesh)));
  run.history.stage.clear();
  run.history.values = {{}, {}, {}};
  for (int k = 0; k < 20; ++k) {
    writer.write(raised({}, k));
    run.history.stage.push_back("drag_" + std::to_string(k));
    run.history.values[0].push_back(k), run.history.values[1].push_back(0), run.history.values[2].push_back(0);
  }
  const std::optional<base::Chart> chart = ground_chart(run);
  ASSERT_TRUE(chart);
  EXPECT_EQ(chart->title, "Ground at the ends of stages, one of 3");
  EXPECT_EQ(chart->curves.size(), 8u);
  EXPECT_EQ(chart->curves.back().name, "drag_19");
}

TEST(ground, of_other_runs_and_without_frames_is_not_drawn)
{
  RemeshedRun made;
  record::RunRecord& run = made.sample.run;
  std::filesystem::remove(made.sample.file("soil_0003.vtu"));
  EXPECT_EQ(ground_chart(run)->curves.size(), 2u) << "up to the frame that is missing";
  run.settings.fem.large_deformation = false;
  EXPECT_FALSE(ground_chart(run)) << "small strain";
  run.settings.fem.large_deformation = true;
  std::filesystem::remove_all(made.sample.folder / "frames");
  EXPECT_FALSE(ground_chart(run));
}

}  // namespace
}  // namespace berm::report::this_file
