// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How the library is timed over time steps: from the new centres of a step to the complete list of its pairs.
#pragma once

#include "packing/random.hpp"
#include "particles/insert.hpp"
#include "particles/particle_set.hpp"
#include "programs/measure/search_timer.hpp"

#include <hgrid/hgrid.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace measure {

// Particles that fly straight on, each with a velocity of its own: any direction, any speed up to `displacement` per
// step.
class Flight {
 public:
  Flight(const particles::ParticleSet &start, double displacement) : particles_(start) {
    packing::Random random(1);
    velocity_.reserve(start.centers.size());
    const auto dimension = static_cast<size_t>(start.dimension);
    while (velocity_.size() < start.centers.size()) {
      double direction[3] = {0, 0, 0}, square = 0;
      for (size_t k = 0; k < dimension; k++) {
        direction[k] = 2 * random.uniform() - 1;
        square += direction[k] * direction[k];
      }
      if (square > 1) continue;
      for (size_t k = 0; k < dimension; k++) velocity_.push_back(displacement * direction[k]);
    }
  }

  void step() {
    for (size_t i = 0; i < velocity_.size(); i++) particles_.centers[i] += velocity_[i];
  }
  const particles::ParticleSet &particles() const { return particles_; }

 private:
  particles::ParticleSet particles_;
  std::vector<double> velocity_;
};

// One grid that follows a flight, and what each step took.
class StepTimer {
 public:
  StepTimer(const hg_grid_def &def, const particles::ParticleSet &start) : grid_(def) {
    particles::insert(start, grid_);
    pairs_ = grid_.query_pairs().size();
  }

  void step(const particles::ParticleSet &particles) {
    const int64_t searches = grid_.get_stats().search_count;
    const double seconds = seconds_of([&] {
      grid_.move(particles.count(), particles.centers.data());
      pairs_ = grid_.query_pairs().size();
    });
    (grid_.get_stats().search_count > searches ? searched_ : filtered_).push_back(seconds);
  }

  // Seconds of the steps that searched anew, and of those that filtered stored candidates.
  const std::vector<double> &searched() const { return searched_; }
  const std::vector<double> &filtered() const { return filtered_; }
  size_t pairs() const { return pairs_; }  // of the last step
  hgrid::Grid &grid() { return grid_; }

 private:
  hgrid::Grid grid_;
  size_t pairs_ = 0;
  std::vector<double> searched_, filtered_;
};

}  // namespace measure
