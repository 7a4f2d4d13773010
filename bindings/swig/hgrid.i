/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The C interface as scripting languages see it. This file and status.i are shared by all of them; <language>.i says
 * how arrays, handles, lists and visitors travel (README.md lists what it must provide). */
%module hgrid

%{
#include <hgrid/hgrid.h>
%}

%include <stdint.i>
%include <typemaps.i>
%include <constraints.i>

#if defined(SWIGPYTHON)
%include "python.i"
#else
#error "libhgrid has no SWIG typemaps for this language yet: see bindings/swig/README.md"
#endif
%include "status.i"

/* A handle frees its grid; only hg_make makes one. */
%nodefaultctor hg_grid;
typedef struct hg_grid {
  %extend {
    ~hg_grid() { hg_destroy($self); }
  }
} hg_grid;
%ignore hg_destroy;

/* The same for a contact history, made by hg_history_create. */
%nodefaultctor hg_history;
typedef struct hg_history {
  %extend {
    ~hg_history() { hg_history_destroy($self); }
  }
} hg_history;
%ignore hg_history_destroy;

/* A definition starts with the defaults of the library. Pointers and bookkeeping are no business of scripts. */
%extend hg_grid_def {
  hg_grid_def(void) {
    hg_grid_def *def = malloc(sizeof *def);
    if (def != NULL) (void)hg_grid_def_init(def, sizeof *def);
    return def;
  }
}
%ignore hg_grid_def::struct_size;
%ignore hg_grid_def::cell_sizes;
%ignore hg_grid_def::reserved0;
%ignore hg_grid_def::reserved1;
%ignore hg_grid_def_init;
%ignore hg_set_allocator;
%ignore hg_allocator;
%ignore hg_pair;

/* These take or return a size that no script should have to know; the functions below stand in for them. */
%ignore hg_create;
%ignore hg_get_stats;
%ignore hg_query_neighbors;
%ignore hg_history_update;

%apply int *OUTPUT { int *major, int *minor, int *patch };
%apply Pointer NONNULL { const hg_grid_def *def };

%inline %{
/* hg_create with the cell sizes beside the definition, so that no pointer outlives the call; count 0 means none. */
static hg_status hg_make(const hg_grid_def *def, size_t count, const double *cell_sizes, hg_grid **grid) {
  hg_grid_def whole = *def;
  if (count > 0) {
    whole.level_count = count < INT32_MAX ? (int32_t)count : INT32_MAX;
    whole.cell_sizes = cell_sizes;
  }
  return hg_create(&whole, grid);
}

/* hg_get_stats for the struct of this build. */
static hg_status hg_read_stats(hg_grid *grid, hg_grid_stats *stats) { return hg_get_stats(grid, stats, sizeof *stats); }

/* hg_query_neighbors with the lengths of both arrays. */
static hg_status hg_list_neighbors(hg_grid *grid, int32_t list, const int64_t **offsets, size_t *offset_count,
                                   const int32_t **neighbors, size_t *neighbor_count) {
  hg_grid_stats stats;
  hg_status status = hg_query_neighbors(grid, list, offsets, neighbors);
  if (status == HG_OK) status = hg_get_stats(grid, &stats, sizeof stats);
  if (status != HG_OK) return status;
  *offset_count = (size_t)stats.particle_count + 1;
  *neighbor_count = (size_t)(*offsets)[stats.particle_count];
  return HG_OK;
}

/* hg_history_update with the length of its result. */
static hg_status hg_match_pairs(hg_history *history, size_t count, const hg_pair *pairs, const int64_t **previous,
                                size_t *previous_count) {
  *previous_count = count;
  return hg_history_update(history, count, pairs, previous);
}
%}

/* Data of contacts are arrays of the language, which gathers them by itself. */
%ignore hg_history_carry;

%include <hgrid/base.h>
%include <hgrid/types.h>
%include <hgrid/grid.h>
%include <hgrid/history.h>
