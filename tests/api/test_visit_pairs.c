/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_visit_pairs: batches, stopping, and calls back into the grid. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <string.h>

/* Seen pairs of a chain: how often (a, a + 1) came. */
typedef struct tally {
  int seen[CHAIN_COUNT];
  int strange; /* pairs that are no chain pair, or empty batches */
  size_t total;
  int batches;
} tally;

static int32_t count_pairs(void *context, const hg_pair *pairs, size_t count) {
  tally *t = context;
  size_t k;
  ++t->batches;
  t->total += count;
  if (count == 0) ++t->strange;
  for (k = 0; k < count; ++k) {
    if (pairs[k].a < 0 || pairs[k].a >= CHAIN_COUNT - 1 || pairs[k].b != pairs[k].a + 1) {
      ++t->strange;
    } else {
      ++t->seen[pairs[k].a];
    }
  }
  return 0;
}

TEST(every_pair_once) {
  int32_t order;
  for (order = HG_ORDER_GRID; order <= HG_ORDER_ID; ++order) {
    hg_grid_def def = hg_default_grid_def();
    hg_grid *grid;
    tally t;
    int i;
    def.pair_order = order;
    grid = make_chain(&def);
    memset(&t, 0, sizeof t);
    assert_ok(hg_visit_pairs(grid, count_pairs, &t));
    assert_int_equal(0, t.strange);
    assert_int_equal(CHAIN_COUNT - 1, t.total);
    for (i = 0; i < CHAIN_COUNT - 1; ++i) assert_int_equal(1, t.seen[i]);
    hg_destroy(grid);
  }
}

TEST(nothing_to_visit) {
  hg_grid *grid = make_empty(NULL);
  tally t;
  memset(&t, 0, sizeof t);
  assert_ok(hg_visit_pairs(grid, count_pairs, &t));
  assert_int_equal(0, t.batches);
  hg_destroy(grid);
}

static int32_t stop_at_once(void *context, const hg_pair *pairs, size_t count) {
  (void)pairs;
  (void)count;
  ++*(int *)context;
  return -5;
}

/* N coincident particles: more pairs than any batch holds. */
enum { PILE = 700 };
static hg_grid *make_pile(const hg_grid_def *def) {
  static double centers[3 * PILE], radii[PILE];
  int i;
  for (i = 0; i < PILE; ++i) radii[i] = 1;
  return make_grid(def, PILE, centers, radii);
}

TEST(nonzero_stops) {
  int32_t order, threads;
  for (order = HG_ORDER_GRID; order <= HG_ORDER_ID; ++order) {
    for (threads = 1; threads <= 2; ++threads) {
      hg_grid_def def = hg_default_grid_def();
      hg_grid *grid;
      int calls = 0;
      def.pair_order = order;
      def.thread_count = threads;
      grid = make_pile(&def);
      assert_ok(hg_visit_pairs(grid, stop_at_once, &calls));
      assert_int_equal(1, calls);
      assert_int_equal(PILE * (PILE - 1) / 2, pairs_in(grid));
      hg_destroy(grid);
    }
  }
}

static int32_t add_counts(void *context, const hg_pair *pairs, size_t count) {
  (void)pairs;
  *(size_t *)context += count;
  return 0;
}

TEST(nothing_is_stored) {
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  size_t total = 0;
  long long before;
  def.thread_count = 1;
  failing_alloc_install();
  grid = make_pile(&def);
  assert_ok(hg_build(grid));
  before = failing_alloc_books().live_bytes;
  assert_ok(hg_visit_pairs(grid, add_counts, &total));
  assert_int_equal(PILE * (PILE - 1) / 2, total);
  /* The list would take sizeof(hg_pair) * total, nearly 2 MB. */
  assert_true(failing_alloc_books().live_bytes - before < (long long)(sizeof(hg_pair) * total / 4));
  hg_destroy(grid);
  failing_alloc_remove();
}

TEST(null_is_refused) {
  hg_grid *grid = make_chain(NULL);
  tally t;
  assert_status(HG_ERR_NULL, hg_visit_pairs(NULL, count_pairs, &t));
  assert_status(HG_ERR_NULL, hg_visit_pairs(grid, NULL, &t));
  hg_destroy(grid);
}

static hg_status visit_again(hg_grid *grid) {
  tally t;
  return hg_visit_pairs(grid, count_pairs, &t);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(visit_again); }

static int32_t visit_other(void *context, const hg_pair *pairs, size_t count) {
  (void)pairs;
  (void)count;
  assert_chain(context, 0);
  return 0;
}

TEST(another_grid_is_free) {
  hg_grid *grid = make_chain(NULL), *other = make_chain(NULL);
  assert_ok(hg_visit_pairs(grid, visit_other, other));
  hg_destroy(grid);
  hg_destroy(other);
}

/* The refusal ends with the visit. */
TEST(the_grid_is_free_after_a_stop) {
  const double center[3] = {100, 0, 0}, radius = 1;
  hg_grid *grid = make_chain(NULL);
  int calls = 0;
  assert_ok(hg_visit_pairs(grid, stop_at_once, &calls));
  assert_ok(hg_insert(grid, 1, center, &radius));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

static void prepare_id_order(hg_grid **grid) {
  hg_grid_def def = hg_default_grid_def();
  def.pair_order = HG_ORDER_ID;
  *grid = make_chain(&def);
}
static hg_status visit_all(hg_grid *grid) {
  size_t total = 0;
  const hg_status status = hg_visit_pairs(grid, add_counts, &total);
  if (status == HG_OK) assert_int_equal(CHAIN_COUNT - 1, total);
  return status;
}
static hg_status visit(hg_grid **grid) { return visit_all(*grid); }
static void still_a_chain(hg_grid *grid) { assert_chain(grid, 0); }

TEST(no_memory) {
  const alloc_scenario id_order = {prepare_id_order, visit, NULL, still_a_chain};
  assert_true(refuse_each_allocation_on_chain(visit_all) > 0);
  assert_true(refuse_each_allocation(&id_order) > 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(every_pair_once),
                                     cmocka_unit_test(nothing_to_visit),
                                     cmocka_unit_test(nonzero_stops),
                                     cmocka_unit_test(nothing_is_stored),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(another_grid_is_free),
                                     cmocka_unit_test(the_grid_is_free_after_a_stop),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
