// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The names under which FORTRAN 77 finds its calls: in lower case with an underscore, as gfortran, ifort, flang and
// nvfortran write them, and without one (-fno-underscoring, xlf). No name holds an underscore, so none gets a second.
#include "bindings/f77/calls.hpp"

#include <hgrid/base.h>

#define HG_F77_EXPORT extern "C" __attribute__((visibility("default")))
#define HG_F77_CALL(name, parameters, call)       \
  HG_F77_EXPORT void name##_ parameters { call; } \
  HG_F77_EXPORT void name parameters { call; }

using namespace hgrid::f77;

HG_F77_CALL(hgfnew,
            (int32_t * ih, const int32_t *idim, const int32_t *mode, const double *margin, const int32_t *iper,
             const double *boxmin, const double *boxmax, int32_t *ierr),
            create(ih, *idim, *mode, *margin, iper, boxmin, boxmax, ierr))

HG_F77_CALL(hgdprs,
            (const int32_t *ih, const int32_t *n, const double *x, const double *y, const double *z, const double *r,
             const int32_t *maxpr, int32_t *npr, int32_t *ipair, int32_t *jpair, int32_t *ierr),
            pairs<double>("HGDPRS", {ih, n, x, y, z, r}, *maxpr, npr, ipair, jpair, ierr))

HG_F77_CALL(hgsprs,
            (const int32_t *ih, const int32_t *n, const float *x, const float *y, const float *z, const float *r,
             const int32_t *maxpr, int32_t *npr, int32_t *ipair, int32_t *jpair, int32_t *ierr),
            pairs<float>("HGSPRS", {ih, n, x, y, z, r}, *maxpr, npr, ipair, jpair, ierr))

HG_F77_CALL(hgdlst,
            (const int32_t *ih, const int32_t *n, const double *x, const double *y, const double *z, const double *r,
             const int32_t *maxnb, int32_t *point, int32_t *list, int32_t *ierr),
            lists<double>("HGDLST", {ih, n, x, y, z, r}, *maxnb, point, list, ierr))

HG_F77_CALL(hgslst,
            (const int32_t *ih, const int32_t *n, const float *x, const float *y, const float *z, const float *r,
             const int32_t *maxnb, int32_t *point, int32_t *list, int32_t *ierr),
            lists<float>("HGSLST", {ih, n, x, y, z, r}, *maxnb, point, list, ierr))

// The length of TEXT follows it by value, in 32 bits or 64: the lower half is the same.
HG_F77_CALL(hgfmsg, (char *text, int32_t length), message(text, length))

HG_F77_CALL(hgfend, (int32_t * ih, int32_t *ierr), end(ih, ierr))

HG_F77_CALL(hgfver, (int32_t * major, int32_t *minor, int32_t *patch), hg_version(major, minor, patch))
