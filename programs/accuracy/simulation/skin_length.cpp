// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Varies how far particles may move before the library searches candidates anew. It looks at how far every particle has
// moved, so no skin may change the motion by a single bit: that is what is looked for, particle by particle.
#include "packing/packing.hpp"
#include "packing/random.hpp"
#include "particles/text/formatted.hpp"
#include "programs/accuracy/simulation/elastic_gas.hpp"
#include "programs/accuracy/simulation/studies.hpp"
#include "programs/accuracy/simulation/timed_run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace accuracy {
namespace {

// In radii of the smallest particle; the first is what the others are held against.
constexpr double kSkins[] = {0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5};
constexpr double kUsualSkin = 0.1;  // of `hgrid run`
constexpr int kContacts = 4;        // in t_c, of each run and of warming up
constexpr int kMostRounds = 3;

// A packing of many sizes; each particle has the kinetic energy of a gas in which the smallest overlap by 1 %.
dem::Setup many_sizes(size_t count) {
  packing::Request request;
  request.law.ratio = 10;
  request.count = count;
  request.density = timed_gas(count).density;  // low enough that it comes without overlaps
  request.sweeps = 300;                        // leave overlaps of less than a per cent
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
    const double speed = std::sqrt(temperature / setup.masses.back());
    for (int axis = 0; axis < 3; axis++) setup.velocities.push_back(speed * random.normal());
  }
  for (int axis = 0; axis < 3; axis++) {
    setup.box_min[axis] = packing.box_min[axis];
    setup.box_max[axis] = packing.box_max[axis];
    setup.periodic[axis] = false;
    setup.walled[axis] = true;
  }
  return setup;
}

size_t count_elsewhere(const dem::Snapshot &a, const dem::Snapshot &b) {
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

struct SkinRun {
  double skin;
  TimedRun timed;
  int64_t searches_before;
  hg_grid_stats stats;  // after the last run

  void run() {
    timed.run();
    stats = timed.engine().grid_stats();
  }
};

SkinRun skin_run(dem::Setup &setup, double skin) {
  setup.skin = skin;
  TimedRun timed(setup, dem::Precision::kDouble, dem::kUsualStepsPerContact, kContacts, kContacts);
  const hg_grid_stats stats = timed.engine().grid_stats();
  return {skin, std::move(timed), stats.search_count, stats};
}

Finding finding_of(SkinRun &run, const dem::Snapshot &reference) {
  const auto count = static_cast<double>(reference.radii.size());
  const auto searches = static_cast<double>(run.stats.search_count - run.searches_before);
  const std::string note =
      particles::formatted("searched every %.3g steps", static_cast<double>(run.timed.steps_timed()) / searches);
  const size_t elsewhere = count_elsewhere(reference, run.timed.engine().snapshot());
  return {particles::formatted("skin %g", run.skin),
          run.timed.ns_per_step(),
          {{"motion", static_cast<double>(elsewhere) / count, note}},
          run.skin == kUsualSkin,
          run.skin};
}

void measure_system(dem::Setup setup, Recorder &record) {
  std::vector<SkinRun> runs;
  runs.reserve(std::size(kSkins));
  for (const double skin : kSkins) runs.push_back(skin_run(setup, skin));
  measure::in_turns(runs, std::min(record.budget().repeats, kMostRounds));
  const dem::Snapshot reference = runs[0].timed.engine().snapshot();
  for (SkinRun &run : runs) record.add(finding_of(run, reference));
}

}  // namespace

void measure_skin_lengths(Recorder &record) {
  record.begin("equal spheres, density 0.4");
  measure_system(melted_gas(timed_gas(record.budget().timed_count)), record);
  record.begin("ratio 10, density 0.4");
  measure_system(many_sizes(record.budget().timed_count), record);
}

}  // namespace accuracy
