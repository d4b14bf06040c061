// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_live_test.cpp
#include "desk/live.hpp"

#include "run_folder/frame_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::desk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_points = 12000;
constexpr std::uintmax_t largest_frame = 256 << 20;

/// As many digits as a picture needs: a page takes half of the bytes.
template <class Values>
Json thinned(const Values& values, std::size_t step)
{
  Json some = Json::array();
  for (std::size_t k = 0; k < values.size(); k += step) {
    const double value = static_cast<double>(values[k]);
    const double scale = value == 0 ? 1 : std::pow(10, 5 - std::floor(std::log10(std::abs(value))));
    some.push_back(std::isfinite(value) && std::isfinite(scale) ? Json(std::round(value * scale) / scale) : Json(0));
  }
  return some;
}

/// Numbers as they are, lengths of vectors; of tensors nothing.
std::vector<float> sizes_of(const run_folder::FieldValues<float>& field)
{
  const int components = field.info.components;
  if (components == 1) return field.values;
  std::vector<float> sizes;
  for (std::size_t k = 0; k + 2 < field.values.size(); k += 3)
    sizes.push_back(std::hypot(field.values[k], field.values[k + 1], field.values[k + 2]));
  return sizes;
}

const run_folder::FieldValues<float>* chosen(const std::vector<run_folder::FieldValues<float>>& fields, const std::string& name)
{
  const std::vector<std::string> wanted =
      name.empty() ? std::vector<std::string>{"accumulated_deviatoric_strain", "displacement"} : std::vector{name};
  for (const std::string& word : wanted)
    for (const run_folder::FieldValues<float>& field : fields)
      if (field.info.name == word && field.info.components <= 3) return &field;
  return nullptr;
}

/// The outlines of the rigid bodies, as lists of [x, y].
Json outlines_of(const fs::path& file)
{
  Json outlines = Json::array();
  if (file.empty()) return outlines;
  const run_folder::SavedRigids rigids = run_folder::read_rigids(file);
  for (const auto& cell : rigids.cells) {
    Json outline = Json::array();
    for (const Index point : cell)
      outline.push_back({rigids.x[static_cast<std::size_t>(point)], rigids.y[static_cast<std::size_t>(point)]});
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

}  // namespace

std::optional<Json> soil_of(const Folder& folder, const fs::path& run, long after, const std::string& field)
{
  folder.real(run / "frames/frames.pvd");
  const std::vector<run_folder::FrameFiles> frames = run_folder::frame_files(run / "frames");
  const long last = static_cast<long>(frames.size()) - 1;
  if (last < 0 || last <= after) return std::nullopt;
  const run_folder::FrameFiles& files = frames.back();
  for (const fs::path& file : {files.soil, files.rigid})
    if (!file.empty()) folder.real(file);
  if (fs::file_size(files.soil) > largest_frame) throw Refusal(413, "the frame is too large to be shown while the run is in progress");
  const run_folder::SavedSoil soil = run_folder::read_soil(files.soil);
  const std::size_t step = 1 + soil.x.size() / most_points;
  const bool flat = std::all_of(soil.z.begin(), soil.z.end(), [](Real z) { return z == 0; });
  Json answer = {
      {"frame", last}, {"time_s", files.time}, {"points", soil.x.size()}, {"x", thinned(soil.x, step)}, {"y", thinned(soil.y, step)}};
  if (!flat) answer["z"] = thinned(soil.z, step);
  answer["size"] = thinned(soil.volume, step);
  Json names = Json::array();
  for (const run_folder::FieldValues<float>& one : soil.fields)
    if (one.info.components <= 3) names.push_back(one.info.name);
  answer["fields"] = names;
  if (const run_folder::FieldValues<float>* one = chosen(soil.fields, field))
    answer["field"] = {
        {"name", one->info.name}, {"label", one->info.label}, {"unit", one->info.unit}, {"values", thinned(sizes_of(*one), step)}};
  else if (!field.empty())
    throw Refusal(400, fmt::format("the frame has no field {}", field));
  answer["rigids"] = flat ? outlines_of(files.rigid) : Json::array();
  return answer;
}

}  // namespace berm::desk
