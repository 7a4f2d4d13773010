/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Numbers on their way between a language and the objects of objects.i: what each language turns its own tables or
 * matrices into, and what it makes them of. In C, and in C++ where a language needs it. */
#pragma once

#include <hgrid/hgrid.h>

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A table of the caller, row after row; a plain list has rows of one number. The typemap frees `data`, which is NULL
 * where nothing was given. */
typedef struct hgrid_reals {
  double *data;
  size_t rows, columns;
} hgrid_reals;

typedef struct hgrid_integers {
  int64_t *data;
  size_t rows, columns;
} hgrid_integers;

/* A table for the caller. `type`: 'i' 32-bit integers, 'l' 64-bit ones, 'd' doubles. */
typedef struct hgrid_rows {
  const void *data;
  char type;
  int is_list;    /* a list of plain numbers */
  int add;        /* to each integer: 1 where a place is counted from 1 */
  size_t rows;    /* how many there are */
  size_t columns; /* numbers of a row */
  size_t stride;  /* numbers from a row to the next */
  void *to_free;  /* NULL where the library owns the data */
} hgrid_rows;

/* Rows of different lengths for the caller: row k holds ids[offsets[k]] .. ids[offsets[k + 1] - 1]. */
typedef struct hgrid_lists {
  const int64_t *offsets;
  const int32_t *ids;
  size_t count;
} hgrid_lists;

static hgrid_rows hgrid_rows_of(const void *data, char type, size_t rows, size_t columns) {
  hgrid_rows made;
  memset(&made, 0, sizeof made);
  made.data = data;
  made.type = type;
  made.rows = rows;
  made.columns = made.stride = columns;
  return made;
}

static hgrid_rows hgrid_list_of(const void *data, char type, size_t count) {
  hgrid_rows made = hgrid_rows_of(data, type, count, 1);
  made.is_list = 1;
  return made;
}

static int64_t hgrid_integer_at(const hgrid_rows *rows, size_t row, size_t column) {
  size_t place = row * rows->stride + column;
  return (rows->type == 'i' ? ((const int32_t *)rows->data)[place] : ((const int64_t *)rows->data)[place]) + rows->add;
}

static double hgrid_real_at(const hgrid_rows *rows, size_t row, size_t column) {
  return rows->type == 'd' ? ((const double *)rows->data)[row * rows->stride + column]
                           : (double)hgrid_integer_at(rows, row, column);
}

/* A refusal in the manner of the library: a status, and a text for hg_last_error. */
static hg_status hgrid_refuse(hg_status status, const char *format, ...) {
  char text[256];
  va_list arguments;
  va_start(arguments, format);
  (void)vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  hg_set_last_error(text);
  return status;
}

/* Whether there are `columns` numbers in each row. */
static hg_status hgrid_check_rows(hgrid_reals table, const char *name, size_t columns) {
  if (table.rows == 0 || table.columns == columns) return HG_OK;
  return hgrid_refuse(HG_ERR_ARGUMENT, "%s must have %zu numbers in each row, not %zu", name, columns, table.columns);
}

/* Whether the table is a list of `count` numbers, standing or lying. */
static hg_status hgrid_check_list(size_t rows, size_t columns, const char *name, size_t count) {
  size_t given = rows * columns;
  if (given > 0 && rows != 1 && columns != 1) {
    return hgrid_refuse(HG_ERR_ARGUMENT, "%s must be a list of numbers, not %zu rows of %zu", name, rows, columns);
  }
  if (given == count) return HG_OK;
  return hgrid_refuse(HG_ERR_ARGUMENT, "%s must hold %zu numbers, not %zu", name, count, given);
}

/* A list of 32-bit integers, which the caller frees; never NULL on success. */
static hg_status hgrid_narrow(hgrid_integers table, const char *name, int32_t **list) {
  size_t count = table.rows * table.columns, k;
  hg_status status = hgrid_check_list(table.rows, table.columns, name, count);
  if (status != HG_OK) return status;
  *list = (int32_t *)malloc((count + 1) * sizeof **list);
  if (*list == NULL) return hgrid_refuse(HG_ERR_MEMORY, "no memory for %zu numbers of %s", count, name);
  for (k = 0; k < count; ++k) {
    (*list)[k] = (int32_t)table.data[k];
    if ((*list)[k] == table.data[k]) continue;
    status = hgrid_refuse(HG_ERR_ARGUMENT, "%s[%zu] = %lld does not fit in 32 bits", name, k, (long long)table.data[k]);
    free(*list);
    return status;
  }
  return HG_OK;
}
