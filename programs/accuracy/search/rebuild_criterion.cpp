// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Varies when the stored candidates of moving particles are searched anew: every k steps, or when the particles have
// moved by half the skin. Each flight goes through its packing alone: several at once would push each other out of
// cache.
#include "programs/accuracy/search/rebuild_criterion.hpp"

#include "oracle/pairs.hpp"
#include "particles/text/formatted.hpp"
#include "programs/accuracy/contacts.hpp"
#include "programs/accuracy/search/studies.hpp"
#include "programs/accuracy/search/systems.hpp"
#include "programs/accuracy/search/verlet_list.hpp"
#include "programs/measure/search_timer.hpp"
#include "programs/measure/step_timer.hpp"

#include <algorithm>

namespace accuracy {
namespace {

constexpr double kDisplacement = 0.01;  // of the fastest in one step; the smallest radius is 1
constexpr double kMargin = 0.1;
constexpr int kSteps = 60;

hg_grid_def def_of(const particles::ParticleSet &start, int32_t accuracy, double skin) {
  hg_grid_def def = measure::def_of(start);
  def.thread_count = 1;
  def.accuracy = accuracy;
  def.skin = skin;
  return def;
}

void count_missed(const particles::ParticleSet &particles, const oracle::Pairs &truth, const oracle::Pairs &found,
                  Missed &missed) {
  const oracle::Pairs lost = oracle::difference(truth, found).missing;
  missed.contacts += truth.size();
  missed.missed += lost.size();
  for (const hg_pair &pair : lost) missed.deepest = std::max(missed.deepest, relative_overlap(particles, pair));
}

// Against a fresh search in each step, by the expression in doubles with which lists are filtered.
template <class Follower>
Missed missed_by(Follower &follower, const particles::ParticleSet &start, double displacement, int steps) {
  hg_grid_def def = def_of(start, HG_DOUBLE, 0);
  def.pair_order = HG_ORDER_ID;
  measure::MovingGrid fresh(def, start);
  measure::Flight flight(start, displacement);
  Missed missed;
  for (int step = 0; step < steps; step++) {
    flight.step();
    follower.step(flight.particles());
    fresh.step(flight.particles());
    count_missed(flight.particles(), {fresh.pairs().begin(), fresh.pairs().end()},
                 {follower.pairs().begin(), follower.pairs().end()}, missed);
  }
  return missed;
}

// One setting, which is timed on `large` and checked on `small`.
struct Criterion {
  std::string name;
  int interval;  // 0: the library's criterion
  double skin;
  const particles::ParticleSet *large, *small;
  measure::StepTimes times;

  bool is_library() const { return interval == 0; }

  void run() {
    if (is_library()) {
      measure::MovingGrid grid(def_of(*large, HG_EXACT, skin), *large);
      time_flight(grid);
    } else {
      VerletList list(*large, kMargin, interval);
      time_flight(list);
    }
  }
  template <class Follower>
  void time_flight(Follower &follower) {
    measure::Flight flight(*large, kDisplacement);
    for (int step = 0; step < kSteps; step++) {
      flight.step();
      measure::time_step(follower, flight.particles(), times);
    }
  }

  // The library's own criterion is checked like the others.
  Missed missed() const {
    if (!is_library()) return missed_contacts(*small, kDisplacement, kMargin, interval, kSteps);
    measure::MovingGrid grid(def_of(*small, HG_DOUBLE, skin), *small);
    return missed_by(grid, *small, kDisplacement, kSteps);
  }
};

std::vector<Criterion> criteria_of(bool quick, const particles::ParticleSet &large,
                                   const particles::ParticleSet &small) {
  std::vector<Criterion> criteria;
  for (const double skin : {0.0, 0.05, 0.1, 0.2}) {
    const std::string name = skin > 0 ? particles::formatted("skin %g", skin) : "search each step";
    criteria.push_back({name, 0, skin, &large, &small, {}});
  }
  const std::vector<int> all = {5, 7, 10, 14, 20, 30}, few = {5, 20};
  for (const int interval : quick ? few : all) {
    criteria.push_back({"every " + std::to_string(interval) + " steps", interval, 0, &large, &small, {}});
  }
  return criteria;
}

Finding finding_of(const Criterion &criterion) {
  const Missed missed = criterion.missed();
  const std::string note = particles::formatted("%zu of %zu missed", missed.missed, missed.contacts);
  const double share = static_cast<double>(missed.missed) / static_cast<double>(missed.contacts);
  return {criterion.name,
          1e9 * criterion.times.mean() / static_cast<double>(criterion.large->count()),
          {{"contacts missed", share, note}, {"deepest overlap missed", missed.deepest, note}},
          criterion.is_library() && criterion.skin == 0};
}

}  // namespace

Missed missed_contacts(const particles::ParticleSet &start, double displacement, double margin, int interval,
                       int steps) {
  VerletList list(start, margin, interval);
  return missed_by(list, start, displacement, steps);
}

void measure_rebuild_criteria(Recorder &record) {
  const Budget &budget = record.budget();
  for (const auto &[name, law] : {kEqualSpheres, kUniformVolume10}) {
    record.begin(name);
    const particles::ParticleSet small = relaxed(law, budget.truth_count), large = relaxed(law, budget.timed_count);
    std::vector<Criterion> criteria = criteria_of(budget.quick, large, small);
    measure::in_turns(criteria, std::max(1, budget.repeats / 5));  // each has many steps
    for (const Criterion &criterion : criteria) record.add(finding_of(criterion));
  }
}

}  // namespace accuracy
