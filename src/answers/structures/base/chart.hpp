// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/run_charts_test.cpp
#pragma once

#include "core/types.hpp"
#include "run_folder/uncertainty.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace berm::base {

/// A curve of a chart of a run.
struct Curve {
  std::string name;               ///< what it is of: a stage, a depth; "push": the way down
  std::vector<Index> rows{};      ///< of the history; empty where its points are none of its rows
  std::vector<Real> x{}, y{};     ///< in the units of the chart
  std::vector<Real> smooth{};     ///< y freed from noise by row as a smooth line is drawn; empty where y is one
  std::vector<Real> travel{};     ///< m, along which noise is averaged; NaN in rows that do not count
  Real begin = 0, direction = 1;  ///< of a drag: at travel s x = begin + direction s
};

/// Curves of a run over one another.
struct Chart {
  struct Axis {
    std::string words, symbol, unit;  ///< unit: SI
  };
  std::string id;  ///< V_w, H_u, w_u ...
  Axis x, y;
  std::vector<Curve> curves{};
  std::string title{};  ///< with which the page shows it as it is; "": the page has none, or one of its own kind
};
using Charts = std::vector<Chart>;

/// A curve along a travel by row, freed from noise over +-half of it (record::drawn_along; rows that do not count stay as they are).
Curve travelled(Curve curve, Real half);

/// The curves of a chart; none where there is no such chart.
const std::vector<Curve>& curves_in(const Charts& charts, const std::string& id);

/// A chart with its bands. `kept`: only these rows of the history, counted by their places here; null: all.
nlohmann::ordered_json json_of(const Chart& chart, const std::vector<run_folder::CurveBand>& bands,
                               const std::vector<Index>* kept = nullptr);

/// curves.json: the charts of a run whose history has that many rows, with their bands.
std::string json_text(const Charts& charts, Index rows, const std::vector<run_folder::CurveBand>& bands);

}  // namespace berm::base
