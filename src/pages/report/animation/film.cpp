// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film.hpp"

#include "os/text_of_list.hpp"
#include "report/animation/film_frames.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace berm::report {
namespace {

std::size_t size_of(const Film& film)
{
  std::size_t size = 0;
  for (const FilmBlock& block : film.blocks) size += block.base64.size();
  return size;
}

/// What the film leaves out, in words: frames, and all but the first `fields` fields.
std::string note_of(const FilmFrames& footage, Index step, std::size_t fields)
{
  std::vector<std::string> words;
  if (footage.slice)
    words.push_back(fmt::format("slice in the middle: what lay within a particle's size of z = {:.3g} m at the start", *footage.slice));
  if (footage.one_of > 1)
    words.push_back(fmt::format("one of {} particles, each drawn with the volume of those that it represents", footage.one_of));
  if (step > 1) words.push_back(kept_words(step));
  std::vector<std::string> names;
  for (std::size_t f = footage.fields.size(); f-- > fields;) names.push_back(footage.fields[f].label);
  if (!names.empty()) words.push_back(fmt::format("without {}", text_of_list(names, " and ")));
  return text_of_list(words, "; ");
}

/// The film of a footage that takes at most so many bytes.
Film fitted(const record::RunRecord& run, const FilmFrames& footage, const std::string& prefix, std::size_t max_bytes)
{
  std::vector<std::string> faults;
  if (!footage.fault.empty()) faults.push_back(footage.fault);
  if (footage.frames.empty()) return {nullptr, {}, faults};

  const std::vector<std::string> stages = footage.stages();
  const Index count = static_cast<Index>(stages.size());
  const std::size_t fewest = kept_frames(stages, count).size();
  std::size_t fields = footage.fields.size();
  Index step = 1;
  while (true) {
    const std::vector<Index> kept = kept_frames(stages, step);
    Film film = encoded_film(run, footage, kept, fields, prefix);
    const std::size_t size = size_of(film);
    if (size <= max_bytes) {
      const std::string note = note_of(footage, step * footage.step, fields);
      if (!note.empty()) film.json["note"] = note;
      film.faults = faults;
      return film;
    }
    if (fields > 1 && footage.fields[fields - 1].spare) {
      --fields;
    } else if (kept.size() > fewest) {
      const Real wanted = static_cast<Real>(step) * static_cast<Real>(size) / static_cast<Real>(std::max<std::size_t>(max_bytes, 1));
      step = std::max(step + 1, static_cast<Index>(std::min<Real>(wanted, count)));
    } else if (fields > 1) {
      --fields;
    } else {
      faults.push_back(
          fmt::format("the film of the soil is left out: it takes {:.1f} MB even with {} frames, and the page allows {:.1f} MB",
                      static_cast<Real>(size) / 1e6, fewest, static_cast<Real>(max_bytes) / 1e6));
      return {nullptr, {}, faults};
    }
  }
}

/// The part of a page's room that the slice of a run in space takes; the rest goes to the whole.
constexpr std::size_t part_of_slice = 4;

}  // namespace

Film make_film(const record::RunRecord& run, const std::string& prefix, std::size_t max_bytes)
{
  if (run.settings.dimension() == 2) return fitted(run, read_footage(run), prefix, max_bytes);
  Film film = fitted(run, read_footage(run), prefix, max_bytes / part_of_slice);
  if (film.json.is_null()) return film;
  Film whole = fitted(run, read_footage(run, max_memory_of_footage, FilmPart::whole), prefix + "-space", max_bytes - size_of(film));
  film.json["space"] = whole.json;
  std::move(whole.blocks.begin(), whole.blocks.end(), std::back_inserter(film.blocks));
  for (const std::string& fault : whole.faults)
    if (std::find(film.faults.begin(), film.faults.end(), fault) == film.faults.end()) film.faults.push_back(fault);
  return film;
}

}  // namespace berm::report
