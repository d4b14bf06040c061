// SPDX-License-Identifier: BSD-3-Clause
// The springs are read back, and CalculiX computes pipes on them whose answers are known.
#include "samples/made_springs.hpp"
#include "samples/temporary_folder.hpp"
#include "springs/formats.hpp"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace berm::springs::this_file {
namespace {

const std::string& text_of(const ExportFiles& files, const std::string& name)
{
  for (const ExportFile& file : files)
    if (file.name == name) return file.text;
  throw std::runtime_error("no file " + name);
}

/// Freedom and points of the only spring of a file.
struct ReadSpring {
  std::string set;
  int freedom = 0;
  Points points;
};

ReadSpring read_spring(const std::string& text)
{
  ReadSpring read;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    Point p{};
    char rest = 0;
    if (line.starts_with("**")) continue;
    if (line.starts_with("*")) {
      EXPECT_TRUE(read.set.empty()) << "one spring a file";
      EXPECT_TRUE(line.starts_with("*SPRING, ELSET=") && line.ends_with(", NONLINEAR")) << line;
      read.set = line.substr(15, line.size() - 15 - 11);
    } else if (read.freedom == 0) {
      int of_ground = 0;
      EXPECT_EQ(std::sscanf(line.c_str(), "%d, %d%c", &read.freedom, &of_ground, &rest), 2) << "no decimal point: " << line;
      EXPECT_EQ(of_ground, read.freedom);
    } else {
      EXPECT_EQ(std::sscanf(line.c_str(), "%lf, %lf%c", &p.F, &p.x, &rest), 2) << line;
      EXPECT_LT(line.find('.'), line.find(',')) << "a force has a decimal point, a freedom none: " << line;
      EXPECT_LE(line.find(','), 20u) << "a number has twenty letters at most";
      if (!read.points.empty()) {
        EXPECT_GT(p.x, read.points.back().x) << "elongations ascend";
      }
      read.points.push_back(p);
    }
  }
  return read;
}

TEST(CalculixFormat, has_a_file_for_each_spring_with_force_before_displacement)
{
  const Design design = made_design();
  const ExportFiles files = calculix_files(design);
  EXPECT_EQ(files.size(), 12u) << "two travels, along the axis, downwards, of three estimates";
  const ReadSpring lateral = read_spring(text_of(files, "springs_low_lateral_sweep_1.inp"));
  EXPECT_EQ(lateral.set, "BERM_LATERAL");
  EXPECT_EQ(lateral.freedom, 2);
  const Points spring = design.low->lateral[0].spring();
  ASSERT_EQ(lateral.points.size(), 2 * spring.size() - 1);
  for (std::size_t k = 0; k < spring.size(); ++k)
    for (const int sign : {1, -1}) {
      const Point& p = lateral.points[spring.size() - 1 + static_cast<std::size_t>(sign) * k];
      EXPECT_NEAR(p.x, sign * spring[k].x, 1e-6 * spring[k].x);
      EXPECT_NEAR(p.F, sign * spring[k].F, 1e-6 * spring[k].F);
    }
  const ReadSpring axial = read_spring(text_of(files, "springs_best_axial.inp"));
  EXPECT_EQ(axial.set, "BERM_AXIAL");
  EXPECT_EQ(axial.freedom, 1);
  ASSERT_EQ(axial.points.size(), 5u);
  EXPECT_EQ(axial.points[3].F, 240);
  EXPECT_NEAR(axial.points[3].x, 0.005, 1e-9);
  const ReadSpring vertical = read_spring(text_of(files, "springs_best_vertical.inp"));
  EXPECT_EQ(vertical.set, "BERM_VERTICAL");
  EXPECT_EQ(vertical.freedom, 3);
  ASSERT_EQ(vertical.points.size(), 5u);
  EXPECT_EQ(vertical.points[1].F, -2000) << "downwards is negative";
  EXPECT_EQ(vertical.points[3].x, 0.5e-6) << "a pipe without load has the stiffness of the bed";
  EXPECT_EQ(vertical.points[3].F, 0);
  EXPECT_EQ(vertical.points[4].F, 0) << "nothing where the pipe is lifted";
}

/// A straight bar along x, 0.3 m by 0.3 m, of sections a metre apart with nine nodes each. That on the axis has the spring, and the number of its section; others have
/// a thousand more for each.
struct Pipe {
  int sections = 81;
  Real E = 0;             ///< Pa
  std::string springs;    ///< the file
  std::string set;        ///< of its elements
  std::string held;       ///< lines of *BOUNDARY
  std::string loads;      ///< lines of *CLOAD
  Real tolerance = 5e-4;  ///< of the sums of forces over their mean; that of the program by itself is 5e-3

  static constexpr Real side = 0.3;
  static constexpr Real area = side * side, inertia = side * side * side * side / 12;
  static int node(int section, int y, int z)
  {
    const int place = 3 * y + z;
    return place == 4 ? section : 1000 * (place + 1) + section;
  }
};

std::string deck_of(const Pipe& pipe)
{
  std::string nodes = "*NODE, NSET=ALL\n", ground = "*NODE, NSET=GROUND\n", solid = "*ELEMENT, TYPE=C3D8I, ELSET=PIPE\n",
              springs = fmt::format("*ELEMENT, TYPE=SPRING2, ELSET={}\n", pipe.set);
  int elements = 0;
  for (int n = 1; n <= pipe.sections; ++n) {
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z)
        nodes += fmt::format("{}, {}., {:.3f}, {:.3f}\n", Pipe::node(n, y, z), n - 1, (y - 1) * Pipe::side / 2, (z - 1) * Pipe::side / 2);
    ground += fmt::format("{}, {}., 0., 0.\n", 20000 + n, n - 1);
    springs += fmt::format("{}, {}, {}\n", 10000 + n, n, 20000 + n);
    for (int y = 0; y < 2 && n < pipe.sections; ++y)
      for (int z = 0; z < 2; ++z) {
        solid += fmt::format("{}", ++elements);
        for (const int above : {0, 1})
          for (const auto& [along, across] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
            solid += fmt::format(", {}", Pipe::node(n + along, y + across, z + above));
        solid += "\n";
      }
  }
  return nodes + ground + fmt::format("*NSET, NSET=AXIS, GENERATE\n1, {}\n", pipe.sections) + solid + springs +
         fmt::format("*MATERIAL, NAME=STEEL\n*ELASTIC\n{:.8e}, 0.\n*SOLID SECTION, ELSET=PIPE, MATERIAL=STEEL\n", pipe.E) +
         "*INCLUDE, INPUT=springs.inp\n*BOUNDARY\nGROUND, 1, 3\n" + pipe.held +
         fmt::format("*STEP, NLGEOM, INC=100\n*STATIC\n0.5, 1.\n*CONTROLS, PARAMETERS=FIELD\n{:.1e}, 1.e-2\n*CLOAD\n", pipe.tolerance) +
         pipe.loads + "*NODE PRINT, NSET=AXIS\nU\n*END STEP\n";
}

/// Displacements of the axis at the end of the step, that CalculiX prints; none where it did not come to it.
std::vector<std::array<Real, 3>> computed(const Pipe& pipe)
{
  const TemporaryFolder folder;
  folder.write("springs.inp", pipe.springs);
  folder.write("pipe.inp", deck_of(pipe));
  const std::string command = "cd '" + folder.path().string() + "' && OMP_NUM_THREADS=1 ccx pipe > ccx.txt 2>&1";
  if (std::system(command.c_str()) != 0) {
    ADD_FAILURE() << folder.read("ccx.txt").substr(0, 3000);
    return {};
  }
  std::vector<std::array<Real, 3>> displacements;
  std::istringstream lines(folder.read("pipe.dat"));
  Real time = 0;
  for (std::string line; std::getline(lines, line);) {
    int node = 0;
    std::array<Real, 3> u{};
    if (const auto at = line.find("and time"); at != std::string::npos) {
      time = std::stod(line.substr(at + 8));
      displacements.clear();
    } else if (std::sscanf(line.c_str(), "%d %lf %lf %lf", &node, &u[0], &u[1], &u[2]) == 4) {
      displacements.push_back(u);
    }
  }
  EXPECT_NEAR(time, 1, 1e-6);
  EXPECT_EQ(displacements.size(), static_cast<std::size_t>(pipe.sections));
  return displacements;
}

class Calculix : public testing::Test {
protected:
  void SetUp() override
  {
    if (std::system("command -v ccx > /dev/null 2>&1") != 0) GTEST_SKIP() << "CalculiX (calculix-ccx) is not installed";
  }
};

/// Only its lateral spring: straight to `limit` (N/m) at `yield` (m), level from there on.
Design level_beyond_yield(Real limit, Real yield)
{
  Design design;
  design.best.diameter = 0.5;
  Lateral l;
  l.stage = "drag";
  l.breaks = true;
  l.peak = l.residual = l.end = limit;
  l.u_peak = yield;
  for (std::size_t k = 0; k < mobilised_parts.size(); ++k) l.mobilised[k] = mobilised_parts[k] * yield;
  l.travel = 1;
  design.best.lateral = {l};
  return design;
}

constexpr Real limit = 600, yield = 0.01, k = limit / yield;  // N/m, m, N/m^2
constexpr Real beta = 0.1;                                    // 1/m: ten springs in 1/beta, four of it in half the pipe
constexpr Real EI = k / (4 * beta * beta * beta * beta);

/// In the middle of a long pipe that a force pushes sideways there.
std::vector<std::array<Real, 3>> pushed_sideways(Real force)
{
  Pipe pipe;
  pipe.E = EI / Pipe::inertia;
  pipe.springs = text_of(calculix_files(level_beyond_yield(limit, yield)), "springs_best_lateral_drag.inp");
  pipe.set = "BERM_LATERAL";
  pipe.held = "AXIS, 3, 3\n1, 1, 1\n8001, 3, 3\n";
  pipe.loads = fmt::format("41, 2, {:.8e}\n", force);
  return computed(pipe);
}

/// w(x) = P beta/(2 k) exp(-beta x) (cos(beta x) + sin(beta x)): Hetenyi's beam on an elastic foundation, without shear (0.02 % here), with springs a metre apart.
TEST_F(Calculix, long_pipe_under_a_small_force_is_a_beam_on_an_elastic_foundation)
{
  constexpr Real w_0 = 0.4 * yield, force = 2 * k * w_0 / beta;
  const auto u = pushed_sideways(force);
  ASSERT_EQ(u.size(), 81u);
  for (const int x : {0, 5, 10, 20}) {
    const Real s = beta * x, w = w_0 * std::exp(-s) * (std::cos(s) + std::sin(s));
    EXPECT_NEAR(u[40 + static_cast<std::size_t>(x)][1], w, 0.003 * w_0) << x << " m from the force";
    EXPECT_NEAR(u[40 - static_cast<std::size_t>(x)][1], w, 0.003 * w_0) << x << " m from the force";
  }
}

/// Where the springs yield over a length `a` each side of the force, EI w'''' = -limit there, and beyond is the end of a beam on an elastic foundation,
/// w = exp(-s) (yield cos(s) + B sin(s)) with s = beta (x - a): w', w'', w''' meet at a, w' = 0 and EI w''' = P/2 at the force. That is linear in P for a given a.
TEST_F(Calculix, long_pipe_whose_springs_yield_moves_as_far_as_plasticity_says)
{
  constexpr Real a = 1 / beta, p = limit;
  const auto w_prime_gap = [&](Real S) {
    const Real B = (S - p * a) / (2 * EI * beta * beta * beta) - yield;
    const Real curvature = -2 * beta * beta * B - S * a / EI + p * a * a / (2 * EI);
    return std::array<Real, 3>{a * curvature + S * a * a / (2 * EI) - p * a * a * a / (6 * EI) - beta * (B - yield), curvature, B};
  };
  const Real at_0 = w_prime_gap(0)[0], at_1 = w_prime_gap(1)[0], S = at_0 / (at_0 - at_1);
  const Real curvature = w_prime_gap(S)[1];
  const auto w_inside = [&](Real x) {
    const auto grown = [&](Real r) { return curvature * r * r / 2 + S * r * r * r / (6 * EI) - p * r * r * r * r / (24 * EI); };
    return yield - grown(a) + grown(x);
  };
  const Real elastic = 2 * S * beta / (2 * k);
  ASSERT_GT(w_inside(0), 1.3 * elastic) << "far from the elastic answer";
  const auto u = pushed_sideways(2 * S);
  ASSERT_EQ(u.size(), 81u);
  // Springs are a metre apart, so that the ends of the yielded length are known to half a metre of ten.
  for (const int x : {0, 5, 10})
    EXPECT_NEAR(u[40 + static_cast<std::size_t>(x)][1], w_inside(x), 0.01 * w_inside(0)) << x << " m from the force";
}

/// Each node carries as much as its spring: under V of the state the pipe lies at its embedment. Unloading has 1e5 N/m2, and the push ends with 1.6e4.
TEST_F(Calculix, pipe_under_V_of_the_state_lies_at_its_embedment)
{
  Design design;
  design.best = made_springs();
  design.best.vertical.unloading = {{"unload", 2000, 1000, 1e5}};
  const Springs& s = design.best;
  Pipe pipe;
  pipe.sections = 11;
  pipe.E = 2.1e11;
  pipe.springs = text_of(calculix_files(design), "springs_best_vertical.inp");
  pipe.set = "BERM_VERTICAL";
  pipe.held = "AXIS, 2, 2\n1, 1, 1\n4001, 2, 2\n";
  const Real rest = s.embedment - s.V / 1e5;
  for (const auto& [V, w] : {std::pair(s.V, s.embedment), std::pair(500., s.embedment - 500 / 1e5),
                             std::pair(1600., s.embedment + 600 / 1e5), std::pair(2400., s.embedment + 1000 / 1e5 + 400 / 1.6e4)}) {
    pipe.loads = fmt::format("AXIS, 3, {:.8e}\n", -V);
    const auto u = computed(pipe);
    ASSERT_EQ(u.size(), 11u);
    for (const auto& node : u) EXPECT_NEAR(rest - node[2], w, 1e-5) << V << " N/m";
  }
}

/// A bar on springs: k_end = EA/l (tanh(L/l) + r)/(1 + r tanh(L/l)) with l^2 = EA/k and r = k h/2 l/EA of the far end, whose node has the spring of a whole metre h
/// and not of half of one; that of the near end is added.
TEST_F(Calculix, pipe_that_is_pulled_along_its_axis_is_a_bar_on_springs)
{
  Design design;
  design.best = made_springs();
  Pipe pipe;
  pipe.E = 2e9;
  pipe.springs = text_of(calculix_files(design), "springs_best_axial.inp");
  pipe.set = "BERM_AXIAL";
  pipe.held = "AXIS, 2, 3\n8001, 3, 3\n";
  const Real k_axial = 240 / 0.005, EA = pipe.E * Pipe::area, l = std::sqrt(EA / k_axial), L = pipe.sections - 1, half = k_axial / 2;
  const Real r = half * l / EA, stiffness = EA / l * (std::tanh(L / l) + r) / (1 + r * std::tanh(L / l)) + half;
  const Real pulled = 0.004;
  for (int y = 0; y < 3; ++y)
    for (int z = 0; z < 3; ++z)
      pipe.loads +=
          fmt::format("{}, 1, {:.8e}\n", Pipe::node(pipe.sections, y, z), stiffness * pulled / 16 * (y == 1 ? 2 : 1) * (z == 1 ? 2 : 1));
  const auto u = computed(pipe);
  ASSERT_EQ(u.size(), 81u);
  EXPECT_NEAR(u.back()[0], pulled, 1e-3 * pulled);
  EXPECT_LT(u.front()[0], 0.6 * pulled) << "the springs hold it back on the way";
}

}  // namespace
}  // namespace berm::springs::this_file
