/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Hosts with several threads or processes: a grid for each thread, a grid that lives on in a forked child. */
#include "tests/support/fixture.h"

#include <pthread.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

/* A cubic lattice of spheres that overlap along the axes only: 3 SIDE^2 (SIDE - 1) pairs. */
enum { SIDE = 30, COUNT = SIDE * SIDE * SIDE, PAIRS = 3 * SIDE * SIDE * (SIDE - 1) };

static hg_grid *make_lattice(int threads) {
  double *centers = malloc(3 * COUNT * sizeof *centers), *radii = malloc(COUNT * sizeof *radii);
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  int i;
  assert_non_null(centers);
  assert_non_null(radii);
  for (i = 0; i < COUNT; ++i) {
    centers[3 * i] = i % SIDE;
    centers[3 * i + 1] = i / SIDE % SIDE;
    centers[3 * i + 2] = i / SIDE / SIDE;
    radii[i] = 0.6;
  }
  def.thread_count = threads;
  grid = make_grid(&def, COUNT, centers, radii);
  free(centers);
  free(radii);
  return grid;
}

static int has_all_pairs(hg_grid *grid) {
  const hg_pair *pairs;
  size_t count;
  return hg_query_pairs(grid, &pairs, &count) == HG_OK && count == PAIRS;
}

/* A particle that meets no other makes the grid build and search anew. */
static int finds_all_pairs_anew(hg_grid *grid) {
  static double far = -10;
  const double center[3] = {far, far, far}, radius = 0.1;
  far -= 1;
  return hg_insert(grid, 1, center, &radius) == HG_OK && has_all_pairs(grid);
}

/* In the child: 0 if all is well. A child that hangs is ended by its alarm. */
static int child_status(int (*work)(hg_grid *grid), hg_grid *grid) {
  int status = 0;
  const pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) {
    alarm(30);
    _exit(work(grid) ? 0 : 1);
  }
  assert_int_equal(child, waitpid(child, &status, 0));
  return status;
}

/* The parent's grid is the child's as well; both go on without the other. */
TEST(a_forked_child_has_the_grid) {
  hg_grid *grid = make_lattice(1);
  assert_true(has_all_pairs(grid));
  assert_int_equal(0, child_status(has_all_pairs, grid));
  assert_int_equal(0, child_status(finds_all_pairs_anew, grid));
  assert_true(finds_all_pairs_anew(grid));
  hg_destroy(grid);
}

/* The threads that searched for the parent do not exist in the child, which makes its own. */
TEST(a_forked_child_searches_without_the_parents_threads) {
  hg_grid *grid = make_lattice(2);
  assert_true(has_all_pairs(grid));
  assert_int_equal(0, child_status(finds_all_pairs_anew, grid));
  assert_true(finds_all_pairs_anew(grid));
  hg_destroy(grid);
}

static void *own_grids(void *result) {
  int round;
  *(int *)result = 1;
  for (round = 0; round < 3; ++round) {
    hg_grid *grid = make_lattice(1);
    *(int *)result &= has_all_pairs(grid);
    hg_destroy(grid);
  }
  return NULL;
}

TEST(two_grids_in_two_threads) {
  pthread_t threads[2];
  int results[2] = {0, 0}, k;
  for (k = 0; k < 2; ++k) assert_int_equal(0, pthread_create(&threads[k], NULL, own_grids, &results[k]));
  for (k = 0; k < 2; ++k) assert_int_equal(0, pthread_join(threads[k], NULL));
  for (k = 0; k < 2; ++k) assert_int_equal(1, results[k]);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(a_forked_child_has_the_grid),
                                     cmocka_unit_test(a_forked_child_searches_without_the_parents_threads),
                                     cmocka_unit_test(two_grids_in_two_threads)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
