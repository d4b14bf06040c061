// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/frame_reader.hpp"

#include "os/error.hpp"
#include "samples/run_to_write.hpp"
#include "samples/unpacked_vtu.hpp"

#include <gtest/gtest.h>
#include <map>
#include <random>

namespace berm::run_folder::this_file {
namespace {

std::string refusal_of(const std::filesystem::path& file)
{
  try {
    file.filename().string().starts_with("rigid") ? static_cast<void>(read_rigids(file)) : static_cast<void>(read_soil(file));
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

/// A folder of two frames, as sample_problem makes them.
template <int dim>
struct WrittenFrames {
  TemporaryFolder folder;
  problem::Problem<dim> problem = sample_problem<dim>();
  SampleFrames<dim> frames{folder.path(), problem};
  WrittenFrames()
  {
    frames.write(problem.state);
    problem.state.time = 0.1 + 0.2;  // not a short number
    frames.write(problem.state);
  }
};

template <class T>
class FrameReaderIn : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(FrameReaderIn, Dimensions);

TYPED_TEST(FrameReaderIn, soil_reads_back_as_it_was_written)
{
  constexpr int dim = TypeParam::value;
  const WrittenFrames<dim> written;
  const std::vector<FrameFiles> files = frame_files(written.folder.path());
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].time, 0);
  EXPECT_EQ(files[1].time, 0.1 + 0.2);
  const SavedSoil soil = read_soil(files[1].soil);
  const auto particles = particles_of(written.frames.last());
  ASSERT_EQ(soil.x.size(), particles.size());
  EXPECT_TRUE(soil.triangles.empty());
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const bodies::Particle<dim>& p = particles[k].particle;
    EXPECT_EQ(soil.x[k], p.x[0]);
    EXPECT_EQ(soil.y[k], p.x[1]);
    EXPECT_EQ(soil.z[k], dim == 3 ? p.x[dim - 1] : 0);
    for (int d = 0; d < 3; ++d) {
      EXPECT_EQ(soil["velocity"][3 * k + d], d < dim ? static_cast<float>(p.v[d]) : 0);
      EXPECT_EQ(soil["displacement"][3 * k + d], 0);
    }
    EXPECT_EQ(soil["mean_stress"][k], static_cast<float>(trace(p.stress) / 3));
    EXPECT_EQ(soil.volume[k], static_cast<float>(p.volume));
    EXPECT_EQ(soil.id[k], p.id);
    EXPECT_EQ(soil.body[k], particles[k].body);
  }
}

TYPED_TEST(FrameReaderIn, rigid_bodies_read_back_with_their_cells)
{
  constexpr int dim = TypeParam::value;
  const WrittenFrames<dim> written;
  const SavedRigids rigid_bodies = read_rigids(frame_files(written.folder.path())[0].rigid);
  using Kind = typename bodies::SurfaceMesh<dim>::Kind;
  const std::map<Kind, run_folder::VtkCell> vtk = {{Kind::line, run_folder::VtkCell::line},
                                                   {Kind::polygon, run_folder::VtkCell::polygon},
                                                   {Kind::quad, run_folder::VtkCell::quad},
                                                   {Kind::hexahedron, run_folder::VtkCell::hexahedron}};
  std::size_t cell = 0, first = 0;
  for (std::size_t r = 0; r < 3; ++r) {
    const bodies::SurfaceMesh<dim>& surface = written.frames.last().rigid_bodies[r].surface;
    for (const auto& wanted : surface.cells) {
      ASSERT_LT(cell, rigid_bodies.cells.size());
      EXPECT_EQ(rigid_bodies.rigid[cell], static_cast<std::int32_t>(r));
      EXPECT_EQ(rigid_bodies.types[cell], vtk.at(wanted.kind));
      ASSERT_EQ(rigid_bodies.cells[cell].size(), wanted.points.size());
      for (std::size_t k = 0; k < wanted.points.size(); ++k) {
        const Vec<dim>& x = surface.points[wanted.points[k]];
        const Index at = rigid_bodies.cells[cell][k];
        ASSERT_EQ(at, static_cast<Index>(first) + wanted.points[k]);
        EXPECT_EQ(rigid_bodies.x[at], x[0]);
        EXPECT_EQ(rigid_bodies.y[at], x[1]);
        EXPECT_EQ(rigid_bodies.z[at], dim == 3 ? x[dim - 1] : 0);
      }
      ++cell;
    }
    first += surface.points.size();
  }
  EXPECT_EQ(cell, rigid_bodies.cells.size());
}

TEST(FrameReader, triangles_read_back)
{
  const TemporaryFolder folder;
  FrameWriter<2>(folder.path(), sample_problem<2>().model.mesh).write(two_triangles());
  const std::vector<FrameFiles> files = frame_files(folder.path());
  ASSERT_EQ(files.size(), 1u);
  EXPECT_TRUE(files[0].rigid.empty());
  const SavedSoil soil = read_soil(files[0].soil);
  EXPECT_EQ(soil.triangles, two_triangles().triangles);
  EXPECT_EQ(soil.x.size(), 9u);
  for (std::size_t k = 0; k < 9; ++k) {
    EXPECT_EQ(soil["deviatoric_strain"][k], static_cast<float>(two_triangles().field("deviatoric_strain").at(k)));
    EXPECT_EQ(soil["incremental_deviatoric_strain"][k], 0.25f);
  }
}

TEST(FrameReader, frames_that_were_not_compressed_read_the_same)
{
  const WrittenFrames<2> written;
  const FrameFiles frame = frame_files(written.folder.path())[1];
  const SavedSoil soil = read_soil(frame.soil);
  const SavedRigids rigids = read_rigids(frame.rigid);
  for (const std::filesystem::path& file : {frame.soil, frame.rigid}) put(file, unpacked_vtu(content_of(file)));
  const SavedSoil same = read_soil(frame.soil);
  EXPECT_EQ(same.x, soil.x);
  EXPECT_EQ(same.y, soil.y);
  EXPECT_EQ(same.volume, soil.volume);
  EXPECT_EQ(same.id, soil.id);
  ASSERT_EQ(same.fields.size(), soil.fields.size());
  for (std::size_t f = 0; f < soil.fields.size(); ++f) EXPECT_EQ(same.fields[f].values, soil.fields[f].values);
  EXPECT_EQ(read_rigids(frame.rigid).cells, rigids.cells);
  EXPECT_EQ(read_rigids(frame.rigid).x, rigids.x);
}

TEST(FrameReader, every_field_reads_back_with_its_label_and_unit)
{
  const TemporaryFolder folder;
  Frame<2> frame = two_triangles();
  frame.fields.push_back({{"suction", "suction <\"&>", "Pa"}, std::vector<Real>(9, 0.5)});
  FrameWriter<2>(folder.path(), sample_problem<2>().model.mesh).write(frame);
  const SavedSoil soil = read_soil(frame_files(folder.path())[0].soil);
  ASSERT_EQ(soil.fields.size(), frame.fields.size());
  for (std::size_t f = 0; f < frame.fields.size(); ++f) {
    const FieldInfo &wanted = frame.fields[f].info, &found = soil.fields[f].info;
    EXPECT_EQ(found.name, wanted.name);
    EXPECT_EQ(found.label, wanted.label);
    EXPECT_EQ(found.unit, wanted.unit);
    EXPECT_EQ(found.components, wanted.components == 2 ? 3 : wanted.components == 4 ? 6 : 1);
  }
  EXPECT_EQ(soil["suction"], std::vector<float>(9, 0.5f));
  EXPECT_THROW(soil["nothing"], RunError);
}

TEST(FrameReader, without_a_collection_there_are_no_frames)
{
  const TemporaryFolder folder;
  EXPECT_TRUE(frame_files(folder.path()).empty());
  EXPECT_TRUE(frame_files(folder.path() / "nowhere").empty());
}

TEST(FrameReader, missing_file_is_named)
{
  const TemporaryFolder folder;
  EXPECT_NE(refusal_of(folder.path() / "particles_0007.vtu").find("particles_0007.vtu"), std::string::npos);
  std::filesystem::create_directory(folder.path() / "rigid_0001.vtu");
  EXPECT_NE(refusal_of(folder.path() / "rigid_0001.vtu").find("rigid_0001.vtu"), std::string::npos);
}

TEST(FrameReader, file_cut_off_anywhere_is_refused_with_its_name)
{
  const WrittenFrames<2> written;
  for (const char* name : {"particles_0001.vtu", "rigid_0001.vtu"}) {
    const std::filesystem::path file = written.folder.path() / name;
    const std::string whole = content_of(file);
    ASSERT_EQ(refusal_of(file), "");
    for (std::size_t length = 0; length < whole.size(); length += 97) {
      put(file, whole.substr(0, length));
      EXPECT_NE(refusal_of(file).find(name), std::string::npos) << "cut at " << length;
    }
    put(file, whole.substr(0, whole.size() - 1));
    EXPECT_NE(refusal_of(file).find(name), std::string::npos);
  }
}

TEST(FrameReader, file_without_its_middle_is_refused)
{
  const WrittenFrames<2> written;
  const std::filesystem::path file = written.folder.path() / "particles_0001.vtu";
  const std::string whole = content_of(file);
  const std::size_t data = whole.find("<AppendedData");
  for (std::size_t at = data + 40; at + 200 < whole.size(); at += 97) {
    put(file, whole.substr(0, at) + whole.substr(at + 64));
    EXPECT_NE(refusal_of(file), "") << "64 bytes missing at " << at;
  }
}

TEST(FrameReader, offsets_and_sizes_beyond_the_file_are_refused)
{
  const WrittenFrames<2> written;
  const std::filesystem::path file = written.folder.path() / "particles_0001.vtu";
  const std::string packed = content_of(file), whole = unpacked_vtu(packed);
  const auto with = [&](const std::string& what, const std::string& instead) {
    const std::size_t at = whole.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    put(file, whole.substr(0, at) + instead + whole.substr(at + what.size()));
    return refusal_of(file);
  };
  EXPECT_NE(with("Name=\"Points\" NumberOfComponents=\"3\" format=\"appended\" offset=\"16\"", "Name=\"Points\" offset=\"999999999\""), "");
  EXPECT_NE(with("format=\"appended\" offset=\"16\"", "offset=\"18446744073709551615\""), "");
  EXPECT_NE(with("format=\"appended\" offset=\"16\"", "offset=\"99999999999999999999999\""), "");
  EXPECT_NE(with("format=\"appended\" offset=\"16\"", "offset=\"-16\""), "");
  EXPECT_NE(with("format=\"appended\" offset=\"16\"", "offset=\"0\""), "");
  EXPECT_NE(with("NumberOfPoints=\"64\"", "NumberOfPoints=\"9223372036854775807\""), "");
  EXPECT_NE(with("NumberOfPoints=\"64\"", "NumberOfPoints=\"63\""), "");
  EXPECT_NE(with("NumberOfCells=\"64\"", "NumberOfCells=\"4611686018427387904\""), "");
  EXPECT_NE(with("type=\"Float64\" Name=\"Points\"", "type=\"Float32\" Name=\"Points\""), "");
  EXPECT_NE(with("Name=\"id\"", "Name=\"di\""), "");
  EXPECT_NE(with("header_type=\"UInt64\"", "header_type=\"UInt32\""), "");

  const std::string mark = "<AppendedData encoding=\"raw\">\n_";
  std::string huge = whole;
  huge.replace(huge.find(mark) + mark.size() + 16, 8, std::string(8, '\xff'));  // the length of Points
  put(file, huge);
  EXPECT_NE(refusal_of(file).find("particles_0001.vtu"), std::string::npos);

  // The same of a compressed file, of Points: how many blocks, size of the last (there is only that one), size of the first block packed.
  const std::size_t offset = packed.find("offset=\"", packed.find("Name=\"Points\"")) + 8;
  const std::size_t points = packed.find(mark) + mark.size() + std::stoul(packed.substr(offset));
  for (const std::size_t place : {0, 16, 24})
    for (const std::string& number : {std::string(8, '\xff'), std::string("\x40\0\0\0\0\0\0\0", 8), std::string(8, '\0')}) {
      std::string broken = packed;
      if (broken.compare(points + place, 8, number) == 0) continue;
      put(file, broken.replace(points + place, 8, number));
      EXPECT_NE(refusal_of(file).find("particles_0001.vtu"), std::string::npos) << place;
    }
  put(file, packed);
  EXPECT_EQ(refusal_of(file), "");
}

TEST(FrameReader, cell_with_points_that_are_not_there_is_refused)
{
  const TemporaryFolder folder;
  FrameWriter<2>(folder.path(), sample_problem<2>().model.mesh).write(two_triangles());
  const std::filesystem::path file = folder.path() / "soil_0000.vtu";
  const std::string whole = unpacked_vtu(content_of(file)), mark = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t connectivity = whole.find(mark) + mark.size() + 16 + 8 + 9 * 24 + 8, offsets = connectivity + 12 * 8 + 8;
  for (const auto& [place, value] : std::vector<std::pair<std::size_t, std::int64_t>>{
           {connectivity, 9}, {connectivity + 8, -1}, {connectivity, std::int64_t{1} << 40}, {offsets, 13}, {offsets, -1}, {offsets, 5}}) {
    std::string broken = whole;
    broken.replace(place, 8, reinterpret_cast<const char*>(&value), 8);
    put(file, broken);
    EXPECT_NE(refusal_of(file).find("soil_0000.vtu"), std::string::npos) << place << " " << value;
  }
}

TEST(FrameReader, coordinate_that_is_no_number_is_refused)
{
  WrittenFrames<2> written;
  bodies::Particle<2> p = written.problem.state.particles[0].take(0, 0);
  p.x[1] = std::numeric_limits<Real>::quiet_NaN();
  written.problem.state.particles[0].insert(0, p);
  written.problem.state.time = 1;
  written.frames.write(written.problem.state);
  EXPECT_NE(refusal_of(written.folder.path() / "particles_0002.vtu").find("a coordinate that is not a finite number"), std::string::npos);
}

TEST(FrameReader, flipped_bits_are_read_as_some_numbers_or_refused)
{
  const WrittenFrames<2> written;
  std::mt19937 random(1);
  for (const char* name : {"particles_0001.vtu", "rigid_0001.vtu"}) {
    const std::filesystem::path file = written.folder.path() / name;
    const std::string whole = content_of(file);
    const std::size_t header = whole.find("<AppendedData");
    for (int attempt = 0; attempt < 800; ++attempt) {
      std::string broken = whole;
      const std::size_t reach = attempt % 2 == 0 ? header : whole.size();
      broken[random() % reach] ^= static_cast<char>(1 << random() % 8);
      put(file, broken);
      const std::string refusal = refusal_of(file);  // throws nothing but a RunError
      EXPECT_TRUE(refusal.empty() || refusal.find(name) != std::string::npos) << refusal;
    }
  }
}

TEST(FrameReader, collection_that_is_damaged_is_refused_with_its_name)
{
  const WrittenFrames<2> written;
  const std::filesystem::path file = written.folder.path() / "frames.pvd";
  const std::string whole = content_of(file);
  const auto refused = [&](const std::string& content) {
    put(file, content);
    try {
      frame_files(written.folder.path());
    } catch (const RunError& error) {
      return std::string(error.what()).find("frames.pvd") != std::string::npos;
    }
    return false;
  };
  EXPECT_FALSE(refused(whole));
  for (std::size_t length = 0; length < whole.size(); length += 7) EXPECT_TRUE(refused(whole.substr(0, length))) << length;
  const auto with = [&](const std::string& what, const std::string& instead) {
    return std::string(whole).replace(whole.find(what), what.size(), instead);
  };
  EXPECT_TRUE(refused(with("timestep=\"0\"", "timestep=\"soon\"")));
  EXPECT_TRUE(refused(with("timestep=\"0\"", "timestep=\"nan\"")));
  EXPECT_TRUE(refused(with("file=\"particles_0000.vtu\"", "file=\"../../elsewhere\"")));
  EXPECT_TRUE(refused(with("part=\"0\"", "part=\"1\"")));
}

}  // namespace
}  // namespace berm::run_folder::this_file
