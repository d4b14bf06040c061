// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/animation/film_test.cpp
#include "report/animation/film_fields.hpp"

namespace berm::report {
namespace {

std::vector<float> one_after_the_other(const std::vector<const FilmFrame*>& frames, std::vector<float> FilmFrame::*list)
{
  std::vector<float> all;
  all.reserve(frames.size() * (frames.front()->*list).size());
  for (const FilmFrame* frame : frames) all.insert(all.end(), (frame->*list).begin(), (frame->*list).end());
  return all;
}

std::vector<float> increments(const std::vector<const FilmFrame*>& frames, const std::vector<Real>& factor)
{
  const std::size_t count = frames.front()->sheared.size();
  std::vector<float> all(count * frames.size(), 0);
  for (std::size_t f = 1; f < frames.size(); ++f)
    for (std::size_t k = 0; k < count; ++k)
      all[f * count + k] = static_cast<float>(factor[f] * (frames[f]->sheared[k] - frames[f - 1]->sheared[k]));
  return all;
}

}  // namespace

FieldWords words_of(FilmField field, bool with_pipe)
{
  switch (field) {
  case FilmField::deviatoric_strain:
    return {"deviatoric_strain", "deviatoric strain of displacement since the start", "1"};
  case FilmField::incremental_deviatoric_strain:
    return {"incremental_deviatoric_strain",
            with_pipe ? "deviatoric strain of displacement per 0.01 D of the pipe's way (at rest: since the frame before)"
                      : "deviatoric strain of displacement since the frame before",
            "1"};
  case FilmField::mean_stress:
    return {"mean_stress", "mean stress (compression positive)", "kPa"};
  case FilmField::speed:
    return {"speed", "speed", "m/s"};
  case FilmField::displacement:
    return {"displacement", "displacement since the start", "mm"};
  }
  return {};
}

std::vector<float> field_values(FilmField field, const std::vector<const FilmFrame*>& frames, const std::vector<Real>& increment_factor)
{
  switch (field) {
  case FilmField::deviatoric_strain:
    return one_after_the_other(frames, &FilmFrame::strain);
  case FilmField::incremental_deviatoric_strain:
    return increments(frames, increment_factor);
  case FilmField::mean_stress:
    return one_after_the_other(frames, &FilmFrame::mean_stress);
  case FilmField::speed:
    return one_after_the_other(frames, &FilmFrame::speed);
  case FilmField::displacement:
    return one_after_the_other(frames, &FilmFrame::displacement);
  }
  return {};
}

}  // namespace berm::report
