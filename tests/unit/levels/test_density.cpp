// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Sampled densities: against even density, a film, crowds of known volume, and at the ends of doubles.
#include "src/levels/density.hpp"
#include "src/particles/bounds.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/stores.hpp"

#include <cmath>
#include <vector>

namespace {

using namespace hgtest;
using hg::Density;

// `count` centres drawn by place(rng, x), in a box without periods.
template <class Place>
struct Scene {
  Scene(uint64_t seed, int dimension, size_t count, Place place)
      : memory(hg::system_allocator()), domain(open_space(dimension)), store(make_store(memory, domain)) {
    Rng rng(seed);
    std::vector<double> centers(count * static_cast<size_t>(dimension)), radii(count, 1e-6);
    for (size_t i = 0; i < count; i++) place(rng, &centers[i * static_cast<size_t>(dimension)]);
    store.insert(count, centers.data(), radii.data());
    map = hg::FixedPoint::over(hg::bounds_of(store, domain, 1), domain, 0);
    density = Density::sample(store, map, dimension);
  }

  // In the caller's unit of volume, near meaning `length`.
  double at(double length) const { return density.at(length * map.scale) * std::pow(map.scale, domain.dimension); }

  hg::Memory memory;
  hg::Domain domain;
  hg::ParticleStore store;
  hg::FixedPoint map;
  Density density;
};

void check_even(uint64_t seed) {
  const int d = seed % 2 == 0 ? 3 : 2;
  const Scene scene(seed, d, 50000, [d](Rng &rng, double *x) {
    for (int axis = 0; axis < d; axis++) x[axis] = rng.uniform();
  });
  const Density even = Density::even(scene.map.extent, d);
  for (double length : {1e-5, 1e-3, 0.02, 0.1}) {
    const double found = scene.at(length);
    require(std::fabs(found - 1) < 0.25, "density %g at %g", found, length);
    const double limit = even.at(length * scene.map.scale) * std::pow(scene.map.scale, d);
    require(std::fabs(limit - 1) < 1e-3, "even density %g at %g", limit, length);
  }
}

// A film 1 x 1 x 0.01: twice as long a cell meets four times as many, once it is thicker than the film.
void check_film(uint64_t seed) {
  const Scene scene(seed, 3, 50000, [](Rng &rng, double *x) {
    x[0] = rng.uniform();
    x[1] = rng.uniform();
    x[2] = 0.01 * rng.uniform();
  });
  require(std::fabs(scene.at(0.2) * 0.2 - 1) < 0.3, "density %g of cells far thicker than the film", scene.at(0.2));
}

// 99 % in 1 % of the volume: the mean over particles of the density is 0.99 * 99 + 0.01 * about 1.
void check_crowded(uint64_t seed) {
  const double edge = std::cbrt(0.01);
  const Scene scene(seed, 3, 50000, [edge](Rng &rng, double *x) {
    const double scale = rng.chance(0.99) ? edge : 1;
    for (int axis = 0; axis < 3; axis++) x[axis] = scale * rng.uniform();
  });
  require(std::fabs(scene.at(0.01) / 98 - 1) < 0.25, "density %g", scene.at(0.01));
  require(scene.at(1) < 2, "density %g over the whole", scene.at(1));
}

// The same of the same particles, whatever lies between; one particle and coincident ones are no trouble.
void check_edges(uint64_t) {
  const auto origin = [](Rng &, double *x) { x[0] = x[1] = x[2] = 5; };
  for (size_t count : {1, 2, 3, 1023, 1024, 1025, 5000}) {
    const Scene scene(1, 3, count, origin);
    for (double length : {0.0, 1.0, 1e9, HUGE_VAL}) {
      const double density = scene.density.at(length);
      require(density > 0 && density <= 1 && std::isfinite(density), "%zu in a point: density %g", count, density);
    }
    // All in one cell, of the smallest edge that is looked at too.
    require(scene.density.at(1024) == 0x1p-30 || count < 16, "%zu in a point: %g", count, scene.density.at(1024));
  }
  const auto wild = [](Rng &rng, double *x) {
    for (int axis = 0; axis < 3; axis++) x[axis] = std::ldexp(rng.uniform() - 0.5, rng.integer(-1074, 1022));
  };
  const Scene one(3, 3, 3000, wild), again(3, 3, 3000, wild);
  for (int octave = 0; octave <= 30; octave++) {
    const double length = std::ldexp(1.3, octave), density = one.density.at(length);
    require(density > 0 && density <= 1, "density %g", density);
    require(density == again.density.at(length), "not the same twice");
  }
}

void even_density(void **) { assert_true(sweep(8, check_even)); }
void film(void **) { assert_true(sweep(4, check_film)); }
void crowded(void **) { assert_true(sweep(4, check_crowded)); }
void edges(void **) { assert_true(holds(0, check_edges)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(even_density),
      cmocka_unit_test(film),
      cmocka_unit_test(crowded),
      cmocka_unit_test(edges),
  };
  return cmocka_run_group_tests_name("density", tests, nullptr, nullptr);
}
