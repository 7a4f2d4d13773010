/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_copy_pairs: the pairs into arrays of the caller's, which are left alone if they are too small. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

enum { PAIRS = CHAIN_COUNT - 1, UNTOUCHED = -77 };

static int32_t first[PAIRS + 1], second[PAIRS + 1];

static void reset(void) {
  int k;
  for (k = 0; k <= PAIRS; ++k) first[k] = second[k] = UNTOUCHED;
}

static void assert_copied(int copied) {
  int k;
  for (k = 0; k <= PAIRS; ++k) {
    assert_int_equal(k < copied ? k + 1 : UNTOUCHED, first[k]);
    assert_int_equal(k < copied ? k + 2 : UNTOUCHED, second[k]);
  }
}

static hg_grid *make_ordered_chain(void) {
  hg_grid_def def = hg_default_grid_def();
  def.pair_order = HG_ORDER_ID;
  def.index_base = 1;
  return make_chain(&def);
}

TEST(room_enough) {
  hg_grid *grid = make_ordered_chain();
  size_t capacity, count;
  for (capacity = PAIRS; capacity <= PAIRS + 1; ++capacity) {
    reset();
    count = 0;
    assert_ok(hg_copy_pairs(grid, capacity, first, second, &count));
    assert_int_equal(PAIRS, count);
    assert_copied(PAIRS);
  }
  hg_destroy(grid);
}

TEST(too_small) {
  hg_grid *grid = make_ordered_chain();
  size_t capacity, count;
  for (capacity = 0; capacity < PAIRS; ++capacity) {
    reset();
    count = 0;
    assert_status(HG_ERR_CAPACITY, hg_copy_pairs(grid, capacity, first, second, &count));
    assert_error_names("8");
    assert_int_equal(PAIRS, count);
    assert_copied(0);
  }
  count = 0;
  assert_status(HG_ERR_CAPACITY, hg_copy_pairs(grid, 0, NULL, NULL, &count));
  assert_int_equal(PAIRS, count);
  hg_destroy(grid);
}

TEST(in_the_order_of_query_pairs) {
  const double centers[12] = {5, 0, 0, 1, 0, 0, 0, 0, 0, 4, 0, 0}, radii[4] = {0.6, 0.6, 0.6, 0.6};
  const hg_pair *pairs;
  int32_t a[2], b[2];
  hg_grid *grid = make_grid(NULL, 4, centers, radii);
  size_t count, copied, k;
  assert_ok(hg_copy_pairs(grid, 2, a, b, &copied));
  assert_ok(hg_query_pairs(grid, &pairs, &count));
  assert_int_equal(2, count);
  assert_int_equal(2, copied);
  for (k = 0; k < 2; ++k) assert_true(pairs[k].a == a[k] && pairs[k].b == b[k]);
  hg_destroy(grid);
}

TEST(no_pairs) {
  hg_grid *grid = make_empty(NULL);
  size_t count = 5;
  assert_ok(hg_copy_pairs(grid, 0, NULL, NULL, &count));
  assert_int_equal(0, count);
  count = 5;
  assert_ok(hg_copy_pairs(grid, 9, NULL, NULL, &count));
  assert_int_equal(0, count);
  hg_destroy(grid);
}

TEST(null_is_refused) {
  hg_grid *grid = make_ordered_chain();
  size_t count;
  reset();
  assert_status(HG_ERR_NULL, hg_copy_pairs(NULL, PAIRS, first, second, &count));
  assert_status(HG_ERR_NULL, hg_copy_pairs(grid, PAIRS, first, second, NULL));
  assert_status(HG_ERR_NULL, hg_copy_pairs(grid, PAIRS, NULL, second, &count));
  assert_error_names("a is NULL");
  assert_status(HG_ERR_NULL, hg_copy_pairs(grid, PAIRS, first, NULL, &count));
  assert_error_names("b is NULL");
  assert_copied(0);
  hg_destroy(grid);
}

static hg_status copy(hg_grid *grid) {
  size_t count;
  return hg_copy_pairs(grid, PAIRS, first, second, &count);
}

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(copy) > 0); }
TEST(refused_inside_a_visitor) { assert_refused_in_visitor(copy); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(room_enough),
                                     cmocka_unit_test(too_small),
                                     cmocka_unit_test(in_the_order_of_query_pairs),
                                     cmocka_unit_test(no_pairs),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(no_memory),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
