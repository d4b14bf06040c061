// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "springs/formats.hpp"

// What the files of all programs have in common.

namespace berm::springs {

enum class Direction { lateral, axial, vertical };

/// A spring as files have it.
struct WrittenSpring {
  Direction direction;
  std::string travel;  ///< that it was found in; of a formula none
  Points points;       ///< displacement and resistance per length one way, from the origin on; downwards positive
  Real V;              ///< N/m, the normal force that coefficients of friction are over; NaN: there are none
  std::string origin;  ///< run, state, travel and what it was found by, in one line
};

/// Of each travel, along the axis and downwards: those that are known.
std::vector<WrittenSpring> springs_to_write(const Springs& springs);

/// What the peak of a lateral spring is: "H at breakout", ...
const char* peak_words(const Lateral& lateral);
/// Where a lateral, the axial and the vertical spring are from: run, state, travel, formula.
std::string origin_of(const Springs& springs, const Lateral& lateral);
std::string axial_origin(const Springs& springs);
std::string vertical_origin(const Springs& springs);
/// "axial, undisturbed clay": what the axial spring is called, with whose strength it has.
std::string axial_title(const Springs& springs);

/// Straight to the breakout, and down to the residual where that is less; level from there on. None where nothing is mobilised.
Points axial_spring(const Springs& springs, Real Range::*estimate = &Range::best);
/// N/m, the vertical force under which the pipe slides along its axis: that of the state, else that of the first drag.
Real axial_V(const Springs& springs);
/// V over the embedment, of the pipe as it lies in the state: nothing down to where it would rise to without load, then the line of unloading and reloading through the state to
/// the preload, then the virgin curve, with its last slope for another tenth of the diameter where it has not been followed so deep. Without V in the state the virgin curve.
Points vertical_spring(const Springs& springs);
/// The same over the way down from the pipe without load, for elements that begin there; what says where that is.
Points from_rest(Points vertical);
std::string rest_words(const Springs& springs);

/// A spring that resists both ways: its points mirrored, from the least displacement on.
Points both_ways(const Points& spring);
/// One that resists downwards only, over a displacement that is positive upwards: nothing where the pipe is lifted, up to `lift`.
Points upwards_positive(const Points& push, Real lift);
/// Level for another `length` beyond its last point, for programs that go on with the last slope.
Points level_beyond(Points spring, Real length);

/// N/m^2, V over w for small changes of V: of the first stage that unloads or reloads, else by the formula, else of the whole push; NaN where none is known.
struct NormalStiffness {
  Real value = nan;
  std::string origin;
};
NormalStiffness normal_stiffness(const Springs& springs);

/// Says that a spring ("sweep_1") has no coefficient of friction.
std::string without_friction(const std::string& spring);

/// A comment behind the mark that begins one, in lines of at most some 120 letters.
std::string remark(const std::string& mark, const std::string& text);
/// Comments at the head of a file: the provenance, the springs that are missing, `remarks` (units, how sure the format is), the size of the prototype.
std::string comments(const Design& design, const std::string& mark, const std::vector<std::string>& remarks);

/// A name of at most `max` letters, digits and _, in capitals.
std::string identifier(const std::string& name, std::size_t max);

/// One file for each estimate, made by body(set, springs).
template <class Body>
ExportFiles by_estimate(const Design& design, const char* extension, const Body& body)
{
  ExportFiles files;
  for (const auto& [set, springs] : sets_of(design)) files.push_back({"springs_" + set + "." + extension, body(set, *springs)});
  return files;
}

}  // namespace berm::springs
