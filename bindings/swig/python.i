/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* How arguments and results travel between Python and C. Arrays come in as C-contiguous buffers of the exact type and
 * go out as memoryviews of the library's memory; the package hgrid makes the first and copies the second. */
%{
#include "python_glue.h"
%}

/* Arrays in. */
%define %hgrid_buffer_cleanup(...)
%typemap(arginit) (__VA_ARGS__) { view$argnum.obj = NULL; }
%typemap(freearg) (__VA_ARGS__) { PyBuffer_Release(&view$argnum); }
%enddef

%define %hgrid_counted_array(TYPE, NAME, KIND, DIMENSIONS)
%typemap(in) (size_t count, const TYPE *NAME) (Py_buffer view) {
  if (hgrid_take_buffer($input, #NAME, KIND, DIMENSIONS, &view) != 0) SWIG_fail;
  $1 = (size_t)view.shape[0];
  $2 = ($2_ltype)view.buf;
}
%hgrid_buffer_cleanup(size_t count, const TYPE *NAME)
%enddef
%hgrid_counted_array(double, centers, 'd', 2)
%hgrid_counted_array(double, cell_sizes, 'd', 1)
%hgrid_counted_array(int32_t, ids, 'i', 1)
%hgrid_counted_array(hg_pair, pairs, 'i', 2)

%define %hgrid_plain_array(NAME)
%typemap(in) const double *NAME (Py_buffer view) {
  if ($input == Py_None) {
    $1 = NULL;
  } else {
    if (hgrid_take_buffer($input, #NAME, 'd', 1, &view) != 0) SWIG_fail;
    $1 = ($1_ltype)view.buf;
  }
}
%hgrid_buffer_cleanup(const double *NAME)
%enddef
%hgrid_plain_array(radii)
%hgrid_plain_array(center)

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
%define %hgrid_new_object(TYPE, NAME)
%typemap(in, numinputs=0) TYPE **NAME (TYPE *made = NULL) { $1 = &made; }
%typemap(argout) TYPE **NAME {
  %append_output(SWIG_NewPointerObj(made$argnum, $*1_descriptor, SWIG_POINTER_OWN));
}
%enddef
%hgrid_new_object(hg_grid, grid)
%hgrid_new_object(hg_history, history)

/* Arrays out. */
%define %hgrid_lent_array(TYPE, NAME, COUNT)
%typemap(in, numinputs=0) (const TYPE **NAME, size_t *COUNT) (const TYPE *items = NULL, size_t item_count = 0) {
  $1 = ($1_ltype)&items;
  $2 = &item_count;
}
%typemap(argout) (const TYPE **NAME, size_t *COUNT) {
  %append_output(hgrid_lend(items$argnum, item_count$argnum * sizeof(TYPE)));
}
%enddef
%hgrid_lent_array(hg_pair, pairs, count)
%hgrid_lent_array(int32_t, ids, count)
%hgrid_lent_array(int64_t, offsets, offset_count)
%hgrid_lent_array(int32_t, neighbors, neighbor_count)
%hgrid_lent_array(int64_t, previous, previous_count)

/* Lists of structs out, each a copy owned by its proxy. */
%define %hgrid_struct_list(TYPE, NAME)
%typemap(in, numinputs=0) (const TYPE **NAME, size_t *count) (const TYPE *items = NULL, size_t item_count = 0) {
  $1 = ($1_ltype)&items;
  $2 = &item_count;
}
%typemap(argout) (const TYPE **NAME, size_t *count) {
  PyObject *list = PyList_New(0);
  size_t k;
  for (k = 0; list != NULL && k < item_count$argnum; ++k) {
    void *copy = hgrid_copy(items$argnum + k, sizeof(TYPE));
    PyObject *proxy = copy == NULL ? NULL : SWIG_NewPointerObj(copy, $*1_descriptor, SWIG_POINTER_OWN);
    list = hgrid_append(list, proxy);
  }
  Py_XDECREF($result);
  $result = list;
  if (list == NULL) SWIG_fail;
}
%enddef
%hgrid_struct_list(hg_level, levels)
%hgrid_struct_list(hg_level_cost, costs)

/* A visitor is any callable. An exception that it raises ends the visit and passes on to the caller. */
%typemap(in) (hg_pair_visitor *visit, void *context) {
  $1 = hgrid_visit;
  $2 = $input;
}
%typemap(argout) (hg_pair_visitor *visit, void *context) {
  if (PyErr_Occurred()) {
    Py_CLEAR($result);
    SWIG_fail;
  }
}

/* Calls that may search or build run without the interpreter lock. Those that read the caller's arrays keep it: another
 * Python thread could otherwise change the numbers between their check and their use. */
%define %hgrid_long_call(NAME)
%exception NAME {
  Py_BEGIN_ALLOW_THREADS
  $action
  Py_END_ALLOW_THREADS
}
%enddef
%hgrid_long_call(hg_build)
%hgrid_long_call(hg_query_pairs)
%hgrid_long_call(hg_visit_pairs)
%hgrid_long_call(hg_list_neighbors)
%hgrid_long_call(hg_query_levels)
%hgrid_long_call(hg_query_level_costs)
