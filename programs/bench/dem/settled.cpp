// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// From a scene to a state in which particles touch as they do in the long run.
#include "programs/bench/dem/settled.hpp"

#include "dem/base/error.hpp"
#include "dem/effects/table.hpp"
#include "dem/engine/engine.hpp"
#include "dem/scene/scene.hpp"
#include "programs/bench/child.hpp"
#include "programs/bench/hierarchical_grid.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace bench {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr uint64_t kStepsBetweenLooks = 50;
constexpr double kSkin = 0.2;  // of the smallest radius

std::vector<hg_pair> contacts_of(const dem::Setup &setup, const MotionState &state) {
  const auto [smallest, largest] = std::minmax_element(setup.radii.begin(), setup.radii.end());
  std::vector<double> cells{2 * *smallest};
  while (cells.back() < 2 * *largest) cells.push_back(2 * cells.back());
  const Particles particles{setup.count(), state.centers.data(), setup.radii.data()};
  return hierarchical_grid_pairs(3, particles, cells, nullptr);
}

double kinetic_energy(const dem::Setup &setup, const std::vector<double> &velocities) {
  double sum = 0;
  for (size_t i = 0; i < setup.count(); i++) {
    for (size_t k = 0; k < 3; k++) sum += 0.5 * setup.masses[i] * velocities[3 * i + k] * velocities[3 * i + k];
  }
  return sum;
}

// Collisions per particle in so long a time: each contact there is lasts pi sqrt(mu / k) and has two partners.
double collisions_in(double time, const dem::Setup &setup, const MotionState &state) {
  double begun = 0;
  for (const hg_pair &pair : contacts_of(setup, state)) {
    const double a = setup.masses[static_cast<size_t>(pair.a)], b = setup.masses[static_cast<size_t>(pair.b)];
    begun += time / (kPi * std::sqrt(a * b / (a + b) / setup.contact.stiffness));
  }
  return 2 * begun / static_cast<double>(setup.count());
}

struct Progress {
  double collisions = 0;
  uint64_t steps = 0;
};

// Runs the setup until it is settled; leaves the state in it.
Progress let_settle(dem::Setup &setup, const Settling &settling) {
  const double wanted = kinetic_energy(setup, setup.velocities);
  const double interval = setup.time_step * static_cast<double>(kStepsBetweenLooks);
  Progress progress;
  auto engine = dem::make_engine(setup);
  while (progress.collisions < settling.collisions &&
         (settling.most_steps == 0 || progress.steps < settling.most_steps)) {
    engine->run(kStepsBetweenLooks);
    progress.steps += kStepsBetweenLooks;
    dem::Snapshot now = engine->snapshot();
    progress.collisions += collisions_in(interval, setup, {now.centers, now.velocities});
    const double kinetic = kinetic_energy(setup, now.velocities);
    if (!(kinetic > 0)) throw dem::Error("nothing moves: give the particles a temperature or an overlap");
    setup.centers = std::move(now.centers);
    setup.velocities = std::move(now.velocities);
    if (kinetic > 1.1 * wanted) {
      for (double &v : setup.velocities) v *= std::sqrt(wanted / kinetic);
      progress.collisions = 0;  // what springs apart is no collision
      engine = dem::make_engine(setup);
    }
  }
  return progress;
}

dem::Setup read_elastic(const std::string &path) {
  scene::Scene scene = scene::read_scene(path);
  dem::Setup &setup = scene.setup;
  if (setup.dimension != 3 || (setup.effects & ~static_cast<dem::EffectSet>(dem::kWalls)) != 0) {
    throw dem::Error(path + ": other programs are compared on elastic spheres between walls, not with " +
                     dem::names_of(setup.effects));
  }
  setup.skin = kSkin * *std::min_element(setup.radii.begin(), setup.radii.end());
  return std::move(setup);
}

// The file holds the progress, then centres and velocities, in this machine's bytes.
bool read_state(const std::string &path, SettledSystem &system) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return false;
  const auto take = [&](void *bytes, size_t size) {
    file.read(static_cast<char *>(bytes), static_cast<std::streamsize>(size));
  };
  take(&system.collisions, sizeof system.collisions);
  take(&system.steps, sizeof system.steps);
  take(system.setup.centers.data(), system.setup.centers.size() * sizeof(double));
  take(system.setup.velocities.data(), system.setup.velocities.size() * sizeof(double));
  if (!file || file.peek() != std::ifstream::traits_type::eof()) {
    throw dem::Error(path + ": not the settled state of " + std::to_string(system.setup.count()) + " particles");
  }
  return true;
}

void write_state(const std::string &path, const SettledSystem &system) {
  std::ofstream file(path, std::ios::binary);
  const auto put = [&](const void *bytes, size_t size) {
    file.write(static_cast<const char *>(bytes), static_cast<std::streamsize>(size));
  };
  put(&system.collisions, sizeof system.collisions);
  put(&system.steps, sizeof system.steps);
  put(system.setup.centers.data(), system.setup.centers.size() * sizeof(double));
  put(system.setup.velocities.data(), system.setup.velocities.size() * sizeof(double));
  file.close();
  if (!file) throw dem::Error(path + ": cannot be written");
}

}  // namespace

Sums sums_of(const dem::Setup &setup, const MotionState &state) {
  Sums sums;
  sums.kinetic = kinetic_energy(setup, state.velocities);
  double squares = 0;  // of all overlaps
  for (const hg_pair &pair : contacts_of(setup, state)) {
    const size_t a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
    double square = 0;
    for (size_t k = 0; k < 3; k++) square += std::pow(state.centers[3 * a + k] - state.centers[3 * b + k], 2);
    squares += std::pow(setup.radii[a] + setup.radii[b] - std::sqrt(square), 2);
    sums.contacts++;
  }
  for (size_t i = 0; i < setup.count(); i++) {
    for (size_t k = 0; k < 3; k++) {
      if (!setup.walled[k]) continue;
      const double x = state.centers[3 * i + k], r = setup.radii[i];
      squares += std::pow(std::max(0.0, r - (x - setup.box_min[k])), 2);
      squares += std::pow(std::max(0.0, r - (setup.box_max[k] - x)), 2);
    }
  }
  sums.elastic = 0.5 * setup.contact.stiffness * squares;
  return sums;
}

SettledSystem settle(const std::string &scene, const Settling &settling, bool keep) {
  const std::string state = std::filesystem::path(scene).replace_extension("state").string();
  SettledSystem system;
  system.name = std::filesystem::path(scene).stem().string();
  system.setup = read_elastic(scene);
  if (keep && read_state(state, system)) return system;
  Child maker(scene, [&](Channel &channel) {
    const Progress progress = let_settle(system.setup, settling);
    channel.send(progress);
    channel.send_array(system.setup.centers);
    channel.send_array(system.setup.velocities);
  });
  const auto progress = maker.channel().receive<Progress>();
  system.collisions = progress.collisions;
  system.steps = progress.steps;
  system.setup.centers = maker.channel().receive_array<double>();
  system.setup.velocities = maker.channel().receive_array<double>();
  maker.wait();
  if (keep) write_state(state, system);
  return system;
}

}  // namespace bench
