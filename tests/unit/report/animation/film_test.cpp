// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film.hpp"

#include "report/animation/film_fields.hpp"
#include "samples/film_decoding.hpp"
#include "samples/sample_film_run.hpp"

#include <gtest/gtest.h>
#include <omp.h>

namespace berm::report::this_file {
namespace {

constexpr std::size_t plenty = 10'000'000;

std::vector<Real> times_of(const Film& film)
{
  std::vector<Real> times;
  for (const auto& frame : film.json["frames"]) times.push_back(frame["time"]);
  return times;
}

std::size_t size_of(const Film& film)
{
  std::size_t size = 0;
  for (const FilmBlock& block : film.blocks) size += block.base64.size();
  return size;
}

TEST(film, places_decode_within_half_a_step_and_fields_within_half_a_level)
{
  const SampleFilmRun<2> sample;
  const Film film = make_film(sample.run, "film-3", plenty);
  ASSERT_TRUE(film.json.is_object());
  EXPECT_TRUE(film.faults.empty());
  const SeenFilm seen{film};
  ASSERT_EQ(seen.frames(), 7u);
  ASSERT_EQ(seen.count(), 32u);
  const Real half_step = film.json["step"].get<Real>() / 2 * (1 + 1e-6);
  EXPECT_LT(half_step, 0.5 / 65535 / 2 * 1.01);  // the bed is less than 0.5 m wide
  const auto x = seen.places(0), y = seen.places(1);
  const auto strain = seen.values("deviatoric_strain"), stress = seen.values("mean_stress"), speed = seen.values("speed"),
             moved = seen.values("displacement");
  const auto near = [&](const std::string& name, Real value, Real wanted) {
    const Real high = (*seen.field(name))["high"];
    EXPECT_NEAR(value, std::min(wanted, high), seen.level(name) / 2 * (1 + 1e-5) + 1e-6 * high) << name;
  };
  for (Index f = 0; f < 7; ++f) {
    const auto particles = particles_of(sample.frame(f));
    for (std::size_t k = 0; k < 32; ++k) {
      const run_folder::FrameParticle<2>& p = particles[k];
      EXPECT_NEAR(x[f][k], p.particle.x[0], half_step);
      EXPECT_NEAR(y[f][k], p.particle.x[1], half_step);
      near("deviatoric_strain", strain[f][k], p.strain.deviatoric);
      near("mean_stress", stress[f][k], static_cast<Real>(k + 1) + 0.01 * f);  // kPa, compression positive
      near("speed", speed[f][k], p.particle.v.norm());
      near("displacement", moved[f][k], 1000 * p.displacement.norm());
    }
  }
}

TEST(film, tells_what_the_history_tells_of_each_frame)
{
  const SampleFilmRun<2> sample;
  const Film film = make_film(sample.run, "f", plenty);
  for (Index f = 0; f < 7; ++f) {
    const auto& frame = film.json["frames"][f];
    EXPECT_EQ(frame["time"], sample.time(f));
    EXPECT_EQ(frame["stage"], sample.stage(f));
    EXPECT_NEAR(frame["u"], sample.u(f), 1e-15);
    EXPECT_NEAR(frame["w"], sample.w(f), 1e-15);
    EXPECT_EQ(frame["H"], 20. * f);
    EXPECT_EQ(frame["V"], 200. * f);
  }
}

TEST(film, is_the_same_for_any_number_of_threads)
{
  const SampleFilmRun<2> sample;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Film one = make_film(sample.run, "f", plenty);
  omp_set_num_threads(3);
  const Film three = make_film(sample.run, "f", plenty);
  omp_set_num_threads(threads);
  EXPECT_EQ(one.json, three.json);
  ASSERT_EQ(one.blocks.size(), three.blocks.size());
  for (std::size_t k = 0; k < one.blocks.size(); ++k) {
    EXPECT_EQ(one.blocks[k].id, three.blocks[k].id);
    EXPECT_EQ(one.blocks[k].base64, three.blocks[k].base64);
  }
}

TEST(film, sizes_are_the_sides_of_squares)
{
  const SampleFilmRun<2> sample;
  const Film film = make_film(sample.run, "f", plenty);
  const SeenFilm seen{film};
  const auto sizes = numbers_in<std::uint16_t>(seen.bytes(film.json["size"]));
  ASSERT_EQ(sizes.size(), seen.count());
  const Real step = film.json["step"];
  for (const std::uint16_t size : sizes) EXPECT_NEAR(size * step, sample.cell / std::sqrt(2.), step / 2 * (1 + 1e-6));
  EXPECT_TRUE(film.json["triangles"].is_null());
  EXPECT_EQ(film.json["kind"], "particles");
}

TEST(film, incremental_strain_is_per_way_of_the_pipe)
{
  const SampleFilmRun<2> sample;
  const Film film = make_film(sample.run, "f", plenty);
  const SeenFilm seen{film};
  const char* name = "incremental_deviatoric_strain";
  const auto increments = seen.values(name);
  const Real way = std::hypot(0.02, 0.01);  // of the pipe between two frames of the drag, D
  for (Index f = 0; f < 7; ++f)
    for (Index k = 0; k < 32; ++k) {
      const Real change = f == 0 ? 0 : 0.01 * (2 * f - 1) + 0.001 * (k % 8);
      EXPECT_NEAR(increments[f][k], f < sample.settle_frames ? change : change * 0.01 / way, seen.level(name) * 0.501) << f << " " << k;
    }
  EXPECT_NE((*seen.field(name))["label"].get<std::string>().find("per 0.01 D"), std::string::npos);
}

TEST(film, incremental_strain_follows_the_frames_that_are_kept)
{
  const SampleFilmRun<2> sample(13);
  const Film all = make_film(sample.run, "f", plenty), without_spare = make_film(sample.run, "f", size_of(all) - 1);
  const Film film = make_film(sample.run, "f", size_of(without_spare) - 1);
  ASSERT_EQ(film.json["note"], "every 2nd frame; without accumulated deviatoric strain");
  ASSERT_EQ(times_of(film), (std::vector<Real>{0, 1, 2, 3, 4, 5, 6}));  // 2 is the last of its stage, too
  const SeenFilm seen{film};
  const char* name = "incremental_deviatoric_strain";
  const auto increments = seen.values(name);
  const Real way = 2 * std::hypot(0.02, 0.01);
  for (Index k = 0; k < 32; ++k)  // frames 10 to 12 of the run
    EXPECT_NEAR(increments[6][k], (0.01 * (144 - 100) + 0.002 * (k % 8)) * 0.01 / way, seen.level(name) * 0.501);
}

TEST(film, budget_keeps_the_first_the_last_and_the_last_of_each_stage)
{
  const SampleFilmRun<2> sample(24);
  const Film all = make_film(sample.run, "f", plenty);
  EXPECT_TRUE(all.json["note"].is_null());
  const std::size_t size = size_of(make_film(sample.run, "f", size_of(all) - 1));  // without the field that goes before frames do
  for (const std::size_t max : {size - 1, size / 2, size / 3, size / 5}) {
    const Film film = make_film(sample.run, "f", max);
    ASSERT_TRUE(film.json.is_object()) << max;
    EXPECT_LE(size_of(film), max);
    const std::vector<Real> times = times_of(film);
    EXPECT_LT(times.size(), 24u);
    EXPECT_EQ(times.front(), 0);
    EXPECT_EQ(times.back(), sample.time(23));
    EXPECT_NE(std::find(times.begin(), times.end(), sample.time(2)), times.end());  // the last of "settle"
    EXPECT_NE(film.json["note"].get<std::string>().find("every "), std::string::npos);
    EXPECT_EQ(SeenFilm{film}.places(0).size(), times.size());
  }
}

TEST(film, where_the_fewest_frames_are_too_large_fields_go_and_then_the_film)
{
  const SampleFilmRun<2> sample(2);
  const Film few = make_film(sample.run, "f", size_of(make_film(sample.run, "f", plenty)) - 1);
  ASSERT_TRUE(few.json.is_object());
  const SeenFilm seen{few};
  EXPECT_NE(seen.field("deviatoric_strain"), nullptr);
  EXPECT_NE(seen.field("speed"), nullptr);
  EXPECT_EQ(seen.field("accumulated_deviatoric_strain"), nullptr);
  EXPECT_EQ(few.json["note"], "without accumulated deviatoric strain");
  EXPECT_EQ(seen.frames(), 2u);

  const Film none_left = make_film(sample.run, "f", 100);
  EXPECT_TRUE(none_left.json.is_null());
  EXPECT_TRUE(none_left.blocks.empty());
  ASSERT_EQ(none_left.faults.size(), 1u);
  EXPECT_NE(none_left.faults[0].find("left out"), std::string::npos);
}

TEST(film, ends_before_a_frame_that_cannot_be_read)
{
  for (const char* name : {"particles_0004.vtu", "rigid_0004.vtu"}) {
    const SampleFilmRun<2> sample;
    const auto film_ends = [&] {
      const Film film = make_film(sample.run, "f", plenty);
      EXPECT_EQ(times_of(film), (std::vector<Real>{0, 0.5, 1, 1.5}));
      EXPECT_EQ(SeenFilm{film}.values("speed").size(), 4u);
      ASSERT_EQ(film.faults.size(), 1u);
      EXPECT_EQ(film.faults[0].find("frame 5 of 7 cannot be read: "), 0u) << film.faults[0];
      EXPECT_NE(film.faults[0].find(name), std::string::npos) << film.faults[0];
      EXPECT_NE(film.faults[0].find("; the film ends before it"), std::string::npos) << film.faults[0];
    };
    std::filesystem::resize_file(sample.file(name), std::filesystem::file_size(sample.file(name)) - 400);
    film_ends();
    std::filesystem::remove(sample.file(name));
    film_ends();
  }
}

TEST(film, ends_before_a_frame_with_other_particles)
{
  const SampleFilmRun<2> sample, larger(1);
  run_folder::Frame<2> other = sample.frame(0);
  other.id[5] = 77;
  run_folder::FrameWriter<2>(larger.folder / "frames", make_box<2>(std::get<mesh::BoxMesh>(larger.run.settings.mesh))).write(other);
  std::filesystem::copy_file(larger.file("particles_0000.vtu"), sample.file("particles_0002.vtu"),
                             std::filesystem::copy_options::overwrite_existing);
  const Film film = make_film(sample.run, "f", plenty);
  EXPECT_EQ(times_of(film), (std::vector<Real>{0, 0.5}));
  ASSERT_EQ(film.faults.size(), 1u);
  EXPECT_NE(film.faults[0].find("other particles"), std::string::npos) << film.faults[0];
}

TEST(film, without_a_first_frame_or_a_sound_list_there_is_none_and_it_says_why)
{
  const SampleFilmRun<2> sample;
  std::filesystem::remove(sample.file("particles_0000.vtu"));
  Film film = make_film(sample.run, "f", plenty);
  EXPECT_TRUE(film.json.is_null());
  ASSERT_EQ(film.faults.size(), 1u);
  EXPECT_NE(film.faults[0].find("frame 1 of 7"), std::string::npos) << film.faults[0];
  std::filesystem::resize_file(sample.file("frames.pvd"), 100);
  film = make_film(sample.run, "f", plenty);
  EXPECT_TRUE(film.json.is_null());
  ASSERT_EQ(film.faults.size(), 1u);
  EXPECT_NE(film.faults[0].find("frames.pvd"), std::string::npos) << film.faults[0];
}

TEST(film, of_a_run_without_frames_is_null)
{
  const TemporaryFolder folder;
  record::RunRecord run;
  run.folder = folder.path();
  const Film film = make_film(run, "f", plenty);
  EXPECT_TRUE(film.json.is_null());
  EXPECT_TRUE(film.blocks.empty());
  EXPECT_TRUE(film.faults.empty());
}

TEST(film, without_a_pipe_shows_all_the_soil_and_plain_increments)
{
  const SampleFilmRun<2> sample(5, false);
  const Film film = make_film(sample.run, "f", plenty);
  ASSERT_TRUE(film.json.is_object());
  EXPECT_TRUE(film.faults.empty());
  EXPECT_TRUE(film.json["rigids"].empty());
  for (const auto& frame : film.json["frames"])
    for (const char* name : {"u", "w", "H", "V"}) EXPECT_TRUE(frame[name].is_null()) << name;
  const SeenFilm seen{film};
  const auto x = seen.places(0), y = seen.places(1), increments = seen.values("incremental_deviatoric_strain");
  const auto &lower = film.json["view"]["lower"], &upper = film.json["view"]["upper"];
  for (std::size_t f = 0; f < 5; ++f)
    for (std::size_t k = 0; k < 32; ++k) {
      EXPECT_TRUE(lower[0] <= x[f][k] && x[f][k] <= upper[0] && lower[1] <= y[f][k] && y[f][k] <= upper[1]);
      const Real change = f == 0 ? 0 : 0.01 * (2. * static_cast<Real>(f) - 1) + 0.001 * static_cast<Real>(k % 8);
      EXPECT_NEAR(increments[f][k], change, seen.level("incremental_deviatoric_strain") * 0.501);
    }
  EXPECT_NEAR(upper[0].get<Real>() - lower[0].get<Real>(), 7 * sample.cell + 0.016 + 0.00028 + sample.cell / std::sqrt(2.), 1e-3);
  EXPECT_EQ((*seen.field("incremental_deviatoric_strain"))["label"], "deviatoric strain of displacement since the frame before");
}

TEST(film, without_a_history_still_shows_the_soil)
{
  SampleFilmRun<2> sample;
  sample.run.history = {};
  const Film film = make_film(sample.run, "f", plenty);
  ASSERT_EQ(film.json["frames"].size(), 7u);
  EXPECT_EQ(film.json["frames"][3]["stage"], "");
  EXPECT_TRUE(film.json["frames"][3]["u"].is_null());
}

TEST(film, of_a_soil_that_never_moves_has_ranges)
{
  SampleFilmRun<2> sample(1);
  const Film film = make_film(sample.run, "f", plenty);
  ASSERT_EQ(film.json["frames"].size(), 1u);
  for (const auto& field : film.json["fields"]) EXPECT_LT(field["low"].get<Real>(), field["high"].get<Real>()) << field["name"];
}

TEST(film, outline_of_the_pipe_moves_with_it)
{
  const SampleFilmRun<2> sample;
  const Film film = make_film(sample.run, "f", plenty);
  ASSERT_EQ(film.json["rigids"].size(), 1u);
  const auto& rigid = film.json["rigids"][0];
  EXPECT_EQ(rigid["name"], "pipe <1>");
  const std::size_t points = rigid["points"];
  const auto corners = numbers_in<float>(SeenFilm{film}.bytes(rigid["block"]));
  ASSERT_EQ(corners.size(), 2 * points * 7);
  const Vec<2> lower(film.json["lower"][0].get<Real>(), film.json["lower"][1].get<Real>());  // corners count from it
  for (Index f = 0; f < 7; ++f)
    for (std::size_t k = 0; k < points; ++k) {
      const float* corner = &corners[2 * (f * points + k)];
      const Vec<2> center(sample.u(f), sample.D / 2 - sample.w(f));
      EXPECT_NEAR((lower + Vec<2>(corner[0], corner[1]) - center).norm(), sample.D / 2, 3e-8);  // single precision of 0.3 m
    }
}

TEST(film, in_space_is_the_slice_in_the_middle)
{
  const SampleFilmRun<3> sample;
  const Film film = make_film(sample.run, "f", plenty);
  ASSERT_TRUE(film.json.is_object());
  EXPECT_NE(film.json["note"].get<std::string>().find("slice in the middle"), std::string::npos);
  const SeenFilm seen{film};
  ASSERT_EQ(seen.count(), 64u);  // of four layers 0.025 m apart the two that are 0.0125 m from the middle; particles are 0.02 m wide
  const Real step = film.json["step"], half_step = step / 2 * (1 + 1e-6);
  const auto x = seen.places(0), y = seen.places(1);
  for (Index f = 0; f < 7; ++f) {
    const auto particles = particles_of(sample.frame(f));
    for (std::size_t k = 0; k < 64; ++k) {
      const run_folder::FrameParticle<3>& p = particles[32 + k];
      EXPECT_NEAR(x[f][k], p.particle.x[0], half_step);
      EXPECT_NEAR(y[f][k], p.particle.x[1], half_step);
    }
  }
  for (const std::uint16_t size : numbers_in<std::uint16_t>(seen.bytes(film.json["size"]))) EXPECT_NEAR(size * step, 0.02, half_step);
  ASSERT_EQ(film.json["rigids"].size(), 1u);
  const std::size_t points = film.json["rigids"][0]["points"];
  const auto corners = numbers_in<float>(seen.bytes(film.json["rigids"][0]["block"]));
  ASSERT_EQ(corners.size(), 2 * points * 7);
  const Vec<2> lower(film.json["lower"][0].get<Real>(), film.json["lower"][1].get<Real>());  // corners count from it
  for (std::size_t k = 0; k < points; ++k)
    EXPECT_NEAR((lower + Vec<2>(corners[2 * k], corners[2 * k + 1] - 0.01)).norm(), 0.01, 3e-8);  // single precision of 0.3 m
}

// A field that no line of the report knows: a law's, in kPa and with a name that a page must not take for markup.
TEST(film, lists_every_field_that_the_frames_hold_with_its_label_and_unit)
{
  const SampleFilmRun<2> sample;
  run_folder::FrameWriter<2> writer(sample.folder / "frames", make_box<2>(std::get<mesh::BoxMesh>(sample.run.settings.mesh)));
  for (Index f = 0; f < 7; ++f) {
    run_folder::Frame<2> frame = sample.frame(f);
    run_folder::FieldValues<Real> suction{{"suction", "suction <\"&>", "Pa"}, std::vector<Real>(frame.points.size(), 0)};
    for (std::size_t k = 0; k < suction.values.size(); ++k) suction.values[k] = 1000. * static_cast<Real>(f) - 2000;
    frame.fields.push_back(suction);
    writer.write(frame);
  }
  const Film film = make_film(sample.run, "f", plenty);
  const SeenFilm seen{film};
  const auto* field = seen.field("suction");
  ASSERT_NE(field, nullptr);
  EXPECT_EQ((*field)["label"], "suction <\"&>");
  EXPECT_EQ((*field)["unit"], "kPa");
  EXPECT_EQ((*field)["low"], -2);
  EXPECT_EQ((*field)["high"], 4);
  for (Index f = 0; f < 7; ++f) EXPECT_NEAR(seen.values("suction")[f][3], f - 2, seen.level("suction") * 0.501);
  EXPECT_EQ(seen.field("volumetric_strain"), nullptr) << "it is zero in all frames";
}

TEST(film, of_finite_elements_is_of_triangles_without_speed)
{
  SampleFilmRun<2> sample(1, false);
  sample.run.settings.method = settings::Method::fem;
  std::vector<run_folder::FrameParticle<2>> nodes;
  for (int k = 0; k < 9; ++k) {
    run_folder::FrameParticle<2> p{{}, 0, Vec<2>::Zero(), {}, 0};
    p.particle.x = Vec<2>(0.1 * (k % 3), 0.1 * static_cast<Real>(k / 3));
    p.particle.id = k;
    p.strain.deviatoric = 0.1;
    nodes.push_back(p);
  }
  run_folder::Frame<2> frame = frame_of(nodes);
  frame.triangles = {{0, 2, 8, 1, 5, 4}, {0, 8, 6, 4, 7, 3}};
  run_folder::FrameWriter<2>(sample.folder / "frames", make_box<2>(std::get<mesh::BoxMesh>(sample.run.settings.mesh))).write(frame);
  const Film film = make_film(sample.run, "f", plenty);
  EXPECT_EQ(film.json["kind"], "triangles");
  EXPECT_TRUE(film.json["size"].is_null());
  EXPECT_EQ(film.json["elements"], 4);
  const SeenFilm seen{film};
  EXPECT_EQ(seen.field("speed"), nullptr);
  const auto corners = numbers_in<std::uint32_t>(seen.bytes(film.json["triangles"]));
  const auto x = seen.places(0)[0], y = seen.places(1)[0];
  ASSERT_EQ(corners.size(), 24u);
  for (std::size_t t = 0; t < 8; ++t) {  // each a quarter of its element's area, corners counter-clockwise
    const auto a = corners[3 * t], b = corners[3 * t + 1], c = corners[3 * t + 2];
    EXPECT_NEAR((x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]), 0.04 / 4, 1e-5);
  }
}

TEST(film, of_the_whole_in_space_holds_all_particles_and_the_surface_of_the_pipe)
{
  const SampleFilmRun<3> sample;
  const Film film = make_film(sample.run, "f", plenty);
  ASSERT_TRUE(film.json["space"].is_object());
  const Film whole{film.json["space"], film.blocks, {}};
  const SeenFilm seen{whole};
  ASSERT_EQ(seen.count(), 128u);
  EXPECT_TRUE(whole.json["note"].is_null());
  EXPECT_EQ(whole.json["forces"], "N");
  const Real half_step = whole.json["step"].get<Real>() / 2 * (1 + 1e-6);
  const std::vector<std::vector<Real>> places[] = {seen.places(0), seen.places(1), seen.places(2)};
  for (Index f = 0; f < 7; ++f) {
    const auto particles = particles_of(sample.frame(f));
    for (std::size_t k = 0; k < 128; ++k)
      for (int d = 0; d < 3; ++d) EXPECT_NEAR(places[d][f][k], particles[k].particle.x[d], half_step);
  }

  ASSERT_EQ(whole.json["surfaces"].size(), 1u);
  const auto& surface = whole.json["surfaces"][0];
  EXPECT_EQ(surface["name"], "pipe <1>");
  const std::size_t points = surface["points"];
  const auto codes = decoded_places(seen.bytes(surface["position"]), 7, points, 3);
  const Real step = surface["step"];
  for (Index f = 0; f < 7; ++f)
    for (std::size_t k = 0; k < points; ++k) {
      const auto corner = [&](int d) { return surface["lower"][d].get<Real>() + step * codes[d][f][k]; };
      const Real away = std::hypot(corner(0) - sample.u(f), corner(1) - (sample.D / 2 - sample.w(f)));
      EXPECT_LE(away, sample.D / 2 + 2 * step);  // the circle's own corners; those of its ends' middles lie inside
    }
}

TEST(film, particles_that_are_too_many_in_space_are_thinned_and_stand_for_their_neighbours)
{
  const SampleFilmRun<3> sample;
  const std::vector<run_folder::FrameFiles> files = run_folder::frame_files(sample.folder / "frames");
  const FilmReader all(files, 3, "", false, FilmPart::whole), some(files, 3, "", false, FilmPart::whole, 43);
  EXPECT_EQ(all.one_of(), 1);
  EXPECT_EQ(all.count(), 128u);
  EXPECT_EQ(some.one_of(), 3);
  EXPECT_NEAR(static_cast<Real>(some.count()), 128. / 3, 3 * std::sqrt(128. * 2 / 9));  // three standard deviations of a choice at random
  EXPECT_NEAR(some.sizes().front(), all.sizes().front() * std::cbrt(3.), 1e-6);
  EXPECT_EQ(some.read(files.front()).z.size(), some.count());
}

}  // namespace
}  // namespace berm::report::this_file
