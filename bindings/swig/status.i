/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* A call that fails raises, a call that succeeds returns its results without the status. The language file provides
 * hgrid_raise(status), which turns the status and hg_last_error() into the language's own exception. */
%typemap(out) hg_status {
  if ($1 != HG_OK) {
    hgrid_raise($1);
    SWIG_fail;
  }
  %set_output(VOID_Object);
}
