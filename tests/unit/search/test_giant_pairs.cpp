// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search of giants against the oracle: among themselves, over dust, as images.
#include "src/search/giant_pairs.hpp"
#include "tests/unit/uneven_crowd.hpp"

namespace {

using namespace hgtest;

bool check_crowd(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  const hg::Domain domain = any_box(rng);
  const double smallest = std::pow(10, rng.uniform(-12, -5));
  // A margin is a part of all diameters.
  const hg::Interaction interaction{rng.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE, rng.chance(0.8) ? 0.0 : smallest};
  const Crowd crowd(memory, domain, interaction, 0, uneven_particles(rng, domain, 1 + rng.below(400), smallest),
                    std::pow(10, rng.uniform(1, 4)));
  check_tasks(crowd, rng.below(4));
  return crowd.index.chunked && crowd.index.chunks.has_giants();
}

void any_crowds(void **) {
  int with_giants = 0;
  assert_true(sweep(300, [&](uint64_t seed) { with_giants += check_crowd(seed) ? 1 : 0; }));
  assert_true(with_giants > 60);
}

// One giant over more dust than the output has room for at once.
void check_many(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  const hg::Domain domain = any_box(rng);
  const Particles particles = ball_in_dust(rng, domain.dimension, 4000, 12, 0.01, 1e-6);
  const Crowd crowd(memory, domain, {}, 0, particles, 1e6);
  require(crowd.index.chunked && crowd.index.chunks.has_giants(), "no giants");
  check_tasks(crowd, seed % 5);
}

void many_under_one(void **) { assert_true(sweep(10, check_many)); }

// So large that neither its places nor floats know numbers for it.
void check_beyond_float(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  const hg::Domain domain = open_space(rng.integer(2, 3));
  Particles particles = uneven_particles(rng, domain, 200, 1e-5);
  const double radius = std::pow(10, rng.uniform(30, 307));
  for (int i = 0; i < 3; i++) {
    double center[3];
    for (double &x : center) x = 50 + radius * rng.uniform(-1, 1) / 1.8;
    particles.add(center, radius);
  }
  const Crowd crowd(memory, domain, {}, 0, particles, 1e4);
  check_tasks(crowd, SIZE_MAX);
}

void beyond_float(void **) { assert_true(sweep(100, check_beyond_float)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_crowds), cmocka_unit_test(many_under_one),
                              cmocka_unit_test(beyond_float)};
  return cmocka_run_group_tests_name("giant_pairs", tests, nullptr, nullptr);
}
