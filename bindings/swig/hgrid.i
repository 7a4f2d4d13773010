/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The library as scripting languages see it. Constants and errors are the same for all of them; <language>.i says how
 * numbers travel. What lies between is one of two: objects.i has objects that check what they are given, for users who
 * take the module as it is; calls.i has the bare calls, for the package that Python has on top. */
%module hgrid

%{
#include <hgrid/hgrid.h>
%}

%include <stdint.i>

#if defined(SWIGPYTHON)
%include "python.i"
#elif defined(SWIGLUA)
%include "lua.i"
#elif defined(SWIGOCTAVE)
%include "octave.i"
#else
#error "libhgrid has no SWIG typemaps for this language yet: see bindings/swig/README.md"
#endif

/* A call that fails raises, a call that succeeds returns its results without the status. The language file provides
 * hgrid_raise(status), which turns the status and hg_last_error() into the language's own exception. */
%typemap(out) hg_status {
  if ($1 != HG_OK) {
    hgrid_raise($1);
    SWIG_fail;
  }
  %set_output(VOID_Object);
}

#if defined(SWIGPYTHON)
%include "calls.i"
#else
%include "objects.i"
#endif
