// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/tensor.hpp"
#include "core/types.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace berm::run_folder {

/// A unit of columns: as UDUNITS-2 spells it ("1" = a bare number), and as the names of its columns end ("" = with nothing).
struct ColumnUnit {
  const char *name, *ending;
  const ColumnUnit* whole = nullptr;  ///< of what a part of the whole has a part of: the unit of the whole
};
inline constexpr ColumnUnit bare{"1", ""}, seconds{"s", "s"}, metres{"m", "m"}, metres_per_second{"m/s", "m_s"}, radians{"rad", "rad"},
    pascals{"Pa", "Pa"};
inline constexpr ColumnUnit whole_newtons{"N", "N"}, whole_joules{"J", "J"}, whole_newton_metres{"N m", "Nm"},
    whole_newton_metre_seconds{"N m s", "Nm_s"}, square_metres{"m2", "m2"}, whole_kilograms{"kg", "kg"};
/// What a model of a part in space has a part of, in the unit of the whole.
constexpr ColumnUnit of_part(const ColumnUnit& whole)
{
  return {whole.name, whole.ending, &whole};
}
/// What plane strain counts per metre run, and space as a whole.
template <int dim>
inline constexpr ColumnUnit newtons = dim == 2 ? ColumnUnit{"N/m", "N_m", &whole_newtons} : of_part(whole_newtons);
template <int dim>
inline constexpr ColumnUnit joules = dim == 2 ? ColumnUnit{"J/m", "J_m", &whole_joules} : of_part(whole_joules);
template <int dim>
inline constexpr ColumnUnit newton_metres = dim == 2 ? ColumnUnit{"N m/m", "Nm_m", &whole_newton_metres} : of_part(whole_newton_metres);
template <int dim>
inline constexpr ColumnUnit newton_metre_seconds = dim == 2 ? ColumnUnit{"N s", "N_s", &whole_newton_metre_seconds}
                                                            : of_part(whole_newton_metre_seconds);
template <int dim>
inline constexpr ColumnUnit surface = dim == 2 ? ColumnUnit{"m", "m", &square_metres} : of_part(square_metres);

template <int dim>
inline constexpr ColumnUnit kilograms = dim == 2 ? ColumnUnit{"kg/m", "kg_m", &whole_kilograms} : of_part(whole_kilograms);

/// What is said of a column of history.csv where its value is made.
struct Column {
  std::string name;     ///< as the file spells it: tip_uy_m
  std::string label;    ///< the same for people and without its unit, whatever the dimension: "tip uy"
  std::string unit;     ///< SI, as UDUNITS-2 spells it; "1" = a bare number
  std::string meaning;  ///< in some words
  std::string of;       ///< the body, contact, traction or watch that it is of, or "run"

  bool operator==(const Column&) const = default;
  /// "embedment" of what needs no name, else the label.
  const std::string& words() const { return name.starts_with(of + '_') ? label : meaning; }
};

/// A row of history.csv. A column is declared where its value is made:
///
///   row("w", motion.w, metres, "embedment");  // the column w_m
///
/// The first row fixes the columns; a later one with others is a RunError. The columns time_s and stage come before all others.
class Row {
public:
  /// From here on forces, moments, energies and areas are those of one of so many equal parts (radians around an axis, halves or quarters in space), and go into
  /// the columns of the whole.
  void count_parts(Real parts) { parts_ = parts; }
  /// What such a number is multiplied with in its column.
  Real parts() const { return parts_; }

  /// Begins a row; what follows is of the run.
  void begin(Real time, const std::string& stage);
  /// What follows is of this, whose name the columns begin with: tip_uy_m.
  void of(std::string_view what) { set_of(what, true); }
  /// What follows is of this, whose name the columns leave out: it is the only one of its kind, or the main one.
  void of_main(std::string_view what) { set_of(what, false); }

  void operator()(std::string_view symbol, Real value, const ColumnUnit& unit, std::string_view meaning);
  /// A vector by its components: ux_m, uy_m and, in space, uz_m.
  template <int dim>
  void operator()(std::string_view symbol, const Vec<dim>& value, const ColumnUnit& unit, std::string_view meaning)
  {
    for (int d = 0; d < dim; ++d) component(symbol, d, value[d], unit, meaning);
  }
  /// One component of a vector, d = 0, 1, 2.
  void component(std::string_view symbol, int d, Real value, const ColumnUnit& unit, std::string_view meaning);
  /// A stress: sxx_Pa, syy_Pa ...
  template <int dim>
  void operator()(std::string_view symbol, const SymTensor<dim>& value, const ColumnUnit& unit, std::string_view meaning)
  {
    for (int k = 0; k < tensor_size<dim>; ++k) add(symbol, tensor_components[k], value.c[k], unit, meaning);
  }

  /// Ends the row: the columns are fixed. Throws RunError where it has less columns than the rows before.
  void end();

  const std::vector<Column>& columns() const { return columns_; }  ///< but the stage
  const std::vector<Real>& values() const { return values_; }
  const std::string& stage() const { return stage_; }

private:
  static constexpr const char* tensor_components[6] = {"xx", "yy", "zz", "xy", "yz", "zx"};

  void set_of(std::string_view what, bool in_name);
  void add(std::string_view symbol, std::string_view component, Real value, const ColumnUnit& unit, std::string_view meaning);
  [[noreturn]] void refuse() const;

  std::vector<Column> columns_;
  std::vector<Real> values_;
  Real parts_ = 1;
  bool fixed_ = false, of_in_name_ = false;
  std::string of_, stage_, name_;  ///< name_: of the column being added
};

}  // namespace berm::run_folder
