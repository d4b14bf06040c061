// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/summary.hpp"
#include "structures/base/driven_body.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <optional>
#include <string>

namespace berm::base {

/// What forces per metre are made dimensionless with; those in space are not.
struct ForceMeasure {
  enum class Kind {
    unknown,  ///< weightless soil with friction or without strength
    weight,   ///< gamma' D^2
    strength  ///< D s_u, of soil without friction; s_u that at BodyScale::strength_depth
  };
  Kind kind = Kind::unknown;
  Real size = 0;  ///< N/m
};

ForceMeasure force_measure(const BodyScale& scale);

/// The same as summary.json has it, "suD" or "gammaD2" with its letters; empty where there is none.
std::optional<run_folder::Quantity> measure_quantity(const BodyScale& scale);

/// The same in letters, as HTML.
std::string letters_of(ForceMeasure::Kind kind);

/// The results of a run, and what they are made dimensionless with.
struct ScaledRun {
  BodyScale scale;
  const std::vector<run_folder::Quantity>* quantities;
};

/// How forces (per metre; in space whole) and lengths of all runs stand on one page: at model scale in the units of the largest (unit_of_forces), per metre
/// dimensionless, and at prototype scale where a run has one: lengths and forces per metre times the gravity level, forces in space times its square.
class DisplayUnits {
public:
  explicit DisplayUnits(const std::vector<ScaledRun>& runs);

  /// The columns of a force called `symbol` (HTML), each with its unit; and a force (N/m, N) under a scale in them.
  std::vector<text::HtmlCell> force_columns(const std::string& symbol) const;
  std::vector<text::HtmlCell> force_cells(const BodyScale& scale, Real force) const;
  /// The same of a length, m.
  std::vector<text::HtmlCell> length_columns(const std::string& symbol) const;
  std::vector<text::HtmlCell> length_cells(const BodyScale& scale, Real length) const;

  /// "0.783 kN/m (39.1 kN/m in the prototype, 4.55 γ′ D²)", HTML.
  std::string force_text(const BodyScale& scale, Real force) const;
  /// "0.1 D (2 mm, 0.1 m in the prototype)".
  std::string length_text(const BodyScale& scale, Real length) const;

  /// What the prototype is, and at which depth s_u is taken where it varies, as paragraphs; "" without either.
  std::string scale_words() const;

  /// The unit of the forces of a run.
  const char* force_unit(const BodyScale& scale) const { return force_.of(scale).name; }
  /// A force (N/m or N) in its unit.
  Real in_force_unit(Real force) const { return force / force_.plane.size; }

private:
  /// One size, with its name per metre and in space.
  struct ForceUnit {
    text::NamedUnit plane{1, "N/m"}, space{1, "N"};
    const text::NamedUnit& of(const BodyScale& scale) const { return scale.dimension == 2 ? plane : space; }
    std::string heading(bool some_in_plane, bool some_in_space) const;
  };

  ForceUnit force_, prototype_force_;
  text::NamedUnit length_;
  std::vector<std::pair<Real, Real>> strengths_;  ///< Pa, and the depth where the soil has it, m: of the runs whose soil varies, each once
  std::vector<Real> levels_;                      ///< gravity levels of the runs that have a prototype, each once
  bool by_weight_ = false, by_strength_ = false, in_plane_ = false, in_space_ = false;
};

/// A range of src/formulas, "0 <= w/D <= 0.5", with the signs of print, HTML.
std::string printed_range(const char* range);

}  // namespace berm::base
