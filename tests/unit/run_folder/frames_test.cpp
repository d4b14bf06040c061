// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/frames.hpp"

#include "samples/run_to_write.hpp"
#include "samples/unpacked_vtu.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <regex>

namespace berm::run_folder::this_file {
namespace {

/// A .vtu file read back without the writer's code: the arrays by name, their types, and whether the blocks lie end to end.
struct ReadVtu {
  struct Array {
    std::string type;
    int components = 1;
    std::string bytes;
  };
  std::map<std::string, Array> arrays;
  int points = 0, cells = 0;
  bool tight = true;  ///< every block begins where the one before ends, and the last ends at the closing tag

  explicit ReadVtu(const std::filesystem::path& path)
  {
    const std::string text = unpacked_vtu(content_of(path)), mark = "<AppendedData encoding=\"raw\">\n_";
    const std::size_t data = text.find(mark);
    if (data == std::string::npos) throw std::runtime_error("no appended data in " + path.string());
    const std::string header = text.substr(0, data);
    std::smatch found;
    if (!std::regex_search(
            header, found,
            std::regex("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">")))
      throw std::runtime_error("no header in " + path.string());
    std::regex_search(header, found, std::regex("NumberOfPoints=\"(\\d+)\" NumberOfCells=\"(\\d+)\""));
    points = std::stoi(found[1]);
    cells = std::stoi(found[2]);
    const std::regex tag("<DataArray type=\"(\\w+)\" Name=\"(\\w+)\"([^>]*) offset=\"(\\d+)\"/>"),
        components("NumberOfComponents=\"(\\d+)\"");
    std::size_t end = 0;
    for (std::sregex_iterator k(header.begin(), header.end(), tag), none_left; k != none_left; ++k) {
      const std::size_t offset = std::stoul((*k)[4]), at = data + mark.size() + offset;
      std::uint64_t size = 0;
      std::memcpy(&size, text.data() + at, 8);
      Array& array = arrays[(*k)[2]];
      array.type = (*k)[1];
      const std::string rest = (*k)[3];
      if (std::regex_search(rest, found, components)) array.components = std::stoi(found[1]);
      array.bytes = text.substr(at + 8, size);
      tight = tight && offset == end && array.bytes.size() == size;
      end = offset + 8 + size;
    }
    tight = tight && text.substr(data + mark.size() + end) == "\n</AppendedData>\n</VTKFile>\n";
  }

  template <class T>
  std::vector<T> numbers(const std::string& name) const
  {
    const std::string& bytes = arrays.at(name).bytes;
    std::vector<T> list(bytes.size() / sizeof(T));
    std::memcpy(list.data(), bytes.data(), bytes.size());
    return list;
  }
};

template <int dim>
void move_all(problem::Problem<dim>& problem, const Vec<dim>& by, Real strain)
{
  for (auto& particles : problem.state.particles)
    for (Index cell = 0; cell < problem.model.mesh.cell_count(); ++cell) {
      std::vector<bodies::Particle<dim>> taken;
      while (particles.count_in(cell) > 0) taken.push_back(particles.take(cell, 0));
      for (bodies::Particle<dim>& p : taken) {
        p.x += by;
        p.deviatoric_strain += strain;
        particles.insert(cell, p);
      }
    }
}

template <class T>
class FramesIn : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(FramesIn, Dimensions);

TYPED_TEST(FramesIn, particles_read_back_by_body_then_id_with_every_field)
{
  constexpr int dim = TypeParam::value;
  const TemporaryFolder folder;
  problem::Problem<dim> problem = sample_problem<dim>();
  SampleFrames<dim> frames(folder.path() / "frames", problem);
  frames.write(problem.state);
  const Vec<dim> by = Vec<dim>::Constant(0.001);
  move_all<dim>(problem, by, 0.25);
  problem.state.time = 1.5;
  frames.write(problem.state);

  const ReadVtu vtu(folder.path() / "frames" / "particles_0001.vtu");
  const int count = problem.state.particles[0].size() + problem.state.particles[1].size();
  EXPECT_TRUE(vtu.tight);
  ASSERT_EQ(vtu.points, count);
  ASSERT_EQ(vtu.cells, count);
  EXPECT_EQ(vtu.arrays.at("Points").type, "Float64");
  EXPECT_EQ(vtu.arrays.at("stress").components, 6);
  EXPECT_EQ(vtu.numbers<double>("TimeValue"), std::vector<double>{1.5});
  const auto body = vtu.numbers<std::int32_t>("body"), id = vtu.numbers<std::int32_t>("id");
  const auto velocity = vtu.numbers<float>("velocity"), stress = vtu.numbers<float>("stress"), mean = vtu.numbers<float>("mean_stress"),
             moved_by = vtu.numbers<float>("displacement"), strain = vtu.numbers<float>("deviatoric_strain"),
             volumetric = vtu.numbers<float>("volumetric_strain"), increment = vtu.numbers<float>("incremental_deviatoric_strain"),
             accumulated = vtu.numbers<float>("accumulated_deviatoric_strain"), volume = vtu.numbers<float>("volume");
  const auto connectivity = vtu.numbers<std::int64_t>("connectivity"), offsets = vtu.numbers<std::int64_t>("offsets");
  const auto types = vtu.numbers<std::uint8_t>("types");
  for (int k = 0; k < count; ++k) {
    const int b = k < problem.state.particles[0].size() ? 0 : 1, i = k - (b == 1 ? problem.state.particles[0].size() : 0);
    ASSERT_EQ(body[k], b);
    ASSERT_EQ(id[k], i);
    EXPECT_EQ(connectivity[k], k);
    EXPECT_EQ(offsets[k], k + 1);
    EXPECT_EQ(types[k], 1);
    for (int d = 0; d < 3; ++d) {
      EXPECT_FLOAT_EQ(velocity[3 * k + d], d < dim ? static_cast<float>(100 * b + i + 0.25 * d) : 0);
      EXPECT_NEAR(moved_by[3 * k + d], d < dim ? 0.001 : 0, 1e-9);  // single precision of 0.001
    }
    for (int c = 0; c < 6; ++c) EXPECT_FLOAT_EQ(stress[6 * k + c], c < tensor_size<dim> ? static_cast<float>(10 * i + c) : 0);
    EXPECT_FLOAT_EQ(mean[k], static_cast<float>(10 * i + 1));
    EXPECT_FLOAT_EQ(accumulated[k], static_cast<float>(0.5 * i + 0.25));
    for (const float zero : {strain[k], volumetric[k], increment[k]}) EXPECT_NEAR(zero, 0, 1e-12);  // all soil moves as one
    EXPECT_FLOAT_EQ(volume[k], static_cast<float>(1 + i));
  }
}

TYPED_TEST(FramesIn, positions_are_exact_and_the_mesh_is_there)
{
  constexpr int dim = TypeParam::value;
  const TemporaryFolder folder;
  const problem::Problem<dim> problem = sample_problem<dim>();
  SampleFrames<dim> frames(folder.path(), problem);
  frames.write(problem.state);
  const ReadVtu particles(folder.path() / "particles_0000.vtu"), mesh(folder.path() / "mesh.vtu");
  const auto x = particles.numbers<double>("Points");
  for (std::size_t k = 0; k < frames.last().points.size(); ++k)
    for (int d = 0; d < 3; ++d) EXPECT_EQ(x[3 * k + d], d < dim ? frames.last().points[k][d] : 0);
  EXPECT_TRUE(mesh.tight);
  EXPECT_EQ(mesh.points, problem.model.mesh.node_count());
  EXPECT_EQ(mesh.cells, problem.model.mesh.cell_count());
  EXPECT_EQ(mesh.numbers<std::int64_t>("offsets").back(), (dim + 1) * mesh.cells);
  EXPECT_EQ(mesh.numbers<std::int32_t>("region").size(), static_cast<std::size_t>(mesh.cells));
}

TYPED_TEST(FramesIn, rigid_bodies_move_with_their_displacement)
{
  constexpr int dim = TypeParam::value;
  const TemporaryFolder folder;
  problem::Problem<dim> problem = sample_problem<dim>();
  SampleFrames<dim> frames(folder.path(), problem);
  problem.state.rigid_bodies[0].displacement[0] = 0.03;
  frames.write(problem.state);
  const ReadVtu vtu(folder.path() / "rigid_0000.vtu");
  EXPECT_TRUE(vtu.tight);
  const auto x = vtu.numbers<double>("Points");
  const auto rigid = vtu.numbers<std::int32_t>("rigid");
  EXPECT_EQ(rigid.front(), 0);
  EXPECT_EQ(rigid.back(), 2);
  for (int k = 0; k < (dim == 2 ? 128 : 256); ++k)
    EXPECT_NEAR(std::hypot(x[3 * k] - 0.13, x[3 * k + 1] - 0.05), 0.02, 1e-12);  // the circle's centre is at (0.1, 0.05)
  for (const auto corner : vtu.numbers<std::int64_t>("connectivity")) EXPECT_LT(corner, vtu.points);
}

TYPED_TEST(FramesIn, the_collection_lists_every_frame_and_every_file_it_lists_is_there)
{
  constexpr int dim = TypeParam::value;
  const TemporaryFolder folder;
  problem::Problem<dim> problem = sample_problem<dim>();
  SampleFrames<dim> frames(folder.path(), problem);
  for (int k = 0; k < 3; ++k) {
    problem.state.time = 0.125 * k;
    frames.write(problem.state);
    frames.write(problem.state);  // the same time: nothing new
    EXPECT_EQ(frames.count(), static_cast<std::size_t>(k + 1));
    const std::string pvd = content_of(folder.path() / "frames.pvd");
    EXPECT_EQ(pvd.rfind("</VTKFile>\n"), pvd.size() - 11);
    const std::regex entry("<DataSet timestep=\"([^\"]+)\" part=\"(\\d)\" name=\"(\\w+)\" file=\"([^\"]+)\"/>");
    int entries = 0;
    for (std::sregex_iterator e(pvd.begin(), pvd.end(), entry), none_left; e != none_left; ++e, ++entries) {
      EXPECT_EQ(std::stod((*e)[1]), 0.125 * (entries / 2));
      EXPECT_TRUE(std::filesystem::exists(folder.path() / std::string((*e)[4])));
    }
    EXPECT_EQ(entries, 2 * (k + 1));
  }
}

TEST(Frames, without_rigid_bodies_there_is_no_rigid_file)
{
  const TemporaryFolder folder;
  problem::Problem<2> problem = sample_problem<2>();
  problem.model.rigid_bodies.clear();
  problem.state.rigid_bodies.clear();
  SampleFrames<2> frames(folder.path(), problem);
  frames.write(problem.state);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "rigid_0000.vtu"));
  EXPECT_EQ(content_of(folder.path() / "frames.pvd").find("rigid"), std::string::npos);
}

TEST(Frames, of_finite_elements_are_quadratic_triangles_with_every_field_at_their_nodes)
{
  const TemporaryFolder folder;
  FrameWriter<2> frames(folder.path(), sample_problem<2>().model.mesh);
  Frame<2> frame = two_triangles();
  frames.write(frame);
  frame.time = 0.5;
  frames.write(frame);
  EXPECT_EQ(frames.times(), (std::vector<Real>{0, 0.5}));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "particles_0000.vtu"));
  const std::string pvd = content_of(folder.path() / "frames.pvd");
  for (const char* name : {"soil_0000.vtu", "soil_0001.vtu"}) EXPECT_NE(pvd.find(name), std::string::npos) << name;

  const ReadVtu vtu(folder.path() / "soil_0001.vtu");
  EXPECT_TRUE(vtu.tight);
  ASSERT_EQ(vtu.points, 9);
  ASSERT_EQ(vtu.cells, 2);
  EXPECT_EQ(vtu.numbers<std::uint8_t>("types"), (std::vector<std::uint8_t>{22, 22}));
  EXPECT_EQ(vtu.numbers<std::int64_t>("offsets"), (std::vector<std::int64_t>{6, 12}));
  EXPECT_EQ(vtu.numbers<std::int64_t>("connectivity"), (std::vector<std::int64_t>{0, 2, 8, 1, 5, 4, 0, 8, 6, 4, 7, 3}));
  EXPECT_EQ(vtu.numbers<double>("TimeValue"), std::vector<double>{0.5});
  EXPECT_EQ(vtu.numbers<float>("velocity"), std::vector<float>(27, 0));
  EXPECT_EQ(vtu.numbers<std::int32_t>("body"), std::vector<std::int32_t>(9, 0));
  const auto x = vtu.numbers<double>("Points");
  const auto nodes = particles_of(frame);
  for (std::size_t k = 0; k < 9; ++k) {
    const FrameParticle<2>& f = nodes[k];
    EXPECT_EQ(x[3 * k], f.particle.x[0]);
    EXPECT_EQ(x[3 * k + 1], f.particle.x[1]);
    EXPECT_EQ(vtu.numbers<float>("displacement")[3 * k], static_cast<float>(0.001 * static_cast<Real>(k)));
    EXPECT_EQ(vtu.numbers<float>("stress")[6 * k + 3], static_cast<float>(10 * k + 3));
    EXPECT_EQ(vtu.numbers<float>("mean_stress")[k], static_cast<float>(10 * k + 1));
    EXPECT_EQ(vtu.numbers<float>("deviatoric_strain")[k], static_cast<float>(f.strain.deviatoric));
    EXPECT_EQ(vtu.numbers<float>("volumetric_strain")[k], static_cast<float>(f.strain.volumetric));
    EXPECT_EQ(vtu.numbers<float>("incremental_deviatoric_strain")[k], 0.25f);
    EXPECT_EQ(vtu.numbers<float>("accumulated_deviatoric_strain")[k], static_cast<float>(f.particle.deviatoric_strain));
    EXPECT_EQ(vtu.numbers<float>("volume")[k], static_cast<float>(0.04 / 9));
    EXPECT_EQ(vtu.numbers<std::int32_t>("id")[k], static_cast<std::int32_t>(k));
  }
}

TEST(Frames, rigid_bodies_have_their_velocities)
{
  const TemporaryFolder folder;
  problem::Problem<2> problem = sample_problem<2>();
  for (std::size_t r = 0; r < 3; ++r) problem.state.rigid_bodies[r].velocity = Vec<2>(static_cast<Real>(r), -0.5);
  SampleFrames<2> frames(folder.path(), problem);
  frames.write(problem.state);
  const ReadVtu vtu(folder.path() / "rigid_0000.vtu");
  const auto rigid = vtu.numbers<std::int32_t>("rigid");
  const auto velocity = vtu.numbers<float>("velocity");
  ASSERT_EQ(velocity.size(), 3 * rigid.size());
  for (std::size_t k = 0; k < rigid.size(); ++k) {
    EXPECT_EQ(velocity[3 * k], static_cast<float>(rigid[k]));
    EXPECT_EQ(velocity[3 * k + 1], -0.5f);
  }
}

}  // namespace
}  // namespace berm::run_folder::this_file
