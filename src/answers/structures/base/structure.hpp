// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/error.hpp"
#include "record/travel_curve.hpp"
#include "run_folder/run_folder.hpp"
#include "structures/base/display_units.hpp"
#include "structures/base/kind.hpp"
#include "structures/base/published_envelope.hpp"
#include "structures/base/published_point.hpp"
#include "structures/base/run_details.hpp"
#include "structures/base/trust_measure.hpp"

#include <memory>

namespace berm::base {

/// A run of a page, and its number there, which gives its colour.
struct PageRun {
  const record::RunRecord* record;
  std::size_t number;
};
/// Runs of a page that are of one structure, in the order of the page.
using Runs = std::vector<PageRun>;

/// The rows of a history that a push or a drag made, ascending, with its travel in each.
struct StagePath {
  std::vector<Index> rows;
  std::vector<Real> travel;  ///< m
};
struct StagePaths {
  StagePath push;
  std::vector<StagePath> drags;
  std::vector<StagePath> lifts;  ///< travel upwards
};

/// The displacement of a named point of a body that turns, by row of the history.
struct PointTravel {
  std::string words;    ///< "displacement at the bed"
  std::vector<Real> u;  ///< m, along the axis in which u counts
};

/// A chart of the page that a structure has by itself: curves of one run over one another, by the same rows of its history.
struct OwnChart {
  struct Axis {
    std::string words, symbol, unit;  ///< unit: SI
  };
  struct Curve {
    std::string name;
    std::vector<Real> x, y, mean;  ///< y as it is, and as a smooth line is drawn (record::drawn_along)
  };
  std::string id, title;
  Axis x, y;
  std::vector<Index> rows;
  std::vector<Curve> curves;
};

/// A curve of a chart: at travel s it stands at x = begin + direction s.
struct ChartCurve {
  std::string chart;  ///< V_w, H_u, w_u
  Real begin, direction;
  record::TravelCurve values;
};
using ChartCurves = std::vector<ChartCurve>;
using CurveBands = std::vector<run_folder::CurveBand>;

/// What berm knows of a structure, beyond its being a rigid body: the numbers that matter of it and how they are told. A structure says what it has; the rest
/// stays empty. structures/structures.hpp lists all.
class Structure {
public:
  virtual ~Structure() = default;

  /// rigid.NAME.structure, a row of input/structure_words.cpp.
  virtual const char* word() const = 0;
  /// Whether a case is of this structure.
  virtual bool applies_to(const problem::Case& c) const { return kind_of(c) == word(); }

  /// The key results of a run (its folder with the frames, case and history, which may be without rows). `held_forces`: V that each stage of the case was to
  /// hold, N/m, NaN where none; empty where they are not known.
  virtual std::vector<run_folder::Quantity> quantities(const record::RunRecord&, const std::vector<Real>&) const { return {}; }
  /// The names of all key results that a run of a case may have, with # for the number in V_at_w_0.1D; empty where they are not known beforehand.
  virtual std::vector<std::string> quantity_names(const problem::Case&) const { return {}; }
  /// The key results of a run, its quantities, as a table of the log; "" where there is none.
  virtual std::string table_of(const record::RunRecord&) const { return ""; }
  /// Draws curves.png of a run into its folder, with the bands of its curves. False, with a warning, where it could not be drawn.
  virtual bool draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const CurveBands& bands) const = 0;
  /// The curves that have bands.
  virtual ChartCurves chart_curves(const record::RunRecord&) const { return {}; }

  /// What a run did and met, in a few sentences, HTML without the run's name.
  virtual std::string in_words(const record::RunRecord& run, const DisplayUnits& shown) const = 0;
  /// The key results of runs as HTML tables; "" where there is none.
  virtual std::string key_results(const Runs&, const DisplayUnits&) const { return ""; }
  /// What design codes and published formulas give beside the runs, as HTML with its heading; "" where there is none.
  virtual std::string published_values(const Runs&, const DisplayUnits&) const { return ""; }
  /// Results that stand at the end of the section, a run after the other, as HTML; `id` begins the names of its tables.
  virtual std::string other_results(const record::RunRecord&, const std::string&) const { return ""; }

  /// What is looked at in a run of a case to know whether it can be trusted, in the order of the page.
  virtual TrustMeasures measures(const problem::Case& c) const = 0;
  /// What a reader must know of the quality of these runs beyond their measures, as HTML.
  virtual std::string quality_note(const Runs&) const { return ""; }

  /// Push and drag of a run, for the charts of the page.
  virtual StagePaths paths(const record::RunRecord&) const { return {}; }
  /// Draw the curves of the runs over one another, with what is published, and the soil of each, as SVG and PNG. Give the names of what was drawn.
  virtual std::vector<std::string> draw_report_curves(const Runs&, const PublishedPoints&, const std::filesystem::path&) const
  {
    return {};
  }
  virtual std::vector<std::string> draw_report_soil(const Runs&, const std::filesystem::path&) const { return {}; }

  /// Further numbers of a run, which must outlive them; null where there are none.
  virtual std::unique_ptr<RunDetails> details(const record::RunRecord&) const { return nullptr; }

  /// How the structure lies before the first stage, for its envelope. Throws InputError where a case has none.
  virtual EmbeddedBody embedded(const problem::Case&) const
  {
    throw KeyError("stage: an envelope needs a push or a drag by velocity, of a rigid body whose envelope is known");
  }
  /// What is published beside an envelope that was found.
  virtual PublishedEnvelope published_envelope(const problem::Case&, const EnvelopeEnds&) const { return {}; }

  /// The charts that answer the question of the structure, the first of the page.
  virtual std::vector<OwnChart> own_charts(const record::RunRecord&) const { return {}; }
  /// What u is of on the page where that is not the centre of the body.
  virtual std::optional<PointTravel> point_travel(const record::RunRecord&) const { return {}; }
};

}  // namespace berm::base
