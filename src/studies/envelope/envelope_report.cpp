// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_test.cpp
#include "envelope/envelope_report.hpp"

#include "envelope/foundation.hpp"
#include "io/atomic_file.hpp"
#include "io/log.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::envelope {
namespace {

using Json = nlohmann::ordered_json;

/// NaN becomes null.
Json number(Real value, const char* unit)
{
  return {{"value", value}, {"unit", unit}};
}

std::string summary_json(const settings::Case& c, const std::vector<EnvelopeRow>& rows)
{
  const EnvelopeExtremes extremes = extremes_of(rows);
  const base::PublishedEnvelope published = published_for(c, rows);
  const base::EmbeddedBody body = embedded_body(c);
  const bool plane = c.force_dimension() == 2;
  const char *force = plane ? "N/m" : "N", *moment = plane ? "N m/m" : "N m";
  Json quantities = {{"w_over_D", number(body.embedment / body.width, "1")},
                     {"V_max", number(extremes.V_max, force)},
                     {"H_max", number(extremes.H_max, force)},
                     {"V_over_V_max_at_H_max", number(extremes.V_at_H_max / extremes.V_max, "1")}};
  if (published.unit > 0) {
    quantities["V_max_over_unit"] = number(extremes.V_max / published.unit, "1");
    quantities["H_max_over_unit"] = number(extremes.H_max / published.unit, "1");
    quantities["unit"] = number(published.unit, force);
  }
  if (body.arm) {
    quantities["M_max"] = number(extremes.M_max, moment);
    quantities["V_over_V_max_at_M_max"] = number(extremes.V_at_M_max / extremes.V_max, "1");
    quantities["M_largest"] = number(extremes.M_largest, moment);
    quantities["H_over_H_max_at_M_largest"] = number(extremes.H_at_M_largest / extremes.H_max, "1");
    if (published.unit > 0) {
      quantities["M_max_over_unit_D"] = number(extremes.M_max / (published.unit * body.width), "1");
      quantities["M_largest_over_unit_D"] = number(extremes.M_largest / (published.unit * body.width), "1");
    }
  }
  Json all = {{"quantities", quantities}, {"published", Json::object()}};
  for (const base::PublishedNumber& known : published.numbers) {
    const formulas::Source& source = known.formula.source;
    all["published"][known.name] = {
        {"value", known.formula.value},   {"unit", known.name.starts_with("parabola") ? "1" : known.moment ? moment : force},
        {"label", word_of(source.label)}, {"source", citation(source)},
        {"range", source.range},          {"in_range", known.formula.valid}};
  }
  Json states = Json::object();
  for (const EnvelopeRow& row : rows) states[row.probe.name] = row.state;
  all["probes"] = states;
  all["text"] = {{"title", c.title}, {"version", BERM_VERSION}};
  if (!published.remark.empty()) all["text"]["remark"] = published.remark;
  if (body.arm) all["text"]["moments"] = "about the middle of the base, clockwise where H goes to the right";
  return all.dump(2) + "\n";
}

std::string ratio_words(Real ratio)
{
  return std::isfinite(ratio) ? fmt::format("{:.3f}", ratio) : "-";
}

}  // namespace

void write_envelope_report(const settings::Case& c, const std::vector<EnvelopeRow>& rows, const std::filesystem::path& folder)
{
  io::write_atomically(folder / "envelope.csv", envelope_csv(rows, embedded_body(c).arm.has_value(), c.force_dimension()));
  io::write_atomically(folder / "summary.json", summary_json(c, rows));
  draw_envelope(c, rows, folder);
  const base::EmbeddedBody body = embedded_body(c);
  const bool open = std::any_of(rows.begin(), rows.end(), [](const EnvelopeRow& row) { return row.state != "finished"; });
  if (body.arm && !open) try {
      const Foundation foundation = fit_foundation(rows, body.width);
      io::write_atomically(folder / "redwin.txt", foundation_properties(foundation, c.force_dimension()));
      io::write_atomically(folder / "redwin.c", redwin_code);
      io::write_atomically(folder / "redwin.so", redwin_library);
    } catch (const RunError& error) {
      io::warn("{}", error.what());
    }
}

std::string envelope_words(const settings::Case& c, const std::vector<EnvelopeRow>& rows)
{
  const base::PublishedEnvelope published = published_for(c, rows);
  const EnvelopeExtremes extremes = extremes_of(rows);
  const base::EmbeddedBody body = embedded_body(c);
  const bool plane = c.force_dimension() == 2;
  const char *force = plane ? "N/m" : "N", *moment = plane ? "N m/m" : "N m";
  const auto of = [](const char* symbol, const char* unit) { return fmt::format("{} ({})", symbol, unit); };
  std::string text =
      fmt::format("{:<18} {:>11} {:>11} {:>8} {:>8} {:>8}", "probe", of("V", force), of("H", force), "V/Vmax", "H/Hmax", "growth");
  text += body.arm ? fmt::format(" {:>11} {:>8}\n", of("M", moment), "M/Mmax") : "\n";
  for (const EnvelopeRow& row : rows) {
    const ProbeResult& r = row.result;
    if (row.state == "finished") {
      text += fmt::format("{:<18} {:>11.5g} {:>11.5g} {:>8} {:>8} {:>7.2f}%", row.probe.name, r.end.V, r.end.H,
                          ratio_words(r.end.V / extremes.V_max), ratio_words(r.end.H / extremes.H_max), 100 * r.growth);
      text += body.arm ? fmt::format(" {:>11.5g} {:>8}\n", r.end.M, ratio_words(r.end.M / extremes.M_max)) : "\n";
    } else {
      text += fmt::format("{:<18} {}\n", row.probe.name, row.state);
    }
  }
  if (!std::isfinite(extremes.V_max) || !std::isfinite(extremes.H_max))
    return text + "Vmax and Hmax are not known before the probes that look for them are done\n";
  const std::string unit = published.unit > 0 ? fmt::format(" = {:.4g} and {:.4g} times {:.5g} {}", extremes.V_max / published.unit,
                                                            extremes.H_max / published.unit, published.unit, force)
                                              : "";
  const bool open = std::any_of(rows.begin(), rows.end(), [](const EnvelopeRow& row) { return row.state != "finished"; });
  if (open) text += "of the probes that are done: ";
  text += fmt::format("Vmax {:.5g} {}, Hmax {:.5g} {}{}\n", extremes.V_max, force, extremes.H_max, force, unit);
  if (std::isfinite(extremes.M_max)) {
    const std::string times = published.unit > 0 ? fmt::format(" = {:.4g} times {:.5g} {}", extremes.M_max / (published.unit * body.width),
                                                               published.unit * body.width, moment)
                                                 : "";
    text += fmt::format("Mmax {:.5g} {}{} at V/Vmax {:.3f}, without H; with any H {:.5g} {} at H/Hmax {:.3f}\n", extremes.M_max, moment,
                        times, extremes.V_at_M_max / extremes.V_max, extremes.M_largest, moment, extremes.H_at_M_largest / extremes.H_max);
  }
  for (const base::PublishedNumber& known : published.numbers)
    text += fmt::format("published: {} = {:.5g} [{}: {}{}]\n", known.name, known.formula.value, word_of(known.formula.source.label),
                        citation(known.formula.source),
                        known.formula.valid ? "" : fmt::format("; out of range: {}", known.formula.source.range));
  if (!published.remark.empty()) text += published.remark + "\n";
  return text;
}

}  // namespace berm::envelope
