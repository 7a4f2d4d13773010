/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_query_sphere: the particles that a sphere meets, by the rule of the grid. */
#define _DEFAULT_SOURCE /* setrlimit */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <malloc.h>
#include <stdlib.h>
#include <sys/resource.h>

/* The sphere at (x, 0, 0) meets the ids first .. last. */
static void assert_range(hg_grid *grid, double x, double radius, int32_t first, int32_t last) {
  double center[3] = {0, 0, 0};
  const int32_t *ids;
  size_t count, k;
  center[0] = x;
  assert_ok(hg_query_sphere(grid, center, radius, &ids, &count));
  assert_int_equal(last - first + 1, count);
  for (k = 0; k < count; ++k) assert_int_equal(first + (int32_t)k, ids[k]);
}

TEST(ids_ascend) {
  hg_grid *grid = make_chain(NULL);
  assert_range(grid, 4, 0, 4, 4);
  assert_range(grid, 4.5, 0, 4, 5);
  assert_range(grid, 4, 1, 3, 5);
  assert_range(grid, 4, 100, 0, CHAIN_COUNT - 1);
  assert_range(grid, 1e9, 1, 0, -1);
  hg_destroy(grid);
}

TEST(touching_is_no_hit) {
  const double centers[6] = {0, 0, 0, 4, 0, 0}, radii[2] = {1, 1};
  hg_grid *grid = make_grid(NULL, 2, centers, radii);
  assert_range(grid, 2, 1, 0, -1);
  assert_range(grid, 1.9999999999999998, 1, 0, 0);
  assert_range(grid, 1, 0, 0, -1);
  hg_destroy(grid);
}

TEST(margin_and_max_range_count) {
  const double centers[6] = {0, 0, 0, 4, 0, 0}, radii[2] = {1, 1};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.margin = 0.5;
  grid = make_grid(&def, 2, centers, radii);
  assert_range(grid, 2, 0.5, 0, -1);
  assert_range(grid, 2, 0.75, 0, 1);
  hg_destroy(grid);
  def.margin = 0;
  def.interaction = HG_MAX_RANGE;
  grid = make_grid(&def, 2, centers, radii);
  assert_range(grid, 0.5, 0.25, 0, 0);
  assert_range(grid, 2, 2, 0, -1);
  assert_range(grid, 2, 2.5, 0, 1);
  hg_destroy(grid);
}

TEST(nearest_image_counts) {
  const double centers[6] = {0.25, 0, 0, 9, 0, 0}, radii[2] = {0.5, 0.5};
  const hg_grid_def def = periodic_axis(0, 10);
  hg_grid *grid = make_grid(&def, 2, centers, radii);
  assert_range(grid, 9.5, 0.5, 0, 1);
  assert_range(grid, -0.5, 0.5, 0, 1);
  assert_range(grid, 9.75, 0.25, 0, 0);
  assert_range(grid, 10005, 0.25, 0, -1);
  assert_range(grid, 10009, 0.25, 1, 1);
  assert_range(grid, 5, 1000, 0, 1);
  hg_destroy(grid);
}

TEST(two_dimensions) {
  const double centers[4] = {0, 0, 3, 4}, radii[2] = {1, 1}, center[2] = {3, 5};
  hg_grid_def def = hg_default_grid_def();
  const int32_t *ids;
  hg_grid *grid;
  size_t count;
  def.dimension = 2;
  def.index_base = 1;
  grid = make_grid(&def, 2, centers, radii);
  assert_ok(hg_query_sphere(grid, center, 0.5, &ids, &count));
  assert_int_equal(1, count);
  assert_int_equal(2, ids[0]);
  hg_destroy(grid);
}

TEST(empty_grid) {
  hg_grid *grid = make_empty(NULL);
  assert_range(grid, 0, 1e6, 0, -1);
  hg_destroy(grid);
}

TEST(bad_arguments) {
  hg_grid *grid = make_chain(NULL);
  double center[3] = {0, 0, 0};
  const int32_t *ids;
  size_t count;
  int axis;
  assert_status(HG_ERR_NULL, hg_query_sphere(NULL, center, 1, &ids, &count));
  assert_status(HG_ERR_NULL, hg_query_sphere(grid, NULL, 1, &ids, &count));
  assert_status(HG_ERR_NULL, hg_query_sphere(grid, center, 1, NULL, &count));
  assert_status(HG_ERR_NULL, hg_query_sphere(grid, center, 1, &ids, NULL));
  assert_status(HG_ERR_ARGUMENT, hg_query_sphere(grid, center, -0.375, &ids, &count));
  assert_error_names("-0.375");
  assert_status(HG_ERR_ARGUMENT, hg_query_sphere(grid, center, not_a_number(), &ids, &count));
  assert_status(HG_ERR_ARGUMENT, hg_query_sphere(grid, center, infinity(), &ids, &count));
  for (axis = 0; axis < 3; ++axis) {
    center[axis] = not_a_number();
    assert_status(HG_ERR_ARGUMENT, hg_query_sphere(grid, center, 1, &ids, &count));
    assert_error_names("nan");
    center[axis] = -infinity();
    assert_status(HG_ERR_ARGUMENT, hg_query_sphere(grid, center, 1, &ids, &count));
    assert_error_names("-inf");
    center[axis] = 0;
  }
  assert_chain(grid, 0);
  hg_destroy(grid);
}

TEST(too_far_outside_a_periodic_box) {
  const double far[3] = {0, 4294967296.0, 0};
  const hg_grid_def def = periodic_axis(1, 1);
  hg_grid *grid = make_empty(&def);
  const int32_t *ids;
  size_t count;
  assert_status(HG_ERR_ARGUMENT, hg_query_sphere(grid, far, 0.1, &ids, &count));
  assert_error_names("center[1]");
  hg_destroy(grid);
}

static hg_status query_again(hg_grid *grid) {
  const double center[3] = {4, 0, 0};
  const int32_t *ids;
  size_t count;
  const hg_status status = hg_query_sphere(grid, center, 1, &ids, &count);
  if (status == HG_OK) assert_true(count == 3 && ids[0] == 3 && ids[2] == 5);
  return status;
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(query_again); }

TEST(no_memory) { assert_true(refuse_each_allocation_on_chain(query_again) > 0); }

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MALLOC_ASKS_THE_SYSTEM 0 /* the sanitizers' own malloc ends the program when the system refuses */
#else
#define MALLOC_ASKS_THE_SYSTEM 1
#endif

/* The list of ids is the thread's and comes from malloc, which no hook reaches: so the system refuses the memory. */
TEST(no_memory_for_the_list) {
  enum { COUNT = 300000 };
  double *centers, *radii;
  const double center[3] = {0, 0, 0};
  const int32_t *ids = NULL;
  struct rlimit usual, none;
  hg_status status;
  size_t count = 0;
  hg_grid *grid;
  int k;
  if (!MALLOC_ASKS_THE_SYSTEM) skip();
  centers = calloc(3 * COUNT, sizeof *centers);
  radii = calloc(COUNT, sizeof *radii);
  for (k = 0; k < COUNT; ++k) centers[3 * k] = k;
  grid = make_grid(NULL, COUNT, centers, radii);
  free(centers);
  free(radii);
  assert_ok(hg_build(grid));
  assert_int_equal(0, getrlimit(RLIMIT_AS, &usual));
  none = usual;
  none.rlim_cur = 0;
  assert_int_equal(0, setrlimit(RLIMIT_AS, &none));
  status = hg_query_sphere(grid, center, 2.0 * COUNT, &ids, &count);
  assert_int_equal(0, setrlimit(RLIMIT_AS, &usual));
  assert_status(HG_ERR_MEMORY, status);
  assert_ok(hg_query_sphere(grid, center, 2.0 * COUNT, &ids, &count));
  assert_int_equal(COUNT, count);
  assert_int_equal(COUNT - 1, ids[COUNT - 1]);
  hg_destroy(grid);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(ids_ascend),
                                     cmocka_unit_test(touching_is_no_hit),
                                     cmocka_unit_test(margin_and_max_range_count),
                                     cmocka_unit_test(nearest_image_counts),
                                     cmocka_unit_test(two_dimensions),
                                     cmocka_unit_test(empty_grid),
                                     cmocka_unit_test(bad_arguments),
                                     cmocka_unit_test(too_far_outside_a_periodic_box),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(no_memory),
                                     cmocka_unit_test(no_memory_for_the_list)};
  /* Large blocks come from the system each time, so that it can refuse them. */
  mallopt(M_MMAP_THRESHOLD, 1 << 16);
  return cmocka_run_group_tests(tests, NULL, NULL);
}
