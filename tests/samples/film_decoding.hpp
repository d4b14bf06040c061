// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/animation/film.hpp"
#include "samples/unpacking.hpp"

namespace berm {

/// Decodes what the page's script decodes, from the words of web/src/data.ts alone.

/// The codes of all places by direction, frame and point.
inline std::vector<std::vector<std::vector<int>>> decoded_places(const std::string& bytes, std::size_t frames, std::size_t count,
                                                                 std::size_t axes = 2)
{
  EXPECT_EQ(bytes.size(), 2 * axes * frames * count);
  std::vector<std::vector<std::vector<int>>> places(axes);
  for (std::size_t d = 0; d < axes; ++d)
    for (std::size_t f = 0; f < frames; ++f) {
      std::vector<int>& now = places[d].emplace_back();
      for (std::size_t k = 0; k < count; ++k) {
        const auto byte = [&](std::size_t plane) { return static_cast<unsigned char>(bytes[(plane * frames + f) * count + k]); };
        const int stored = byte(2 * d) + 256 * byte(2 * d + 1);
        const int change = stored % 2 == 0 ? stored / 2 : -(stored + 1) / 2;
        now.push_back(f == 0 ? stored : ((places[d][f - 1][k] + change) % 65536 + 65536) % 65536);
      }
    }
  return places;
}

/// The bytes of a field by frame and point.
inline std::vector<std::vector<int>> decoded_values(const std::string& bytes, std::size_t frames, std::size_t count)
{
  EXPECT_EQ(bytes.size(), frames * count);
  std::vector<std::vector<int>> values;
  for (std::size_t f = 0; f < frames; ++f) {
    std::vector<int>& now = values.emplace_back();
    for (std::size_t k = 0; k < count; ++k) {
      const int stored = static_cast<unsigned char>(bytes[f * count + k]);
      now.push_back(f == 0 ? stored : (values[f - 1][k] + stored) % 256);
    }
  }
  return values;
}

/// A film as the page sees it.
struct SeenFilm {
  const report::Film& film;

  std::size_t frames() const { return film.json["frames"].size(); }
  std::size_t count() const { return film.json["count"]; }
  std::string bytes(const std::string& id) const
  {
    for (const report::FilmBlock& block : film.blocks)
      if (block.id == id) return inflated(from_base64(block.base64));
    ADD_FAILURE() << "no block " << id;
    return "";
  }
  /// m, by frame and point.
  std::vector<std::vector<Real>> places(int d) const
  {
    const bool in_space = film.json.contains("lower_z");
    const auto codes = decoded_places(bytes(film.json["position"]), frames(), count(), in_space ? 3 : 2);
    const Real lower = d == 2 ? film.json["lower_z"] : film.json["lower"][d];
    std::vector<std::vector<Real>> list;
    for (const std::vector<int>& frame : codes[d]) {
      std::vector<Real>& now = list.emplace_back();
      for (const int code : frame) now.push_back(lower + film.json["step"].get<Real>() * code);
    }
    return list;
  }
  const nlohmann::ordered_json* field(const std::string& name) const
  {
    for (const auto& field : film.json["fields"])
      if (field["name"] == name) return &field;
    return nullptr;
  }
  Real level(const std::string& name) const { return ((*field(name))["high"].get<Real>() - (*field(name))["low"].get<Real>()) / 255; }
  /// In the field's unit, by frame and point.
  std::vector<std::vector<Real>> values(const std::string& name) const
  {
    const auto& about = *field(name);
    std::vector<std::vector<Real>> list;
    for (const std::vector<int>& frame : decoded_values(bytes(about["block"]), frames(), count())) {
      std::vector<Real>& now = list.emplace_back();
      for (const int byte : frame) now.push_back(about["low"].get<Real>() + level(name) * byte);
    }
    return list;
  }
};

}  // namespace berm
