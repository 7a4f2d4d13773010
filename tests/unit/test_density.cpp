// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Sampled densities: against even fillings, a film, crowds of known volume, and at the ends of doubles.
#include "src/levels/density.hpp"
#include "tests/unit/checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace hgtest;
using hg::Density;

// `count` centres drawn by place(rng, x), in a box without periods.
template <class Place>
struct Scene {
  Scene(uint64_t seed, int dimension, size_t count, Place place)
      : memory(hg::system_allocator()), store(memory, domain_of(dimension), {}, 0, HUGE_VAL) {
    Rng rng(seed);
    std::vector<double> centers(count * static_cast<size_t>(dimension)), radii(count, 1e-6);
    for (size_t i = 0; i < count; i++) place(rng, &centers[i * static_cast<size_t>(dimension)]);
    store.insert(count, centers.data(), radii.data());
    domain = domain_of(dimension);
    frame = hg::FixedPoint::over(hg::bounds_of(store, domain, 1), domain, 0);
    filling = Filling::sample(store, domain, frame);
  }

  static hg::Domain domain_of(int dimension) {
    hg::Domain domain;
    domain.dimension = dimension;
    return domain;
  }

  // In the caller's unit of volume, near meaning `length`.
  double density(double length) const {
    return filling.density(length * frame.scale) * std::pow(frame.scale, domain.dimension);
  }

  hg::Memory memory;
  hg::ParticleStore store;
  hg::Domain domain;
  hg::FixedPoint frame;
  Filling filling;
};

void check_even(uint64_t seed) {
  const int d = seed % 2 == 0 ? 3 : 2;
  const Scene scene(seed, d, 50000, [d](Rng &rng, double *x) {
    for (int k = 0; k < d; k++) x[k] = rng.uniform();
  });
  const Filling even = Filling::even(scene.frame.extent, d);
  for (double length : {1e-5, 1e-3, 0.02, 0.1}) {
    const double found = scene.density(length);
    require(std::fabs(found - 1) < 0.25, "density %g at %g", found, length);
    const double limit = even.density(length * scene.frame.scale) * std::pow(scene.frame.scale, d);
    require(std::fabs(limit - 1) < 1e-3, "even filling: density %g at %g", limit, length);
  }
}

// A film 1 x 1 x 0.01: twice as long a cell meets four times as many, once it is thicker than the film.
void check_film(uint64_t seed) {
  const Scene scene(seed, 3, 50000, [](Rng &rng, double *x) {
    x[0] = rng.uniform();
    x[1] = rng.uniform();
    x[2] = 0.01 * rng.uniform();
  });
  require(std::fabs(scene.density(0.2) * 0.2 - 1) < 0.3, "density %g of cells far thicker than the film",
          scene.density(0.2));
}

// 99 % in 1 % of the volume: the mean over particles of the density is 0.99 * 99 + 0.01 * about 1.
void check_crowded(uint64_t seed) {
  const double edge = std::cbrt(0.01);
  const Scene scene(seed, 3, 50000, [edge](Rng &rng, double *x) {
    const double scale = rng.chance(0.99) ? edge : 1;
    for (int k = 0; k < 3; k++) x[k] = scale * rng.uniform();
  });
  require(std::fabs(scene.density(0.01) / 98 - 1) < 0.25, "density %g", scene.density(0.01));
  require(scene.density(1) < 2, "density %g over the whole", scene.density(1));
}

// The same of the same particles, whatever lies between; one particle and coincident ones are no trouble.
void check_edges(uint64_t) {
  const auto origin = [](Rng &, double *x) { x[0] = x[1] = x[2] = 5; };
  for (size_t count : {1, 2, 3, 1023, 1024, 1025, 5000}) {
    const Scene scene(1, 3, count, origin);
    for (double length : {0.0, 1.0, 1e9, HUGE_VAL}) {
      const double density = scene.filling.density(length);
      require(density > 0 && density <= 1 && std::isfinite(density), "%zu in a point: density %g", count, density);
    }
    // All in one cell, of the smallest edge that is looked at too.
    require(scene.filling.density(1024) == 0x1p-30 || count < 16, "%zu in a point: %g", count,
            scene.filling.density(1024));
  }
  const auto wild = [](Rng &rng, double *x) {
    for (int k = 0; k < 3; k++) x[k] = std::ldexp(rng.uniform() - 0.5, rng.integer(-1074, 1022));
  };
  const Scene one(3, 3, 3000, wild), again(3, 3, 3000, wild);
  for (int octave = 0; octave <= 30; octave++) {
    const double length = std::ldexp(1.3, octave), density = one.filling.density(length);
    require(density > 0 && density <= 1, "density %g", density);
    require(density == again.filling.density(length), "not the same twice");
  }
}

void even_filling(void **) { assert_true(sweep(8, check_even)); }
void film(void **) { assert_true(sweep(4, check_film)); }
void crowded(void **) { assert_true(sweep(4, check_crowded)); }
void edges(void **) { assert_true(holds(0, check_edges)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(even_filling),
      cmocka_unit_test(film),
      cmocka_unit_test(crowded),
      cmocka_unit_test(edges),
  };
  return cmocka_run_group_tests_name("filling", tests, nullptr, nullptr);
}
