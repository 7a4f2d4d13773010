// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Images of periodic boxes: a search of all pairs among them finds the pairs of nearest images, each once. All numbers
// are multiples of 1/64, where doubles are exact.
#include "packing/random.hpp"
#include "programs/bench/images.hpp"
#include "programs/bench/pair_sets.hpp"
#include "tests/support/frame.h"

#include <cmath>
#include <cstdio>

namespace {

constexpr uint64_t kSeed = 31;
constexpr double kEdges[3] = {16, 20, 33};  // two of the largest diameters and more

double draw(packing::Random &random, double from, double to) {
  return from + static_cast<double>(random.below(static_cast<uint64_t>(64 * (to - from)))) / 64;
}

// Some places are outside the box.
particles::ParticleSet random_set(packing::Random &random, int dimension, unsigned periodic) {
  particles::ParticleSet set;
  set.dimension = dimension;
  set.has_box = true;
  for (int axis = 0; axis < dimension; axis++) {
    set.box_min[axis] = -2;
    set.box_max[axis] = -2 + kEdges[axis];
    set.periodic[axis] = (periodic >> axis & 1u) != 0 ? 1 : 0;
  }
  for (int i = 0; i < 150; i++) {
    double center[3];
    for (int axis = 0; axis < dimension; axis++)
      center[axis] = random.below(10) == 0 ? draw(random, -60, 60) : draw(random, -2, -2 + kEdges[axis]);
    set.add(center, random.below(8) == 0 ? 4 : draw(random, 0.5, 1.5));
  }
  return set;
}

// `nearest` gives what is left of a difference along an axis.
template <class Nearest>
std::vector<hg_pair> pairs_of(const particles::ParticleSet &set, Nearest nearest) {
  std::vector<hg_pair> pairs;
  for (size_t a = 0; a < set.count(); a++) {
    for (size_t b = a + 1; b < set.count(); b++) {
      double square = 0;
      for (int axis = 0; axis < set.dimension; axis++) {
        const double difference = nearest(axis, set.center(b)[axis] - set.center(a)[axis]);
        square += difference * difference;
      }
      const double sum = set.radii[a] + set.radii[b];
      if (square < sum * sum) pairs.push_back({static_cast<int32_t>(a), static_cast<int32_t>(b)});
    }
  }
  return pairs;
}

bool finds_all(const particles::ParticleSet &set, unsigned periodic) {
  const auto expected = pairs_of(set, [&set](int axis, double difference) {
    return set.periodic[axis] != 0 ? std::remainder(difference, kEdges[axis]) : difference;
  });
  bench::Images images(set);
  images.refresh();  // the memory of the first time is used again
  const auto among_images = pairs_of(images.all(), [](int, double difference) { return difference; });
  std::vector<hg_pair> found;
  images.fold({among_images.data(), among_images.size()}, found);
  const size_t odd = bench::differences(expected, bench::sorted(found.data(), found.size())).size();
  const bool has_images = images.all().count() > set.count();
  if (odd == 0 && !expected.empty() && has_images == (periodic != 0) && bench::is_periodic(set) == has_images)
    return true;
  std::fprintf(stderr, "dimension %d, axes %u, seed %llu: %zu pairs found, %zu expected, %zu differ\n", set.dimension,
               periodic, static_cast<unsigned long long>(kSeed), found.size(), expected.size(), odd);
  return false;
}

bool images_hold_all_pairs() {
  packing::Random random(kSeed);
  bool good = true;
  for (const int dimension : {2, 3}) {
    for (unsigned periodic = 0; periodic < 1u << dimension; periodic++)
      for (int repeat = 0; repeat < 20; repeat++)
        good = finds_all(random_set(random, dimension, periodic), periodic) && good;
  }
  return good;
}

// Across a face of the box rounding of its edge is excused, a true distance is not.
bool touching_across_faces() {
  particles::ParticleSet set;
  set.has_box = true;
  set.box_max[0] = 1e6;
  set.periodic[0] = 1;
  set.centers = {0.5, 0, 0, 1e6 - 1.5 + 1e-10, 0, 0, 1e6 - 1.5 + 1e-6, 0, 0};
  set.radii = {1, 1, 1};
  return bench::touch_within(set, {0, 1}, bench::kDoubleRounding) &&
         !bench::touch_within(set, {0, 2}, bench::kDoubleRounding);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<images_hold_all_pairs>),
      cmocka_unit_test(passes<touching_across_faces>),
  };
  return cmocka_run_group_tests_name("images", tests, nullptr, nullptr);
}
