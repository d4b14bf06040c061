// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/pipe/plots_test.cpp
#include "io/atomic_file.hpp"
#include "plot/gnuplot.hpp"
#include "plot/nice_number.hpp"
#include "plot/raster.hpp"
#include "structures/pipe/plots.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::pipe {
namespace {

constexpr int width = 1200, left = 95, right = 175, bottom = 80, top = 70;  // pixels; the plot's height follows from the view
constexpr int plot_width = width - left - right;
// Ten equally spaced colours of viridis, which is even to the eye and in grey.
constexpr const char* palette =
    "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', 6 '#35b779', "
    "7 '#6ece58', 8 '#b5de2b', 9 '#fde725')\n";

/// A picture in the making: what it shows and in which unit.
struct Picture {
  const run_folder::Frame<2>& frame;
  const std::string& name;
  bool since_start;
  const SoilView& view;
  plot::PlotUnit unit;
  Vec<2> size() const { return view.upper - view.lower; }
  int plot_height() const { return std::clamp(static_cast<int>(std::lround(plot_width * size()[1] / size()[0])), 200, 1400); }
  const char* words() const
  {
    return since_start ? "deviatoric strain of displacement since the start" : "deviatoric strain of displacement since last frame";
  }
  Real value(const run_folder::FrameParticle<2>& f) const { return since_start ? f.strain.deviatoric : f.strain_increment; }
};

constexpr std::size_t max_disks = 100'000;  // beyond, a picture of a million pixels has hardly any left for each

/// Radius of the disk that stands for a particle: larger than its share, so that neighbours close the ground between them.
Real shown_radius(const bodies::Particle<2>& p)
{
  return std::sqrt(p.volume);
}

std::vector<const run_folder::FrameParticle<2>*> particles_in_view(const Picture& picture)
{
  std::vector<const run_folder::FrameParticle<2>*> shown;
  for (const run_folder::FrameParticle<2>& f : picture.frame.particles) {
    const auto x = f.particle.x.array();
    const Real radius = shown_radius(f.particle);
    if ((x >= picture.view.lower.array() - radius).all() && (x <= picture.view.upper.array() + radius).all()) shown.push_back(&f);
  }
  return shown;
}

/// The data of a picture of disks.
std::string disks(const Picture& picture, const std::vector<const run_folder::FrameParticle<2>*>& particles)
{
  const plot::PlotUnit& unit = picture.unit;
  std::string data = fmt::format("# x, y, radius ({}), {}\n", unit.name, picture.words());
  for (const run_folder::FrameParticle<2>* f : particles)
    data += fmt::format("{:.6g} {:.6g} {:.4g} {:.5g}\n", f->particle.x[0] * unit.per_si, f->particle.x[1] * unit.per_si,
                        shown_radius(f->particle) * unit.per_si, picture.value(*f));
  return data;
}

std::string pixel_text(const Picture& picture, const plot::Raster& raster)
{
  return fmt::format("# {}, of each pixel, a line a row, the lowest first\n", picture.words()) + raster.text();
}

/// The data of a picture of triangles: each is painted as four, between its corners and the middles of its sides.
std::string pixels(const Picture& picture)
{
  constexpr int parts[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  plot::Raster raster(picture.view.lower, picture.view.upper, plot_width, picture.plot_height());
  for (const std::array<Index, 6>& nodes : picture.frame.triangles)
    for (const auto& part : parts) {
      std::array<Vec<2>, 3> corners;
      std::array<Real, 3> values;
      for (int k = 0; k < 3; ++k) {
        const run_folder::FrameParticle<2>& node = picture.frame.particles[nodes[part[k]]];
        corners[k] = node.particle.x;
        values[k] = picture.value(node);
      }
      raster.paint(corners, values);
    }
  return pixel_text(picture, raster);
}

/// Particles as pixels, each as the square of its radius: a vector graphic of a disk for every particle would be tens of megabytes, and gnuplot takes more
/// than a kilobyte of memory for each.
std::string pixels(const Picture& picture, const std::vector<const run_folder::FrameParticle<2>*>& particles)
{
  plot::Raster raster(picture.view.lower, picture.view.upper, plot_width, picture.plot_height());
  for (const run_folder::FrameParticle<2>* f : particles) {
    const Real half = shown_radius(f->particle), value = picture.value(*f);
    const Vec<2> x = f->particle.x, across(half, -half), up(half, half);
    raster.paint({x - up, Vec<2>(x + across), Vec<2>(x + up)}, {value, value, value});
    raster.paint({x - up, Vec<2>(x + up), Vec<2>(x - across)}, {value, value, value});
  }
  return pixel_text(picture, raster);
}

std::string outlines(const Picture& picture)
{
  const Real per_si = picture.unit.per_si;
  std::string data = fmt::format("# x, y ({}) of each rigid body\n", picture.unit.name);
  for (const run_folder::FrameRigid<2>& rigid : picture.frame.rigid_bodies)
    for (const auto& cell : rigid.surface.cells) {
      const auto line = [&](Index k) {
        return fmt::format("{:.6g} {:.6g}\n", rigid.surface.points[k][0] * per_si, rigid.surface.points[k][1] * per_si);
      };
      for (const Index k : cell.points) data += line(k);
      data += line(cell.points[0]) + '\n';
    }
  return data;
}

/// The value that one particle in a hundred exceeds.
Real hundredth(const Picture& picture, const std::vector<const run_folder::FrameParticle<2>*>& particles)
{
  std::vector<Real> values;
  for (const run_folder::FrameParticle<2>* f : particles) values.push_back(picture.value(*f));
  const auto place = values.end() - 1 - static_cast<std::ptrdiff_t>(values.size() / 100);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Axes, colours and the line of the surface.
std::string axes(const Picture& picture, Real max, const std::string& title)
{
  const int height = picture.plot_height() + bottom + top;
  const SoilView& view = picture.view;
  const plot::PlotUnit& unit = picture.unit;
  const auto part = [](int pixels, int of) { return static_cast<Real>(pixels) / of; };
  std::string script = fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\n",
      part(left, width), 1 - part(right, width), part(bottom, height), 1 - part(top, height));
  script += fmt::format("set title {} font 'DejaVu Sans,17'\nset size ratio -1\n", plot::gnuplot_text(title));
  script += fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", view.lower[0] * unit.per_si,
                        view.upper[0] * unit.per_si, view.lower[1] * unit.per_si, view.upper[1] * unit.per_si);
  script += fmt::format("set xlabel 'x ({0})'\nset ylabel 'y ({0})'\nset tics out nomirror\nset border lc rgb '#444444'\n", unit.name);
  script += fmt::format("set cblabel '{}'\nset cbrange [0:{:g}]\n", picture.words(), plot::round_up(max));
  script += std::string(palette) + "unset key\nset style fill solid noborder\n";
  if (view.surface) {
    const Real level = *view.surface * unit.per_si;
    script += fmt::format("set arrow 1 from {:.6g},{:.6g} to {:.6g},{:.6g} nohead dt 2 lc rgb '#666666' lw 1 front\n",
                          view.lower[0] * unit.per_si, level, view.upper[0] * unit.per_si, level);
  }
  return script;
}

/// A file of plots/ between quotes. With ./ before it, since gnuplot runs a name that begins with < as a command.
std::string data_file(const std::string& name)
{
  return plot::gnuplot_text("./" + name + ".dat");
}

/// The command that draws the data.
std::string plot(const Picture& picture, bool as_disks)
{
  std::string command;
  if (as_disks) {
    command = fmt::format("plot {} using 1:2:3:4 with circles lc palette", data_file(picture.name));
  } else {
    const Vec<2> lower = picture.view.lower * picture.unit.per_si, size = picture.size() * picture.unit.per_si;
    command = fmt::format("plot {} matrix using ({:.9g}+($1+0.5)*{:.9g}):({:.9g}+($2+0.5)*{:.9g}):3 with image", data_file(picture.name),
                          lower[0], size[0] / plot_width, lower[1], size[1] / picture.plot_height());
  }
  if (!picture.frame.rigid_bodies.empty())
    command += fmt::format(", \\\n     {} with filledcurves closed lc rgb '#c9ccd1', '' with lines lc rgb '#33373d' lw 2",
                           data_file(picture.name + "_rigid"));
  return command + '\n';
}

}  // namespace

SoilView view_around_pipe(Real x, Real lowest, Real diameter, Real surface)
{
  return {Vec<2>(x - 2.5 * diameter, lowest - 1.2 * diameter), Vec<2>(x + 2.5 * diameter, lowest + 1.3 * diameter), surface};
}

bool draw_soil(const std::filesystem::path& folder, const run_folder::Frame<2>& frame, const SoilPicture& wanted, plot::PlotFormat format)
{
  const SoilView& view = wanted.view;
  const Picture picture{frame, wanted.name, wanted.color == SoilColor::deviatoric_strain, view,
                        plot::length_unit((view.upper - view.lower).maxCoeff())};
  const std::vector<const run_folder::FrameParticle<2>*> particles = particles_in_view(picture);
  const std::filesystem::path plots = folder / "plots";
  io::make_folder(plots);
  if (particles.empty()) return false;
  const bool as_disks = frame.triangles.empty() && format == plot::PlotFormat::png && particles.size() <= max_disks;
  io::write_atomically(plots / (picture.name + ".dat"), as_disks                  ? disks(picture, particles)
                                                        : frame.triangles.empty() ? pixels(picture, particles)
                                                                                  : pixels(picture));
  io::write_atomically(plots / (picture.name + "_rigid.dat"), outlines(picture));
  return draw(folder, picture.name, width, picture.plot_height() + bottom + top,
              axes(picture, hundredth(picture, particles), wanted.title) + plot(picture, as_disks), format);
}

}  // namespace berm::pipe
