// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The paper's program in short: its search in each step, linear springs, velocity Verlet, scalar code throughout.
#include "dem/setup/space_order.hpp"
#include "programs/bench/dem/stepper.hpp"
#include "programs/bench/plain_searches.hpp"
#include "programs/measure/timing.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace bench {
namespace {

class PlainSteps {
 public:
  // The particles stand in `order`.
  PlainSteps(const dem::Setup &setup, std::vector<uint32_t> order, const Contestant &search);

  void run(uint64_t steps);
  MotionState state() const;
  Details details() const { return search_.details(); }

 private:
  void find_forces();
  void add_pair_force(const hg_pair &pair);
  void add_wall_forces(size_t particle);
  void kick_half();

  dem::Setup setup_;
  std::vector<uint32_t> order_;
  particles::ParticleSet set_;
  Search search_;
  std::vector<double> forces_;  // [count][3]
};

PlainSteps::PlainSteps(const dem::Setup &setup, std::vector<uint32_t> order, const Contestant &search)
    : setup_(dem::reordered(setup, order)), order_(std::move(order)), forces_(3 * setup.count()) {
  set_.centers = setup_.centers;
  set_.radii = setup_.radii;
  set_.has_box = setup_.walled[0] && setup_.walled[1] && setup_.walled[2];
  std::copy_n(setup_.box_min, 3, set_.box_min);
  std::copy_n(setup_.box_max, 3, set_.box_max);
  search_ = search.prepare(set_);
  find_forces();
}

void PlainSteps::add_pair_force(const hg_pair &pair) {
  const double *a = &set_.centers[3 * static_cast<size_t>(pair.a)];
  const double *b = &set_.centers[3 * static_cast<size_t>(pair.b)];
  const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const double distance = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  const double reach = set_.radii[static_cast<size_t>(pair.a)] + set_.radii[static_cast<size_t>(pair.b)];
  const double pull = setup_.contact.stiffness * (reach - distance) / distance;
  for (size_t k = 0; k < 3; k++) {
    forces_[3 * static_cast<size_t>(pair.a) + k] -= pull * d[k];
    forces_[3 * static_cast<size_t>(pair.b) + k] += pull * d[k];
  }
}

void PlainSteps::add_wall_forces(size_t particle) {
  const double radius = set_.radii[particle];
  for (size_t k = 0; k < 3; k++) {
    if (!setup_.walled[k]) continue;
    const double x = set_.centers[3 * particle + k];
    const double below = radius - (x - setup_.box_min[k]), above = radius - (setup_.box_max[k] - x);
    if (below > 0) forces_[3 * particle + k] += setup_.contact.stiffness * below;
    if (above > 0) forces_[3 * particle + k] -= setup_.contact.stiffness * above;
  }
}

void PlainSteps::find_forces() {
  PairView pairs;
  search_.run(pairs);
  std::fill(forces_.begin(), forces_.end(), 0.0);
  for (const hg_pair &pair : pairs) add_pair_force(pair);
  for (size_t i = 0; i < set_.count(); i++) add_wall_forces(i);
}

void PlainSteps::kick_half() {
  for (size_t i = 0; i < set_.count(); i++) {
    const double factor = 0.5 * setup_.time_step / setup_.masses[i];
    for (size_t k = 0; k < 3; k++) setup_.velocities[3 * i + k] += factor * forces_[3 * i + k];
  }
}

void PlainSteps::run(uint64_t steps) {
  for (uint64_t step = 0; step < steps; step++) {
    kick_half();
    for (size_t k = 0; k < set_.centers.size(); k++) set_.centers[k] += setup_.time_step * setup_.velocities[k];
    find_forces();
    kick_half();
  }
}

MotionState PlainSteps::state() const {
  MotionState state{std::vector<double>(set_.centers.size()), std::vector<double>(set_.centers.size())};
  for (size_t i = 0; i < order_.size(); i++) {
    const size_t given = order_[i];
    for (size_t k = 0; k < 3; k++) {
      state.centers[3 * given + k] = set_.centers[3 * i + k];
      state.velocities[3 * given + k] = setup_.velocities[3 * i + k];
    }
  }
  return state;
}

using OrderOf = std::vector<uint32_t> (*)(const dem::Setup &);

std::vector<uint32_t> given_order(const dem::Setup &setup) {
  std::vector<uint32_t> order(setup.count());
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

StepContestant steps_with(const Contestant &search, OrderOf order_of) {
  StepContestant contestant;
  contestant.name = search.name;
  contestant.variant = search.variant;
  contestant.prepare = [search, order_of](const dem::Setup &setup) {
    const auto steps = std::make_shared<PlainSteps>(setup, order_of(setup), search);
    Stepper stepper;
    stepper.run = [steps](uint64_t count) { steps->run(count); };
    stepper.state = [steps] { return steps->state(); };
    stepper.details = [steps] { return steps->details(); };
    return stepper;
  };
  return contestant;
}

}  // namespace

StepContestant plain_steps(int level_count) {
  return steps_with(hierarchical_grid_search(level_count), dem::space_order);
}

StepContestant hashed_steps(int level_count) { return steps_with(hashed_grid_search(level_count), given_order); }

}  // namespace bench
