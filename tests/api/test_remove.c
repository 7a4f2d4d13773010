/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_remove: unknown, removed and repeated ids; ids are not given out again. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

TEST(neighbours_of_the_gap_remain) {
  const int32_t gone[2] = {4, 0};
  const hg_pair expected[5] = {{1, 2}, {2, 3}, {5, 6}, {6, 7}, {7, 8}};
  hg_grid *grid = make_chain(NULL);
  assert_ok(hg_remove(grid, 2, gone));
  assert_pairs(grid, expected, 5);
  hg_destroy(grid);
}

TEST(ids_are_not_reused) {
  const int32_t last = CHAIN_COUNT - 1;
  const double center[3] = {CHAIN_COUNT - 1, 0, 0}, radius = 0.6;
  const hg_pair *pairs;
  hg_grid *grid = make_chain(NULL);
  size_t count;
  assert_ok(hg_remove(grid, 1, &last));
  assert_ok(hg_insert(grid, 1, center, &radius));
  assert_ok(hg_query_pairs(grid, &pairs, &count));
  assert_int_equal(CHAIN_COUNT - 1, count);
  while (count > 0) assert_int_not_equal(last, pairs[--count].b);
  assert_status(HG_ERR_NOT_FOUND, hg_remove(grid, 1, &last));
  assert_error_names("8");
  hg_destroy(grid);
}

TEST(removing_all_leaves_an_empty_grid) {
  const int32_t all[CHAIN_COUNT] = {8, 7, 6, 5, 4, 3, 2, 1, 0};
  const double centers[6] = {0, 0, 0, 1, 0, 0}, radii[2] = {0.6, 0.6};
  const hg_pair expected = {CHAIN_COUNT, CHAIN_COUNT + 1};
  hg_grid *grid = make_chain(NULL);
  assert_ok(hg_remove(grid, CHAIN_COUNT, all));
  assert_pairs(grid, NULL, 0);
  assert_ok(hg_insert(grid, 2, centers, radii));
  assert_pairs(grid, &expected, 1);
  hg_destroy(grid);
}

static void refuse(hg_grid *grid, int32_t first, int32_t second, int32_t third, const char *text) {
  int32_t ids[3];
  ids[0] = first;
  ids[1] = second;
  ids[2] = third;
  assert_status(HG_ERR_NOT_FOUND, hg_remove(grid, 3, ids));
  assert_error_names(text);
  assert_chain(grid, 0);
}

TEST(unknown_ids_change_nothing) {
  hg_grid *grid = make_chain(NULL);
  refuse(grid, 1, 2, CHAIN_COUNT, "9");
  refuse(grid, -1, 2, 3, "-1");
  refuse(grid, 3, INT32_MAX, 4, "2147483647");
  refuse(grid, 3, INT32_MIN, 4, "-2147483648");
  refuse(grid, 5, 6, 5, "5");
  hg_destroy(grid);
}

TEST(index_base_shifts_the_ids) {
  const int32_t zero = 0, nine = CHAIN_COUNT;
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.index_base = 1;
  grid = make_chain(&def);
  assert_status(HG_ERR_NOT_FOUND, hg_remove(grid, 1, &zero));
  assert_ok(hg_remove(grid, 1, &nine));
  assert_int_equal(CHAIN_COUNT - 2, pairs_in(grid));
  hg_destroy(grid);
}

TEST(null_and_zero) {
  const int32_t id = 0;
  hg_grid *grid = make_chain(NULL);
  assert_status(HG_ERR_NULL, hg_remove(NULL, 1, &id));
  assert_status(HG_ERR_NULL, hg_remove(grid, 1, NULL));
  assert_ok(hg_remove(grid, 0, &id));
  assert_ok(hg_remove(grid, 0, NULL));
  assert_chain(grid, 0);
  hg_destroy(grid);
}

static hg_status remove_again(hg_grid *grid) {
  const int32_t id = 0;
  return hg_remove(grid, 1, &id);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(remove_again); }

static void prepare(hg_grid **grid) {
  *grid = make_chain(NULL);
  assert_chain(*grid, 0);
}
static hg_status remove_last_two(hg_grid **grid) {
  const int32_t ids[2] = {8, 7};
  return hg_remove(*grid, 2, ids);
}
static void still_a_chain(hg_grid *grid) { assert_chain(grid, 0); }
static void short_chain(hg_grid *grid) {
  const hg_pair expected[6] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}};
  assert_pairs(grid, expected, 6);
}

/* Whether the call needs memory is the library's choice. */
TEST(no_memory) {
  const alloc_scenario scenario = {prepare, remove_last_two, still_a_chain, short_chain};
  refuse_each_allocation(&scenario);
}

static void prepare_removed(hg_grid **grid) {
  *grid = make_chain(NULL);
  assert_ok(remove_last_two(grid));
}
static hg_status query(hg_grid **grid) { return search(*grid); }

TEST(no_memory_in_the_next_search) {
  const alloc_scenario scenario = {prepare_removed, query, NULL, short_chain};
  assert_true(refuse_each_allocation(&scenario) > 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(neighbours_of_the_gap_remain),
                                     cmocka_unit_test(ids_are_not_reused),
                                     cmocka_unit_test(removing_all_leaves_an_empty_grid),
                                     cmocka_unit_test(unknown_ids_change_nothing),
                                     cmocka_unit_test(index_base_shifts_the_ids),
                                     cmocka_unit_test(null_and_zero),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(no_memory_in_the_next_search),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
