// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the particles of a group come from.
#include "dem/scene/sources.hpp"

#include "dem/base/error.hpp"
#include "dem/scene/size_laws.hpp"
#include "packing/event/grown_packing.hpp"
#include "packing/packing.hpp"
#include "packing/random.hpp"
#include "particles/error.hpp"
#include "particles/files/reader.hpp"
#include "particles/text/formatted.hpp"
#include "particles/text/number.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <numeric>
#include <utility>

namespace scene {
namespace {

// A packing without overlaps: what does not reach the density is none.
particles::ParticleSet grow(const packing::Request &request) {
  packing::event::GrownPacking packing = packing::event::grow_packing(request, 0, [](const auto &) { return true; });
  if (packing.growth.end != packing::event::GrowthEnd::kDone) {
    throw particles::Error("the growth jammed at density " + particles::text(packing.growth.density));
  }
  return std::move(packing.particles);
}

// Refuses a number of particles that would not fit into this machine: a slip of the hand is told before it swaps.
void require_memory(const Table &table, const char *key, double count) {
  constexpr double kBytesPerParticle = 300;  // of a run: state, grid, stored candidates
  const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  constexpr double kGiga = 1e9;
  if (count * kBytesPerParticle <= memory) return;
  table.fail(key, particles::formatted("%.3g particles would take about %.3g GB, and this machine has %.3g GB", count,
                                       count * kBytesPerParticle / kGiga, memory / kGiga));
}

particles::ParticleSet read_pack(const Table &group, const Table &table, const std::string &folder,
                                 const dem::Setup &setup) {
  packing::Request request;
  request.law = read_law(table, folder, setup.dimension);
  request.count = static_cast<size_t>(table.count("count"));
  require_memory(table, "count", static_cast<double>(request.count));
  request.density = table.number("fraction");
  request.seed = table.count("seed", 1);
  request.sweeps = static_cast<int>(table.count("sweeps", 60));
  for (size_t axis = 0; axis < 3; axis++) request.periodic[axis] = setup.periodic[axis];
  const bool grows = table.choice("method", {"relax", "event"}) == "event";
  if (grows && table.has("sweeps")) table.fail("sweeps", "is for the method relax");
  particles::ParticleSet set;
  try {
    set = grows ? grow(request) : packing::make_packing(request, [](int, const packing::Overlaps &) {}).particles;
  } catch (const std::exception &error) {
    group.fail("pack", particles::message_of(error));
  }
  const double first = packing::first_radius(request.law), radius = group.number("radius", first);
  if (!(radius > 0)) group.fail("radius", "is not above 0");
  packing::scale(set, radius / first);
  return set;
}

particles::ParticleSet read_file(const Table &group, const std::string &folder, const dem::Setup &setup) {
  const std::filesystem::path name = group.text("file", "");
  particles::ReadOptions options;
  options.dimension = setup.dimension;
  options.motion = true;
  try {
    return particles::read_particles((std::filesystem::path(folder) / name).string(), options);
  } catch (const std::exception &error) {
    group.fail("file", error.what());
  }
}

double radius_of(const Table &group) {
  const double radius = group.number("radius");
  if (!(radius > 0)) group.fail("radius", "is not above 0");
  return radius;
}

particles::ParticleSet read_list(const Table &group, const dem::Setup &setup) {
  particles::ParticleSet set;
  set.dimension = setup.dimension;
  for (const std::vector<double> &center : group.list("at", static_cast<size_t>(setup.dimension))) {
    set.centers.insert(set.centers.end(), center.begin(), center.end());
    set.radii.push_back(radius_of(group));
  }
  return set;
}

// The place of lattice point (i, j, k), nearest neighbours one apart. Hexagonal: rows along x, each shifted by half;
// in three dimensions such layers are stacked ABAB (hcp).
void lattice_point(bool hexagonal, int dimension, const size_t (&index)[3], double (&point)[3]) {
  const auto i = static_cast<double>(index[0]), j = static_cast<double>(index[1]), k = static_cast<double>(index[2]);
  if (!hexagonal) {
    point[0] = i;
    point[1] = j;
    point[2] = k;
    return;
  }
  const double odd_layer = dimension == 3 && index[2] % 2 == 1 ? 1 : 0;
  const double odd_row = index[1] % 2 == 1 ? 1 : 0;
  point[0] = i + 0.5 * (odd_row == odd_layer ? 0 : 1);
  point[1] = std::sqrt(0.75) * (j + odd_layer / 3);
  point[2] = std::sqrt(2.0 / 3) * k;
}

particles::ParticleSet read_lattice(const Table &group, const Table &table, const dem::Setup &setup) {
  const auto dimension = static_cast<size_t>(setup.dimension);
  const double radius = radius_of(group);
  const bool hexagonal = table.choice("kind", {"cubic", "hexagonal"}) == "hexagonal";
  const std::vector<double> counts = table.vector("counts", dimension), origin = table.vector("origin", dimension, 0);
  const double spacing = table.number("spacing", 2 * radius), jitter = table.number("jitter", 0);
  size_t most[3] = {1, 1, 1};
  for (size_t axis = 0; axis < dimension; axis++) {
    if (!(counts[axis] >= 1) || counts[axis] != std::floor(counts[axis]) || counts[axis] > 1e6) {
      table.fail("counts", particles::text(counts[axis]) + " is not a whole number of 1 or more");
    }
    most[axis] = static_cast<size_t>(counts[axis]);
  }
  require_memory(table, "counts", std::accumulate(counts.begin(), counts.end(), 1.0, std::multiplies<>()));
  packing::Random random(table.count("seed", 1));
  particles::ParticleSet set;
  set.dimension = setup.dimension;
  size_t index[3] = {0, 0, 0};
  for (index[2] = 0; index[2] < most[2]; ++index[2]) {
    for (index[1] = 0; index[1] < most[1]; ++index[1]) {
      for (index[0] = 0; index[0] < most[0]; ++index[0]) {
        double point[3];
        lattice_point(hexagonal, setup.dimension, index, point);
        for (size_t axis = 0; axis < dimension; axis++) {
          const double shift = jitter > 0 ? jitter * (2 * random.uniform() - 1) : 0;
          set.centers.push_back(origin[axis] + spacing * point[axis] + shift);
        }
        set.radii.push_back(radius);
      }
    }
  }
  return set;
}

}  // namespace

particles::ParticleSet read_source(const Table &table, const std::string &folder, const dem::Setup &setup) {
  int sources = 0;
  for (const char *name : {"file", "pack", "lattice", "at"}) sources += table.has(name) ? 1 : 0;
  if (sources != 1) table.fail("file", "each [[particles]] names one source of file, pack, lattice and at");
  if (const auto pack = table.part("pack")) return read_pack(table, *pack, folder, setup);
  if (const auto lattice = table.part("lattice")) return read_lattice(table, *lattice, setup);
  if (table.has("at")) return read_list(table, setup);
  return read_file(table, folder, setup);
}

}  // namespace scene
