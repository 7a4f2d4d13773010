// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How the library is timed over time steps: from the new centres of a step to the complete list of its pairs.
#pragma once

#include "packing/random.hpp"
#include "particles/insert.hpp"
#include "particles/particle_set.hpp"
#include "programs/measure/statistics.hpp"
#include "programs/measure/timing.hpp"

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
      for (size_t axis = 0; axis < dimension; axis++) {
        direction[axis] = 2 * random.uniform() - 1;
        square += direction[axis] * direction[axis];
      }
      if (square > 1) continue;
      for (size_t axis = 0; axis < dimension; axis++) velocity_.push_back(displacement * direction[axis]);
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

// Seconds of steps that searched anew, and of those that filtered stored candidates. Steps of a kind are alike, so
// their median stands for each of them: a slow moment of the machine does not count.
class StepTimes {
 public:
  void add(bool searched, double seconds) { (searched ? searched_ : filtered_).push_back(seconds); }

  // Of a step of that kind; 0 where there was none.
  double searched() const { return searched_.empty() ? 0 : median(searched_); }
  double filtered() const { return filtered_.empty() ? 0 : median(filtered_); }
  double search_share() const {
    return static_cast<double>(searched_.size()) / static_cast<double>(searched_.size() + filtered_.size());
  }
  double mean() const { return search_share() * searched() + (1 - search_share()) * filtered(); }

 private:
  std::vector<double> searched_, filtered_;
};

// One grid that follows moving particles.
class MovingGrid {
 public:
  MovingGrid(const hg_grid_def &def, const particles::ParticleSet &start) : grid_(def) { start_at(start); }

  // Anew, in the memory that is there; ends with candidates that have just been stored.
  void start_at(const particles::ParticleSet &start) {
    grid_.clear();
    particles::insert(start, grid_);
    pairs_ = grid_.query_pairs();
    count_searches();
  }
  void step(const particles::ParticleSet &particles) {
    grid_.move(particles.count(), particles.centers.data());
    pairs_ = grid_.query_pairs();
  }
  // Whether a new search was made since this was asked last.
  bool has_searched() {
    const int64_t before = searches_;
    count_searches();
    return searches_ > before;
  }

  const hgrid::View<hg_pair> &pairs() const { return pairs_; }
  hgrid::Grid &grid() { return grid_; }

 private:
  void count_searches() { searches_ = grid_.get_stats().search_count; }

  hgrid::Grid grid_;
  hgrid::View<hg_pair> pairs_;
  int64_t searches_ = 0;
};

// Times a step of whatever follows the particles.
template <class Follower>
void time_step(Follower &follower, const particles::ParticleSet &now, StepTimes &times) {
  const double seconds = seconds_of([&] { follower.step(now); });
  times.add(follower.has_searched(), seconds);
}

}  // namespace measure
