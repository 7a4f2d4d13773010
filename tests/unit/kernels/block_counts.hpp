// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers of particles for kernels that go through them in blocks: Scene(seed, count).check() for all numbers around
// one block, and for more.
#pragma once

#include "tests/unit/checks.hpp"

namespace hgtest {

template <class Scene>
void around_a_block(void **) {
  assert_true(sweep(140, [](uint64_t seed) { Scene(seed, seed).check(); }));
}

template <class Scene, uint64_t Rounds>
void any_number(void **) {
  assert_true(sweep(Rounds, [](uint64_t seed) { Scene(seed, Rng(seed).below(1500)).check(); }));
}

template <class Scene, uint64_t Rounds>
int check_counts(const char *name) {
  const CMUnitTest tests[] = {cmocka_unit_test((around_a_block<Scene>)), cmocka_unit_test((any_number<Scene, Rounds>))};
  return cmocka_run_group_tests_name(name, tests, nullptr, nullptr);
}

}  // namespace hgtest
