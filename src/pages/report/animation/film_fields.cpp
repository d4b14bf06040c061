// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/animation/film_test.cpp
#include "report/animation/film_fields.hpp"

#include "run_folder/frame.hpp"

#include <algorithm>
#include <fmt/format.h>

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
      field.label = fmt::format("deviatoric strain of displacement per 0.01 D of the {}'s way (at rest: since the frame before)", body);
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

}  // namespace berm::report
