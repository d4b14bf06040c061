// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/run_record.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

namespace berm::pipe {

/// A number for a table: four digits that count, "–" where it is none.
std::string table_number(Real value);

/// A number for a sentence: three digits that count, without zeros at its end.
std::string short_number(Real value);

/// What a run's forces (N/m) are made dimensionless with.
struct ForceMeasure {
  enum class Kind {
    unknown,  ///< weightless soil with friction or without strength
    weight,   ///< gamma' D^2
    strength  ///< D s_u, of soil without friction; s_u that at the surface
  };
  Kind kind = Kind::unknown;
  Real size = 0;  ///< N/m
};

ForceMeasure force_measure(const RunRecord& run);

/// The same in letters, as HTML.
std::string letters_of(ForceMeasure::Kind kind);

/// How forces per metre and lengths of all runs stand on one page: at model scale in the units of the largest (unit_of_forces), dimensionless, and at prototype scale
/// (times the gravity level) where a run has one.
class DisplayUnits {
public:
  explicit DisplayUnits(const std::vector<RunRecord>& runs);

  /// The columns of a force called `symbol` (HTML), each with its unit; and a force (N/m) of a run in them.
  std::vector<text::HtmlCell> force_columns(const std::string& symbol) const;
  std::vector<text::HtmlCell> force_cells(const RunRecord& run, Real force) const;
  /// The same of a length, m.
  std::vector<text::HtmlCell> length_columns(const std::string& symbol) const;
  std::vector<text::HtmlCell> length_cells(const RunRecord& run, Real length) const;

  /// "0.783 kN/m (39.1 kN/m in the prototype, 4.55 γ′ D²)", HTML.
  std::string force_text(const RunRecord& run, Real force) const;
  /// "0.1 D (2 mm, 0.1 m in the prototype)".
  std::string length_text(const RunRecord& run, Real length) const;

  /// What the prototype is, as a paragraph; "" without one.
  std::string prototype_words() const;

  const char* force_unit() const { return force_.name; }
  /// A force (N/m) in that unit.
  Real in_force_unit(Real force) const { return force / force_.size; }

private:
  text::NamedUnit force_, prototype_force_, length_;
  std::vector<Real> levels_;  ///< gravity levels of the runs that have a prototype, each once
  bool by_weight_ = false, by_strength_ = false;
};

}  // namespace berm::pipe
