// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/triangulated_test.cpp
#include "bodies/rigid/triangle_file.hpp"

#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"
#include "os/read_file.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <fmt/format.h>
#include <string_view>
#include <unordered_map>

namespace berm::bodies {
namespace {

constexpr std::size_t most_triangles = 2'000'000;  // take some 0.7 GiB and a minute

/// Triangles whose equal points become one.
class Collected {
public:
  explicit Collected(std::string file) : file_(std::move(file)) {}

  Index point(const Vec<3>& x)
  {
    const auto [found, is_new] = number_.try_emplace({x[0] + 0., x[1] + 0., x[2] + 0.}, static_cast<Index>(triangles.points.size()));
    if (is_new) triangles.points.push_back(x);
    return found->second;
  }
  void triangle(const std::array<Index, 3>& corners)
  {
    if (triangles.corners.size() == most_triangles) refuse_more("triangles", most_triangles);
    stop_if_asked("the triangles of a surface were read");
    triangles.corners.push_back(corners);
  }
  [[noreturn]] void refuse_more(const char* what, std::size_t most) const
  {
    throw InputError(
        fmt::format("{}: has more than {} {}, which a surface may have: let the program that made it take fewer and larger triangles",
                    file_, most, what));
  }

  Triangles triangles;

private:
  struct Hash {
    std::size_t operator()(const std::array<Real, 3>& x) const
    {
      std::uint64_t hash = 0;
      for (const Real number : x) hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x9E3779B97F4A7C15u, hash ^= hash >> 32;
      return hash;
    }
  };
  std::string file_;
  std::unordered_map<std::array<Real, 3>, Index, Hash> number_;
};

/// The lines of a text, as words, with their number for messages.
class Lines {
public:
  Lines(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {}

  const std::string& file() const { return file_; }
  bool next(std::vector<std::string_view>& words)
  {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    words.clear();
    constexpr std::string_view blanks = " \t\r\f\v";
    while (true) {
      line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
      if (line.empty()) return true;
      words.push_back(line.substr(0, line.find_first_of(blanks)));
      line.remove_prefix(words.back().size());
    }
  }
  [[noreturn]] void refuse(const std::string& message) const
  {
    throw InputError(fmt::format("{}:{}: {}", file_, number_, one_line(message)));
  }

  Vec<3> three_numbers(const std::vector<std::string_view>& words) const
  {
    Vec<3> x;
    for (std::size_t d = 0; d < 3; ++d) {
      std::string_view word = words.size() > d + 1 ? words[d + 1] : words[0];
      if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
      const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), x[static_cast<int>(d)]);
      if (error != std::errc() || stop != word.data() + word.size()) refuse(fmt::format("needs three numbers after \"{}\"", words[0]));
    }
    return x;
  }

private:
  std::string file_;
  std::string_view rest_;
  int number_ = 0;
};

std::string without_capitals(std::string_view words)
{
  std::string text(words);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

Triangles text_stl(Lines lines)
{
  Collected found(lines.file());
  std::vector<std::string_view> words;
  std::vector<Index> corners;
  while (lines.next(words)) {
    if (words.empty()) continue;
    const std::string keyword = without_capitals(words[0]);
    if (keyword == "vertex") {
      if (corners.size() == 3) lines.refuse("a facet of an STL file has three vertices, and this one more");
      corners.push_back(found.point(lines.three_numbers(words)));
    }
    if (keyword != "endloop") continue;
    if (corners.size() != 3) lines.refuse(fmt::format("a facet of an STL file has three vertices, and this one {}", corners.size()));
    found.triangle({corners[0], corners[1], corners[2]});
    corners.clear();
  }
  if (!corners.empty()) lines.refuse("the file ends within a facet");
  return std::move(found.triangles);
}

constexpr std::size_t stl_header = 80, stl_facet = 50;

/// Number of facets that a binary STL file says it has.
std::uint32_t facets_of(const std::string& bytes)
{
  std::uint32_t count = 0;
  if (bytes.size() >= stl_header + sizeof count) std::memcpy(&count, bytes.data() + stl_header, sizeof count);
  return count;
}

Triangles binary_stl(const std::string& file, const std::string& bytes)
{
  Collected found(file);
  if (facets_of(bytes) > most_triangles) found.refuse_more("triangles", most_triangles);
  for (std::uint32_t k = 0; k < facets_of(bytes); ++k) {
    float numbers[12];  // the normal, which follows from the vertices, and these
    std::memcpy(numbers, bytes.data() + stl_header + sizeof k + k * stl_facet, sizeof numbers);
    std::array<Index, 3> corners;
    for (int c = 0; c < 3; ++c) corners[c] = found.point(Vec<3>(numbers[3 + 3 * c], numbers[4 + 3 * c], numbers[5 + 3 * c]));
    found.triangle(corners);
  }
  return std::move(found.triangles);
}

Triangles obj(Lines lines)
{
  constexpr std::size_t most_points = 3 * most_triangles, most_shown = 60;
  Collected found(lines.file());
  std::vector<Vec<3>> points;  // those of no face are left out
  std::vector<std::string_view> words;
  std::vector<Index> corners;
  while (lines.next(words)) {
    if (words.empty()) continue;
    if (words[0] == "v") {
      if (points.size() == most_points) found.refuse_more("vertices", most_points);
      points.push_back(lines.three_numbers(words));
    }
    if (words[0] != "f") continue;
    corners.clear();
    for (std::size_t k = 1; k < words.size(); ++k) {
      const char* const end = words[k].data() + words[k].size();
      Index number = 0;  // from 1; negative ones count from the last
      const auto [stop, error] = std::from_chars(words[k].data(), end, number);
      const Index count = static_cast<Index>(points.size()), index = number < 0 ? count + number : number - 1;
      if (error != std::errc() || (stop != end && *stop != '/') || index < 0 || index >= count)
        lines.refuse(fmt::format("\"{}\" is not a vertex before this line, which has {} of them", words[k].substr(0, most_shown), count));
      corners.push_back(found.point(points[static_cast<std::size_t>(index)]));
    }
    if (corners.size() < 3) lines.refuse(fmt::format("a face has three corners or more, and this one {}", corners.size()));
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) found.triangle({corners[0], corners[k], corners[k + 1]});
  }
  return std::move(found.triangles);
}

}  // namespace

Triangles read_triangles(const std::filesystem::path& file)
{
  constexpr std::uintmax_t max_bytes = 1'000'000'000;
  const auto [bytes, fault] = read_file(file, max_bytes);
  if (!fault.empty()) throw InputError(fmt::format("{}: {}", file.string(), fault));
  const std::string ending = without_capitals(file.extension().string());
  if (ending == ".obj") return obj({file.string(), bytes});
  if (ending != ".stl") throw InputError(fmt::format("{}: is neither an STL nor an OBJ file by its ending: .stl, .obj", file.string()));
  const std::size_t of_facets = stl_header + sizeof(std::uint32_t) + facets_of(bytes) * stl_facet;
  if (bytes.size() >= stl_header + sizeof(std::uint32_t) && bytes.size() == of_facets) return binary_stl(file.string(), bytes);
  if (without_capitals(std::string_view(bytes).substr(0, 5)) == "solid") return text_stl({file.string(), bytes});
  throw InputError(fmt::format("{}: has {} bytes, and a binary STL file with its {} facets has {}", file.string(), bytes.size(),
                               facets_of(bytes), of_facets));
}

}  // namespace berm::bodies
