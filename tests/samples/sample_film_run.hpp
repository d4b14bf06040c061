// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/box.hpp"
#include "record/run_record.hpp"
#include "run_folder/frames.hpp"
#include "samples/frame_particles.hpp"
#include "samples/history_columns.hpp"
#include "samples/temporary_folder.hpp"

namespace berm {

/// Frames of a run: a bed of 0.4 x 0.1 (x 0.1) m whose 8 x 4 (x 4, 0.02 m wide) particles shear, and a pipe of 0.02 m that goes 0.01 D down and 0.02 D along x in each
/// frame of its drag. Stages: "settle" (frames 0 to 2, the pipe rests), "drag" (the others).
template <int dim>
class SampleFilmRun {
public:
  static constexpr Index across = 8, up = 4, settle_frames = 3;
  static constexpr Real D = 0.02, cell = 0.05, first_time = 0.5;  // m, m, s
  TemporaryFolder folder;
  record::RunRecord run;

  explicit SampleFilmRun(Index frames = 7, bool pipe = true) : pipe_(pipe)
  {
    run.folder = folder.path();
    settings::Case& c = run.settings;
    c.geometry = dim == 2 ? settings::Geometry::plane_strain : settings::Geometry::space;
    mesh::BoxMesh box{.lower = {-0.2, -0.1, 0}, .size = {0.4, 0.13, 0.1}, .cells = {8, 4, 2}};
    for (auto* list : {&box.lower, &box.size, &box.cells}) list->resize(dim);
    c.mesh = box;
    c.body = {{"sand", bodies::BodySettings{}}};
    c.body[0].second.k0 = 0.5;
    if (pipe) {
      bodies::RigidSettings rigid;
      rigid.shape = bodies::CircleSettings{std::vector<Real>{0, D / 2, 0}, D};
      std::get<bodies::CircleSettings>(rigid.shape).center.resize(dim);
      c.rigid = {{"pipe <1>", rigid}};
      settings::StageSettings drag;
      drag.name = "drag";
      drag.kind = settings::StageKind::drag;
      drag.rigid = "pipe <1>";
      c.stage = {drag};
    }
    write_history(frames);
    run_folder::FrameWriter<dim> writer(folder / "frames", make_box<dim>(box));
    for (Index f = 0; f < frames; ++f) writer.write(frame(f));
  }

  std::filesystem::path file(const std::string& name) const { return folder / ("frames/" + name); }
  static Index moved_frames(Index f) { return std::max(0, f - settle_frames + 1); }
  static Real time(Index f) { return first_time * f; }
  static Real u(Index f) { return 0.02 * D * moved_frames(f); }
  static Real w(Index f) { return 0.01 * D * moved_frames(f); }
  static std::string stage(Index f) { return f < settle_frames ? "settle" : "drag"; }

  /// What is written.
  run_folder::Frame<dim> frame(Index f) const
  {
    std::vector<run_folder::FrameParticle<dim>> particles;
    Index id = 0;
    for (Index k = 0; k < (dim == 3 ? 4 : 1); ++k)
      for (Index j = 0; j < up; ++j)
        for (Index i = 0; i < across; ++i, ++id) {
          run_folder::FrameParticle<dim> p{{}, 0, Vec<dim>::Zero(), {}, 0};
          p.displacement[0] = 1e-3 * f * (j + 1) + 1e-5 * f * i;
          p.displacement[1] = -2e-3 * f * i;
          p.particle.x = p.displacement;
          p.particle.x[0] += -0.2 + cell * (i + 0.5);
          p.particle.x[1] += -0.1 + cell / 2 * (j + 0.5);
          if (dim == 3) p.particle.x[dim - 1] = cell / 2 * (k + 0.5);
          p.particle.id = id;
          p.particle.volume = dim == 2 ? cell * cell / 2 : std::pow(0.4 * cell, 3);
          p.particle.v = p.displacement / first_time;
          p.strain.deviatoric = 0.005 * f * f + 0.002 * f * i;
          p.strain_increment = f == 0 ? 0 : 0.01 * (2 * f - 1) + 0.001 * i;
          p.particle.deviatoric_strain = 5 + i;
          for (int d = 0; d < 3; ++d) p.particle.stress[d] = -1000 * (id + 1) - 10 * f;  // so the mean, Pa
          particles.push_back(p);
        }
    run_folder::Frame<dim> frame = frame_of(particles);
    frame.time = time(f);
    if (pipe_) {
      Vec<dim> center = Vec<dim>::Zero(), low = Vec<dim>::Constant(-0.2), high = Vec<dim>::Constant(0.2);
      center[0] = u(f);
      center[1] = D / 2 - w(f);
      frame.rigid_bodies = {{bodies::surface_mesh<dim>(bodies::Circle<dim>{center, D / 2}, low, high), Vec<dim>::Zero()}};
    }
    return frame;
  }

private:
  /// Two rows a frame, u and w linear in time between frames.
  void write_history(Index frames)
  {
    run_folder::History& h = run.history;
    h.columns = columns_named({"time_s", "u_m", "w_m", "H_N_m", "V_N_m"});
    h.values.resize(5);
    for (Index row = 0; row <= 2 * (frames - 1); ++row) {
      const Index f = row / 2, next = (row + 1) / 2;
      const Real values[] = {time(f) + first_time / 2 * (row % 2), (u(f) + u(next)) / 2, (w(f) + w(next)) / 2, 10. * row, 100. * row};
      for (std::size_t k = 0; k < 5; ++k) h.values[k].push_back(values[k]);
      h.stage.push_back(stage(next));
    }
  }

  bool pipe_;
};

}  // namespace berm
