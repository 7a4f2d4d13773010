/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_query_pair_vectors: what leads from a to b in each pair, and through which image. */
#include "tests/support/failing_alloc.h"
#include "tests/support/fixture.h"

#include <stdint.h>

static hg_status query(hg_grid *grid) {
  const double *vectors;
  const int32_t *shifts;
  return hg_query_pair_vectors(grid, &vectors, &shifts);
}

/* Of the only pair. */
static void assert_vector(hg_grid *grid, int dimension, const double *vector, const int32_t *shift) {
  const double *vectors = NULL;
  const int32_t *shifts = NULL;
  int axis;
  assert_int_equal(1, pairs_in(grid));
  assert_ok(hg_query_pair_vectors(grid, &vectors, &shifts));
  for (axis = 0; axis < dimension; ++axis) {
    assert_true(vectors[axis] == vector[axis]);
    assert_int_equal(shift[axis], shifts[axis]);
  }
}

TEST(open_axes) {
  const hg_pair *pairs;
  const double *vectors;
  const int32_t *shifts;
  hg_grid *grid = make_chain(NULL);
  size_t count, k;
  assert_ok(hg_query_pair_vectors(grid, &vectors, &shifts)); /* searches by itself */
  assert_ok(hg_query_pairs(grid, &pairs, &count));
  for (k = 0; k < count; ++k) {
    assert_true(vectors[3 * k] == pairs[k].b - pairs[k].a);
    assert_true(vectors[3 * k + 1] == 0 && vectors[3 * k + 2] == 0);
    assert_true(shifts[3 * k] == 0 && shifts[3 * k + 1] == 0 && shifts[3 * k + 2] == 0);
  }
  hg_destroy(grid);
}

/* Shifts are relative to the places as given, however far outside the box. */
TEST(across_a_periodic_face) {
  const double centers[2][6] = {{0.25, 5, 5, 9.5, 5, 5}, {30.25, 5, 5, -10.5, 5, 5}}, radii[2] = {0.5, 0.5};
  const double vector[3] = {-0.75, 0, 0};
  const int32_t shifts[2][3] = {{-1, 0, 0}, {4, 0, 0}};
  const hg_grid_def def = periodic_axis(0, 10);
  int k;
  for (k = 0; k < 2; ++k) {
    hg_grid *grid = make_grid(&def, 2, centers[k], radii);
    assert_vector(grid, 3, vector, shifts[k]);
    hg_destroy(grid);
  }
}

TEST(a_tilted_plane) {
  const double centers[4] = {1, 0.5, 3, 3.5}, radii[2] = {0.75, 0.75}, vector[2] = {0, -1};
  const int32_t shift[2] = {0, -1};
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  def.dimension = 2;
  def.periodic[0] = def.periodic[1] = 1;
  def.box_max[0] = def.box_max[1] = 4;
  def.tilt[0] = 2;
  grid = make_grid(&def, 2, centers, radii);
  assert_vector(grid, 2, vector, shift);
  hg_destroy(grid);
}

/* Two images at the same distance: the smaller shift. */
TEST(touching_twice) {
  const double centers[6] = {1, 0, 0, 3, 0, 0}, radii[2] = {1, 1}, vector[3] = {-2, 0, 0};
  const int32_t shift[3] = {-1, 0, 0};
  hg_grid_def def = periodic_axis(0, 4);
  hg_grid *grid;
  def.touching = 1;
  grid = make_grid(&def, 2, centers, radii);
  assert_vector(grid, 3, vector, shift);
  hg_destroy(grid);
}

/* A lone sphere and its images in a cubic lattice: each shift whose last component that is not 0 is positive. */
TEST(a_particle_and_its_own_images) {
  const double center[3] = {0.5, 0.5, 0.5}, radius = 0.5;
  const int32_t expected[9] = {0, 0, 1, 0, 1, 0, 1, 0, 0};
  const double *vectors;
  const int32_t *shifts;
  hg_grid_def def = hg_default_grid_def();
  hg_grid *grid;
  int k;
  def.touching = 1;
  def.images = HG_ALL_IMAGES;
  for (k = 0; k < 3; ++k) def.periodic[k] = 1, def.box_max[k] = 1;
  grid = make_grid(&def, 1, center, &radius);
  assert_int_equal(3, pairs_in(grid));
  assert_ok(hg_query_pair_vectors(grid, &vectors, &shifts));
  for (k = 0; k < 9; ++k) {
    assert_int_equal(expected[k], shifts[k]);
    assert_true(vectors[k] == expected[k]);
  }
  hg_destroy(grid);
}

/* 1/3 - 2^60 and the box length 2^60 cancel: what is left is what a rounded place would have lost. */
TEST(rounded_once) {
  const double third = 1.0 / 3, length = 1152921504606846976.0;
  const double centers[6] = {0x1p-10, 0, 0, 0, 0, 0}, radii[2] = {1, 1};
  const int32_t shift[3] = {0, 0, 0};
  double moved[6], vector[3] = {0, 0, 0};
  hg_grid_def def = periodic_axis(0, length);
  hg_grid *grid;
  int k;
  for (k = 0; k < 6; ++k) moved[k] = centers[k];
  moved[0] = length;
  moved[3] = third;
  vector[0] = third;
  grid = make_grid(&def, 2, moved, radii);
  {
    const int32_t across[3] = {1, 0, 0};
    assert_vector(grid, 3, vector, across);
  }
  assert_ok(hg_move(grid, 2, centers, NULL));
  vector[0] = -0x1p-10;
  assert_vector(grid, 3, vector, shift);
  hg_destroy(grid);
}

/* As long as the grid does not change, whatever else is asked. */
TEST(borrowed_until_the_grid_changes) {
  const double *vectors, *again, center[3] = {0, 0, 0};
  const int32_t *shifts, *same, *ids;
  const int64_t *offsets;
  hg_grid *grid = make_chain(NULL);
  size_t count;
  assert_ok(hg_query_pair_vectors(grid, &vectors, &shifts));
  assert_ok(hg_query_neighbors(grid, HG_FULL, &offsets, &ids));
  assert_ok(hg_query_order(grid, &ids, &count));
  assert_ok(hg_query_sphere(grid, center, 1, &ids, &count));
  assert_ok(search(grid));
  assert_true(vectors[0] == 1);
  assert_ok(hg_query_pair_vectors(grid, &again, &same));
  assert_ptr_equal(vectors, again);
  assert_ptr_equal(shifts, same);
  assert_ok(hg_query_pair_vectors(grid, NULL, &same));
  assert_ptr_equal(shifts, same);
  assert_ok(hg_query_pair_vectors(grid, &again, NULL));
  assert_ok(hg_query_pair_vectors(grid, NULL, NULL));
  hg_destroy(grid);
}

TEST(each_change_is_followed) {
  const double start[6] = {1, 0, 0, 1.5, 0, 0}, moved[6] = {3.5, 0, 0, 0, 0, 0}, radii[2] = {0.5, 0.5};
  const double low[3] = {0, 0, 0}, high[3] = {3.75, 0, 0};
  const double first[3] = {0.5, 0, 0}, second[3] = {0.5, 0, 0}, third[3] = {0.25, 0, 0};
  const int32_t none[3] = {0, 0, 0}, right[3] = {1, 0, 0};
  hg_grid_def def = periodic_axis(0, 4);
  hg_grid *grid;
  for (def.skin = 0; def.skin < 1; def.skin += 0.5) {
    grid = make_grid(&def, 2, start, radii);
    assert_vector(grid, 3, first, none);
    assert_ok(hg_move(grid, 2, moved, NULL));
    assert_vector(grid, 3, second, right);
    assert_ok(hg_set_box(grid, low, high, NULL));
    assert_vector(grid, 3, third, right);
    assert_ok(hg_set(grid, 2, start, radii));
    assert_vector(grid, 3, first, none);
    hg_destroy(grid);
  }
}

TEST(without_pairs) {
  const double center[3] = {0, 0, 0}, radius = 1;
  const double *vectors = &radius;
  const int32_t *shifts = (const int32_t *)(const void *)center;
  hg_grid *grid = make_empty(NULL);
  assert_ok(hg_query_pair_vectors(grid, &vectors, &shifts));
  assert_null(vectors);
  assert_null(shifts);
  assert_ok(hg_insert(grid, 1, center, &radius));
  assert_ok(hg_query_pair_vectors(grid, &vectors, &shifts));
  assert_null(vectors);
  hg_destroy(grid);
}

TEST(null_is_refused) {
  const double *vectors;
  const int32_t *shifts;
  assert_status(HG_ERR_NULL, hg_query_pair_vectors(NULL, &vectors, &shifts));
}

static void short_cell(hg_grid **grid) {
  const double centers[6] = {0, 0, 0, 0.5, 0, 0}, radii[2] = {0.6, 0.6};
  hg_grid_def def = periodic_axis(0, 1);
  def.images = HG_ALL_IMAGES;
  *grid = make_grid(&def, 2, centers, radii);
}
static hg_status query_again(hg_grid **grid) { return query(*grid); }

TEST(no_memory) {
  const alloc_scenario all_images = {short_cell, query_again, NULL, NULL};
  assert_true(refuse_each_allocation_on_chain(query) > 0);
  assert_true(refuse_each_allocation(&all_images) > 0);
}

TEST(refused_inside_a_visitor) { assert_refused_in_visitor(query); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(open_axes),
                                     cmocka_unit_test(across_a_periodic_face),
                                     cmocka_unit_test(a_tilted_plane),
                                     cmocka_unit_test(touching_twice),
                                     cmocka_unit_test(a_particle_and_its_own_images),
                                     cmocka_unit_test(rounded_once),
                                     cmocka_unit_test(borrowed_until_the_grid_changes),
                                     cmocka_unit_test(each_change_is_followed),
                                     cmocka_unit_test(without_pairs),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(no_memory),
                                     cmocka_unit_test(refused_inside_a_visitor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
