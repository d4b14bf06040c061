// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/animation/film_test.cpp
#include "report/animation/film_flow.hpp"

#include <algorithm>

namespace berm::report {
namespace {

constexpr Real across = 36;  // squares that the wider side of a view has
constexpr Real least_filled = 0.5;
constexpr Real most_code = 127;

FilmFlow empty_flow(const FilmBox& view)
{
  FilmFlow flow;
  const Vec<2> size = view.upper - view.lower;
  flow.side = size.maxCoeff() / across;
  flow.columns = std::max<Index>(1, static_cast<Index>(std::lround(size[0] / flow.side)));
  flow.rows = std::max<Index>(1, static_cast<Index>(std::lround(size[1] / flow.side)));
  flow.box = {view.lower, view.lower + flow.side * Vec<2>(Real(flow.columns), Real(flow.rows))};
  return flow;
}

/// The mean flux in each square, m/s.
std::vector<Vec<2>> mean_fluxes(const FilmFlow& flow, const FilmFrame& frame, const std::vector<float>& sizes)
{
  struct Square {
    Vec<2> sum = Vec<2>::Zero();
    Real area = 0;
  };
  std::vector<Square> squares(static_cast<std::size_t>(flow.columns) * static_cast<std::size_t>(flow.rows));
  for (std::size_t k = 0; k < frame.x.size(); ++k) {
    const Real column = std::floor((Real(frame.x[k]) - flow.box.lower[0]) / flow.side),
               row = std::floor((Real(frame.y[k]) - flow.box.lower[1]) / flow.side);
    if (!(column >= 0 && column < Real(flow.columns) && row >= 0 && row < Real(flow.rows))) continue;
    Square& square = squares[static_cast<std::size_t>(row) * static_cast<std::size_t>(flow.columns) + static_cast<std::size_t>(column)];
    const Real area = Real(sizes[k]) * Real(sizes[k]);
    square.sum += area * Vec<2>(Real(frame.flow_x[k]), Real(frame.flow_y[k]));
    square.area += area;
  }
  std::vector<Vec<2>> means;
  means.reserve(squares.size());
  for (const Square& square : squares)
    means.push_back(square.area >= least_filled * flow.side * flow.side ? Vec<2>(square.sum / square.area) : Vec<2>(Vec<2>::Zero()));
  return means;
}

}  // namespace

std::optional<FilmFlow> film_flow(const std::vector<const FilmFrame*>& frames, const std::vector<float>& sizes, const FilmBox& view)
{
  if (frames.empty() || frames.front()->flow_x.empty()) return {};
  FilmFlow flow = empty_flow(view);
  for (const FilmFrame* frame : frames) {
    const std::vector<Vec<2>> means = mean_fluxes(flow, *frame, sizes);
    Real largest = 0;
    for (const Vec<2>& mean : means) largest = std::max(largest, mean.cwiseAbs().maxCoeff());
    flow.largest.push_back(largest);
    for (const Vec<2>& mean : means)
      for (int d = 0; d < 2; ++d)
        flow.codes.push_back(static_cast<std::int8_t>(largest > 0 ? std::lround(most_code * mean[d] / largest) : 0));
  }
  if (*std::max_element(flow.largest.begin(), flow.largest.end()) == 0) return {};
  return flow;
}

}  // namespace berm::report
