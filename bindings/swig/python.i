/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* How arguments and results travel between Python and C. Arrays come in as C-contiguous buffers of the exact type and
 * go out as memoryviews of the library's memory; the package hgrid makes the first, checks their shapes, and copies the
 * second. Typemaps go by type, and by the name of the first where they take several arguments: a new call with arguments
 * like those of the others needs nothing here. */
%{
#include "python_glue.h"
%}

/* Arrays in: any number of them, the first with its length. None is NULL. */
%define %hgrid_array_in(TYPE, KIND)
%typemap(arginit) const TYPE *, (size_t count, const TYPE *) { view$argnum.obj = NULL; }
%typemap(in) const TYPE * (Py_buffer view) {
  if (hgrid_take_buffer($input, "$1_name", KIND, &view) != 0) SWIG_fail;
  $1 = ($1_ltype)view.buf;
}
%typemap(in) (size_t count, const TYPE *) (Py_buffer view) {
  if (hgrid_take_buffer($input, "$2_name", KIND, &view) != 0) SWIG_fail;
  $1 = view.buf == NULL ? 0 : (size_t)view.shape[0];
  $2 = ($2_ltype)view.buf;
}
%typemap(freearg) const TYPE *, (size_t count, const TYPE *) { PyBuffer_Release(&view$argnum); }
%enddef
%hgrid_array_in(double, 'd')
%hgrid_array_in(int32_t, 'i')
%hgrid_array_in(hg_pair, 'i')
%hgrid_array_in(hg_contact_key, 'q')

/* Members with one value per axis. */
%typemap(in) double [3] (double values[3]) {
  if (hgrid_take_axes($input, "$1_name", values) != 0) SWIG_fail;
  $1 = values;
}
%typemap(in) int32_t [3] (double values[3], int32_t flags[3]) {
  int axis;
  if (hgrid_take_axes($input, "$1_name", values) != 0) SWIG_fail;
  for (axis = 0; axis < 3; ++axis) flags[axis] = values[axis] != 0;
  $1 = flags;
}

/* A new object, owned by its proxy. */
%define %hgrid_new_object(TYPE)
%typemap(in, numinputs=0) TYPE ** (TYPE *made = NULL) { $1 = &made; }
%typemap(argout) TYPE ** { %append_output(SWIG_NewPointerObj(made$argnum, $*1_descriptor, SWIG_POINTER_OWN)); }
%enddef
%hgrid_new_object(hg_grid)
%hgrid_new_object(hg_history)

/* Arrays out: rows of COLUMNS numbers. */
%define %hgrid_lent_array(TYPE, NAME, FORMAT, COLUMNS)
%typemap(in, numinputs=0) (const TYPE **NAME, size_t *) (const TYPE *items = NULL, size_t item_count = 0) {
  $1 = ($1_ltype)&items;
  $2 = &item_count;
}
%typemap(argout) (const TYPE **NAME, size_t *) {
  %append_output(hgrid_lend(items$argnum, item_count$argnum, FORMAT, COLUMNS));
}
%enddef
%hgrid_lent_array(hg_pair, pairs, "i", 2)
%hgrid_lent_array(hg_contact_key, keys, HGRID_INT64, 3)
%hgrid_lent_array(int32_t, ids, "i", 1)

/* Compressed rows out. C does not tell how many there are: the package does, as an argument in their place. */
%typemap(in) (const int64_t **offsets, const int32_t **) (const int64_t *offsets = NULL, const int32_t *ids = NULL, size_t rows) {
  rows = PyLong_AsSize_t($input);
  if (PyErr_Occurred()) SWIG_fail;
  $1 = ($1_ltype)&offsets;
  $2 = ($2_ltype)&ids;
}
%typemap(argout) (const int64_t **offsets, const int32_t **) {
  %append_output(hgrid_lend(offsets$argnum, rows$argnum + 1, HGRID_INT64, 1));
  %append_output(hgrid_lend(ids$argnum, (size_t)offsets$argnum[rows$argnum], "i", 1));
}

/* Vectors of pairs out, flat. C does not tell how many numbers there are: the package does. */
%typemap(in) (const double **vectors, const int32_t **shifts) (const double *vectors = NULL, const int32_t *shifts = NULL, size_t numbers) {
  numbers = PyLong_AsSize_t($input);
  if (PyErr_Occurred()) SWIG_fail;
  $1 = ($1_ltype)&vectors;
  $2 = ($2_ltype)&shifts;
}
%typemap(argout) (const double **vectors, const int32_t **shifts) {
  %append_output(hgrid_lend(vectors$argnum, numbers$argnum, "d", 1));
  %append_output(hgrid_lend(shifts$argnum, numbers$argnum, "i", 1));
}

/* A list of contacts in, and one number for each of them out; contacts and one number for each out. */
%define %hgrid_contacts(TYPE, NAME, KIND, FORMAT, COLUMNS)
%typemap(arginit) (size_t count, const TYPE *NAME, const int64_t **) { view$argnum.obj = NULL; }
%typemap(in) (size_t count, const TYPE *NAME, const int64_t **) (Py_buffer view, const int64_t *places = NULL) {
  if (hgrid_take_buffer($input, "$2_name", KIND, &view) != 0) SWIG_fail;
  $1 = (size_t)view.shape[0];
  $2 = ($2_ltype)view.buf;
  $3 = ($3_ltype)&places;
}
%typemap(argout) (size_t count, const TYPE *NAME, const int64_t **) {
  %append_output(hgrid_lend(places$argnum, $1, HGRID_INT64, 1));
}
%typemap(freearg) (size_t count, const TYPE *NAME, const int64_t **) { PyBuffer_Release(&view$argnum); }
%typemap(in, numinputs=0) (const TYPE **NAME, const int64_t **places, size_t *count) (const TYPE *items = NULL, const int64_t *places = NULL, size_t item_count = 0) {
  $1 = ($1_ltype)&items;
  $2 = ($2_ltype)&places;
  $3 = &item_count;
}
%typemap(argout) (const TYPE **NAME, const int64_t **places, size_t *count) {
  %append_output(hgrid_lend(items$argnum, item_count$argnum, FORMAT, COLUMNS));
  %append_output(hgrid_lend(places$argnum, item_count$argnum, HGRID_INT64, 1));
}
%enddef
%hgrid_contacts(hg_pair, pairs, 'i', "i", 2)
%hgrid_contacts(hg_contact_key, keys, 'q', HGRID_INT64, 3)

/* Structs out, each a copy owned by its proxy: lists of them, or one of the size of this build. */
%define %hgrid_struct_list(TYPE, NAME)
%typemap(in, numinputs=0) (const TYPE **NAME, size_t *) (const TYPE *items = NULL, size_t item_count = 0) {
  $1 = ($1_ltype)&items;
  $2 = &item_count;
}
%typemap(argout) (const TYPE **NAME, size_t *) {
  PyObject *list = PyList_New(0);
  size_t k;
  for (k = 0; list != NULL && k < item_count$argnum; ++k) {
    list = hgrid_append(list, hgrid_copy(items$argnum + k, sizeof(TYPE), $*1_descriptor));
  }
  Py_XDECREF($result);
  $result = list;
  if (list == NULL) SWIG_fail;
}
%enddef
%hgrid_struct_list(hg_level, levels)
%hgrid_struct_list(hg_level_cost, costs)
%typemap(in, numinputs=0) (hg_grid_stats *stats, size_t struct_size) (hg_grid_stats counters) {
  $1 = &counters;
  $2 = sizeof counters;
}
%typemap(argout) (hg_grid_stats *stats, size_t struct_size) {
  %append_output(hgrid_copy($1, $2, $1_descriptor));
}

/* A visitor is any callable. An exception that it raises ends the visit and passes on to the caller. */
%define %hgrid_visitor(TYPE, FORWARD)
%typemap(in) (TYPE *visit, void *context) {
  $1 = FORWARD;
  $2 = $input;
}
%typemap(argout) (TYPE *visit, void *context) {
  if (PyErr_Occurred()) {
    Py_CLEAR($result);
    SWIG_fail;
  }
}
%enddef
%hgrid_visitor(hg_pair_visitor, hgrid_visit)
%hgrid_visitor(hg_contact_visitor, hgrid_visit_contacts)

/* For what follows: calls run without the interpreter lock. Those that read arrays of the caller keep it: another Python thread
 * could otherwise change the numbers between their check and their use. */
%define %hgrid_long_calls
%exception {
  PyThreadState *unlocked = hgrid_reads_arrays("$decl") ? NULL : PyEval_SaveThread();
  $action
  if (unlocked != NULL) PyEval_RestoreThread(unlocked);
}
%enddef
