// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The course of a growth: rate by density, kinetic energy kept in bounds, jamming recognised and retried.
#include "packing/event/growth.hpp"

#include "packing/morton.hpp"
#include "packing/portable_math.hpp"
#include "packing/random.hpp"
#include "particles/error.hpp"
#include "particles/text/number.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace packing::event {
namespace {

// Growth of <r> over the thermal speed: what leaves a dense fluid time to relax, and what a dilute one bears.
constexpr double kUsualRate = 0.01, kFastestRate = 0.1;
constexpr double kLongestStep = 0.02;        // of the scale, before the rate is chosen anew
constexpr uint64_t kCollisionsPerEpoch = 5;  // over the number of particles
constexpr double kHottest = 1.5;             // kinetic energy over that at the start
// Growth goes on past the radii wanted by this share, which rounding cannot eat up.
constexpr double kSpare = 1e-10;
// A fluid at the densities that can be reached has a pressure of 10 to 100; beyond this, particles hold each other.
constexpr double kJammedPressure = 1e4;
constexpr double kRetryDensity = 0.5;  // where tries start again
constexpr double kRetrySlowdown = 4;

State random_points(const Box &box, const GrowthRequest &request) {
  State state;
  Random random(request.seed);
  state.radii = request.radii;
  state.masses.assign(state.count(), 1.0);
  state.scale = 0;
  for (size_t i = 0; i < state.count(); i++) {
    Vector center = Vector::Zero(), velocity = Vector::Zero();
    for (int axis = 0; axis < box.dimension(); axis++) {
      center[axis] = random.uniform() * box.edge(axis);
      velocity[axis] = random.normal();
    }
    state.centers.push_back(center);
    state.velocities.push_back(velocity);
  }
  return state;
}

// The numbers of the points along Morton's curve, 1024 cells per axis of the box.
std::vector<size_t> spatial_order(const Box &box, const std::vector<Vector> &points) {
  constexpr int kBits = 10;
  std::vector<uint64_t> places;
  places.reserve(points.size());
  for (const Vector &point : points) {
    uint32_t cell[3] = {0, 0, 0};
    for (int axis = 0; axis < box.dimension(); axis++) {
      const double place = point[axis] / box.edge(axis) * (1 << kBits);
      cell[axis] = static_cast<uint32_t>(std::min(std::max(place, 0.0), (1 << kBits) - 1.0));
    }
    places.push_back(morton_place(cell, box.dimension(), kBits));
  }
  return order_by_place<size_t>(places);
}

// items[order[0]], items[order[1]] ...
template <class T>
std::vector<T> reordered(const std::vector<T> &items, const std::vector<size_t> &order) {
  std::vector<T> result;
  result.reserve(items.size());
  for (const size_t k : order) result.push_back(items[k]);
  return result;
}

class Growth {
 public:
  Growth(const Box &box, const GrowthRequest &request, const GrowthObserver &observe)
      : box_(box),
        request_(request),
        observe_(observe),
        fluid_(request.radii, box.dimension()),
        target_(volume_of(request.radii, box.dimension()) / box.volume()),
        rate_(request.rate > 0 ? request.rate : kUsualRate / fluid_.mean_radius()) {
    if (!(target_ < 1)) throw particles::Error("the particles fill " + particles::text(target_) + " of the box");
    if (!(request.rate >= 0) || !std::isfinite(request.rate)) {
      throw particles::Error("a growth rate of " + particles::text(request.rate));
    }
    energy_ = static_cast<double>(request.radii.size()) * box.dimension() / 2;  // kT = 1
    tabulate_work();
  }

  GrowthResult run() {
    restart_ = random_points(box_, request_);
    sort_particles();
    for (;;) {
      const GrowthEnd end = attempt();
      if (end != GrowthEnd::kJammed || retries_ == request_.most_retries) return result(end);
      retries_++;
      rate_ /= kRetrySlowdown;
    }
  }

 private:
  static constexpr int kWorkSteps = 200;

  double density(double scale) const { return target_ * power(scale, box_.dimension()); }

  // The pressure of the fluid sets the number of collisions per time: growing slower by as much where it is high gives
  // every step of density as many collisions.
  double rate_at(double scale) const {
    const double ratio = fluid_.compressibility(target_) / fluid_.compressibility(density(scale));
    return std::min(rate_ * ratio, std::max(rate_, kFastestRate / fluid_.mean_radius()));
  }

  // Collisions, and with them work, up to each scale.
  void tabulate_work() {
    for (int k = 0; k < kWorkSteps; k++) {
      const double scale = (k + 0.5) / kWorkSteps;
      work_[k + 1] = work_[k] + fluid_.compressibility(density(scale)) / rate_at(scale);
    }
  }

  double share_done(double scale) const {
    const double place = std::min(std::max(scale, 0.0), 1.0) * kWorkSteps;
    const int k = std::min(static_cast<int>(place), kWorkSteps - 1);
    return (work_[k] + (place - k) * (work_[k + 1] - work_[k])) / work_[kWorkSteps];
  }

  // Particles stay near where they start, compared with the box.
  void sort_particles() {
    order_ = spatial_order(box_, restart_.centers);
    restart_.centers = reordered(restart_.centers, order_);
    restart_.velocities = reordered(restart_.velocities, order_);
    restart_.radii = reordered(restart_.radii, order_);
  }

  // What the pressure is measured from.
  struct Window {
    uint64_t collisions = 0;
    double virial = 0, energy_time = 0;
  };

  GrowthEnd attempt();
  bool poll();
  bool jammed(EpochEnd end, const Tally &before, double energy_before);
  GrowthResult result(GrowthEnd end);

  Box box_;
  const GrowthRequest &request_;
  const GrowthObserver &observe_;
  Fluid fluid_;
  double target_, rate_, energy_ = 0;
  double work_[kWorkSteps + 1]{};
  State restart_;              // where a retry begins
  std::vector<size_t> order_;  // whom the k-th particle of the engine stands for
  std::unique_ptr<Engine> engine_;
  Tally earlier_;  // of former tries
  GrowthProgress progress_;
  Window window_;
  int retries_ = 0;
};

void add(Tally &sum, const Tally &more) {
  sum.collisions += more.collisions;
  sum.wall_hits += more.wall_hits;
  sum.renewals += more.renewals;
  sum.stale += more.stale;
  sum.predictions += more.predictions;
  sum.candidates += more.candidates;
  sum.rebuilds += more.rebuilds;
  sum.time += more.time;
  sum.virial += more.virial;
  sum.wall_impulse += more.wall_impulse;
  sum.energy_gain += more.energy_gain;
}

bool Growth::poll() {
  if (!observe_) return true;
  const double scale = engine_->scale();
  Tally all = earlier_;
  add(all, engine_->tally());
  progress_.density = density(scale);
  progress_.share_done = share_done(scale);
  progress_.retries = retries_;
  progress_.tally = &all;
  return observe_(progress_);
}

// Judges the pressure whenever there have been enough collisions for it: an epoch may be too short.
bool Growth::jammed(EpochEnd end, const Tally &before, double energy_before) {
  if (end == EpochEnd::kStalled) return true;
  const Tally &after = engine_->tally();
  window_.collisions += after.collisions - before.collisions;
  window_.virial += after.virial - before.virial;
  window_.energy_time += (after.time - before.time) * (energy_before + engine_->state().kinetic_energy()) / 2;
  if (window_.collisions < request_.radii.size()) return false;
  progress_.compressibility = 1 + window_.virial / (2 * window_.energy_time);
  window_ = {};
  return progress_.compressibility > kJammedPressure;
}

// Grows from restart_, which it moves to kRetryDensity when it gets there.
GrowthEnd Growth::attempt() {
  if (engine_) add(earlier_, engine_->tally());
  engine_ = std::make_unique<Engine>(box_, restart_);
  window_ = {};
  const double last_scale = 1 + kSpare;
  bool restart_is_set = density(restart_.scale) >= kRetryDensity;
  while (engine_->state().scale < last_scale) {
    double energy = engine_->state().kinetic_energy();
    if (energy > kHottest * energy_) {
      engine_->scale_velocities(std::sqrt(energy_ / energy));
      energy = energy_;
    }
    const double scale = engine_->state().scale;
    if (!restart_is_set && density(scale) >= kRetryDensity) {
      restart_ = engine_->state();
      restart_is_set = true;
    }
    Epoch epoch;
    epoch.growth = rate_at(scale);
    epoch.longest = std::min(kLongestStep, last_scale - scale) / epoch.growth;
    epoch.most_collisions = kCollisionsPerEpoch * static_cast<uint64_t>(request_.radii.size());
    epoch.highest_energy = kHottest * energy_;
    const Tally before = engine_->tally();
    const EpochEnd end = engine_->run(epoch, [this] { return poll(); });
    if (end == EpochEnd::kStopped) return GrowthEnd::kStopped;
    if (jammed(end, before, energy)) return GrowthEnd::kJammed;
    if (end == EpochEnd::kTime && epoch.longest < kLongestStep / epoch.growth) break;  // the last step, rounded
  }
  return GrowthEnd::kDone;
}

GrowthResult Growth::result(GrowthEnd end) {
  GrowthResult result;
  const State &state = engine_->state();
  const double scale = end == GrowthEnd::kDone ? 1 : std::min(state.scale / (1 + kSpare), 1.0);
  result.end = end;
  result.centers.resize(state.count());
  for (size_t k = 0; k < state.count(); k++) result.centers[order_[k]] = state.centers[k];
  result.radii = request_.radii;
  if (scale < 1) {
    for (double &r : result.radii) r *= scale;
  }
  result.density = density(scale);
  result.rate = rate_;
  result.retries = retries_;
  result.compressibility = progress_.compressibility;
  result.tally = earlier_;
  add(result.tally, engine_->tally());
  return result;
}

}  // namespace

GrowthResult grow(const Box &box, const GrowthRequest &request, const GrowthObserver &observe) {
  if (request.radii.empty()) throw particles::Error("no particles to grow");
  return Growth(box, request, observe).run();
}

}  // namespace packing::event
