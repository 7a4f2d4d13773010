// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The list of pairs and the visit of it: the same bytes with any number of threads, batches that add up to the list.
#include "src/pairs/pair_list.hpp"
#include "src/pairs/pair_visit.hpp"
#include "src/search/pair_search.hpp"
#include "tests/unit/crowd.hpp"
#include "tests/unit/same_pairs.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

namespace {

using namespace hgtest;
using hg::PairList;

hg::PairSearch search_of(const Crowd &crowd) { return {crowd.index, crowd.tasks, crowd.store, crowd.overlap}; }

// A list with a pool of its own, of the pairs of a crowd.
struct List {
  List(hg::Memory &memory, int threads) : pool(memory, threads), pairs(memory) {}
  hg::SearchCounts search(const Crowd &crowd) { return pairs.gather(search_of(crowd), pool, crowd.store.slots()); }
  const hg_pair *data() const { return pairs.data(); }
  size_t count() const { return pairs.count(); }

  hg::PairPool pool;
  PairList pairs;
};

bool same(const hg_pair *p, const hg_pair *q, size_t count) {
  return count == 0 || std::memcmp(p, q, count * sizeof *p) == 0;
}

void check_all_pairs(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  const Crowd crowd(seed, memory, any_shape(rng, rng.below(250)));
  List list(memory, 1);
  list.search(crowd);
  require_pairs("a crowd", sorted(list.data(), list.count()), crowd.pairs());
}

void check_threads(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  Crowd crowd(seed, memory, any_shape(rng, 25000));
  List alone(memory, 1);
  const hg::SearchCounts counts = alone.search(crowd);
  require(alone.count() > 1000, "only %zu pairs", alone.count());
  for (int threads : {2, 5}) {
    crowd.build(threads);
    List together(memory, threads);
    for (int again = 0; again < 2; again++) {
      const hg::SearchCounts c = together.search(crowd);
      require(together.count() == alone.count() && same(together.data(), alone.data(), alone.count()),
              "%d threads: %zu pairs instead of %zu, or another order", threads, together.count(), alone.count());
      require(c.candidates == counts.candidates && c.undecided == counts.undecided && c.exact == counts.exact,
              "%d threads: the counts differ", threads);
    }
  }
}

struct Visited {
  std::vector<hg_pair> pairs;
  size_t batches = 0, largest = 0, stop_after = SIZE_MAX;
};

int32_t note(void *context, const hg_pair *pairs, size_t count) {
  auto *visited = static_cast<Visited *>(context);
  visited->pairs.insert(visited->pairs.end(), pairs, pairs + count);
  visited->largest = std::max(visited->largest, count);
  return ++visited->batches >= visited->stop_after ? 1 : 0;
}

void check_visit(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  const Crowd crowd(seed, memory, any_shape(rng, rng.below(12000)));
  List list(memory, 1);
  list.search(crowd);

  const hg::PairSearch source = search_of(crowd);
  Visited search, stored, stopped;
  const hg::VisitResult result = hg::visit_source(source, crowd.store, memory, note, &search);
  hg::visit_list(list.data(), list.count(), note, &stored);
  for (const Visited *v : {&search, &stored}) {
    require(v->pairs.size() == list.count() && same(v->pairs.data(), list.data(), list.count()),
            "%zu pairs visited instead of %zu, or another order", v->pairs.size(), list.count());
    require(v->largest <= hg::kVisitBatch, "a batch of %zu", v->largest);
  }
  require(result.pairs == list.count(), "%zu pairs counted", result.pairs);

  if (list.count() == 0) return;
  stopped.stop_after = 1;
  const hg::VisitResult some = hg::visit_source(source, crowd.store, memory, note, &stopped);
  require(stopped.batches == 1, "%zu batches after a stop", stopped.batches);
  require(some.pairs == stopped.pairs.size() && same(stopped.pairs.data(), list.data(), stopped.pairs.size()),
          "%zu pairs before the stop", some.pairs);
}

// Where ids have gaps, pairs come as slots and are named afterwards.
void check_ids(uint64_t) {
  hg::Memory memory(hg::system_allocator());
  hg::ParticleStore store = make_store(memory, open_space(3), {}, 1);
  const double x[12] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3}, r[4] = {1, 1, 1, 1};
  const int32_t second = 2;
  hg_pair pairs[2] = {{1, 2}, {2, 3}};
  store.insert(4, x, r);
  hg::to_ids(pairs, 2, store);
  require(pairs[0].a == 1 && pairs[1].b == 3, "ids without gaps are final");
  store.remove(1, &second);
  store.compact();
  hg_pair slots[2] = {{0, 1}, {1, 2}};
  hg::to_ids(slots, 2, store);
  require(slots[0].a == 1 && slots[0].b == 3 && slots[1].a == 3 && slots[1].b == 4, "(%d, %d), (%d, %d)", slots[0].a,
          slots[0].b, slots[1].a, slots[1].b);
}

void every_pair(void **) { assert_true(sweep(40, check_all_pairs)); }
void any_number_of_threads(void **) { assert_true(sweep(6, check_threads)); }
void visits(void **) { assert_true(sweep(20, check_visit)); }
void ids(void **) { assert_true(holds(0, check_ids)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_pair),
      cmocka_unit_test(any_number_of_threads),
      cmocka_unit_test(visits),
      cmocka_unit_test(ids),
  };
  return cmocka_run_group_tests_name("pair_list", tests, nullptr, nullptr);
}
