// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A state in float against the same in double.
#include "programs/accuracy/simulation/float_state.hpp"

#include "particles/insert.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace accuracy {
namespace {

bool by_id(const hg_pair &p, const hg_pair &q) { return p.a != q.a ? p.a < q.a : p.b < q.b; }

particles::ParticleSet particles_of(const dem::Setup &setup, const dem::Snapshot &state) {
  particles::ParticleSet set;
  set.dimension = setup.dimension;
  set.centers = state.centers;
  set.radii = state.radii;
  set.has_box = true;
  for (int k = 0; k < setup.dimension; k++) {
    set.box_min[k] = setup.box_min[k];
    set.box_max[k] = setup.box_max[k];
    set.periodic[k] = setup.periodic[k] ? 1 : 0;
  }
  return set;
}

std::vector<hg_pair> overlapping(const particles::ParticleSet &particles) {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = particles.dimension;
  def.pair_order = HG_ORDER_ID;
  for (int k = 0; k < particles.dimension; k++) {
    def.box_min[k] = particles.box_min[k];
    def.box_max[k] = particles.box_max[k];
    def.periodic[k] = particles.periodic[k];
  }
  hgrid::Grid grid(def);
  particles::insert(particles, grid);
  const hgrid::View<hg_pair> pairs = grid.query_pairs();
  return {pairs.begin(), pairs.end()};
}

double overlap(const particles::ParticleSet &set, const hg_pair &pair) {
  const auto d = static_cast<size_t>(set.dimension), a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
  double square = 0;
  for (size_t k = 0; k < d; k++) {
    double between = set.centers[b * d + k] - set.centers[a * d + k];
    const double period = set.box_max[k] - set.box_min[k];
    if (set.periodic[k] != 0) between -= period * std::round(between / period);
    square += between * between;
  }
  return set.radii[a] + set.radii[b] - std::sqrt(square);
}

}  // namespace

StateErrors compare_states(const dem::Setup &setup, dem::Engine &in_double, dem::Engine &in_float) {
  const particles::ParticleSet fine = particles_of(setup, in_double.snapshot()),
                               coarse = particles_of(setup, in_float.snapshot());
  const std::vector<hg_pair> fine_pairs = overlapping(fine), coarse_pairs = overlapping(coarse);
  std::vector<hg_pair> both;
  std::set_intersection(fine_pairs.begin(), fine_pairs.end(), coarse_pairs.begin(), coarse_pairs.end(),
                        std::back_inserter(both), by_id);
  StateErrors errors;
  errors.pairs = fine_pairs.size();
  errors.missed = fine_pairs.size() - both.size();
  errors.extra = coarse_pairs.size() - both.size();
  double squares = 0, error_squares = 0;
  for (const hg_pair &pair : both) {
    const double truth = overlap(fine, pair);
    squares += truth * truth;
    error_squares += std::pow(overlap(coarse, pair) - truth, 2);
  }
  errors.overlap = squares > 0 ? std::sqrt(error_squares / squares) : 0;
  const dem::Measurement fine_sums = in_double.measure(), coarse_sums = in_float.measure();
  errors.largest_overlap = std::fabs(coarse_sums.largest_overlap / fine_sums.largest_overlap - 1);
  errors.energy = std::fabs(coarse_sums.energy() / fine_sums.energy() - 1);
  return errors;
}

}  // namespace accuracy
