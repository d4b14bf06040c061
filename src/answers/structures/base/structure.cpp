// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/structures_test.cpp
#include "structures/base/structure.hpp"

#include "os/error.hpp"
#include "structures/base/answer.hpp"

#include <algorithm>
#include <cmath>

namespace berm::base {
namespace {

/// Those that apply to a case.
std::vector<const Reading*> of_case(const Structure& structure, const settings::Case& c)
{
  std::vector<const Reading*> readings;
  for (const Reading& reading : structure.readings)
    if (!reading.applies || reading.applies(c)) readings.push_back(&reading);
  return readings;
}

/// What all readings of a case say in this member, one after the other.
template <class List, class Says, class... Of>
List joined_of(const Structure& structure, const settings::Case& c, Says Reading::*member, const Of&... of)
{
  List all;
  for (const Reading* reading : of_case(structure, c))
    if (const Says& says = reading->*member) {
      const List list = says(of...);
      all.insert(all.end(), list.begin(), list.end());
    }
  return all;
}

/// The same of runs, of which each reading has those that it applies to.
template <class List, class Says, class... Of>
List joined_of(const Structure& structure, const Runs& runs, Says Reading::*member, const Of&... of)
{
  List all;
  for (const Reading& reading : structure.readings) {
    Runs its = runs;
    if (reading.applies) std::erase_if(its, [&](const PageRun& run) { return !reading.applies(run.record->settings); });
    if (its.empty() || !(reading.*member)) continue;
    const List list = (reading.*member)(its, of...);
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

/// The first reading of a case that has this member; null where none has.
template <class Says>
const Says* first_of(const Structure& structure, const settings::Case& c, Says Reading::*member)
{
  for (const Reading* reading : of_case(structure, c))
    if (reading->*member) return &(reading->*member);
  return nullptr;
}

}  // namespace

std::vector<run_folder::Quantity> Structure::quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const
{
  return joined_of<Reading::Quantities>(*this, run.settings, &Reading::answers, run, held_forces);
}

std::vector<std::string> Structure::quantity_names(const settings::Case& c) const
{
  std::vector<std::string> all;
  for (const Reading* reading : of_case(*this, c)) {
    if (!reading->answers) continue;
    const std::vector<std::string> names = reading->names ? reading->names(c) : std::vector<std::string>{};
    if (names.empty()) return {};
    all.insert(all.end(), names.begin(), names.end());
  }
  return all;
}

std::string Structure::table_of(const record::RunRecord& run) const
{
  std::string table;
  const std::vector<const Reading*> readings = of_case(*this, run.settings);
  if (std::ranges::any_of(readings, [](const Reading* reading) { return reading->answers && !reading->table; }))
    table = log_table(run.quantities, body_scale(run));
  return table + joined_of<std::string>(*this, run.settings, &Reading::table, run) +
         (table.empty() ? "" : joined_of<std::string>(*this, run.settings, &Reading::notes, run));
}

void Structure::write_files(const run_folder::RunFolder& folder, const record::RunRecord& run) const
{
  for (const Reading* reading : of_case(*this, run.settings))
    if (reading->write_files) reading->write_files(folder, run);
}

bool Structure::draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const CurveBands& bands) const
{
  const auto* draw = first_of(*this, run.settings, &Reading::draw_curves);
  return draw != nullptr && (*draw)(folder, run, bands);
}

Charts Structure::charts(const record::RunRecord& run) const
{
  return joined_of<Charts>(*this, run.settings, &Reading::charts, run);
}

Headline Structure::headline(const record::RunRecord& run, const DisplayUnits& shown) const
{
  constexpr std::size_t most = 5;
  Headline numbers = joined_of<Headline>(*this, run.settings, &Reading::headline, run, shown);
  std::erase_if(numbers, [&](const HeadlineNumber& number) {
    const run_folder::Quantity* q = run.quantity(number.quantity);
    return q == nullptr || !std::isfinite(q->value);
  });
  if (numbers.size() > most) numbers.resize(most);
  return numbers;
}

std::string Structure::in_words(const record::RunRecord& run, const DisplayUnits& shown) const
{
  std::string words;
  for (const Reading* reading : of_case(*this, run.settings))
    if (const std::string more = reading->words ? reading->words(run, shown) : ""; !more.empty())
      words += (words.empty() || more.starts_with(' ') ? "" : " ") + more;
  return words;
}

std::string Structure::key_results(const Runs& runs, const DisplayUnits& shown) const
{
  return joined_of<std::string>(*this, runs, &Reading::key_results, shown);
}

std::string Structure::published_values(const Runs& runs, const DisplayUnits& shown) const
{
  return joined_of<std::string>(*this, runs, &Reading::published, shown);
}

std::string Structure::other_results(const record::RunRecord& run, const std::string& id) const
{
  return joined_of<std::string>(*this, run.settings, &Reading::other_results, run, id);
}

TrustMeasures Structure::measures(const settings::Case& c) const
{
  return joined_of<TrustMeasures>(*this, c, &Reading::measures, c);
}

std::string Structure::quality_note(const Runs& runs) const
{
  return joined_of<std::string>(*this, runs, &Reading::quality_note);
}

std::vector<std::string> Structure::draw_report_curves(const Runs& runs, const PublishedPoints& published,
                                                       const std::filesystem::path& folder) const
{
  return joined_of<Reading::Names>(*this, runs, &Reading::draw_report_curves, published, folder);
}

std::vector<std::string> Structure::draw_report_soil(const Runs& runs, const std::filesystem::path& folder) const
{
  return joined_of<Reading::Names>(*this, runs, &Reading::draw_report_soil, folder);
}

std::optional<PointTravel> Structure::point_travel(const record::RunRecord& run) const
{
  const auto* point = first_of(*this, run.settings, &Reading::point_travel);
  return point == nullptr ? std::nullopt : (*point)(run);
}

RunDetails Structure::details(const record::RunRecord& run) const
{
  const auto* details = first_of(*this, run.settings, &Reading::details);
  return details == nullptr ? RunDetails{} : (*details)(run);
}

EmbeddedBody Structure::embedded(const settings::Case& c) const
{
  const auto* embedded = first_of(*this, c, &Reading::embedded);
  if (embedded == nullptr) throw KeyError("stage: an envelope needs a push or a drag by velocity, of a rigid body whose envelope is known");
  return (*embedded)(c);
}

PublishedEnvelope Structure::published_envelope(const settings::Case& c, const EnvelopeEnds& ends) const
{
  const auto* published = first_of(*this, c, &Reading::published_envelope);
  return published == nullptr ? PublishedEnvelope{} : (*published)(c, ends);
}

}  // namespace berm::base
