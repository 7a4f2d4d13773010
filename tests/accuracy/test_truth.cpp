// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The judge of `hgrid accuracy`: its sweep against looking at every pair in whole numbers, what it says of an injected
// fault, and of the library.
#include "oracle/pairs.hpp"
#include "programs/accuracy/contacts.hpp"
#include "programs/accuracy/search/systems.hpp"
#include "programs/measure/search_timer.hpp"
#include "tests/oracle/whole_numbers.hpp"
#include "tests/support/frame.h"

#include <hgrid/hgrid.h>

#include <algorithm>
#include <cstdio>

namespace {

const std::vector<particles::ParticleSet> &systems() {
  static const std::vector<particles::ParticleSet> all = {
      accuracy::relaxed({packing::Law::kUniformVolume, 20, 3}, 600),
      accuracy::moved(accuracy::relaxed({packing::Law::kMono, 1, 3}, 500), 1e9), accuracy::touching_chain(600, 1e6),
      accuracy::turned_lattice(500)};
  return all;
}

oracle::Pairs true_pairs(const particles::ParticleSet &particles) {
  return oracle::swept_pairs(measure::def_of(particles), particles, oracle::exact_interact);
}

oracle::Pairs found_pairs(const particles::ParticleSet &particles, int32_t accuracy) {
  hg_grid_def def = measure::def_of(particles);
  def.accuracy = accuracy;
  return accuracy::found_pairs(def, particles);
}

bool same(const oracle::Pairs &a, const oracle::Pairs &b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), oracle::pair_equal);
}

bool the_sweep_finds_what_all_pairs_hold() {
  for (const particles::ParticleSet &particles : systems()) {
    const oracle::Pairs all = hgtest::whole_number_pairs(measure::def_of(particles), particles);
    if (all.empty() || !same(true_pairs(particles), all)) return false;
  }
  return true;
}

// A pair taken out and another put in are named, in whatever order the list is.
bool an_injected_fault_is_found() {
  const oracle::Pairs truth = true_pairs(systems()[0]);
  oracle::Pairs found(truth.rbegin(), truth.rend());
  const auto lost = found[found.size() / 2];
  found[found.size() / 2] = found.front();  // once more instead
  const oracle::Difference wrong = oracle::difference(truth, found);
  return same(wrong.missing, {lost}) && same(wrong.extra, {found.front()}) &&
         oracle::difference(truth, truth).count() == 0;
}

// HG_EXACT is never wrong, HG_FLOAT never misses; the lattice shows that the judge does see wrong pairs.
bool the_library_keeps_its_promise() {
  for (const particles::ParticleSet &particles : systems()) {
    const oracle::Pairs truth = true_pairs(particles);
    const oracle::Difference exact = oracle::difference(truth, found_pairs(particles, HG_EXACT));
    const oracle::Difference with_float = oracle::difference(truth, found_pairs(particles, HG_FLOAT));
    if (exact.count() != 0 || !with_float.missing.empty()) return false;
  }
  const particles::ParticleSet &lattice = systems().back();
  const oracle::Difference wrong = oracle::difference(true_pairs(lattice), found_pairs(lattice, HG_DOUBLE));
  std::printf("HG_DOUBLE on the lattice: %zu missing, %zu extra\n", wrong.missing.size(), wrong.extra.size());
  return !wrong.missing.empty() && !wrong.extra.empty();
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(passes<the_sweep_finds_what_all_pairs_hold>),
                              cmocka_unit_test(passes<an_injected_fault_is_found>),
                              cmocka_unit_test(passes<the_library_keeps_its_promise>)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
