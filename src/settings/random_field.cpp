// SPDX-License-Identifier: BSD-3-Clause
#include "settings/random_field.hpp"

#include "core/for_each.hpp"
#include "os/error.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>
#include <map>

namespace berm::settings {
namespace {

constexpr Real cells_per_length = 20;  // of a field of points
constexpr Real most_cells = 1e8;
constexpr Real most_numbered = 2e9;  ///< what an Index holds

/// Beyond so many correlation lengths the square root of the covariance is below 1e-6 of its middle.
Real reach_over_length(Correlation correlation)
{
  return correlation == Correlation::markov ? 7 : 2.5;
}

/// The finaliser of splitmix64 (Steele, Lea and Flood 2014): all bits of the result depend on all of x.
std::uint64_t mix(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

std::uint64_t key_of(int seed, const std::string& path)
{
  std::uint64_t key = mix(static_cast<std::uint64_t>(seed));
  for (const char c : path) key = mix(key ^ static_cast<unsigned char>(c));
  return key;
}

/// Standard normal white noise, by Box and Muller.
Real noise(std::uint64_t key, Index i, Index j, Index k)
{
  std::uint64_t bits = key;
  for (const Index number : {i, j, k}) bits = mix(bits ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(number)));
  const auto share = [](std::uint64_t b) { return (static_cast<Real>(b >> 12) + 0.5) * 0x1p-52; };
  return std::sqrt(-2 * std::log(share(bits))) * std::cos(2 * pi * share(mix(bits)));
}

}  // namespace

Real variance_function(Correlation correlation, Real theta, Real length)
{
  const Real t = length / theta;
  constexpr Real no_length = 1e-5;  // there the formulas lose their digits, and the variance is 1 to 1e-5
  if (t < no_length) return 1;
  if (correlation == Correlation::markov) return (2 * t + std::expm1(-2 * t)) / (2 * t * t);
  return (pi * t * std::erf(std::sqrt(pi) * t) + std::expm1(-pi * t * t)) / (pi * t * t);
}

Real covariance_of_means(Correlation correlation, Real theta, Real averaging, Real lag)
{
  if (averaging == 0) return correlation == Correlation::markov ? std::exp(-2 * lag / theta) : std::exp(-pi * lag * lag / (theta * theta));
  const auto moment = [&](Real length) { return length * length * variance_function(correlation, theta, length); };
  return (moment(lag + averaging) - 2 * moment(lag) + moment(std::abs(lag - averaging))) / (2 * averaging * averaging);
}

std::vector<Real> symmetric_root(const std::vector<Real>& covariance, Index reach)
{
  const auto half = static_cast<Index>(covariance.size()) - 1;
  if (half == 0) return {std::sqrt(covariance[0])};
  std::vector<Real> cosine(2 * static_cast<std::size_t>(half));
  for (std::size_t k = 0; k < cosine.size(); ++k) cosine[k] = std::cos(pi * static_cast<Real>(k) / half);
  // Of an even function by lag: a sum over the whole circle.
  const auto transformed = [&](const std::vector<Real>& f, Index k) {
    Real sum = f[0];
    for (Index j = 1; j <= half; ++j)
      sum += (j < half ? 2 : 1) * f[j] * cosine[static_cast<std::size_t>(static_cast<std::int64_t>(j) * k % (2 * half))];
    return sum;
  };
  std::vector<Real> root(covariance.size());
  for (Index k = 0; k <= half; ++k) root[k] = std::sqrt(std::max(Real(0), transformed(covariance, k)));
  std::vector<Real> weights(2 * static_cast<std::size_t>(reach) + 1);
  for (Index m = 0; m <= reach; ++m) weights[reach + m] = weights[reach - m] = transformed(root, m) / (2 * half);
  return weights;
}

RandomField::RandomField(const RandomFieldSettings& settings, const std::string& path, const SoilPlace& lower, const SoilPlace& upper,
                         const std::vector<Known>& known)
{
  const Real from[3] = {lower.x, lower.depth, lower.z}, to[3] = {upper.x, upper.depth, upper.z};
  const Real averaging = settings.averaging_length.value_or(0);
  Real cells = 1;
  for (std::size_t d = 0; d < 3; ++d) {
    const std::optional<Real> length = settings.lengths()[d];
    if (!length) continue;
    Direction& grid = direction_[d];
    grid.cell = std::max(averaging, *length / cells_per_length);
    const Real count = std::floor(to[d] / grid.cell) - std::floor(from[d] / grid.cell) + 1;
    const Real reach = std::ceil(reach_over_length(settings.correlation) * *length / grid.cell) + 1;
    cells *= count + 2 * reach;
    if (!(cells < most_cells))
      throw KeyError(
          fmt::format("{}.averaging_length: the field would have more than {:.0e} cells of {:.3g} m: average it over the size of the "
                      "cells of the mesh, or take longer correlation lengths",
                      path, most_cells, grid.cell));
    if (!(std::max(std::abs(from[d]), std::abs(to[d])) / grid.cell + 2 * reach < most_numbered))
      throw KeyError(fmt::format("{}: cells of {:.3g} m cannot be numbered from 0 to {:.6g} m: place the origin of x and z near the mesh",
                                 path, grid.cell, std::abs(from[d]) > std::abs(to[d]) ? from[d] : to[d]));
    grid.first = static_cast<Index>(std::floor(from[d] / grid.cell));
    grid.count = static_cast<Index>(count);
    const auto lags = static_cast<Index>(std::max(2 * reach, count));
    grid.covariance.clear();
    for (Index j = 0; j <= lags; ++j)
      grid.covariance.push_back(covariance_of_means(settings.correlation, *length, averaging, j * grid.cell));
    const std::vector<Real> on_circle(grid.covariance.begin(), grid.covariance.begin() + static_cast<std::ptrdiff_t>(2 * reach) + 1);
    grid.weight = symmetric_root(on_circle, static_cast<Index>(reach));
  }
  draw(key_of(settings.seed, path));
  if (!known.empty()) meet(known, path);
}

Index RandomField::Direction::cell_at(Real coordinate) const
{
  return std::isfinite(cell) ? static_cast<Index>(std::floor(coordinate / cell)) - first : 0;
}

RandomField::Cell RandomField::cell_at(const SoilPlace& place) const
{
  return {direction_[0].cell_at(place.x), direction_[1].cell_at(place.depth), direction_[2].cell_at(place.z)};
}

bool RandomField::holds(const Cell& cell) const
{
  for (std::size_t d = 0; d < 3; ++d)
    if (cell[d] < 0 || cell[d] >= direction_[d].count) return false;
  return true;
}

std::size_t RandomField::place_of(const Cell& cell) const
{
  return static_cast<std::size_t>(cell[0]) +
         static_cast<std::size_t>(direction_[0].count) *
             (static_cast<std::size_t>(cell[1]) + static_cast<std::size_t>(direction_[1].count) * static_cast<std::size_t>(cell[2]));
}

Real RandomField::covariance(const Cell& a, const Cell& b) const
{
  Real product = 1;
  for (std::size_t d = 0; d < 3; ++d) product *= direction_[d].covariance[static_cast<std::size_t>(std::abs(a[d] - b[d]))];
  return product;
}

Real RandomField::at(const SoilPlace& place) const
{
  Cell cell = cell_at(place);
  for (std::size_t d = 0; d < 3; ++d) cell[d] = std::clamp(cell[d], Index(0), direction_[d].count - 1);
  return value_[place_of(cell)];
}

void RandomField::draw(std::uint64_t key)
{
  // The grid with what the sums reach beyond it along the directions that are still to be summed.
  std::array<Index, 3> size{}, first{};
  for (std::size_t d = 0; d < 3; ++d) {
    size[d] = direction_[d].count + 2 * direction_[d].reach();
    first[d] = direction_[d].first - direction_[d].reach();
  }
  const auto sum = [](const std::vector<Real>& weight, const Real* noise_of_first, std::size_t stride) {
    Real value = 0;
    for (std::size_t m = 0; m < weight.size(); ++m) value += weight[m] * noise_of_first[m * stride];
    return value;
  };
  const auto along_x = static_cast<std::size_t>(direction_[0].count);
  value_.resize(along_x * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]));
  for_each("random field", size[1] * size[2], [&](Index line) {
    std::vector<Real> white(static_cast<std::size_t>(size[0]));
    for (Index i = 0; i < size[0]; ++i) white[i] = noise(key, first[0] + i, first[1] + line % size[1], first[2] + line / size[1]);
    for (std::size_t i = 0; i < along_x; ++i)
      value_[static_cast<std::size_t>(line) * along_x + i] = sum(direction_[0].weight, &white[i], 1);
  });
  std::size_t stride = along_x;
  for (std::size_t d = 1; d < 3; ++d) {
    const auto before = static_cast<std::size_t>(size[d]), after = static_cast<std::size_t>(direction_[d].count);
    const std::size_t layers = value_.size() / (stride * before);
    std::vector<Real> summed(stride * after * layers);
    for_each("random field", static_cast<Index>(after * layers), [&](Index line) {
      const std::size_t layer = static_cast<std::size_t>(line) / after, row = static_cast<std::size_t>(line) % after;
      for (std::size_t i = 0; i < stride; ++i)
        summed[static_cast<std::size_t>(line) * stride + i] =
            sum(direction_[d].weight, &value_[(layer * before + row) * stride + i], stride);
    });
    value_ = std::move(summed);
    stride *= after;
  }
}

void RandomField::meet(const std::vector<Known>& known, const std::string& path)
{
  struct Mean {
    Real sum = 0;
    int count = 0;
  };
  std::map<Cell, Mean> means;  // all that is known in a cell is its mean
  for (const Known& each : known) {
    const Cell cell = cell_at(each.place);
    if (!holds(cell))
      throw KeyError(fmt::format("{}.sounding: x = {:.4g} m, {:.4g} m deep, lies outside the mesh", path, each.place.x, each.place.depth));
    means[cell].sum += each.score;
    ++means[cell].count;
  }
  std::vector<Cell> cells;
  for (const auto& entry : means) cells.push_back(entry.first);
  const auto count = static_cast<Eigen::Index>(cells.size());
  Eigen::MatrixXd matrix(count, count);
  Eigen::VectorXd missing(count);
  for (Eigen::Index a = 0; a < count; ++a) {
    const Mean& mean = means[cells[a]];
    missing[a] = mean.sum / mean.count - value_[place_of(cells[a])];
    for (Eigen::Index b = 0; b < count; ++b) matrix(a, b) = covariance(cells[a], cells[b]);
  }
  const Eigen::VectorXd weights = matrix.ldlt().solve(missing);
  constexpr Real met = 1e-8;
  if (!((matrix * weights - missing).cwiseAbs().maxCoeff() < met))
    throw KeyError(fmt::format("{}.sounding: values this close to each other contradict the correlation: leave some out, or take "
                               "correlation = \"markov\"",
                               path));
  const Index columns = direction_[0].count, rows = direction_[1].count;
  for_each("random field", rows * direction_[2].count, [&](Index line) {
    for (Index i = 0; i < columns; ++i) {
      const Cell cell = {i, line % rows, line / rows};
      Real& value = value_[place_of(cell)];
      for (Eigen::Index a = 0; a < count; ++a) value += weights[a] * covariance(cell, cells[a]);
    }
  });
}

}  // namespace berm::settings
