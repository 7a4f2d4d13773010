/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Whose threads a search uses: the program's own where it has OpenMP, else the library's. Compiled with OpenMP and
 * without. */
#include "tests/support/fixture.h"

#include <dirent.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef _OPENMP
#include <omp.h>
#endif

enum { THREADS = 4, COUNT = 40000 };

static int threads_of_process(void) {
  DIR *tasks = opendir("/proc/self/task");
  int count = 0;
  struct dirent *entry;
  if (tasks == NULL) skip();
  while ((entry = readdir(tasks)) != NULL) count += entry->d_name[0] != '.';
  closedir(tasks);
  return count;
}

/* A row of spheres, each of which overlaps the next. */
static int searches(int threads) {
  double *centers = calloc(3 * COUNT, sizeof *centers), *radii = malloc(COUNT * sizeof *radii);
  hg_grid_def def = hg_default_grid_def();
  const hg_pair *pairs;
  size_t count = 0;
  hg_grid *grid;
  int i;
  assert_non_null(centers);
  assert_non_null(radii);
  for (i = 0; i < COUNT; ++i) {
    centers[3 * i] = i;
    radii[i] = 0.6;
  }
  def.thread_count = threads;
  grid = make_grid(&def, COUNT, centers, radii);
  assert_int_equal(HG_OK, hg_query_pairs(grid, &pairs, &count));
  hg_destroy(grid);
  free(centers);
  free(radii);
  return count == COUNT - 1;
}

TEST(one_thread_makes_no_others) {
  assert_true(searches(1));
  assert_int_equal(1, threads_of_process());
}

/* Neither more than were asked for, nor a second set beside those of the program. */
TEST(threads_are_made_once) {
#ifdef _OPENMP
  int there = 0;
#pragma omp parallel num_threads(THREADS) reduction(+ : there)
  there += 1;
  assert_int_equal(THREADS, there);
  assert_int_equal(THREADS, threads_of_process());
#endif
  assert_true(searches(THREADS));
  assert_int_equal(THREADS, threads_of_process());
  assert_true(searches(THREADS));
  assert_int_equal(THREADS, threads_of_process());
}

/* The child has none of them, and neither hangs nor does without. */
TEST(a_child_makes_its_own) {
  int status = 0;
  const pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) {
    alarm(30);
    _exit(searches(THREADS) && threads_of_process() == THREADS ? 0 : 1);
  }
  assert_int_equal(child, waitpid(child, &status, 0));
  assert_int_equal(0, status);
}

#ifdef _OPENMP
/* All cores have work there; as many searches as threads are right. */
TEST(inside_a_parallel_region) {
  int right = 0;
#pragma omp parallel num_threads(THREADS) reduction(+ : right)
  right += searches(THREADS);
  assert_int_equal(THREADS, right);
  assert_int_equal(THREADS, threads_of_process());
}
#endif

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(one_thread_makes_no_others),
      cmocka_unit_test(threads_are_made_once),
      cmocka_unit_test(a_child_makes_its_own),
#ifdef _OPENMP
      cmocka_unit_test(inside_a_parallel_region),
#endif
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
