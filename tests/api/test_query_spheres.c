/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_query_spheres: rows of particles that spheres meet. What one row holds is tested by hg_query_sphere's own test and
 * by property/test_queries_agree. */
#define _DEFAULT_SOURCE /* setrlimit */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <malloc.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

/* Spheres on the chain that meet 3 to 5, none, 8, and 0 to 1. */
enum { SPHERES = 4 };
static const double kCenters[3 * SPHERES] = {4, 0, 0, 100, 0, 0, 8.5, 0, 0, 0, 0, 0.25};
static const double kRadii[SPHERES] = {1, 2, 0, 0.5};
static const int64_t kOffsets[SPHERES + 1] = {0, 3, 3, 4, 6};
static const int32_t kIds[6] = {3, 4, 5, 8, 0, 1};

static void assert_rows(const int64_t *offsets, const int32_t *ids, int32_t first) {
  int k;
  assert_memory_equal(offsets, kOffsets, sizeof kOffsets);
  for (k = 0; k < 6; ++k) assert_int_equal(kIds[k] + first, ids[k]);
}

static hg_status query(hg_grid *grid) {
  const int64_t *offsets = NULL;
  const int32_t *ids = NULL;
  const hg_status status = hg_query_spheres(grid, SPHERES, kCenters, kRadii, &offsets, &ids);
  if (status == HG_OK) assert_rows(offsets, ids, 0);
  return status;
}

TEST(rows_in_the_order_of_the_spheres) {
  const int64_t *offsets;
  const int32_t *ids;
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.index_base = 1;
  grid = make_chain(&def);
  assert_ok(hg_query_spheres(grid, SPHERES, kCenters, kRadii, &offsets, &ids));
  assert_rows(offsets, ids, 1);
  hg_destroy(grid);
}

/* Also of an empty grid, and of arguments that need not exist then. */
TEST(no_spheres) {
  const int64_t *offsets = NULL;
  const int32_t *ids = NULL;
  hg_grid *grids[2];
  int k;
  grids[0] = make_chain(NULL);
  grids[1] = make_empty(NULL);
  for (k = 0; k < 2; ++k) {
    assert_ok(hg_query_spheres(grids[k], 0, NULL, NULL, &offsets, &ids));
    assert_int_equal(0, offsets[0]);
  }
  assert_ok(hg_query_spheres(grids[1], SPHERES, kCenters, kRadii, &offsets, &ids));
  for (k = 0; k <= SPHERES; ++k) assert_int_equal(0, offsets[k]);
  hg_destroy(grids[0]);
  hg_destroy(grids[1]);
}

/* The rows stay while the grid goes, and other queries run. */
TEST(rows_belong_to_the_thread) {
  const int64_t *offsets;
  const int32_t *ids, *others;
  size_t count;
  hg_grid *grid = make_chain(NULL);
  assert_ok(hg_query_spheres(grid, SPHERES, kCenters, kRadii, &offsets, &ids));
  assert_ok(hg_query_sphere(grid, kCenters, 100, &others, &count));
  assert_ok(hg_clear(grid));
  hg_destroy(grid);
  assert_rows(offsets, ids, 0);
}

TEST(packed_bytes) {
  char bytes[1 + sizeof kCenters], radius_bytes[1 + sizeof kRadii];
  const int64_t *offsets;
  const int32_t *ids;
  hg_grid *grid = make_chain(NULL);
  memcpy(bytes + 1, kCenters, sizeof kCenters);
  memcpy(radius_bytes + 1, kRadii, sizeof kRadii);
  assert_ok(hg_query_spheres(grid, SPHERES, (const double *)(const void *)(bytes + 1),
                             (const double *)(const void *)(radius_bytes + 1), &offsets, &ids));
  assert_rows(offsets, ids, 0);
  hg_destroy(grid);
}

static void refuse(hg_grid *grid, int sphere, int axis, double value, const char *name, const char *text) {
  double centers[3 * SPHERES], radii[SPHERES];
  const int64_t *offsets = kOffsets;
  const int32_t *ids = kIds;
  memcpy(centers, kCenters, sizeof centers);
  memcpy(radii, kRadii, sizeof radii);
  *(axis == 3 ? radii + sphere : centers + 3 * sphere + axis) = value;
  assert_status(HG_ERR_ARGUMENT, hg_query_spheres(grid, SPHERES, centers, radii, &offsets, &ids));
  assert_error_names(name);
  assert_error_names(text);
  assert_true(offsets == kOffsets && ids == kIds);
}

TEST(bad_arguments) {
  const hg_grid_def def = periodic_axis(1, 1);
  hg_grid *grid = make_chain(NULL), *periodic = make_empty(&def);
  const int64_t *offsets;
  const int32_t *ids;
  assert_status(HG_ERR_NULL, hg_query_spheres(NULL, SPHERES, kCenters, kRadii, &offsets, &ids));
  assert_status(HG_ERR_NULL, hg_query_spheres(grid, SPHERES, NULL, kRadii, &offsets, &ids));
  assert_error_names("centers");
  assert_status(HG_ERR_NULL, hg_query_spheres(grid, SPHERES, kCenters, NULL, &offsets, &ids));
  assert_error_names("radii");
  assert_status(HG_ERR_NULL, hg_query_spheres(grid, SPHERES, kCenters, kRadii, NULL, &ids));
  assert_status(HG_ERR_NULL, hg_query_spheres(grid, SPHERES, kCenters, kRadii, &offsets, NULL));
  refuse(grid, 2, 1, not_a_number(), "centers[2][1]", "nan");
  refuse(grid, 3, 0, -infinity(), "centers[3][0]", "-inf");
  refuse(grid, 1, 3, -0.375, "radii[1]", "-0.375");
  refuse(grid, 0, 3, infinity(), "radii[0]", "inf");
  refuse(periodic, 3, 1, 4294967296.0, "centers[3][1]", "2^20 box lengths");
  assert_ok(query(grid));
  hg_destroy(grid);
  hg_destroy(periodic);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(query); }

TEST(no_memory_of_the_grid) { assert_true(refuse_each_allocation_on_chain(query) > 0); }

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MALLOC_ASKS_THE_SYSTEM 0 /* the sanitizers' own malloc ends the program when the system refuses */
#else
#define MALLOC_ASKS_THE_SYSTEM 1
#endif

/* The rows are the thread's and come from malloc, which no hook reaches: so the system refuses the memory. */
TEST(no_memory_for_the_rows) {
  enum { COUNT = 100000 };
  double *centers, *radii;
  const int64_t *offsets = NULL;
  const int32_t *ids = NULL;
  struct rlimit usual, none;
  hg_status status;
  hg_grid *grid;
  if (!MALLOC_ASKS_THE_SYSTEM) skip();
  grid = make_chain(NULL);
  centers = calloc(3 * COUNT, sizeof *centers);
  radii = calloc(COUNT, sizeof *radii);
  assert_ok(hg_build(grid));
  assert_int_equal(0, getrlimit(RLIMIT_AS, &usual));
  none = usual;
  none.rlim_cur = 0;
  assert_int_equal(0, setrlimit(RLIMIT_AS, &none));
  status = hg_query_spheres(grid, COUNT, centers, radii, &offsets, &ids);
  assert_int_equal(0, setrlimit(RLIMIT_AS, &usual));
  assert_status(HG_ERR_MEMORY, status);
  assert_ok(hg_query_spheres(grid, COUNT, centers, radii, &offsets, &ids));
  assert_int_equal(COUNT, offsets[COUNT]);
  free(centers);
  free(radii);
  hg_destroy(grid);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(rows_in_the_order_of_the_spheres),
                                     cmocka_unit_test(no_spheres),
                                     cmocka_unit_test(rows_belong_to_the_thread),
                                     cmocka_unit_test(packed_bytes),
                                     cmocka_unit_test(bad_arguments),
                                     cmocka_unit_test(refused_inside_a_visitor),
                                     cmocka_unit_test(no_memory_of_the_grid),
                                     cmocka_unit_test(no_memory_for_the_rows)};
  /* Large blocks come from the system each time, so that it can refuse them. */
  mallopt(M_MMAP_THRESHOLD, 1 << 16);
  return cmocka_run_group_tests(tests, NULL, NULL);
}
