/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_visit_contacts: all pairs with vectors and reaches, in batches; stopping; calls back into the grid. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <string.h>

/* What came of a chain: how often (a, a + 1), and what was wrong. */
typedef struct tally {
  int seen[CHAIN_COUNT];
  int strange;
  int dimension;
  size_t total, largest;
  int batches;
} tally;

static int32_t count_contacts(void *context, const hg_contact_batch *batch) {
  tally *t = context;
  size_t k;
  ++t->batches;
  t->total += batch->count;
  if (batch->count > t->largest) t->largest = batch->count;
  if (batch->count == 0 || batch->count > HG_MAX_BATCH) ++t->strange;
  if ((batch->dz == NULL) != (t->dimension == 2)) ++t->strange;
  for (k = 0; k < batch->count; ++k) {
    const int32_t a = batch->a[k];
    if (a < 0 || a >= CHAIN_COUNT - 1 || batch->b[k] != a + 1 || batch->dx[k] != 1 || batch->dy[k] != 0 ||
        (batch->dz != NULL && batch->dz[k] != 0) || batch->reach[k] != 0.6 + 0.6 + 0.25) {
      ++t->strange;
    } else {
      ++t->seen[a];
    }
  }
  return 0;
}

TEST(every_contact_once) {
  int32_t order, dimension;
  for (order = HG_ORDER_GRID; order <= HG_ORDER_ID; ++order) {
    for (dimension = 2; dimension <= 3; ++dimension) {
      hg_grid_def def = hg_default_grid_def();
      hg_grid *grid;
      tally t;
      int i;
      def.pair_order = order;
      def.dimension = dimension;
      def.margin = 0.25;
      grid = make_chain(&def);
      memset(&t, 0, sizeof t);
      t.dimension = dimension;
      assert_ok(hg_visit_contacts(grid, count_contacts, &t));
      assert_int_equal(0, t.strange);
      assert_int_equal(CHAIN_COUNT - 1, t.total);
      for (i = 0; i < CHAIN_COUNT - 1; ++i) assert_int_equal(1, t.seen[i]);
      hg_destroy(grid);
    }
  }
}

static int32_t keep_reach(void *context, const hg_contact_batch *batch) {
  *(double *)context = batch->reach[0];
  return 0;
}

TEST(the_larger_range_reaches) {
  const double centers[6] = {0, 0, 0, 2.5, 0, 0}, radii[2] = {3, 0.25};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  double reach = 0;
  def.interaction = HG_MAX_RANGE;
  def.margin = 0.5;
  grid = make_grid(&def, 2, centers, radii);
  assert_ok(hg_visit_contacts(grid, keep_reach, &reach));
  assert_true(reach == 3.5);
  hg_destroy(grid);
}

TEST(nothing_to_visit) {
  hg_grid *grid = make_empty(NULL);
  tally t;
  memset(&t, 0, sizeof t);
  assert_ok(hg_visit_contacts(grid, count_contacts, &t));
  assert_int_equal(0, t.batches);
  hg_destroy(grid);
}

/* N coincident particles: more contacts than any batch holds; in a short cell each meets itself, too. */
enum { PILE = 700 };
static hg_grid *make_pile(const hg_grid_def *def) {
  static double centers[3 * PILE], radii[PILE];
  int i;
  for (i = 0; i < PILE; ++i) radii[i] = 1;
  return make_grid(def, PILE, centers, radii);
}

static int32_t add_counts(void *context, const hg_contact_batch *batch) {
  tally *t = context;
  ++t->batches;
  t->total += batch->count;
  if (batch->count > t->largest) t->largest = batch->count;
  return 0;
}

static int32_t stop_at_once(void *context, const hg_contact_batch *batch) {
  (void)batch;
  ++*(int *)context;
  return -5;
}

TEST(batches_are_limited_and_nonzero_stops) {
  int32_t order, images;
  for (order = HG_ORDER_GRID; order <= HG_ORDER_ID; ++order) {
    for (images = HG_NEAREST_IMAGE; images <= HG_ALL_IMAGES; ++images) {
      hg_grid_def def = images == HG_ALL_IMAGES ? periodic_axis(1, 1.5) : hg_default_grid_def();
      hg_grid *grid;
      tally t;
      int calls = 0;
      def.pair_order = order;
      def.images = images;
      def.thread_count = 2;
      grid = make_pile(&def);
      memset(&t, 0, sizeof t);
      assert_ok(hg_visit_contacts(grid, add_counts, &t));
      assert_int_equal(pairs_in(grid), t.total);
      assert_true(t.total >= PILE * (PILE - 1) / 2);
      assert_true(t.largest <= HG_MAX_BATCH);
      assert_ok(hg_visit_contacts(grid, stop_at_once, &calls));
      assert_int_equal(1, calls);
      hg_destroy(grid);
    }
  }
}

TEST(nothing_is_stored) {
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  tally t;
  long long before;
  def.thread_count = 1;
  failing_alloc_install();
  grid = make_pile(&def);
  assert_ok(hg_build(grid));
  memset(&t, 0, sizeof t);
  before = failing_alloc_books().live_bytes;
  assert_ok(hg_visit_contacts(grid, add_counts, &t));
  assert_int_equal(PILE * (PILE - 1) / 2, t.total);
  /* The list would take sizeof(hg_pair) * total, nearly 2 MB. */
  assert_true(failing_alloc_books().live_bytes - before < (long long)(sizeof(hg_pair) * t.total / 4));
  hg_destroy(grid);
  failing_alloc_remove();
}

TEST(candidates_of_a_skin_are_filtered) {
  double centers[6] = {0, 0, 0, 1, 0, 0};
  const double radii[2] = {0.6, 0.6};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  tally t;
  int step;
  def.skin = 0.2;
  grid = make_grid(&def, 2, centers, radii);
  for (step = 0; step < 3; ++step) {
    memset(&t, 0, sizeof t);
    assert_ok(hg_visit_contacts(grid, add_counts, &t));
    assert_int_equal(1, t.total);
    assert_int_equal(1, stats_of(grid).search_count);
    assert_int_equal(step, stats_of(grid).filter_count);
    centers[0] -= 0.03;
    assert_ok(hg_move(grid, 2, centers, NULL));
  }
  hg_destroy(grid);
}

TEST(null_is_refused) {
  hg_grid *grid = make_chain(NULL);
  tally t;
  assert_status(HG_ERR_NULL, hg_visit_contacts(NULL, count_contacts, &t));
  assert_status(HG_ERR_NULL, hg_visit_contacts(grid, NULL, &t));
  hg_destroy(grid);
}

static hg_status visit_all(hg_grid *grid) {
  tally t;
  memset(&t, 0, sizeof t);
  return hg_visit_contacts(grid, add_counts, &t);
}

TEST(refused_inside_a_visitor_of_pairs) { assert_refused_in_visitor(visit_all); }

/* Whatever is asked of the grid from inside is refused; another grid is free. */
typedef struct meddler {
  hg_grid *grid, *other;
  int visits;
} meddler;

static int32_t meddle(void *context, const hg_contact_batch *batch) {
  meddler *m = context;
  const double center[3] = {0, 0, 0}, radius = 1;
  const int32_t *ids;
  size_t count = batch->count;
  ++m->visits;
  assert_status(HG_ERR_STATE, hg_set(m->grid, 1, center, &radius));
  assert_status(HG_ERR_STATE, hg_query_order(m->grid, &ids, &count));
  assert_status(HG_ERR_STATE, search(m->grid));
  assert_status(HG_ERR_STATE, visit_all(m->grid));
  assert_chain(m->other, 0);
  return 0;
}

TEST(calls_from_inside_are_refused) {
  int32_t images;
  for (images = HG_NEAREST_IMAGE; images <= HG_ALL_IMAGES; ++images) {
    hg_grid_def def = periodic_axis(1, 1.1);
    hg_grid *grid;
    meddler m;
    def.periodic[1] = images == HG_ALL_IMAGES;
    def.images = images;
    m.grid = grid = make_chain(&def);
    m.other = make_chain(NULL);
    m.visits = 0;
    assert_ok(hg_visit_contacts(grid, meddle, &m));
    assert_true(m.visits > 0);
    assert_ok(hg_clear(grid));
    hg_destroy(grid);
    hg_destroy(m.other);
  }
}

static void short_cell(hg_grid **grid) {
  hg_grid_def def = periodic_axis(1, 1.1);
  def.images = HG_ALL_IMAGES;
  *grid = make_chain(&def);
}
static hg_status visit(hg_grid **grid) { return visit_all(*grid); }

TEST(no_memory) {
  const alloc_scenario all_images = {short_cell, visit, NULL, NULL};
  assert_true(refuse_each_allocation_on_chain(visit_all) > 0);
  assert_true(refuse_each_allocation(&all_images) > 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(every_contact_once),
                                     cmocka_unit_test(the_larger_range_reaches),
                                     cmocka_unit_test(nothing_to_visit),
                                     cmocka_unit_test(batches_are_limited_and_nonzero_stops),
                                     cmocka_unit_test(nothing_is_stored),
                                     cmocka_unit_test(candidates_of_a_skin_are_filtered),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(refused_inside_a_visitor_of_pairs),
                                     cmocka_unit_test(calls_from_inside_are_refused),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
