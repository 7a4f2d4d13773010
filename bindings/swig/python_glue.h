/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* What the typemaps of python.i call: memory lent in both directions, exceptions, and the visitor. */
#pragma once

#include <hgrid/hgrid.h>

#include <Python.h>
#include <stdlib.h>
#include <string.h>

/* How buffers spell int64_t. */
#define HGRID_INT64 (sizeof(long) == sizeof(int64_t) ? "l" : "q")

/* Borrows a C-contiguous buffer of doubles (kind 'd'), of 32-bit integers ('i') or of 64-bit ones ('q'); None gives
 * NULL. Nonzero: an exception is set. */
static int hgrid_take_buffer(PyObject *object, const char *name, char kind, Py_buffer *view) {
  const char *format;
  size_t size = kind == 'i' ? sizeof(int32_t) : sizeof(int64_t);
  view->buf = NULL;
  if (object == Py_None) return 0;
  if (PyObject_GetBuffer(object, view, PyBUF_C_CONTIGUOUS | PyBUF_FORMAT) != 0) return -1;
  format = view->format == NULL ? "B" : view->format;
  /* A platform may spell either integer as long. */
  if ((format[0] != kind && !(kind != 'd' && format[0] == 'l')) || format[1] != '\0' ||
      view->itemsize != (Py_ssize_t)size || view->ndim == 0) {
    PyErr_Format(PyExc_TypeError, "%s: an array of type '%c' is needed, not one of '%s'", name, kind, format);
    PyBuffer_Release(view);
    return -1;
  }
  return 0;
}

/* Whether a call, declared as SWIG writes it, takes an array: a pointer to what is constant. A pointer to such a
 * pointer is a result. */
static int hgrid_reads_arrays(const char *declaration) {
  return strstr(declaration, " const *,") != NULL || strstr(declaration, " const *)") != NULL;
}

/* Reads a sequence of three numbers. Nonzero: an exception is set. */
static int hgrid_take_axes(PyObject *object, const char *name, double values[3]) {
  int axis;
  PyObject *tuple = PySequence_Tuple(object);
  if (tuple == NULL) return -1;
  if (PyTuple_GET_SIZE(tuple) != 3) {
    PyErr_Format(PyExc_ValueError, "%s: three numbers are needed, not %zd", name, PyTuple_GET_SIZE(tuple));
  }
  for (axis = 0; axis < 3 && !PyErr_Occurred(); ++axis) values[axis] = PyFloat_AsDouble(PyTuple_GET_ITEM(tuple, axis));
  Py_DECREF(tuple);
  return PyErr_Occurred() ? -1 : 0;
}

/* A read-only view of `count` rows of `columns` numbers that the library owns: valid only as long as it says. */
static PyObject *hgrid_lend(const void *memory, size_t count, const char *format, Py_ssize_t columns) {
  static char nothing;
  Py_ssize_t size = format[0] == 'i' ? (Py_ssize_t)sizeof(int32_t) : (Py_ssize_t)sizeof(int64_t);
  Py_ssize_t shape[2], strides[2];
  Py_buffer view;
  memset(&view, 0, sizeof view);
  shape[0] = (Py_ssize_t)count;
  shape[1] = columns;
  strides[0] = columns * size;
  strides[1] = size;
  view.buf = memory == NULL ? &nothing : (char *)memory;
  view.len = shape[0] * strides[0];
  view.readonly = 1;
  view.itemsize = size;
  view.format = (char *)format;
  view.ndim = columns == 1 ? 1 : 2;
  view.shape = shape;
  view.strides = strides;
  return PyMemoryView_FromBuffer(&view);
}

/* A proxy of this type for a copy of a struct. */
static PyObject *hgrid_copy(const void *source, size_t size, swig_type_info *type) {
  void *copy = malloc(size);
  if (copy == NULL) return PyErr_NoMemory();
  memcpy(copy, source, size);
  return SWIG_NewPointerObj(copy, type, SWIG_POINTER_OWN);
}

/* Appends and takes over `item`. NULL with an exception set, and the list released, if either fails. */
static PyObject *hgrid_append(PyObject *list, PyObject *item) {
  int failed = item == NULL || PyList_Append(list, item) != 0;
  Py_XDECREF(item);
  if (failed) Py_CLEAR(list);
  return list;
}

/* Raises the exception that hgrid/errors.py has for this status, unless a visitor's own exception is on its way. */
static void hgrid_raise(hg_status status) {
  PyObject *text, *module, *error;
  if (PyErr_Occurred()) return;
  /* Copied first: importing runs Python code, which may call the library again. */
  text = PyUnicode_DecodeUTF8(hg_last_error(), (Py_ssize_t)strlen(hg_last_error()), "replace");
  module = text == NULL ? NULL : PyImport_ImportModule("hgrid.errors");
  error = module == NULL ? NULL : PyObject_CallMethod(module, "from_status", "iO", (int)status, text);
  if (error != NULL) PyErr_SetObject((PyObject *)Py_TYPE(error), error);
  Py_XDECREF(error);
  Py_XDECREF(module);
  Py_XDECREF(text);
}

/* Hands a batch, which it takes over, to the Python callable in `context`. Nonzero: the visit is to stop. */
static int32_t hgrid_hand_over(void *context, PyObject *batch) {
  PyObject *answer = batch == NULL ? NULL : PyObject_CallFunctionObjArgs((PyObject *)context, batch, NULL);
  int stop = answer == NULL || PyObject_IsTrue(answer) != 0;
  Py_XDECREF(answer);
  Py_XDECREF(batch);
  return stop;
}

/* The visitors. A raised exception stays set and stops the visit. */
static int32_t hgrid_visit(void *context, const hg_pair *pairs, size_t count) {
  PyGILState_STATE lock = PyGILState_Ensure();
  int32_t stop = hgrid_hand_over(context, hgrid_lend(pairs, count, "i", 2));
  PyGILState_Release(lock);
  return stop;
}

/* The batch is a list: both ids, the components of the vectors, and the reach. */
static int32_t hgrid_visit_contacts(void *context, const hg_contact_batch *batch) {
  PyGILState_STATE lock = PyGILState_Ensure();
  const double *numbers[4];
  PyObject *list = PyList_New(0);
  int32_t stop;
  size_t k;
  numbers[0] = batch->dx;
  numbers[1] = batch->dy;
  numbers[2] = batch->dz;
  numbers[3] = batch->reach;
  if (list != NULL) list = hgrid_append(list, hgrid_lend(batch->a, batch->count, "i", 1));
  if (list != NULL) list = hgrid_append(list, hgrid_lend(batch->b, batch->count, "i", 1));
  for (k = 0; list != NULL && k < 4; ++k) {
    if (numbers[k] != NULL) list = hgrid_append(list, hgrid_lend(numbers[k], batch->count, "d", 1));
  }
  stop = hgrid_hand_over(context, list);
  PyGILState_Release(lock);
  return stop;
}
