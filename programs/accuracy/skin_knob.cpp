// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Flights through a packing, one setting at a time: several at once would push each other out of cache.
#include "programs/accuracy/skin_knob.hpp"

#include "particles/insert.hpp"
#include "programs/accuracy/kept_list.hpp"
#include "programs/accuracy/systems.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

namespace accuracy {
namespace {

constexpr double kDisplacement = 0.01;  // of the fastest in one step; the smallest radius is 1
constexpr double kMargin = 0.1;
constexpr int kSteps = 60;

struct Times {
  std::vector<double> searched, filtered;  // seconds of one step
};

struct Setting {
  std::string name;
  int interval;  // 0: the library's criterion
  double skin;
  Times times;
  Missed missed;
};

bool less(const hg_pair &p, const hg_pair &q) { return p.a != q.a ? p.a < q.a : p.b < q.b; }

// All contacts, by the expression with which the list is filtered.
hgrid::Grid fresh_grid(const particles::ParticleSet &start) {
  hg_grid_def def = measure::def_of(start);
  def.thread_count = 1;
  def.accuracy = HG_DOUBLE;
  def.pair_order = HG_ORDER_ID;
  hgrid::Grid grid(def);
  particles::insert(start, grid);
  return grid;
}

void count_missed(const particles::ParticleSet &particles, hgrid::View<hg_pair> truth, std::vector<hg_pair> found,
                  Missed &missed) {
  std::sort(found.begin(), found.end(), less);
  missed.contacts += truth.size();
  for (const hg_pair &pair : truth) {
    if (std::binary_search(found.begin(), found.end(), pair, less)) continue;
    missed.missed++;
    missed.deepest = std::max(missed.deepest, relative_overlap(particles, pair));
  }
}

std::vector<Setting> settings_of(const Budget &budget) {
  std::vector<Setting> settings;
  for (const double skin : {0.0, 0.05, 0.1, 0.2}) {
    char name[40];
    std::snprintf(name, sizeof name, "skin %g", skin);
    settings.push_back({skin > 0 ? name : "search each step", 0, skin, {}, {}});
  }
  const std::vector<int> all = {5, 7, 10, 14, 20, 30}, few = {5, 20};
  for (const int interval : budget.quick ? few : all) {
    settings.push_back({"every " + std::to_string(interval) + " steps", interval, 0, {}, {}});
  }
  return settings;
}

void time_library(const particles::ParticleSet &start, Setting &setting) {
  hg_grid_def def = measure::def_of(start);
  def.thread_count = 1;
  def.skin = setting.skin;
  measure::Flight flight(start, kDisplacement);
  measure::StepTimer timer(def, start);
  for (int step = 0; step < kSteps; step++) {
    flight.step();
    timer.step(flight.particles());
  }
  Times &times = setting.times;
  times.searched.insert(times.searched.end(), timer.searched().begin(), timer.searched().end());
  times.filtered.insert(times.filtered.end(), timer.filtered().begin(), timer.filtered().end());
}

void time_kept_list(const particles::ParticleSet &start, Setting &setting) {
  measure::Flight flight(start, kDisplacement);
  KeptList list(start, kMargin, setting.interval);
  for (int step = 0; step < kSteps; step++) {
    flight.step();
    bool searched = false;
    const double seconds = measure::seconds_of([&] { searched = list.step(flight.particles()); });
    (searched ? setting.times.searched : setting.times.filtered).push_back(seconds);
  }
}

// Steps of a kind are alike, so their median stands for each of them.
double mean_step(const Times &times) {
  const auto searches = static_cast<double>(times.searched.size()),
             filters = static_cast<double>(times.filtered.size());
  const double searched = searches > 0 ? measure::median(times.searched) : 0;
  const double filtered = filters > 0 ? measure::median(times.filtered) : 0;
  return (searches * searched + filters * filtered) / (searches + filters);
}

void add_points(const std::string &system, const Setting &setting, double ns, std::vector<TradePoint> &points) {
  TradePoint point;
  point.knob = "skin";
  point.system = system;
  point.setting = setting.name;
  point.cost = ns;
  point.is_default = setting.interval == 0 && setting.skin == 0;
  char note[80];
  std::snprintf(note, sizeof note, "%zu of %zu missed", setting.missed.missed, setting.missed.contacts);
  point.note = note;
  point.error_of = "contacts missed";
  point.error = static_cast<double>(setting.missed.missed) / static_cast<double>(setting.missed.contacts);
  points.push_back(point);
  point.error_of = "deepest overlap missed";
  point.error = setting.missed.deepest;
  points.push_back(point);
}

// The library's own criterion is checked like the others: against a fresh search in each step.
Missed missed_by_skin(const particles::ParticleSet &start, double skin, int steps) {
  hg_grid_def def = measure::def_of(start);
  def.thread_count = 1;
  def.accuracy = HG_DOUBLE;
  def.skin = skin;
  hgrid::Grid grid(def), fresh = fresh_grid(start);
  particles::insert(start, grid);
  measure::Flight flight(start, kDisplacement);
  Missed missed;
  for (int step = 0; step < steps; step++) {
    flight.step();
    const particles::ParticleSet &now = flight.particles();
    grid.move(now.count(), now.centers.data());
    fresh.move(now.count(), now.centers.data());
    const hgrid::View<hg_pair> found = grid.query_pairs();
    count_missed(now, fresh.query_pairs(), {found.begin(), found.end()}, missed);
  }
  return missed;
}

}  // namespace

Missed missed_contacts(const particles::ParticleSet &start, double displacement, double margin, int interval,
                       int steps) {
  KeptList list(start, margin, interval);
  hgrid::Grid fresh = fresh_grid(start);
  measure::Flight flight(start, displacement);
  Missed missed;
  for (int step = 0; step < steps; step++) {
    flight.step();
    const particles::ParticleSet &now = flight.particles();
    list.step(now);
    fresh.move(now.count(), now.centers.data());
    count_missed(now, fresh.query_pairs(), list.pairs(), missed);
  }
  return missed;
}

std::vector<TradePoint> measure_skins(const Budget &budget, const Progress &progress) {
  std::vector<TradePoint> points;
  const std::vector<std::pair<std::string, packing::SizeLaw>> systems = {
      {"equal spheres", {packing::Law::kMono, 1, 3}},
      {"uniform volume, ratio 10", {packing::Law::kUniformVolume, 10, 3}}};
  for (const auto &[name, law] : systems) {
    progress(name);
    const particles::ParticleSet small = relaxed(law, budget.truth_count), large = relaxed(law, budget.timed_count);
    std::vector<Setting> settings = settings_of(budget);
    const int rounds = std::max(1, budget.repeats / 5);  // each has many steps
    for (int round = 0; round < rounds; round++) {
      for (Setting &setting : settings) {
        setting.interval > 0 ? time_kept_list(large, setting) : time_library(large, setting);
      }
    }
    for (Setting &setting : settings) {
      setting.missed = setting.interval > 0 ? missed_contacts(small, kDisplacement, kMargin, setting.interval, kSteps)
                                            : missed_by_skin(small, setting.skin, kSteps);
      add_points(name, setting, 1e9 * mean_step(setting.times) / static_cast<double>(large.count()), points);
    }
  }
  return points;
}

}  // namespace accuracy
