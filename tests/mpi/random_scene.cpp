// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with all that has led a search over ranks astray: ties across faces, giants, empty ranks, clouds of owners.
#include "oracle/pairs.hpp"
#include "tests/mpi/scene.hpp"

#include <algorithm>
#include <cmath>

namespace hgtest::mpi {
namespace {

hg_grid_def random_def(Rng &rng) {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = rng.chance(0.75) ? 3 : 2;
  def.thread_count = 1;
  def.index_base = rng.integer(0, 1);
  def.interaction = rng.chance(0.7) ? HG_CONTACT : HG_MAX_RANGE;
  def.pair_order = rng.integer(0, 1);
  def.touching = rng.chance(0.2) ? 1 : 0;
  const double length = rng.chance(0.4) ? 0.7 : rng.uniform(0.5, 2.0);
  const double offset = rng.chance(0.2) ? 1e6 : rng.chance(0.5) ? 0.0 : rng.uniform(-1.0, 1.0);
  if (rng.chance(0.3)) def.margin = length * rng.uniform(0.0, 0.05);
  if (rng.chance(0.5)) def.skin = length * rng.uniform(0.01, 0.1);
  for (int axis = 0; axis < def.dimension; axis++) {
    def.periodic[axis] = rng.chance(0.6) ? 1 : 0;
    def.box_min[axis] = offset;
    def.box_max[axis] = offset + length * (rng.chance(0.5) ? 1.0 : rng.uniform(1.0, 1.5));
  }
  const auto tilt = [&](int one, int other) {
    const bool may = def.periodic[one] != 0 && def.periodic[other] != 0 && rng.chance(0.2);
    return may ? length * rng.uniform(-0.5, 0.5) : 0.0;
  };
  def.tilt[0] = tilt(0, 1);
  def.tilt[1] = tilt(0, 2);
  def.tilt[2] = tilt(1, 2);
  return def;
}

double edge(const hg_grid_def &def, size_t axis) { return def.box_max[axis] - def.box_min[axis]; }

// Rows and columns that touch within an ulp, also across the faces.
void add_lattice(Scene &scene, Rng &rng) {
  const size_t d = scene.dimension();
  const int side = rng.integer(2, d == 3 ? 5 : 9);
  double spacing = edge(scene.def, 0) / side;
  const bool max_range = scene.def.interaction == HG_MAX_RANGE;
  const double radius = std::max(0.0, max_range ? spacing - scene.def.margin : 0.5 * (spacing - scene.def.margin));
  int place[3] = {0, 0, 0};
  for (place[2] = 0; place[2] < (d == 3 ? side : 1); place[2]++) {
    for (place[1] = 0; place[1] < side; place[1]++) {
      for (place[0] = 0; place[0] < side; place[0]++) {
        std::vector<double> center;
        for (size_t axis = 0; axis < d; axis++) {
          spacing = edge(scene.def, axis) / side;
          center.push_back(scene.def.box_min[axis] + place[axis] * spacing);
        }
        const double nudged = std::nextafter(radius, rng.chance(0.5) ? 1.0 : 0.0);
        scene.add(center, rng.chance(0.5) ? radius : std::max(0.0, nudged));
      }
    }
  }
}

void add_cloud(Scene &scene, Rng &rng) {
  const int count = rng.chance(0.1) ? rng.integer(0, 2) : rng.integer(3, 120);
  const bool equal = rng.chance(0.3), clusters = rng.chance(0.3), far = rng.chance(0.2);
  const double ratio = std::pow(10.0, rng.uniform(0.0, 4.0));
  const double typical = edge(scene.def, 0) * 0.6 / std::pow(count + 1.0, 1.0 / scene.def.dimension);
  for (int k = 0; k < count; k++) {
    std::vector<double> center;
    for (size_t axis = 0; axis < scene.dimension(); axis++) {
      double place = rng.uniform();
      if (clusters) place = 0.9 + 0.2 * place * rng.uniform();
      if (far) place += rng.integer(-2, 2);
      center.push_back(scene.def.box_min[axis] + place * edge(scene.def, axis));
    }
    const double radius = equal ? typical * 0.5 : typical / std::pow(ratio, rng.uniform());
    scene.add(center, rng.chance(0.03) ? 0.0 : radius);
  }
  // Giants, larger than what a rank owns and, where no axis is periodic, than the box.
  for (int giants = rng.chance(0.4) ? rng.integer(1, 3) : 0; giants > 0 && count > 0; giants--) {
    scene.radii[rng.below(static_cast<uint64_t>(count))] = edge(scene.def, 0) * rng.uniform(0.1, 5.0);
  }
}

int32_t owner_of(const Scene &scene, size_t row, int way, int ranks, Rng &rng) {
  switch (way) {
    case 0:
      return rng.integer(0, ranks - 1);
    case 1:
      return ranks - 1;
    case 2:  // two ranks only
      return rng.chance(0.5) ? 0 : ranks / 2;
    default: {  // slabs
      const size_t axis = scene.dimension() - 1;
      const double place =
          (scene.centers[row * scene.dimension() + axis] - scene.def.box_min[axis]) / edge(scene.def, axis);
      return static_cast<int32_t>(std::clamp(place * ranks, 0.0, ranks - 1.0));
    }
  }
}

}  // namespace

Scene random_scene(Rng &rng, int ranks) {
  Scene scene;
  scene.def = random_def(rng);
  if (rng.chance(0.3)) {
    add_lattice(scene, rng);
  } else {
    add_cloud(scene, rng);
  }
  particles::ParticleSet set;
  set.dimension = scene.def.dimension;
  set.centers = scene.centers;
  set.radii = scene.radii;
  while (oracle::can_meet_twice(scene.def, set)) {
    scene.def.margin *= 0.5;
    double &largest = *std::max_element(set.radii.begin(), set.radii.end());
    largest *= 0.5;
  }
  scene.radii = set.radii;
  const int way = rng.integer(0, 5);
  const bool company = rng.chance(0.25);
  if (company && rng.chance(0.5)) scene.apart = {{0, 1}, {2, 2}};
  for (size_t k = 0; k < scene.count(); k++) {
    // Unique, of any sign, above 2^40.
    scene.gids.push_back((static_cast<int64_t>(rng.next() >> 24) - (int64_t{1} << 39)) * 4096 +
                         static_cast<int64_t>(k));
    scene.owners.push_back(owner_of(scene, k, way, ranks, rng));
    scene.groups.push_back(company ? rng.integer(-1, 2) : 0);
    scene.bodies.push_back(company && rng.chance(0.5) ? rng.integer(0, 5) : -1);
  }
  return scene;
}

}  // namespace hgtest::mpi
