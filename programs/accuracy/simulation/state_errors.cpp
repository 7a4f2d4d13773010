// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/simulation/state_errors.hpp"

#include "oracle/pairs.hpp"
#include "programs/accuracy/contacts.hpp"
#include "programs/measure/search_timer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace accuracy {
namespace {

particles::ParticleSet particles_of(const dem::Setup &setup, const dem::Snapshot &state) {
  particles::ParticleSet set;
  set.dimension = setup.dimension;
  set.centers = state.centers;
  set.radii = state.radii;
  set.has_box = true;
  for (int axis = 0; axis < setup.dimension; axis++) {
    set.box_min[axis] = setup.box_min[axis];
    set.box_max[axis] = setup.box_max[axis];
    set.periodic[axis] = setup.periodic[axis] ? 1 : 0;
  }
  return set;
}

oracle::Pairs ascending_pairs(const particles::ParticleSet &particles) {
  hg_grid_def def = measure::def_of(particles);
  def.pair_order = HG_ORDER_ID;
  return found_pairs(def, particles);
}

}  // namespace

StateErrors compare_states(const dem::Setup &setup, dem::Engine &in_double, dem::Engine &in_float) {
  const particles::ParticleSet fine = particles_of(setup, in_double.snapshot()),
                               coarse = particles_of(setup, in_float.snapshot());
  const oracle::Pairs fine_pairs = ascending_pairs(fine), coarse_pairs = ascending_pairs(coarse);
  oracle::Pairs both;
  std::set_intersection(fine_pairs.begin(), fine_pairs.end(), coarse_pairs.begin(), coarse_pairs.end(),
                        std::back_inserter(both), oracle::pair_less);
  StateErrors errors;
  errors.pairs = fine_pairs.size();
  errors.missed = fine_pairs.size() - both.size();
  errors.extra = coarse_pairs.size() - both.size();
  double squares = 0, error_squares = 0;
  for (const hg_pair &pair : both) {
    const double truth = overlap_of(fine, pair);
    squares += truth * truth;
    error_squares += std::pow(overlap_of(coarse, pair) - truth, 2);
  }
  errors.overlap = squares > 0 ? std::sqrt(error_squares / squares) : 0;
  const dem::Measurement fine_sums = in_double.measure(), coarse_sums = in_float.measure();
  errors.largest_overlap = std::fabs(coarse_sums.largest_overlap / fine_sums.largest_overlap - 1);
  errors.energy = std::fabs(coarse_sums.energy() / fine_sums.energy() - 1);
  return errors;
}

}  // namespace accuracy
