// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/run_folder.hpp"
#include "structures/base/chart.hpp"
#include "structures/base/display_units.hpp"
#include "structures/base/headline.hpp"
#include "structures/base/kind.hpp"
#include "structures/base/published_envelope.hpp"
#include "structures/base/published_point.hpp"
#include "structures/base/run_details.hpp"
#include "structures/base/trust_measure.hpp"

#include <functional>

namespace berm::base {

/// A run of a page, and its number there, which gives its colour.
struct PageRun {
  const record::RunRecord* record;
  std::size_t number;
};
/// Runs of a page that are of one structure, in the order of the page.
using Runs = std::vector<PageRun>;

/// The displacement of a named point of a body that turns, by row of the history.
struct PointTravel {
  std::string words;    ///< "displacement at the bed"
  std::vector<Real> u;  ///< m, along the axis in which u counts
};

using CurveBands = std::vector<run_folder::CurveBand>;

/// Something that a run can be read as: a body that travels, one that is pushed down, a tow. What a reading does not have stays empty. `Runs`: those that it applies to.
struct Reading {
  using Run = const record::RunRecord&;
  using Quantities = std::vector<run_folder::Quantity>;
  using Names = std::vector<std::string>;
  template <class Answer, class... Of>
  using Says = std::function<Answer(Of...)>;

  Says<bool, const settings::Case&> applies{};  ///< to a case of its structure; empty: to each

  /// The answers of a run (its folder with the frames, case and history, which may be without rows), for summary.json and the log. The second: V that each stage of the
  /// case was to hold, N/m, NaN where none; empty where they are not known.
  Says<Quantities, Run, const std::vector<Real>&> answers{};
  /// The names of all that a run of a case may have of these, with # for the number in V_at_w_0.1D; none where they are not known beforehand.
  Says<Names, const settings::Case&> names{};
  Says<std::string, Run> notes{};  ///< lines below the answers in the log
  Says<std::string, Run> table{};  ///< a table of the log, instead of the one in which the answers of all readings stand

  Says<void, const run_folder::RunFolder&, Run> write_files{};  ///< tables of a run, into its folder
  /// Draws curves.png of a run into its folder, with the bands of its curves. False, with a warning, where it could not be drawn.
  Says<bool, const run_folder::RunFolder&, Run, const CurveBands&> draw_curves{};
  Says<Charts, Run> charts{};  ///< all curves of a run

  Says<Headline, Run, const DisplayUnits&> headline{};  ///< the numbers that its job asks for
  /// What a run did and met, in a few sentences, HTML without the run's name.
  Says<std::string, Run, const DisplayUnits&> words{};
  /// The key results of runs as HTML tables.
  Says<std::string, const Runs&, const DisplayUnits&> key_results{};
  /// What design codes and published formulas give beside the runs, as HTML with its heading.
  Says<std::string, const Runs&, const DisplayUnits&> published{};
  /// Results that stand at the end of the section, a run after the other, as HTML; the string begins the names of its tables.
  Says<std::string, Run, const std::string&> other_results{};

  /// What is looked at in a run of a case to know whether it can be trusted, in the order of the page.
  Says<TrustMeasures, const settings::Case&> measures{};
  /// What a reader must know of the quality of these runs beyond their measures, as HTML.
  Says<std::string, const Runs&> quality_note{};

  /// Draw the curves of the runs over one another, with what is published, and the soil of each, as SVG and PNG. Give the names of what was drawn.
  Says<Names, const Runs&, const PublishedPoints&, const std::filesystem::path&> draw_report_curves{};
  Says<Names, const Runs&, const std::filesystem::path&> draw_report_soil{};
  Says<std::optional<PointTravel>, Run> point_travel{};  ///< what u is of on the page where that is not the centre of the body
  Says<RunDetails, Run> details{};                       ///< further numbers of a run, which must outlive them
  Says<EmbeddedBody, const settings::Case&>
      embedded{};  ///< how the body lies before the first stage, for its envelope; throws InputError where a case has none
  Says<PublishedEnvelope, const settings::Case&, const EnvelopeEnds&> published_envelope{};  ///< beside an envelope that was found
};

/// What berm knows of a structure, beyond its being a rigid body: how a run of it is read. Its results are those of its readings that apply, in their order.
/// structures/structures.hpp lists all.
struct Structure {
  const char* word;  ///< rigid.NAME.structure, a row of input/structure_words.cpp
  std::vector<Reading> readings;
  bool (*applies)(const settings::Case&) = nullptr;  ///< to a case; null: where kind_of gives its word

  bool applies_to(const settings::Case& c) const { return applies != nullptr ? applies(c) : kind_of(c) == word; }

  std::vector<run_folder::Quantity> quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const;
  /// Empty where a reading that has answers does not know them beforehand.
  std::vector<std::string> quantity_names(const settings::Case& c) const;
  /// The quantities of a run for the log; "" where there is none.
  std::string table_of(const record::RunRecord& run) const;
  void write_files(const run_folder::RunFolder& folder, const record::RunRecord& run) const;
  /// By the first reading that draws.
  bool draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const CurveBands& bands) const;
  Charts charts(const record::RunRecord& run) const;
  /// Those that the run has, five at most.
  Headline headline(const record::RunRecord& run, const DisplayUnits& shown) const;
  std::string in_words(const record::RunRecord& run, const DisplayUnits& shown) const;
  std::string key_results(const Runs& runs, const DisplayUnits& shown) const;
  std::string published_values(const Runs& runs, const DisplayUnits& shown) const;
  std::string other_results(const record::RunRecord& run, const std::string& id) const;
  TrustMeasures measures(const settings::Case& c) const;
  std::string quality_note(const Runs& runs) const;
  std::vector<std::string> draw_report_curves(const Runs& runs, const PublishedPoints& published,
                                              const std::filesystem::path& folder) const;
  std::vector<std::string> draw_report_soil(const Runs& runs, const std::filesystem::path& folder) const;
  std::optional<PointTravel> point_travel(const record::RunRecord& run) const;
  RunDetails details(const record::RunRecord& run) const;
  /// Throws InputError where no reading has one.
  EmbeddedBody embedded(const settings::Case& c) const;
  PublishedEnvelope published_envelope(const settings::Case& c, const EnvelopeEnds& ends) const;
};

}  // namespace berm::base
