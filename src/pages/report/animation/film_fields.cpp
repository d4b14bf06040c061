// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/animation/film_test.cpp
#include "report/animation/film_fields.hpp"

#include "os/error.hpp"
#include "run_folder/frame.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <set>

namespace berm::report {
namespace {

constexpr const char* wanted_most[] = {"deviatoric_strain", "incremental_deviatoric_strain", "mean_stress", "displacement", "velocity"};

/// 0 ... for those that are wanted most, then what belongs to a law or a method, then the rest.
std::ptrdiff_t rank(const std::string& source)
{
  const auto place = std::find(std::begin(wanted_most), std::end(wanted_most), source) - std::begin(wanted_most);
  return place + (place == std::ssize(wanted_most) && run_folder::is_common_field(source) ? 1 : 0);
}

FilmField film_field(const FieldInfo& info, const std::string& body)
{
  FilmField field{info.name,
                  info.name,
                  info.label,
                  info.unit.empty() ? std::string("1") : info.unit,
                  1,
                  false,
                  rank(info.name) > std::ssize(wanted_most)};
  if (info.unit == "Pa") field.unit = std::string("kPa"), field.factor = 1e-3;
  if (info.unit == "m") field.unit = std::string("mm"), field.factor = 1e3;
  if (info.name == "velocity") field.name = field.label = "speed";
  if (info.name == "mean_stress") field.label = "mean stress (compression positive)", field.factor *= -1;
  if (info.name == "incremental_deviatoric_strain") {
    field.summed = true;
    if (!body.empty())
      field.label =
          fmt::format("deviatoric strain of displacement per 0.01 D of the {}'s travel (at rest: since the previous frame)", body);
  }
  return field;
}

}  // namespace

std::vector<FilmField> film_fields(const std::vector<run_folder::FieldValues<float>>& fields, const std::string& body)
{
  constexpr int number = 1, vector = 3;
  std::vector<FilmField> shown;
  for (const run_folder::FieldValues<float>& field : fields)
    if (field.info.components == number || field.info.components == vector) shown.push_back(film_field(field.info, body));
  std::stable_sort(shown.begin(), shown.end(), [](const FilmField& a, const FilmField& b) { return rank(a.source) < rank(b.source); });
  return shown;
}

namespace {

const std::string flow_field = run_folder::water_flux_field<2>().name;

float finite(float value)
{
  return std::isfinite(value) ? value : 0;
}

/// Whether a particle is among those shown of a run in space: one of `n`, in no order that a lattice of particles could have.
bool is_shown(std::int32_t id, Index n)
{
  std::uint32_t mixed = static_cast<std::uint32_t>(id) * 2654435769u;
  mixed = (mixed ^ mixed >> 15) * 2246822519u;
  return (mixed ^ mixed >> 13) % static_cast<std::uint32_t>(n) == 0;
}

float length(const std::vector<float>& vectors, Index k)
{
  const Real x = vectors[3 * k], y = vectors[3 * k + 1], z = vectors[3 * k + 2];
  return static_cast<float>(std::sqrt(x * x + y * y + z * z));
}

}  // namespace

FilmReader::FilmReader(const std::vector<run_folder::FrameFiles>& files, int dimension, const std::string& body, bool soil_changes,
                       FilmPart part, Index most)
    : first_(run_folder::read_soil(files.front().soil)),
      soil_changes_(soil_changes),
      fields_(film_fields(first_.fields, body))
{
  if (first_.x.empty()) throw RunError(fmt::format("{}: has no particles", first_.file.string()));
  if (soil_changes) add_points_of(files);
  const Index count = static_cast<Index>(first_.id.size());
  with_z_ = dimension == 3 && part == FilmPart::whole;
  has_flow_ = !with_z_ && run_folder::find_field(first_.fields, flow_field) != nullptr;
  if (with_z_) one_of_ = (count + most - 1) / most;
  const auto stands_for = static_cast<float>(std::cbrt(Real(one_of_)));
  const auto [lowest, highest] = std::minmax_element(first_.z.begin(), first_.z.end());
  middle_ = (*lowest + *highest) / 2;
  for (Index k = 0; k < count; ++k) {
    const Real volume = std::max(finite(first_.volume[k]), 0.f), size = dimension == 2 ? std::sqrt(volume) : std::cbrt(volume);
    if (with_z_ ? !is_shown(first_.id[k], one_of_) : dimension == 3 && std::abs(first_.z[k] - middle_) > size) continue;
    chosen_.push_back(k);
    sizes_.push_back(static_cast<float>(size) * stands_for);
  }
  if (chosen_.empty()) throw RunError(fmt::format("{}: has no particles in the middle", first_.file.string()));
}

/// A frame that cannot be read is reported where the film reads it.
void FilmReader::add_points_of(const std::vector<run_folder::FrameFiles>& files)
{
  std::set<std::pair<std::int32_t, std::int32_t>> known;
  for (std::size_t k = 0; k < first_.id.size(); ++k) known.emplace(first_.body[k], first_.id[k]);
  for (std::size_t f = 1; f < files.size(); ++f) try {
      const run_folder::SavedSoil soil = run_folder::read_soil(files[f].soil);
      for (std::size_t k = 0; k < soil.id.size(); ++k) {
        if (!known.emplace(soil.body[k], soil.id[k]).second) continue;
        first_.body.push_back(soil.body[k]);
        first_.id.push_back(soil.id[k]);
        first_.z.push_back(soil.z[k]);
        first_.volume.push_back(soil.volume[k]);
      }
    } catch (const RunError&) {
      return;
    }
}

FilmReader::Found FilmReader::find(const run_folder::FrameFiles& files) const
{
  Found found{run_folder::read_soil(files.soil), chosen_, {}};
  const run_folder::SavedSoil& soil = found.soil;
  if (soil.id == first_.id && soil.body == first_.body) return found;
  if (!soil_changes_ || soil.id.empty()) throw RunError(fmt::format("{}: has other particles than the first frame", files.soil.string()));
  std::map<std::pair<std::int32_t, std::int32_t>, Index> places;
  for (std::size_t k = 0; k < soil.id.size(); ++k) places[{soil.body[k], soil.id[k]}] = static_cast<Index>(k);
  const auto largest = static_cast<Index>(std::max_element(soil.volume.begin(), soil.volume.end()) - soil.volume.begin());
  for (Index& place : found.places) {
    const auto at = places.find({first_.body[place], first_.id[place]});
    found.absent.push_back(at == places.end());
    place = found.absent.back() ? largest : at->second;
  }
  return found;
}

FilmFrame FilmReader::read(const run_folder::FrameFiles& files) const
{
  FilmFrame frame = film_frame(find(files));
  if (!files.rigid.empty()) frame.rigid_bodies = run_folder::read_rigids(files.rigid);
  return frame;
}

void FilmReader::add_summed(const run_folder::FrameFiles& files, FilmFrame& frame) const
{
  const Found found = find(files);
  for (std::size_t f = 0; f < fields_.size(); ++f)
    if (fields_[f].summed) {
      std::vector<float> more = values(found, fields_[f]);
      for (std::size_t k = 0; k < found.absent.size(); ++k)
        if (found.absent[k]) more[k] = 0;
      std::transform(more.begin(), more.end(), frame.fields[f].begin(), frame.fields[f].begin(), std::plus<>());
    }
}

std::vector<float> FilmReader::values(const Found& found, const FilmField& field) const
{
  const std::vector<float>& all = found.soil[field.source];
  const bool vectors = all.size() != found.soil.x.size();
  const auto factor = static_cast<float>(field.factor);
  std::vector<float> chosen;
  chosen.reserve(chosen_.size());
  for (const Index k : found.places) chosen.push_back(finite(factor * (vectors ? length(all, k) : all[k])));
  return chosen;
}

FilmFrame FilmReader::film_frame(const Found& found) const
{
  const run_folder::SavedSoil& soil = found.soil;
  FilmFrame frame;
  frame.x.reserve(chosen_.size());
  frame.y.reserve(chosen_.size());
  for (const Index k : found.places) {
    frame.x.push_back(soil.x[k]);
    frame.y.push_back(soil.y[k]);
    if (with_z_) frame.z.push_back(soil.z[k]);
  }
  for (const FilmField& field : fields_) frame.fields.push_back(values(found, field));
  if (!has_flow_) return frame;
  const std::vector<float>& flow = soil[flow_field];
  for (const Index k : found.places) {
    frame.flow_x.push_back(finite(flow[3 * k]));
    frame.flow_y.push_back(finite(flow[3 * k + 1]));
  }
  return frame;
}

}  // namespace berm::report
