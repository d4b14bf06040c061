// SPDX-License-Identifier: BSD-3-Clause
#include "os/error.hpp"
#include "samples/made_pile.hpp"
#include "springs/line_formats.hpp"
#include "structures/lateral/axial_codes.hpp"
#include "structures/lateral/codes.hpp"
#include "structures/lateral/p_y.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

namespace berm::springs::this_file {
namespace {

constexpr int slices = 4;

/// A made pile in four slices with p = k y.
record::RunRecord sliced()
{
  record::RunRecord run = MadePile{}.record();
  run.settings.rigid[0].second.depth_slices = slices;
  const lateral::LateralRun lateral(run);
  for (int n = 0; n < slices; ++n) {
    run_folder::Column column = run.history.columns[3];
    column.name = fmt::format("H{}_N", n + 1);
    std::vector<Real> H(run.history.stage.size(), 0);
    for (std::size_t k = 0; k < lateral.path.rows.size(); ++k)
      H[lateral.path.rows[k]] = 2e6 * (lateral.path.u[k] - (2 * n + 1) * std::sin(lateral.path.tilt[k])) * 2;
    run.history.columns.push_back(column), run.history.values.push_back(H);
  }
  return run;
}

const ExportFile& file(const ExportFiles& files, const std::string& name)
{
  const auto found = std::ranges::find(files, name, &ExportFile::name);
  if (found == files.end()) throw std::runtime_error("no " + name);
  return *found;
}

/// A table behind its comments: names of columns, and rows of fields.
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  explicit Table(const std::string& text)
  {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with('#')) continue;
      std::vector<std::string> fields;
      std::istringstream of(line + ",");
      for (std::string field; std::getline(of, field, ',');) fields.push_back(field);
      if (names.empty())
        names = fields;
      else
        rows.push_back(fields);
    }
  }
  Real at(std::size_t row, const std::string& name) const
  {
    return std::stod(rows.at(row).at(std::ranges::find(names, name) - names.begin()));
  }
};

// Six digits are written.
constexpr Real written = 1e-5;

TEST(PileFormats, py_read_back_has_the_numbers_of_the_run_and_of_the_codes)
{
  const record::RunRecord record = sliced();
  const lateral::LateralRun run(record);
  const ExportFiles files = py_files(record);
  const Table table(file(files, "py.csv").text);
  const std::vector<lateral::PyCurve> curves = lateral::py_curves(run);
  const std::vector<lateral::CodeMethod> codes = lateral::code_methods(run);
  ASSERT_EQ(codes.size(), 6u);
  ASSERT_EQ(table.rows.size(), slices * curves[0].y.size());
  std::size_t row = 0;
  for (const lateral::PyCurve& curve : curves)
    for (std::size_t k = 0; k < curve.y.size(); ++k, ++row) {
      EXPECT_NEAR(table.at(row, "z_m"), curve.z, written);
      EXPECT_NEAR(table.at(row, "y_m"), curve.y[k], written * std::abs(curve.y[k]));
      EXPECT_NEAR(table.at(row, "p_computed_N_m"), curve.p[k], written * std::abs(curve.p[k]));
      for (const lateral::CodeMethod& code : codes) {
        const Real p = code.p(curve.z, curve.y[k]).value;
        EXPECT_NEAR(table.at(row, "p_" + code.column + "_N_m"), p, written * std::abs(p)) << code.name;
      }
    }
  const Table by_codes(file(files, "py_codes.csv").text);
  ASSERT_FALSE(by_codes.rows.empty());
  for (std::size_t k = 0; k < by_codes.rows.size(); ++k) {
    const Real p = codes[3].p(by_codes.at(k, "z_m"), by_codes.at(k, "y_m")).value;
    EXPECT_NEAR(by_codes.at(k, "p_iso_N_m"), p, 3 * written * std::abs(p));
  }
}

TEST(PileFormats, spring_elements_ascend_both_ways_from_the_origin)
{
  const ExportFiles files = py_files(sliced());
  for (const char* name : {"py_computed.inp", "py_api.inp", "py_pisa_cowden.inp"}) {
    std::istringstream lines(file(files, name).text);
    int elements = 0;
    Real last = -infinity, smallest = infinity;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("*SPRING")) {
        EXPECT_NE(line.find("NONLINEAR"), std::string::npos);
        std::getline(lines, line);
        ++elements, last = -infinity;
      } else if (!line.starts_with("**")) {
        const std::size_t comma = line.find(',');
        const Real F = std::stod(line.substr(0, comma)), x = std::stod(line.substr(comma + 1));
        EXPECT_GT(x, last) << name;
        EXPECT_GE(F * x, 0) << name;
        last = x, smallest = std::min(smallest, std::abs(x) + std::abs(F));
      }
    }
    EXPECT_EQ(elements, slices);
    EXPECT_EQ(smallest, 0) << "the origin";
  }
}

TEST(PileFormats, axial_springs_are_those_of_api)
{
  const record::RunRecord record = sliced();
  const ExportFiles files = py_files(record);
  const std::optional<lateral::AxialCode> code = lateral::axial_code(lateral::LateralRun(record));
  ASSERT_TRUE(code);
  const Table t(file(files, "tz.csv").text), Q(file(files, "qz.csv").text);
  Real largest = 0;
  for (std::size_t k = 0; k < t.rows.size(); ++k)
    if (std::abs(t.at(k, "z_m") - code->shaft[0].z) < 1e-9) largest = std::max(largest, t.at(k, "t_N_m"));
  EXPECT_NEAR(largest, code->shaft[0].t.value, written * largest);
  EXPECT_NEAR(Q.at(Q.rows.size() - 1, "Q_N"), code->base.value, written * code->base.value);
}

TEST(PileFormats, refuse_a_run_without_slices)
{
  EXPECT_THROW(py_files(MadePile{}.record()), InputError);
}

}  // namespace
}  // namespace berm::springs::this_file
