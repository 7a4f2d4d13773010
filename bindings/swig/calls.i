/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The calls of the C interface one by one, for a language that has a package of its own on top: it checks shapes and
 * gathers arrays. <language>.i says how arrays, handles, lists and visitors travel (README.md lists what it must
 * provide). */
%include <typemaps.i>
%include <constraints.i>

/* A handle frees its grid; only hg_make makes one. */
%nodefaultctor hg_grid;
typedef struct hg_grid {
  %extend {
    ~hg_grid() { hg_destroy($self); }
  }
} hg_grid;
%ignore hg_destroy;
/* Texts come from this library alone. */
%ignore hg_set_last_error;

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
%ignore hg_contact_key;
%ignore hg_array;
%ignore hg_contact_batch;

%apply int *OUTPUT { int *major, int *minor, int *patch };
%apply Pointer NONNULL { const hg_grid_def *def };

/* hg_create with the cell sizes beside the definition, so that no pointer outlives the call; count 0 means none. */
%ignore hg_create;
%inline %{
static hg_status hg_make(const hg_grid_def *def, size_t count, const double *cell_sizes, hg_grid **grid) {
  hg_grid_def whole = *def;
  if (count > 0) {
    whole.level_count = count < INT32_MAX ? (int32_t)count : INT32_MAX;
    whole.cell_sizes = cell_sizes;
  }
  return hg_create(&whole, grid);
}
%}

/* Arrays of the language are gathered before they come here, and pairs travel as one array. */
%ignore hg_set_arrays;
%ignore hg_insert_arrays;
%ignore hg_move_arrays;
%ignore hg_copy_pairs;
%ignore hg_copy_neighbors;

%apply int *OUTPUT { int32_t *overlaps };

/* Data of contacts are arrays of the language, which gathers them by itself. */
%ignore hg_history_carry;

%include <hgrid/base.h>
%include <hgrid/types.h>
%hgrid_long_calls
%include <hgrid/grid.h>
%exception;
%include <hgrid/history.h>
