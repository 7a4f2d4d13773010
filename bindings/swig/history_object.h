/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The object History of objects.i. Lists are kept as keys, of which a pair is one with the sub-key 0; places in them
 * count from 1, and 0 is the place of a new contact. */
#pragma once

#include "numbers.h"

typedef struct hgrid_history {
  hg_history *handle;
  size_t columns, former_columns; /* of the last two lists as they were given */
  size_t count, former_count;
} hgrid_history;

/* Makes a history that its object owns. */
static hg_status hgrid_make_history(hgrid_history **history) {
  hgrid_history *made = (hgrid_history *)calloc(1, sizeof *made);
  hg_status status;
  if (made == NULL) return hgrid_refuse(HG_ERR_MEMORY, "no memory for a history");
  made->columns = made->former_columns = 2;
  status = hg_history_create(&made->handle);
  if (status == HG_OK) {
    *history = made;
  } else {
    free(made);
  }
  return status;
}

static void delete_hgrid_history(hgrid_history *self) {
  hg_history_destroy(self->handle);
  free(self);
}

/* A list as keys, which the caller frees; never NULL on success. */
static hg_status hgrid_take_keys(hgrid_integers given, hg_contact_key **keys) {
  size_t k;
  if (given.rows > 0 && given.columns != 2 && given.columns != 3) {
    return hgrid_refuse(HG_ERR_ARGUMENT, "contacts must have 2 or 3 numbers in each row, not %zu", given.columns);
  }
  *keys = (hg_contact_key *)malloc((given.rows + 1) * sizeof **keys);
  if (*keys == NULL) return hgrid_refuse(HG_ERR_MEMORY, "no memory for %zu contacts", given.rows);
  for (k = 0; k < given.rows; ++k) {
    const int64_t *row = given.data + k * given.columns;
    (*keys)[k].a = row[0];
    (*keys)[k].b = row[1];
    (*keys)[k].sub = given.columns == 3 ? row[2] : 0;
  }
  return HG_OK;
}

static void hgrid_remember(hgrid_history *self, hgrid_integers given) {
  self->former_columns = self->columns;
  self->former_count = self->count;
  self->columns = given.columns == 3 ? 3 : 2;
  self->count = given.rows;
}

static hgrid_rows hgrid_places_of(const int64_t *places, size_t count) {
  hgrid_rows made = hgrid_list_of(places, 'l', count);
  made.add = 1;
  return made;
}

/* Keys as they were given: as pairs without the third number. */
static hgrid_rows hgrid_contacts_of(const hg_contact_key *keys, size_t count, size_t columns) {
  hgrid_rows made = hgrid_rows_of(keys, 'l', count, columns);
  made.stride = 3;
  return made;
}

static hg_status hgrid_history_update(hgrid_history *self, hgrid_integers contacts, hgrid_rows *previous) {
  hg_contact_key *keys = NULL;
  const int64_t *places = NULL;
  hg_status status = hgrid_take_keys(contacts, &keys);
  if (status == HG_OK) status = hg_history_update_keys(self->handle, contacts.rows, keys, &places);
  free(keys);
  if (status == HG_OK) hgrid_remember(self, contacts);
  *previous = hgrid_places_of(places, contacts.rows);
  return status;
}

static hg_status hgrid_history_carry(hgrid_history *self, hgrid_reals items, hgrid_rows *carried) {
  size_t columns = items.columns > 0 ? items.columns : 1;
  double *moved;
  hg_status status;
  if (items.rows != self->former_count) {
    return hgrid_refuse(HG_ERR_ARGUMENT, "items must have %zu rows, one for each contact of the list before, not %zu",
                        self->former_count, items.rows);
  }
  moved = (double *)malloc((self->count * columns + 1) * sizeof *moved);
  if (moved == NULL) return hgrid_refuse(HG_ERR_MEMORY, "no memory for %zu items", self->count);
  status = hg_history_carry(self->handle, columns * sizeof *moved, items.data, moved);
  if (status != HG_OK) {
    free(moved);
    return status;
  }
  *carried = hgrid_rows_of(moved, 'd', self->count, columns);
  carried->is_list = columns == 1;
  carried->to_free = moved;
  return HG_OK;
}

static hg_status hgrid_history_ended(hgrid_history *self, hgrid_rows *contacts, hgrid_rows *places) {
  const hg_contact_key *keys = NULL;
  const int64_t *where = NULL;
  size_t count = 0;
  hg_status status = hg_history_ended_keys(self->handle, &keys, &where, &count);
  *contacts = hgrid_contacts_of(keys, count, self->former_columns);
  *places = hgrid_places_of(where, count);
  return status;
}

static hg_status hgrid_history_contacts(hgrid_history *self, hgrid_rows *contacts) {
  const hg_contact_key *keys = NULL;
  size_t count = 0;
  hg_status status = hg_history_keys(self->handle, &keys, &count);
  *contacts = hgrid_contacts_of(keys, count, self->columns);
  return status;
}

static hg_status hgrid_history_restore(hgrid_history *self, hgrid_integers contacts) {
  hg_contact_key *keys = NULL;
  hg_status status = hgrid_take_keys(contacts, &keys);
  if (status == HG_OK) status = hg_history_restore_keys(self->handle, contacts.rows, keys);
  free(keys);
  if (status == HG_OK) hgrid_remember(self, contacts);
  return status;
}

static hg_status hgrid_history_clear(hgrid_history *self) {
  const hgrid_integers nothing = {NULL, 0, 0};
  hg_status status = hg_history_clear(self->handle);
  if (status == HG_OK) hgrid_remember(self, nothing);
  return status;
}
