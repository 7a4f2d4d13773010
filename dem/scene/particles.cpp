// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The particles of a scene: masses and first motion of each group.
#include "dem/scene/particles.hpp"

#include "dem/base/error.hpp"
#include "dem/base/vector.hpp"
#include "dem/effects/contact_law.hpp"
#include "dem/scene/materials.hpp"
#include "dem/scene/sources.hpp"
#include "dem/setup/materials.hpp"
#include "packing/random.hpp"

#include <algorithm>
#include <cmath>

namespace scene {
namespace {

using dem::kPi;

// kT at which the mean overlap of two of the smallest particles is the given share of their radius: they meet with the
// flux-weighted mean speed sqrt(pi kT / m) and overlap by that times sqrt(m / (2 k)).
double temperature_of_overlap(const Table &table, const dem::Setup &setup, double overlap, double smallest) {
  if (has(setup.effects, dem::kHertz)) table.fail("overlap", "is for linear contacts: give a temperature");
  const int material = material_in(table, setup);
  const dem::ContactParameters &p =
      material < 0 ? setup.contact : setup.materials[static_cast<size_t>(material)].contact;
  const double depth = overlap * smallest;
  return 2 * dem::linear_stiffness(setup.effects, p, smallest, smallest) * depth * depth / kPi;
}

// Adds velocities of this temperature to the particles from `first` on, and takes out the drift of the group.
void heat(const Table &table, double temperature, size_t first, dem::Setup &setup) {
  const auto dimension = static_cast<size_t>(setup.dimension);
  packing::Random random(table.count("seed", 1));
  std::vector<double> momentum(dimension, 0.0);
  double mass = 0;
  for (size_t i = first; i < setup.count(); i++) {
    const double speed = std::sqrt(temperature / setup.masses[i]);
    mass += setup.masses[i];
    for (size_t axis = 0; axis < dimension; axis++) {
      const double v = speed * random.normal();
      setup.velocities[i * dimension + axis] += v;
      momentum[axis] += setup.masses[i] * v;
    }
  }
  for (size_t i = first; i < setup.count(); i++) {
    for (size_t axis = 0; axis < dimension; axis++) setup.velocities[i * dimension + axis] -= momentum[axis] / mass;
  }
}

void set_temperature(const Table &table, size_t first, dem::Setup &setup) {
  if (table.has("temperature") && table.has("overlap")) table.fail("overlap", "stands instead of temperature");
  double temperature = table.number("temperature", 0);
  if (table.has("overlap")) {
    const auto from = setup.radii.begin() + static_cast<ptrdiff_t>(first);
    temperature =
        temperature_of_overlap(table, setup, table.number("overlap"), *std::min_element(from, setup.radii.end()));
  }
  if (temperature < 0) table.fail("temperature", dem::text(temperature) + " is negative");
  if (temperature == 0) return;
  if (table.flag("fixed", false)) table.fail("fixed", "fixed particles have no temperature");
  heat(table, temperature, first, setup);
}

// The vector of particle k in the file, if it has such, and that of the group. In two dimensions spins point along z.
void append_motion(const particles::ParticleSet &set, const char *name, size_t k, const std::vector<double> &group,
                   std::vector<double> &all) {
  const double *own = set.column(name);
  if (own != nullptr) own += 3 * k + (group.size() == 1 ? 2 : 0);
  for (size_t axis = 0; axis < group.size(); axis++) all.push_back(group[axis] + (own != nullptr ? own[axis] : 0));
}

// What each particle is made of: as the group says, else as its file.
std::vector<int> materials_of(const Table &table, const dem::Setup &setup, particles::ParticleSet &set) {
  const double *own = set.column("material");
  if (own == nullptr || !has(setup.effects, dem::kMaterials) || table.has("material")) {
    if (own != nullptr) set.unused.emplace_back("material");
    return std::vector<int>(set.count(), material_of_group(table, setup));
  }
  std::vector<int> result;
  for (size_t k = 0; k < set.count(); k++) {
    if (!(own[k] >= 0 && own[k] < static_cast<double>(setup.materials.size()) && own[k] == std::floor(own[k])))
      table.fail("file", "particle " + std::to_string(k + 1) + " is of material " + dem::text(own[k]) +
                             ", and the scene has " + std::to_string(setup.materials.size()) + ", counted from 0");
    result.push_back(static_cast<int>(own[k]));
  }
  return result;
}

// Those of the file, unless the group or its material tells a density; 0 and infinity are of particles that are fixed.
std::vector<double> masses_of(const Table &table, const dem::Setup &setup, particles::ParticleSet &set,
                              const std::vector<int> &materials) {
  const double *own = set.column("mass");
  const int material = material_in(table, setup);
  const bool is_told =
      table.has("density") || (material >= 0 && setup.materials[static_cast<size_t>(material)].density > 0);
  if (own != nullptr && is_told) set.unused.emplace_back("mass");
  std::vector<double> result;
  for (size_t k = 0; k < set.count(); k++) {
    if (own == nullptr || is_told) {
      result.push_back(density_of(table, setup, materials[k]) * dem::volume_of_particle(set.radii[k], setup.dimension));
      continue;
    }
    if (!(own[k] >= 0))
      table.fail("file", "the mass of particle " + std::to_string(k + 1) + " is " + dem::text(own[k]));
    result.push_back(own[k] > 0 ? own[k] : dem::kImmovable);
  }
  return result;
}

}  // namespace

int material_of_group(const Table &table, const dem::Setup &setup) {
  const int material = material_in(table, setup);
  if (has(setup.effects, dem::kMaterials) && material < 0) {
    table.fail("material", "each group of a scene with [[material]] names one: " + dem::names_of(setup.materials));
  }
  return material;
}

double density_of(const Table &table, const dem::Setup &setup, int material) {
  const double own = material < 0 ? 0 : setup.materials[static_cast<size_t>(material)].density;
  if (own > 0 && table.has("density")) table.fail("density", "stands in the material of the group");
  if (own > 0) return own;
  const double density = table.number("density", 1, Unit{-setup.dimension, 0, 1});
  if (!(density > 0)) table.fail("density", dem::text(density) + " is not above 0");
  return density;
}

particles::ParticleSet add_particles(const Table &table, const std::string &folder, dem::Setup &setup) {
  particles::ParticleSet set = read_source(table, folder, setup);
  if (set.count() == 0) table.fail("file", "there is no particle in this group");
  const auto dimension = static_cast<size_t>(setup.dimension);
  const size_t first = setup.count(), spin_size = dimension == 3 ? 3 : 1;
  const bool fixed = table.flag("fixed", false);
  const std::vector<double> velocity = table.vector("velocity", dimension, 0),
                            spin = table.vector("spin", spin_size, 0);
  if (table.has("spin") && !has(setup.effects, dem::kFriction)) {
    table.fail("spin", "without [friction] particles do not rotate");
  }
  const std::vector<int> materials = materials_of(table, setup, set);
  const std::vector<double> masses = masses_of(table, setup, set, materials);
  for (size_t k = 0; k < set.count(); k++) {
    setup.radii.push_back(set.radii[k]);
    setup.masses.push_back(fixed ? dem::kImmovable : masses[k]);
    append_motion(set, "velocity", k, velocity, setup.velocities);
    if (has(setup.effects, dem::kFriction)) append_motion(set, "spin", k, spin, setup.spins);
    if (materials[k] >= 0) setup.material_ids.push_back(static_cast<uint8_t>(materials[k]));
  }
  setup.centers.insert(setup.centers.end(), set.centers.begin(), set.centers.end());
  set_temperature(table, first, setup);
  if (set.column("spin") != nullptr && !has(setup.effects, dem::kFriction)) set.unused.emplace_back("spin");
  return set;
}

}  // namespace scene
