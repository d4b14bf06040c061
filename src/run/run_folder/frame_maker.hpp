// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "problem/lengthen.hpp"
#include "run_folder/frame.hpp"

namespace berm::run_folder {

/// Makes the frames of a run of the material point method.
template <int dim>
class FrameMaker {
public:
  /// Remembers where the particles of `start` are, and keeps the model, which must outlive it. The strain of frames counts from there; that of particles that come
  /// later from the first frame that they are in.
  FrameMaker(const problem::Model<dim>& model, const problem::State<dim>& start);

  /// The next frame: its increments count from the frame made before. An old one gives its memory.
  Frame<dim> make(const problem::State<dim>& state, Frame<dim> old = {});

  /// From now on displacements, and their strains, count from here; of particles that come later from the first frame that they are in.
  void zero_displacements(const problem::State<dim>& state);

  /// Takes what is remembered of particles on the mesh before; what is remembered of the start on this one is that of the added length.
  void lengthen(const FrameMaker& before, const problem::LengthenedBed<dim>& bed);

  /// What the increments of the next frame count from, and where particles were first that came later; where displacements count from, once that is not the start. Where the particles were at the start is not kept: a
  /// resumed run makes its FrameMaker at the same start, unless the mesh was lengthened.
  void archive(Archive& k, bool lengthened);

private:
  /// What is remembered of a particle.
  struct Known {
    Vec<dim> first = Vec<dim>::Zero(), last = Vec<dim>::Zero();  ///< m, where it was first and at the frame before
    Index first_cell = none;                                     ///< none: in no frame yet
  };

  /// Where a particle was that displacements count from.
  struct Zero {
    Vec<dim> place = Vec<dim>::Zero();  ///< m
    Index cell = none;
  };

  void meet_new(const bodies::Particles<dim>& particles, std::size_t body);
  Zero zero_of(std::size_t body, std::size_t id) const;
  void archive_zeros(Archive& k, const std::string& ending, std::size_t body);
  void archive_new(Archive& k, const std::string& ending, std::size_t at_start, std::vector<Known>& known) const;
  Index cell_at(const Vec<dim>& x, Index near) const;
  void add_strains(const bodies::Particles<dim>& particles, std::size_t body, const std::vector<Index>& point, Frame<dim>& frame);

  const problem::Model<dim>& model_;
  std::vector<std::vector<Known>> known_;  ///< by body, then id
  std::vector<std::vector<Zero>> zeros_;   ///< the same; empty while displacements count from where particles were first
  std::vector<std::size_t> at_start_;      ///< how many of them there were, by body

public:
  /// Bytes that are kept between frames for each particle.
  static constexpr std::size_t bytes_a_particle = sizeof(Known);
};

}  // namespace berm::run_folder
