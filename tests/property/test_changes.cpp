// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Random sequences of insert, move, remove and clear, with queries in between, against a plain list of the particles.
#include "tests/property/life.hpp"

#include <utility>

namespace {

using namespace hgtest;

void live(uint64_t seed, double skin) {
  Rng rng(seed);
  Scene scene = any_scene(rng, 120);
  scene.def.skin = skin;
  Life(rng.next(), std::move(scene), 0, 0).run(25);
}

void any_sequence(void **) {
  assert_true(sweep(150, [](uint64_t seed) { live(seed, 0); }));
}

// The skin saves searches while particles move little; the answers are the same.
void any_sequence_with_skin(void **) {
  assert_true(sweep(100, [](uint64_t seed) { live(500 + seed, seed % 2 == 0 ? 0.1 : 1e-5); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_sequence), cmocka_unit_test(any_sequence_with_skin)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
