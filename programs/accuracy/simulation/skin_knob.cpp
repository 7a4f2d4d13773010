// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The knob of the skin. The library looks at how far every particle has moved, so no skin may change the motion by a
// single bit: that is what is looked for, particle by particle.
#include "programs/accuracy/simulation/skin_knob.hpp"

#include "dem/setup/time_step.hpp"
#include "packing/packing.hpp"
#include "packing/random.hpp"
#include "programs/accuracy/simulation/elastic_gas.hpp"
#include "programs/accuracy/simulation/step_cost.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

namespace accuracy {
namespace {

// In radii of the smallest particle; the first is what the others are held against.
const std::vector<double> kSkins = {0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5};
constexpr double kDensity = 0.4;    // low enough that the packing of many sizes comes without overlaps
constexpr double kUsualSkin = 0.1;  // of `hgrid run`
constexpr uint64_t kSteps = 200;
constexpr int kMostRounds = 3;

// A packing of many sizes; each particle has the kinetic energy of a gas in which the smallest overlap by 1 %.
dem::Setup many_sizes(size_t count) {
  packing::Request request;
  request.law.ratio = 10;
  request.count = count;
  request.density = timed_gas(count).density;
  request.sweeps = 300;  // leave overlaps of less than a per cent
  const particles::ParticleSet packing = packing::make_packing(request, nullptr).particles;
  dem::Setup setup = elastic_gas({});
  setup.effects = dem::kWalls;
  setup.centers = packing.centers;
  setup.radii = packing.radii;
  setup.masses.clear();
  setup.velocities.clear();
  const double temperature = temperature_of({});
  packing::Random random(1);
  for (const double radius : packing.radii) {
    setup.masses.push_back(radius * radius * radius);
    for (int k = 0; k < 3; k++)
      setup.velocities.push_back(std::sqrt(temperature / setup.masses.back()) * random.normal());
  }
  for (int k = 0; k < 3; k++) {
    setup.box_min[k] = packing.box_min[k];
    setup.box_max[k] = packing.box_max[k];
    setup.periodic[k] = false;
    setup.walled[k] = true;
  }
  return setup;
}

size_t changed(const dem::Snapshot &a, const dem::Snapshot &b) {
  size_t count = 0;
  for (size_t i = 0; i < a.radii.size(); i++) {
    bool same = true;
    for (size_t k = 3 * i; k < 3 * i + 3; k++) {
      same = same && a.centers[k] == b.centers[k] && a.velocities[k] == b.velocities[k];
    }
    count += same ? 0 : 1;
  }
  return count;
}

void add_skins(const std::string &system, dem::Setup setup, int rounds, std::vector<TradePoint> &points) {
  setup.time_step = dem::shortest_contact(setup) / dem::kUsualStepsPerContact;
  std::vector<std::unique_ptr<TimedRun>> runs;
  std::vector<double> searches;
  for (const double skin : kSkins) {
    setup.skin = skin;
    runs.push_back(std::make_unique<TimedRun>(setup, dem::Precision::kDouble, kSteps));
    searches.push_back(-static_cast<double>(runs.back()->engine().grid_stats().search_count));
  }
  for (int round = 0; round < rounds; round++) {
    for (const auto &run : runs) run->run(kSteps);
  }
  dem::Snapshot reference;
  for (size_t k = 0; k < kSkins.size(); k++) {
    const hg_grid_stats stats = runs[k]->engine().grid_stats();
    if (k == 0) reference = runs[0]->engine().snapshot();
    searches[k] += static_cast<double>(stats.search_count);
    const size_t wrong = changed(reference, runs[k]->engine().snapshot());
    const auto count = static_cast<double>(setup.count());
    char setting[32], note[120];
    std::snprintf(setting, sizeof setting, "skin %g", kSkins[k]);
    std::snprintf(note, sizeof note, "searched every %.3g steps, %.1f stored per particle",
                  static_cast<double>(kSteps) * rounds / searches[k], static_cast<double>(stats.stored_count) / count);
    TradePoint point{"skin",
                     system,
                     setting,
                     "motion",
                     static_cast<double>(wrong) / count,
                     runs[k]->ns_per_particle_and_step(),
                     kSkins[k] == kUsualSkin,
                     note};
    point.number = kSkins[k];
    points.push_back(point);
  }
}

}  // namespace

std::vector<TradePoint> measure_run_skins(const Budget &budget, const Progress &progress) {
  std::vector<TradePoint> points;
  const int rounds = std::min(budget.repeats, kMostRounds);
  progress("equal spheres");
  add_skins("equal spheres, density 0.4", melted_gas(timed_gas(budget.timed_count)), rounds, points);
  progress("many sizes");
  add_skins("ratio 10, density 0.4", many_sizes(budget.timed_count), rounds, points);
  return points;
}

}  // namespace accuracy
