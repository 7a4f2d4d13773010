/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* What the typemaps of python.i call: memory lent in both directions, exceptions, and the visitor. */
#pragma once

#include <hgrid/hgrid.h>

#include <Python.h>
#include <stdlib.h>
#include <string.h>

/* Borrows a C-contiguous buffer of doubles (kind 'd') or of 32-bit integers ('i'). Nonzero: an exception is set. */
static int hgrid_take_buffer(PyObject *object, const char *name, char kind, int dimensions, Py_buffer *view) {
  const char *format;
  size_t size = kind == 'd' ? sizeof(double) : sizeof(int32_t);
  if (PyObject_GetBuffer(object, view, PyBUF_C_CONTIGUOUS | PyBUF_FORMAT) != 0) return -1;
  format = view->format == NULL ? "B" : view->format;
  /* A platform may spell its 32-bit integer as long. */
  if ((format[0] != kind && !(kind == 'i' && format[0] == 'l')) || format[1] != '\0' ||
      view->itemsize != (Py_ssize_t)size || view->ndim != dimensions) {
    PyErr_Format(PyExc_TypeError,
                 "%s: a %d-dimensional buffer of type '%c' is needed, not a %d-dimensional one of '%s'", name,
                 dimensions, kind, view->ndim, format);
    PyBuffer_Release(view);
    return -1;
  }
  return 0;
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

/* A read-only view of memory that the library owns: valid only as long as the library says. */
static PyObject *hgrid_lend(const void *memory, size_t bytes) {
  static char nothing;
  char *start = memory == NULL ? &nothing : (char *)memory;
  return PyMemoryView_FromMemory(start, (Py_ssize_t)bytes, PyBUF_READ);
}

static void *hgrid_copy(const void *source, size_t size) {
  void *copy = malloc(size);
  if (copy == NULL) {
    PyErr_NoMemory();
  } else {
    memcpy(copy, source, size);
  }
  return copy;
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

/* Hands a batch to the Python callable in `context`. A raised exception stays set and stops the visit. */
static int32_t hgrid_visit(void *context, const hg_pair *pairs, size_t count) {
  PyGILState_STATE lock = PyGILState_Ensure();
  PyObject *batch = hgrid_lend(pairs, count * sizeof *pairs);
  PyObject *answer = batch == NULL ? NULL : PyObject_CallFunctionObjArgs((PyObject *)context, batch, NULL);
  int stop = answer == NULL || PyObject_IsTrue(answer) != 0;
  Py_XDECREF(answer);
  Py_XDECREF(batch);
  PyGILState_Release(lock);
  return stop;
}
