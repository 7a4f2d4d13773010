/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The calls of hgrid/mpi.h for the package hgrid.mpi: an extension of its own, so that hgrid itself never sees MPI. */
%module(package="hgrid") mpi_capi

%{
#include "bindings/swig/python_glue.h"

#include <hgrid/mpi.h>

/* Both families of MPI in Debian; others keep the handles of one of them. */
#if defined(OPEN_MPI)
#define HGRID_MPI_FAMILY "Open MPI"
#elif defined(MPICH_VERSION) || defined(I_MPI_VERSION)
#define HGRID_MPI_FAMILY "MPICH"
#else
#define HGRID_MPI_FAMILY "unknown"
#endif
%}
%include <exception.i>
%import(module="hgrid.capi") "../hgrid.i"

%constant const char *HG_MPI_FAMILY = HGRID_MPI_FAMILY;

/* A handle is destroyed by the package alone: that is collective, and the garbage collector is not. */
typedef struct hg_mpi hg_mpi;
%typemap(in, numinputs=0) hg_mpi ** (hg_mpi *made = NULL) { $1 = &made; }
%typemap(argout) hg_mpi ** { %append_output(SWIG_NewPointerObj(made$argnum, $*1_descriptor, 0)); }

%hgrid_array_in(int64_t, 'q')
%apply int *OUTPUT { int32_t *ghosts_changed };
%typemap(in, numinputs=0) size_t *new_count (size_t number = 0) { $1 = &number; }
%typemap(argout) size_t *new_count { %append_output(PyLong_FromSize_t(*$1)); }

/* Rows of any type, as bytes. */
%typemap(arginit) const void *, void *after, void *ghosts, double *owned { view$argnum.obj = NULL; }
%typemap(in) const void * (Py_buffer view) {
  if (PyObject_GetBuffer($input, &view, PyBUF_C_CONTIGUOUS) != 0) SWIG_fail;
  $1 = view.buf;
}
%typemap(in) void *after (Py_buffer view), void *ghosts (Py_buffer view), double *owned (Py_buffer view) {
  if (PyObject_GetBuffer($input, &view, PyBUF_C_CONTIGUOUS | PyBUF_WRITABLE) != 0) SWIG_fail;
  $1 = ($1_ltype)view.buf;
}
%typemap(freearg) const void *, void *after, void *ghosts, double *owned { PyBuffer_Release(&view$argnum); }

/* Particles out; C does not tell the dimension: the package does, as an argument in their place. */
%typemap(in) (size_t *count, const int64_t **gids, const double **centers, const double **radii)
  (size_t rows = 0, const int64_t *gids = NULL, const double *centers = NULL, const double *radii = NULL, size_t axes) {
  axes = PyLong_AsSize_t($input);
  if (PyErr_Occurred()) SWIG_fail;
  $1 = &rows;
  $2 = ($2_ltype)&gids;
  $3 = ($3_ltype)&centers;
  $4 = ($4_ltype)&radii;
}
%typemap(argout) (size_t *count, const int64_t **gids, const double **centers, const double **radii) {
  %append_output(hgrid_lend(gids$argnum, rows$argnum, HGRID_INT64, 1));
  %append_output(hgrid_lend(centers$argnum, rows$argnum, "d", (Py_ssize_t)axes$argnum));
  %append_output(hgrid_lend(radii$argnum, rows$argnum, "d", 1));
}
%typemap(in) (size_t *count, const int64_t **gids, const int32_t **owners, const double **centers, const double **radii)
  (size_t rows = 0, const int64_t *gids = NULL, const int32_t *owners = NULL, const double *centers = NULL,
   const double *radii = NULL, size_t axes) {
  axes = PyLong_AsSize_t($input);
  if (PyErr_Occurred()) SWIG_fail;
  $1 = &rows;
  $2 = ($2_ltype)&gids;
  $3 = ($3_ltype)&owners;
  $4 = ($4_ltype)&centers;
  $5 = ($5_ltype)&radii;
}
%typemap(argout) (size_t *count, const int64_t **gids, const int32_t **owners, const double **centers, const double **radii) {
  %append_output(hgrid_lend(gids$argnum, rows$argnum, HGRID_INT64, 1));
  %append_output(hgrid_lend(owners$argnum, rows$argnum, "i", 1));
  %append_output(hgrid_lend(centers$argnum, rows$argnum, "d", (Py_ssize_t)axes$argnum));
  %append_output(hgrid_lend(radii$argnum, rows$argnum, "d", 1));
}
%typemap(in, numinputs=0) (hg_mpi_stats *stats, size_t struct_size) (hg_mpi_stats counters) {
  $1 = &counters;
  $2 = sizeof counters;
}
%typemap(argout) (hg_mpi_stats *stats, size_t struct_size) {
  %append_output(hgrid_copy($1, $2, $1_descriptor));
}

/* A communicator travels as the integer that Fortran knows it by, which mpi4py tells. */
%ignore hg_mpi_create;
%ignore hg_mpi_create_f;
%ignore hg_mpi_def;
%ignore hg_mpi_def_init;
%inline %{
static hg_status hg_mpi_make(int32_t comm, const hg_grid_def *def, size_t count, const double *cell_sizes,
                             int32_t balancer, int32_t verify, double imbalance, hg_mpi **mpi) {
  hg_grid_def whole = *def;
  hg_mpi_def ranks;
  hg_status status = hg_mpi_def_init(&ranks, sizeof ranks);
  if (status != HG_OK) return status;
  ranks.balancer = balancer;
  ranks.verify = verify;
  ranks.imbalance = imbalance;
  if (count > 0) {
    whole.level_count = count < INT32_MAX ? (int32_t)count : INT32_MAX;
    whole.cell_sizes = cell_sizes;
  }
  return hg_mpi_create_f(comm, &whole, &ranks, mpi);
}

/* What a rank calls whose own arguments could not even be read: the collective call, with what the library refuses, so
 * that the other ranks fail with it in place of waiting. */
static hg_status hg_mpi_refuse_create(int32_t comm) {
  hg_mpi *none = NULL;
  const hg_grid_def nothing = {0};
  return hg_mpi_create_f(comm, &nothing, NULL, &none);
}
static hg_status hg_mpi_refuse_set(hg_mpi *mpi) { return hg_mpi_set(mpi, SIZE_MAX, NULL, NULL, NULL); }
static hg_status hg_mpi_refuse_move(hg_mpi *mpi) { return hg_mpi_move(mpi, SIZE_MAX, NULL, NULL, NULL); }
static hg_status hg_mpi_refuse_migrate(hg_mpi *mpi) { return hg_mpi_migrate(mpi, SIZE_MAX, NULL, NULL); }
static hg_status hg_mpi_refuse_forward(hg_mpi *mpi) { return hg_mpi_forward(mpi, SIZE_MAX, NULL, NULL); }
static hg_status hg_mpi_refuse_reverse_add(hg_mpi *mpi) { return hg_mpi_reverse_add(mpi, SIZE_MAX, NULL, NULL); }
static hg_status hg_mpi_refuse_set_group_pair(hg_mpi *mpi) { return hg_mpi_set_group_pair(mpi, -1, -1, 0); }
static hg_status hg_mpi_refuse_set_groups(hg_mpi *mpi) {
  const int32_t none = 0;
  return hg_mpi_set_groups(mpi, SIZE_MAX, &none);
}
static hg_status hg_mpi_refuse_set_bodies(hg_mpi *mpi) {
  const int32_t none = 0;
  return hg_mpi_set_bodies(mpi, SIZE_MAX, &none);
}
%}

%hgrid_long_calls
%include <hgrid/mpi.h>
%exception;
