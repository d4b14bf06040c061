// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/springs/pile_formats_test.cpp
#include "os/error.hpp"
#include "springs/design.hpp"
#include "springs/line_formats.hpp"
#include "springs/written_springs.hpp"
#include "structures/depth/profile.hpp"
#include "structures/lateral/axial_codes.hpp"
#include "structures/lateral/codes.hpp"
#include "structures/lateral/p_y.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::springs {
namespace {

/// Displacements over D at which codes are tabulated.
constexpr std::array code_points{0.,   0.0003, 0.001, 0.002, 0.003, 0.005, 0.009, 0.014, 0.022, 0.032,
                                 0.05, 0.082,  0.1,   0.15,  0.2,   0.25,  0.4,   0.6,   1.};
constexpr std::array axial_points{0., 0.0016, 0.0031, 0.0057, 0.008, 0.01, 0.02, 0.042, 0.073, 0.1, 0.2};

/// A depth with resistance per metre over displacement, from the origin on and ascending.
struct DepthSpring {
  Real z;
  Points points;
};
struct SpringSet {
  std::string column, name;
  std::vector<DepthSpring> springs;
};

/// The points at which a computed curve goes farther than before: below the pivot it goes the other way.
DepthSpring of_curve(const lateral::PyCurve& curve)
{
  DepthSpring spring{curve.z, {{0, 0}}};
  const Real side = curve.y.back() < 0 ? -1 : 1;
  for (std::size_t k = 0; k < curve.y.size(); ++k)
    if (side * curve.y[k] > spring.points.back().x) spring.points.push_back({side * curve.y[k], side * curve.p[k]});
  return spring;
}

/// As computed, then each code at the same depths.
std::vector<SpringSet> spring_sets(const lateral::LateralRun& run, const std::vector<lateral::PyCurve>& curves)
{
  std::vector<SpringSet> sets{{"computed", "computed", {}}};
  for (const lateral::PyCurve& curve : curves) sets[0].springs.push_back(of_curve(curve));
  for (const lateral::CodeMethod& code : lateral::code_methods(run)) {
    SpringSet set{code.column, fmt::format("{} ({})", code.name, code.choices), {}};
    for (const lateral::PyCurve& curve : curves) {
      DepthSpring spring{curve.z, {}};
      for (const Real part : code_points) spring.points.push_back({part * run.width, code.p(curve.z, part * run.width).value});
      set.springs.push_back(std::move(spring));
    }
    const auto unknown = [](const DepthSpring& spring) {
      return std::ranges::any_of(spring.points, [](const Point& point) { return std::isnan(point.F); });
    };
    if (std::ranges::none_of(set.springs, unknown)) sets.push_back(std::move(set));  // else not of a pile so slender
  }
  return sets;
}

/// Computed p of each point, and what the codes have at its y.
std::string computed_table(const lateral::LateralRun& run, const std::vector<lateral::PyCurve>& curves)
{
  const std::vector<lateral::CodeMethod> codes = lateral::code_methods(run);
  std::string text = "z_m,u_at_bed_m,y_m,p_computed_N_m";
  for (const lateral::CodeMethod& code : codes) text += fmt::format(",p_{}_N_m", code.column);
  text += '\n';
  for (const lateral::PyCurve& curve : curves)
    for (std::size_t k = 0; k < curve.y.size(); ++k) {
      text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}", curve.z, curve.u[k], curve.y[k], curve.p[k]);
      for (const lateral::CodeMethod& code : codes) text += fmt::format(",{:.6g}", code.p(curve.z, curve.y[k]).value);
      text += '\n';
    }
  return text;
}

/// The codes by depth and displacement.
std::string code_table(const std::vector<SpringSet>& sets)
{
  std::string text = "z_m,y_m";
  for (std::size_t s = 1; s < sets.size(); ++s) text += fmt::format(",p_{}_N_m", sets[s].column);
  text += '\n';
  for (std::size_t d = 0; d < sets[1].springs.size(); ++d)
    for (std::size_t k = 0; k < sets[1].springs[d].points.size(); ++k) {
      text += fmt::format("{:.6g},{:.6g}", sets[1].springs[d].z, sets[1].springs[d].points[k].x);
      for (std::size_t s = 1; s < sets.size(); ++s) text += fmt::format(",{:.6g}", sets[s].springs[d].points[k].F);
      text += '\n';
    }
  return text;
}

/// SPRING elements across the pile for 1 m of it, force before displacement, both ways.
std::string spring_elements(const SpringSet& set)
{
  std::string text;
  for (std::size_t d = 0; d < set.springs.size(); ++d) {
    text += fmt::format("** z = {:.6g} m below the seabed\n*SPRING, ELSET=BERM_PY_{}, NONLINEAR\n1, 1\n", set.springs[d].z, d + 1);
    for (const Point& point : both_ways(set.springs[d].points)) text += fmt::format("{:.6e}, {:.6e}\n", point.F, point.x);
  }
  return text;
}

void add_axial(const lateral::LateralRun& run, const std::string& head, ExportFiles& files)
{
  const std::optional<lateral::AxialCode> code = lateral::axial_code(run);
  if (!code) return;
  const std::string source = citation(code->base.source);
  std::string t =
      head +
      fmt::format(
          "# friction of the shaft per metre of depth, by {}, within its range; of the run where a stage moves the pile along its axis\n"
          "source,stage,z_m,w_m,t_N_m\n",
          source);
  std::string Q = head + fmt::format("# reaction of a closed base by {}\nsource,w_m,Q_N\n", source);
  for (const lateral::AxialCode::Slice& slice : code->shaft)
    for (const Real part : axial_points)
      if (slice.t.valid)
        t += fmt::format("api,,{:.6g},{:.6g},{:.6g}\n", slice.z, part * run.width, slice.t.value * code->friction_share(part * run.width));
  for (const depth::TzCurve& curve : depth::tz_curves(run.record)) {
    const auto stage = std::ranges::find(run.record.settings.stage, curve.stage, &settings::StageSettings::name);
    if (stage == run.record.settings.stage.end() || base::goes_sideways(run.record.settings, *stage)) continue;
    for (std::size_t k = 0; k < curve.w.size(); ++k)
      t += fmt::format("computed,{},{:.6g},{:.6g},{:.6g}\n", curve.stage, curve.z, curve.w[k], curve.t[k]);
  }
  for (const Real part : axial_points)
    Q += fmt::format("api,{:.6g},{:.6g}\n", part * run.width, code->base.value * code->base_share(part * run.width));
  files.push_back({"tz.csv", std::move(t)});
  if (code->closed) files.push_back({"qz.csv", std::move(Q)});
}

}  // namespace

ExportFiles pile_files(const record::RunRecord& record)
{
  const lateral::LateralRun run(record);
  const std::vector<lateral::PyCurve> curves = lateral::py_curves(run);
  if (curves.empty())
    throw InputError(fmt::format(
        "{} is not a run of a pipeline: its case has no [pipeline]; nor has it p-y curves of a pile, which need a stage that loads a "
        "body laterally and rigid.NAME.depth_slices",
        record.folder.string()));
  std::string head;
  for (const std::string& line : head_of(record)) head += "# " + line + "\n";
  head += fmt::format("# run {}\n", record.name);
  const std::vector<SpringSet> sets = spring_sets(run, curves);
  ExportFiles files{
      {"py.csv", head + "# p along the load per metre of depth against y of the axis at that depth, computed and by codes at the same y\n" +
                     computed_table(run, curves)}};
  if (sets.size() > 1) {
    std::string codes = head + "# p by codes and published methods, as implemented in public programs\n";
    for (std::size_t s = 1; s < sets.size(); ++s) codes += fmt::format("# {}: {}\n", sets[s].column, sets[s].name);
    files.push_back({"py_codes.csv", codes + code_table(sets)});
  }
  for (const SpringSet& set : sets) {
    std::string text;
    for (const std::string& line : head_of(record)) text += "** " + line + "\n";
    text += fmt::format(
        "** run {}, {}\n** N and m, for 1 m of depth: multiply the forces by the length that a node stands for; x along the load\n",
        record.name, set.name);
    files.push_back({fmt::format("py_{}.inp", set.column), text + spring_elements(set)});
  }
  add_axial(run, head, files);
  return files;
}

}  // namespace berm::springs
