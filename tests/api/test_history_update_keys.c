/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* hg_history_update_keys: contacts that only their sub-keys tell apart, large ids, and pairs before and after them. */
#include "tests/support/history_fixture.h"

#include <stdint.h>

static const hg_contact_key kFirst[4] = {{1, 2, 0}, {1, 2, 1}, {1, 2, -7}, {INT64_MAX, INT64_MIN, 5}};

static void assert_places(hg_history *history, const hg_contact_key *keys, size_t count, const int64_t *expected) {
  const int64_t *previous = (const int64_t *)(uintptr_t)0x10;
  size_t k;
  assert_ok(hg_history_update_keys(history, count, keys, &previous));
  if (count == 0) assert_null(previous);
  for (k = 0; k < count; ++k) assert_int_equal(expected[k], previous[k]);
}

TEST(sub_keys_tell_contacts_apart) {
  const hg_contact_key next[4] = {{1, 2, -7}, {1, 2, 2}, {INT64_MAX, INT64_MIN, 5}, {1, 2, 0}};
  const int64_t none[4] = {-1, -1, -1, -1}, places[4] = {2, -1, 3, 0};
  const double before[4] = {10, 11, 12, 13}, expected[4] = {12, 0, 13, 10};
  double after[4];
  hg_history *history = make_empty_history();
  assert_places(history, kFirst, 4, none);
  assert_places(history, next, 4, places);
  assert_ok(hg_history_carry(history, sizeof before[0], before, after));
  assert_memory_equal(expected, after, sizeof expected);
  assert_places(history, NULL, 0, NULL);
  hg_history_destroy(history);
}

/* Ids of which only the upper halves differ are others. */
TEST(all_bits_count) {
  const int64_t far = (int64_t)1 << 40;
  const hg_contact_key one[1] = {{1, 2, 3}}, others[4] = {{1 + far, 2, 3}, {1, 2 + far, 3}, {1, 2, 3 + far}, {1, 2, 3}};
  const int64_t none[1] = {-1}, places[4] = {-1, -1, -1, 0};
  hg_history *history = make_empty_history();
  assert_places(history, one, 1, none);
  assert_places(history, others, 4, places);
  hg_history_destroy(history);
}

/* A pair is the key with sub-key 0. */
TEST(pairs_before_and_after) {
  const hg_contact_key keys[3] = {{3, 4, 1}, {3, 4, 0}, {-1, -1, 0}};
  const hg_pair pairs[3] = {{-1, -1}, {1, 2}, {3, 4}};
  const int64_t places[3] = {-1, 0, 4}, back[3] = {2, -1, 1};
  hg_history *history = make_history();
  assert_places(history, keys, 3, places);
  assert_update(history, pairs, 3, back);
  hg_history_destroy(history);
}

/* Two images of one pair in a short box: refused as pairs, told apart by their shifts. */
TEST(images_of_a_pair) {
  const double centers[6] = {0.25, 0, 0, 0.75, 0, 0}, moved[6] = {0.25, 0, 0, 0.7, 0, 0}, radii[2] = {0.3, 0.3};
  hg_grid_def def = hg_default_grid_def();
  hg_contact_key keys[2];
  const int64_t none[2] = {-1, -1}, same[2] = {0, 1};
  const int64_t *previous;
  hg_history *history = make_empty_history();
  hg_grid *grid;
  const hg_pair *pairs;
  const int32_t *shifts;
  size_t count, k;
  int step;
  def.images = HG_ALL_IMAGES;
  def.periodic[0] = 1;
  def.box_max[0] = 1;
  assert_ok(hg_create(&def, &grid));
  assert_ok(hg_insert(grid, 2, centers, radii));
  for (step = 0; step < 2; ++step) {
    assert_ok(hg_query_pairs(grid, &pairs, &count));
    assert_int_equal(2, count);
    assert_ok(hg_query_pair_vectors(grid, NULL, &shifts));
    for (k = 0; k < count; ++k) {
      keys[k].a = pairs[k].a;
      keys[k].b = pairs[k].b;
      keys[k].sub = shifts[3 * k];
    }
    assert_int_equal(1, keys[1].sub - keys[0].sub);
    assert_status(HG_ERR_ARGUMENT, hg_history_update(history, count, pairs, &previous));
    assert_places(history, keys, count, step == 0 ? none : same);
    assert_ok(hg_move(grid, 2, moved, NULL));
  }
  hg_destroy(grid);
  hg_history_destroy(history);
}

TEST(wrong_arguments) {
  const hg_contact_key twice[3] = {{1, 2, 9}, {1, 2, 8}, {1, 2, 9}};
  const int64_t *previous;
  hg_history *history = make_history();
  assert_status(HG_ERR_NULL, hg_history_update_keys(NULL, 0, NULL, &previous));
  assert_status(HG_ERR_NULL, hg_history_update_keys(history, 1, NULL, &previous));
  assert_error_names("keys");
  assert_status(HG_ERR_NULL, hg_history_update_keys(history, 0, NULL, NULL));
  assert_status(HG_ERR_ARGUMENT, hg_history_update_keys(history, 3, twice, &previous));
  assert_error_names("keys[2] = (1, 2, 9) is already listed as keys[0]");
  assert_history(history);
  hg_history_destroy(history);
}

static hg_status update_keys(hg_history *history, size_t count, const hg_pair *pairs) {
  const int64_t *previous;
  return hg_history_update_keys(history, count, keys_of(count, pairs), &previous);
}

TEST(no_memory) { assert_true(refuse_each_allocation_for_many(update_keys) > 3); }

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(sub_keys_tell_contacts_apart),
                                     cmocka_unit_test(all_bits_count),
                                     cmocka_unit_test(pairs_before_and_after),
                                     cmocka_unit_test(images_of_a_pair),
                                     cmocka_unit_test(wrong_arguments),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
