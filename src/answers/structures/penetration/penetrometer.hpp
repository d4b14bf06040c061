// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"
#include "structures/base/structure.hpp"

namespace berm::penetration {

class PenetrationRun;

/// A symbol as it stands in names of results, and as HTML: "N_kt", "N<sub>kt</sub>".
struct Symbol {
  const char *plain, *html;
};

/// A number of a run beside a published one.
struct Comparison {
  std::string quantity;  ///< HTML
  Real berm;
  formulas::Formula published;
  std::string about;            ///< HTML, "" = nothing to add
  bool level = false;           ///< of the factor that the log shows: a line in it
  std::string on_surface = "";  ///< of a body on the surface of the soil that is below this one: which, "rough base"
};

/// What the net resistance is divided by in soil with friction.
enum class SandMeasure {
  overburden,  ///< sigma_v0
  half_weight  ///< gamma D/2
};

/// How practice reads the resistance of a body that is pushed down: q = V/A over the depth z of its level of full width.
struct Penetrometer {
  const char* word;         ///< that the input calls it
  const char* level;        ///< what z is the depth of: "shoulder of the cone"
  Symbol resistance;        ///< q, Pa
  Symbol in_clay, in_sand;  ///< net resistance over s_u; over the measure of sand
  SandMeasure sand_measure;
  bool flows_around;         ///< soil closes above the body: net of the weight of the soil that it displaces, else of sigma_v0
  Real averaging;            ///< over D: half of the travel over which q is averaged; a twentieth of a short way
  Real last_travel;          ///< over D: the end over which means are taken, and the factor must not change to be steady
  std::vector<Real> depths;  ///< over D: where results are taken
  bool keeps_push;           ///< whether it may be dragged after the push, whose end, and no steady resistance, is then asked for
  const base::Limit* cells;  ///< of D over the size of the cells at the body
  std::vector<Comparison> (*published)(const PenetrationRun& run);
  const char* remark;         ///< on what is published, plain; "" = none
  bool pushes_aside = false;  ///< whether soil is pushed aside as by a cavity that grows
  base::Reading also{};       ///< what it has beyond that
};

}  // namespace berm::penetration
