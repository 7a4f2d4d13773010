// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Stored candidates in a cell that changes, against the oracle: kept, they have all pairs, whatever particles have
// moved; else they are as they were. Kept where the deformation leaves much of the skin, not where it leaves nothing.
#include "src/exact/lattice.hpp"
#include "tests/unit/cells.hpp"
#include "tests/unit/same_pairs.hpp"
#include "tests/unit/search/stored.hpp"

#include <cmath>

namespace {

using namespace hgtest;
using hg::Domain;

CrowdShape periodic_shape(Rng &rng) {
  CrowdShape shape = skinned_shape(rng, 1 + rng.below(150));
  shape.periodic = true;
  shape.filling = rng.chance(0.6) ? Filling::kEven : Filling::kCorner;
  // Of small particles skins may be so long that large deformations leave something.
  if (shape.filling == Filling::kCorner && rng.chance(0.5)) shape.skin = 30;
  for (int k = 0; k < (shape.dimension == 3 ? 3 : 1); k++) shape.tilt[k] = rng.chance(0.5) ? 0 : rng.uniform(-1.5, 1.5);
  return shape;
}

class Run {
 public:
  explicit Run(uint64_t seed)
      : rng_(seed),
        shape_(periodic_shape(rng_)),
        stored_(seed, shape_),
        crowd_(stored_.crowd),
        collected_(crowd_.index.domain),
        cell_(collected_),
        start_(crowd_.particles) {}

  struct Counts {
    int kept = 0, refused = 0;
  };
  Counts check() {
    require(!stored_.candidates.keep_in(cell_), "no candidates are kept");
    require(stored_.collect(), "nothing was kept");
    Counts counts;
    for (int step = 0; step < 4; step++) {
      const Domain next = changed(std::pow(10, -rng_.uniform(1, 5)));
      const double left = skin_left(next);
      const bool kept = stored_.candidates.keep_in(next);
      require(kept || left * crowd_.index.map.scale < 100, "%g of a skin of %g are left, and not used", left,
              shape_.skin);
      require(!kept || left > 0, "candidates without a skin are kept");
      if (kept) take(next);
      (kept ? counts.kept : counts.refused)++;
      move(std::max(0.0, 0.5 * (skin_left(cell_) - 0x1p-18 * shape_.skin) - 20 / crowd_.index.map.scale));
      require(stored_.candidates.update(crowd_.store, false), "motion within what is left of the skin is refused");
      check_pairs();
    }
    check_another();
    return counts;
  }

 private:
  // A cell that is other by such a part of its edges, at another place.
  Domain changed(double part) {
    Domain next = collected_;
    for (int axis = 0; axis < next.dimension; axis++) {
      const double low = Crowd::kEdge * (rng_.chance(0.5) ? 0 : rng_.uniform(-0.9, 0.9));
      set_box(next, axis, low, low + Crowd::kEdge * (1 + part * rng_.uniform(-1, 1)));
    }
    tilt_some(rng_, next, [&](double length) { return length * part * rng_.uniform(-1, 1); });
    for (int k = 0; k < 3; k++)
      next.tilt[k] = next.tilt[k] == collected_.tilt[k] ? next.tilt[k] : collected_.tilt[k] + next.tilt[k];
    return next;
  }

  // docs/theory/exactness.md, section 13: less by the longest change of a shift through which particles that have used
  // up the skin may come within reach; nothing of cells whose lengths change by more than a 16th.
  double skin_left(const Domain &cell) const {
    double most = 0;
    constexpr int kMost = 14, kNumbers = 2 * kMost + 1;
    for (int n = 0; n < kNumbers * kNumbers * kNumbers; n++) {
      const hg::Shift shift{{n % kNumbers - kMost, n / kNumbers % kNumbers - kMost, n / (kNumbers * kNumbers) - kMost}};
      double square = 0;
      bool in_reach = true;
      for (int axis = 0; axis < cell.dimension; axis++) {
        const double change = cell.shifted(axis, shift) - collected_.shifted(axis, shift);
        const double reach = crowd_.index.largest_reach() + 3 * shape_.skin;
        square += change * change;
        in_reach = in_reach && std::fabs(cell.shifted(axis, shift)) <= collected_.length[axis] + reach;
        if (std::fabs(cell.length[axis] - collected_.length[axis]) > 0x1p-4 * collected_.length[axis]) return 0;
      }
      if (in_reach && (cell.dimension == 3 || shift.n[2] == 0)) most = std::max(most, square);
    }
    return shape_.skin - std::sqrt(most);
  }

  void take(const Domain &cell) {
    cell_ = cell;
    crowd_.index.set_cell(cell);
    crowd_.overlap.set_domain(cell);
    crowd_.store.set_cell(cell, hg::ShortCell(cell, crowd_.overlap.interaction()));
  }

  // Each particle to within so much from its start, and by whole edges of the cell as it is now.
  void move(double most) {
    const auto dimension = static_cast<size_t>(shape_.dimension);
    for (size_t i = 0; i < start_.count(); i++) {
      const hg::Shift edges = any_shift(rng_, cell_, 3);
      const bool as_far_as_allowed = rng_.chance(0.5);
      for (size_t axis = 0; axis < dimension; axis++) {
        const double along = as_far_as_allowed ? (rng_.chance(0.5) ? 1 : -1) : rng_.uniform(-1, 1);
        crowd_.particles.centers[i * dimension + axis] = start_.centers[i * dimension + axis] +
                                                         most * along / std::sqrt(shape_.dimension + 1e-6) +
                                                         cell_.shifted(static_cast<int>(axis), edges);
      }
    }
    crowd_.move();
  }

  void check_pairs() {
    const Pairs expected = all_pairs(rule_of(cell_, crowd_.overlap.interaction()), crowd_.particles, exact_interact);
    const Pairs found = stored_.filtered();
    require_pairs("filtered", sorted(found.data(), found.size()), expected);
    require_pairs("one by one", stored_.decided(), found);
  }

  // Cells that are others altogether.
  void check_another() {
    const auto kept = [&](const Domain &cell) { return stored_.candidates.keep_in(cell); };
    Domain flipped = collected_, longer = cell_, moved = cell_;
    flipped.tilt[0] += flipped.length[0];
    set_box(longer, 1, 0, 2 * Crowd::kEdge);
    set_box(moved, 0, 1.5 * Crowd::kEdge, 1.5 * Crowd::kEdge + cell_.length[0]);
    require(!kept(flipped) && !kept(longer) && !kept(moved), "candidates of another cell are kept");
    require(stored_.candidates.kept(), "dropped");
    check_pairs();
  }

  Rng rng_;
  CrowdShape shape_;
  Stored stored_;
  Crowd &crowd_;
  Domain collected_, cell_;  // when candidates were collected, and now
  Particles start_;
};

void changing_cells(void **) {
  int kept = 0, refused = 0;
  assert_true(sweep(400, [&](uint64_t seed) {
    const Run::Counts counts = Run(seed).check();
    kept += counts.kept;
    refused += counts.refused;
  }));
  assert_true(kept > 500 && refused > 500);
}

// Two balls meet through a face that has come nearer, each of them having moved by what the whole skin would allow.
void check_shrinking(uint64_t) {
  hg::Memory memory(hg::system_allocator());
  Domain domain = open_space(3);
  for (int axis = 0; axis < 3; axis++) set_box(domain, axis, 0, 100);
  const double skin = 4, a[3] = {1, 50, 50}, b[3] = {94.99, 50, 50};
  Particles particles;
  particles.add(a, 1);
  particles.add(b, 1);
  Crowd crowd(memory, domain, {}, skin, particles);
  hg::PairPool pool(memory, 1);
  hg::StoredCandidates candidates(memory, 1);
  hg::SearchCounts counts;
  require(candidates.collect(crowd.index, crowd.tasks, crowd.store, {}, pool, counts), "nothing was kept");
  require(candidates.count() == 0, "balls beyond the skin are candidates");
  set_box(domain, 0, 0, 99);
  require(candidates.keep_in(domain), "a hundredth less is another cell");
  crowd.index.set_cell(domain);
  const auto update = [&](double motion) {
    crowd.particles.centers[0] = a[0] - motion;
    crowd.particles.centers[3] = b[0] + motion;
    crowd.move();
    return candidates.update(crowd.store, false);
  };
  require(update(0.3), "motion within what is left of the skin is refused");
  require(!update(0.5 * skin - 0.01), "a pair may be missed");
}

void shrinking_cell(void **) { assert_true(holds(0, check_shrinking)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(changing_cells), cmocka_unit_test(shrinking_cell)};
  return cmocka_run_group_tests_name("changing_cell", tests, nullptr, nullptr);
}
