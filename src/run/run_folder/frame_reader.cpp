// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/frame_reader.hpp"

#include "io/atomic_file.hpp"
#include "os/error.hpp"
#include "run_folder/vtu_file.hpp"
#include "run_folder/xml_tag.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace berm::run_folder {
namespace {

struct Coordinates {
  std::vector<Real> x, y, z;
};

Coordinates coordinates_in(const VtuFile& vtu)
{
  const std::size_t count = vtu.point_count();
  const std::vector<double> points = vtu.numbers<double>("Points", 3 * count);
  Coordinates c{std::vector<Real>(count), std::vector<Real>(count), std::vector<Real>(count)};
  bool finite = true;
  for (std::size_t k = 0; k < count; ++k) {
    c.x[k] = points[3 * k];
    c.y[k] = points[3 * k + 1];
    c.z[k] = points[3 * k + 2];
    finite = finite && std::isfinite(c.x[k]) && std::isfinite(c.y[k]) && std::isfinite(c.z[k]);
  }
  if (!finite) vtu.refuse("a point has a coordinate that is not a finite number");
  return c;
}

/// The points of each cell, all of them points that there are.
std::vector<std::vector<Index>> cells_in(const VtuFile& vtu)
{
  const std::vector<std::int64_t> corners = vtu.numbers<std::int64_t>("connectivity"),
                                  ends = vtu.numbers<std::int64_t>("offsets", vtu.cell_count());
  std::vector<std::vector<Index>> cells;
  std::int64_t begin = 0;
  for (const std::int64_t end : ends) {
    if (end < begin || end > static_cast<std::int64_t>(corners.size())) vtu.refuse("is damaged: a cell has points that are not there");
    std::vector<Index>& cell = cells.emplace_back();
    for (; begin < end; ++begin) {
      const std::int64_t corner = corners[begin];
      if (corner < 0 || corner >= static_cast<std::int64_t>(vtu.point_count()))
        vtu.refuse("is damaged: a cell has points that are not there");
      cell.push_back(static_cast<Index>(corner));
    }
  }
  return cells;
}

std::vector<std::array<Index, 6>> triangles_in(const VtuFile& vtu)
{
  const std::vector<std::uint8_t> types = vtu.numbers<std::uint8_t>("types", vtu.cell_count());
  const auto all = [&](VtkCell wanted) {
    return std::all_of(types.begin(), types.end(), [&](std::uint8_t type) { return type == static_cast<std::uint8_t>(wanted); });
  };
  if (all(VtkCell::vertex) || all(VtkCell::quadratic_tetrahedron)) return {};
  if (!all(VtkCell::quadratic_triangle)) vtu.refuse("is not a file of the soil: its cells are neither particles nor elements");
  std::vector<std::array<Index, 6>> triangles;
  for (const std::vector<Index>& cell : cells_in(vtu)) {
    if (cell.size() != 6) vtu.refuse("is damaged: a triangle does not have six nodes");
    std::copy(cell.begin(), cell.end(), triangles.emplace_back().begin());
  }
  return triangles;
}

}  // namespace

std::vector<FrameFiles> frame_files(const std::filesystem::path& frames_folder)
{
  const std::filesystem::path path = frames_folder / "frames.pvd";
  if (!std::filesystem::exists(path)) return {};
  const std::string text = io::read_text_file(path);
  const auto refuse = [&](const char* words) { throw RunError(fmt::format("{}: {}", path.string(), words)); };
  if (!text.ends_with("</Collection>\n</VTKFile>\n")) refuse("has no end; it was cut off");
  // By time, by travel and at the ends of stages; a case may have 1e5 of the first and of the second.
  constexpr std::size_t most_frames = 300'000;
  std::vector<FrameFiles> frames;
  std::set<std::string> names;
  for (const XmlTag& tag : xml_tags(text, "DataSet")) {
    const std::optional<Real> time = tag.number("timestep");
    const std::string name = tag["file"], part = tag["part"];
    if (!time || name.empty() || name.find_first_of("/\\") != std::string::npos) refuse("is damaged: a frame has no time or no file");
    if (!names.insert(name).second) refuse("is damaged: it names a file twice");
    if (frames.size() == most_frames) refuse("lists more frames than a run has at most");
    if (part == "0")
      frames.push_back({*time, frames_folder / name, {}});
    else if (part == "1" && !frames.empty() && frames.back().rigid.empty() && frames.back().time == *time)
      frames.back().rigid = frames_folder / name;
    else
      refuse("is damaged: a file belongs to no frame");
  }
  return frames;
}

const std::vector<float>& SavedSoil::operator[](const std::string& name) const
{
  const FieldValues<float>* found = find_field(fields, name);
  if (found == nullptr) throw RunError(fmt::format("{}: has no array {}", file.string(), name));
  return found->values;
}

SavedSoil read_soil(const std::filesystem::path& file)
{
  const VtuFile vtu(file);
  const std::size_t count = vtu.point_count();
  SavedSoil soil;
  soil.file = file;
  Coordinates points = coordinates_in(vtu);
  soil.x = std::move(points.x);
  soil.y = std::move(points.y);
  soil.z = std::move(points.z);
  for (const FieldInfo& info : vtu.point_fields())
    if (info.name != "volume")
      soil.fields.push_back({info, vtu.numbers<float>(info.name, static_cast<std::size_t>(info.components) * count)});
  soil.volume = vtu.numbers<float>("volume", count);
  soil.id = vtu.numbers<std::int32_t>("id", count);
  soil.body = vtu.numbers<std::int32_t>("body", count);
  soil.triangles = triangles_in(vtu);
  return soil;
}

SavedRigids read_rigids(const std::filesystem::path& file)
{
  const VtuFile vtu(file);
  SavedRigids rigid_bodies;
  Coordinates points = coordinates_in(vtu);
  rigid_bodies.x = std::move(points.x);
  rigid_bodies.y = std::move(points.y);
  rigid_bodies.z = std::move(points.z);
  rigid_bodies.cells = cells_in(vtu);
  for (const std::uint8_t type : vtu.numbers<std::uint8_t>("types", vtu.cell_count()))
    rigid_bodies.types.push_back(static_cast<VtkCell>(type));
  rigid_bodies.rigid = vtu.numbers<std::int32_t>("rigid", vtu.cell_count());
  return rigid_bodies;
}

}  // namespace berm::run_folder
