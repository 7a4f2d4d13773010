// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Lists that are kept for a fixed number of steps, and boxes before spheres.
#include "oracle/pairs.hpp"
#include "programs/accuracy/contacts.hpp"
#include "programs/accuracy/search/prefilter.hpp"
#include "programs/accuracy/search/rebuild_criterion.hpp"
#include "programs/accuracy/search/systems.hpp"
#include "programs/accuracy/search/verlet_list.hpp"
#include "programs/measure/search_timer.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

const packing::SizeLaw kEqual{packing::Law::kMono, 1, 3};

// The second sphere flies towards the first by 0.1 per step. Overlap begins in step 5, when a list with the margin 0.3
// from the start knows nothing of it; the search of step 8 finds it.
bool a_kept_list_goes_blind() {
  particles::ParticleSet two;
  two.centers = {0, 0, 0, 2.45, 0, 0};
  two.radii = {1, 1};
  accuracy::VerletList list(two, 0.3, 8);
  for (int step = 1; step <= 9; step++) {
    two.centers[3] -= 0.1;
    list.step(two);
    if (list.has_searched() != (step == 8) || list.pairs().size() != (step >= 8 ? 1u : 0u)) return false;
  }
  return std::fabs(accuracy::relative_overlap(two, {0, 1}) - 0.45) < 1e-12;
}

// Two particles close in by at most 2 * 5 * 0.01 in five steps: within the margin nothing can be missed.
bool only_too_long_intervals_miss() {
  const particles::ParticleSet start = accuracy::relaxed(kEqual, 1000);
  const accuracy::Missed safe = accuracy::missed_contacts(start, 0.01, 0.1, 5, 30);
  const accuracy::Missed bold = accuracy::missed_contacts(start, 0.01, 0.1, 30, 30);
  std::printf("missed of %zu: %zu, then %zu, the deepest %g\n", bold.contacts, safe.missed, bold.missed, bold.deepest);
  return safe.missed == 0 && safe.deepest == 0 && bold.missed > 0 && bold.deepest > 0 && bold.deepest < 0.6 &&
         safe.contacts == bold.contacts;
}

// Of candidates at random places those in the ball make up pi / 6 of those in the box around it.
bool boxes_first_change_no_pair() {
  const accuracy::Candidates candidates = accuracy::candidates_of(accuracy::relaxed(kEqual, 20000, 0));
  std::vector<hg_pair> plain, filtered;
  accuracy::filter_pairs(candidates.particles, candidates.pairs, plain);
  const size_t tested = accuracy::filter_boxes_first(candidates, filtered);
  const bool same = std::equal(plain.begin(), plain.end(), filtered.begin(), filtered.end(), oracle::pair_equal);
  const size_t pairs = accuracy::found_pairs(measure::def_of(candidates.particles), candidates.particles).size();
  const double share = static_cast<double>(filtered.size()) / static_cast<double>(tested);
  std::printf("spheres in boxes: %.4f\n", share);
  return same && plain.size() == pairs && std::fabs(share / (3.14159265358979 / 6) - 1) < 0.03;
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(passes<a_kept_list_goes_blind>),
                              cmocka_unit_test(passes<only_too_long_intervals_miss>),
                              cmocka_unit_test(passes<boxes_first_change_no_pair>)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
