/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_set_allocator: all memory of a grid comes from the allocator it was created with, and goes back. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <stdlib.h>

static void use_everything(hg_grid *grid) {
  const double center[3] = {0, 0, 0};
  const int32_t id = 3;
  const int64_t *offsets;
  const int32_t *ids;
  const hg_level *levels;
  const hg_level_cost *costs;
  size_t count;
  assert_chain(grid, 0);
  assert_ok(hg_query_neighbors(grid, HG_FULL, &offsets, &ids));
  assert_ok(hg_query_sphere(grid, center, 5, &ids, &count));
  assert_ok(hg_query_levels(grid, &levels, &count));
  assert_ok(hg_query_level_costs(grid, &costs, &count));
  assert_ok(hg_remove(grid, 1, &id));
  assert_int_equal(CHAIN_COUNT - 3, pairs_in(grid));
  assert_ok(hg_clear(grid));
}

TEST(balanced_at_destroy) {
  const int32_t threads[] = {1, 3};
  size_t k;
  for (k = 0; k < 2; ++k) {
    hg_grid_def def = hg_default_grid_def();
    hg_grid *grid;
    def.thread_count = threads[k];
    failing_alloc_install();
    grid = make_chain(&def);
    assert_true(failing_alloc_books().calls > 0);
    assert_true(failing_alloc_books().live_bytes > 0);
    use_everything(grid);
    hg_destroy(grid);
    assert_int_equal(0, failing_alloc_books().live_blocks);
    assert_int_equal(0, failing_alloc_books().live_bytes);
    assert_int_equal(0, failing_alloc_books().faults);
    failing_alloc_remove();
  }
}

/* The statistics count what the grid holds: no less than the input it copied, no more than it asked for. */
TEST(byte_count_is_within_the_books) {
  hg_grid *grid;
  failing_alloc_install();
  grid = make_chain(NULL);
  assert_chain(grid, 0);
  assert_true(stats_of(grid).byte_count >= (int64_t)(CHAIN_COUNT * 4 * sizeof(double)));
  assert_true(stats_of(grid).byte_count <= failing_alloc_books().live_bytes);
  hg_destroy(grid);
  failing_alloc_remove();
}

TEST(a_grid_keeps_its_allocator) {
  hg_grid *own, *other;
  long long calls;
  failing_alloc_install();
  own = make_chain(NULL);
  failing_alloc_remove();
  calls = failing_alloc_books().calls;
  other = make_chain(NULL);
  assert_chain(other, 0);
  hg_destroy(other);
  assert_int_equal(calls, failing_alloc_books().calls);
  assert_chain(own, 0);
  assert_true(failing_alloc_books().calls > calls);
  hg_destroy(own);
  assert_int_equal(0, failing_alloc_books().live_blocks);
  assert_int_equal(0, failing_alloc_books().faults);
}

static void *some_allocate(void *context, size_t size) {
  ++*(int *)context;
  return malloc(size);
}
static void *some_reallocate(void *context, void *memory, size_t old_size, size_t new_size) {
  ++*(int *)context;
  (void)old_size;
  return realloc(memory, new_size);
}
static void some_release(void *context, void *memory, size_t size) {
  (void)context;
  (void)size;
  free(memory);
}

TEST(context_is_handed_back) {
  int calls = 0;
  hg_allocator allocator = {NULL, some_allocate, some_reallocate, some_release};
  hg_grid *grid;
  allocator.context = &calls;
  assert_ok(hg_set_allocator(&allocator));
  grid = make_chain(NULL);
  assert_ok(hg_set_allocator(NULL));
  assert_true(calls > 0);
  hg_destroy(grid);
}

TEST(a_missing_member_changes_nothing) {
  int calls = 0, missing;
  hg_grid *grid;
  failing_alloc_install();
  for (missing = 0; missing < 3; ++missing) {
    hg_allocator allocator = {NULL, some_allocate, some_reallocate, some_release};
    allocator.context = &calls;
    if (missing == 0) allocator.allocate = NULL;
    if (missing == 1) allocator.reallocate = NULL;
    if (missing == 2) allocator.release = NULL;
    assert_status(HG_ERR_NULL, hg_set_allocator(&allocator));
  }
  grid = make_chain(NULL);
  hg_destroy(grid);
  assert_int_equal(0, calls);
  assert_true(failing_alloc_books().calls > 0);
  failing_alloc_remove();
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(balanced_at_destroy), cmocka_unit_test(byte_count_is_within_the_books),
      cmocka_unit_test(a_grid_keeps_its_allocator), cmocka_unit_test(context_is_handed_back),
      cmocka_unit_test(a_missing_member_changes_nothing)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
