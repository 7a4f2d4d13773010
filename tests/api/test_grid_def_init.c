/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_grid_def_init and hg_default_grid_def: the defaults, and structs of other sizes. */
#include "tests/support/fixture.h"

#include <stddef.h>
#include <string.h>

static void assert_defaults(const hg_grid_def *def) {
  int k;
  assert_int_equal(sizeof(hg_grid_def), def->struct_size);
  assert_int_equal(3, def->dimension);
  assert_int_equal(0, def->thread_count);
  assert_int_equal(0, def->index_base);
  assert_int_equal(HG_CONTACT, def->interaction);
  assert_int_equal(HG_EXACT, def->accuracy);
  assert_int_equal(HG_ORDER_GRID, def->pair_order);
  assert_int_equal(HG_LEVELS_AUTO, def->level_rule);
  assert_int_equal(0, def->level_count);
  assert_int_equal(0, def->reserved0);
  assert_null(def->cell_sizes);
  assert_true(def->margin == 0);
  assert_true(def->skin == 0);
  assert_int_equal(0, def->reserved1);
  assert_true(def->cell_overhead < 0);
  assert_true(def->level_price < 0);
  assert_true(def->row_price < 0);
  assert_int_equal(0, def->touching);
  assert_int_equal(HG_NEAREST_IMAGE, def->images);
  for (k = 0; k < 3; ++k) {
    assert_int_equal(0, def->periodic[k]);
    assert_true(def->box_min[k] == 0);
    assert_true(def->box_max[k] == 0);
    assert_true(def->tilt[k] == 0);
  }
}

TEST(fills_the_defaults) {
  hg_grid_def def;
  memset(&def, 0xff, sizeof def);
  assert_ok(hg_grid_def_init(&def, sizeof def));
  assert_defaults(&def);
}

TEST(default_by_value_is_the_same) {
  const hg_grid_def def = hg_default_grid_def();
  assert_defaults(&def);
}

TEST(null_is_refused) {
  assert_status(HG_ERR_NULL, hg_grid_def_init(NULL, sizeof(hg_grid_def)));
  assert_true(strlen(hg_last_error()) > 0);
}

/* A caller with a newer header than the library, and one older than version 0.1, get an error and an untouched def. */
TEST(other_sizes_are_refused) {
  const size_t sizes[] = {0, 4, 128, sizeof(hg_grid_def) + 8, SIZE_MAX};
  size_t k, byte;
  for (k = 0; k < sizeof sizes / sizeof *sizes; ++k) {
    hg_grid_def def;
    memset(&def, 0x5a, sizeof def);
    assert_status(HG_ERR_ARGUMENT, hg_grid_def_init(&def, sizes[k]));
    for (byte = 0; byte < sizeof def; ++byte) assert_int_equal(0x5a, ((unsigned char *)&def)[byte]);
  }
}

/* What older headers defined counts as far as it goes; what lies behind it in memory is neither read nor written. */
TEST(older_definitions_are_taken) {
  const size_t sizes[] = {offsetof(hg_grid_def, level_price), offsetof(hg_grid_def, tilt)};
  size_t k, byte;
  for (k = 0; k < sizeof sizes / sizeof *sizes; ++k) {
    hg_grid_def def;
    hg_grid *grid;
    memset(&def, 0x5a, sizeof def);
    assert_ok(hg_grid_def_init(&def, sizes[k]));
    for (byte = sizes[k]; byte < sizeof def; ++byte) assert_int_equal(0x5a, ((unsigned char *)&def)[byte]);
    assert_ok(hg_create(&def, &grid));
    hg_destroy(grid);
  }
}

TEST(nothing_is_written_past_the_end) {
  struct {
    hg_grid_def def;
    unsigned char guard[64];
  } guarded;
  size_t byte;
  memset(&guarded, 0x5a, sizeof guarded);
  assert_ok(hg_grid_def_init(&guarded.def, sizeof guarded.def));
  for (byte = 0; byte < sizeof guarded.guard; ++byte) assert_int_equal(0x5a, guarded.guard[byte]);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(fills_the_defaults),
                                     cmocka_unit_test(default_by_value_is_the_same),
                                     cmocka_unit_test(null_is_refused),
                                     cmocka_unit_test(other_sizes_are_refused),
                                     cmocka_unit_test(older_definitions_are_taken),
                                     cmocka_unit_test(nothing_is_written_past_the_end)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
