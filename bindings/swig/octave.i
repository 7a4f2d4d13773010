/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* How arguments and results travel between Octave and C: tables are matrices, structs are structs, errors have the
 * identifier "hgrid:HG_ERR_...". They are C++ exceptions, so that what a typemap holds must free itself. */
%{
#include "octave_glue.h"
%}

#define hgrid_raise(status) hgrid_raise_status(status)

/* Tables in; what is left out or [] is an empty one without data. */
%typemap(arginit) hgrid_reals, hgrid_integers { memset(&$1, 0, sizeof $1); }
%typemap(in) hgrid_reals (std::vector<double> numbers) {
  hgrid_take_reals($input, "$1_name", numbers, $1);
}
%typemap(in) hgrid_integers (std::vector<int64_t> numbers) {
  hgrid_take_integers($input, "$1_name", numbers, $1);
}
%typemap(arginit) const hgrid_definition *definition { $1 = &made$argnum.definition; }
%typemap(in) const hgrid_definition *definition (HgridDefinition made) { hgrid_take_definition($input, made); }
%typemap(in) double { $1 = hgrid_take_number($input, "$1_name"); }
%typemap(in) int32_t { $1 = hgrid_take_integer($input, "$1_name"); }

/* New objects, freed with their last reference. */
%define %hgrid_new_object(TYPE)
%typemap(in, numinputs=0) TYPE ** (TYPE *made = NULL) { $1 = &made; }
%typemap(argout) TYPE ** { %append_output(SWIG_NewPointerObj(made$argnum, $*1_descriptor, SWIG_POINTER_OWN)); }
%enddef
%hgrid_new_object(hgrid_grid)
%hgrid_new_object(hgrid_history)

/* Tables out. */
%typemap(in, numinputs=0) hgrid_rows * (hgrid_rows made) { memset(&made, 0, sizeof made); $1 = &made; }
%typemap(argout) hgrid_rows * { %append_output(hgrid_matrix_of(*$1)); }
%typemap(freearg) hgrid_rows * { free($1->to_free); }
%typemap(in, numinputs=0) hgrid_lists * (hgrid_lists made) { memset(&made, 0, sizeof made); $1 = &made; }
%typemap(argout) hgrid_lists * {
  %append_output(hgrid_offsets_of(*$1));
  %append_output(hgrid_ids_of(*$1));
}
%typemap(in, numinputs=0) hgrid_records * (hgrid_records made) { memset(&made, 0, sizeof made); $1 = &made; }
%typemap(argout) hgrid_records * { %append_output(hgrid_structs_of(*$1)); }
%typemap(in, numinputs=0) (hgrid_records *counters, hg_grid_stats *room) (hgrid_records made, hg_grid_stats room) {
  $1 = &made;
  $2 = &room;
}
%typemap(argout) (hgrid_records *counters, hg_grid_stats *room) { %append_output(hgrid_structs_of(*$1)); }
%typemap(in, numinputs=0) int32_t *overlaps (int32_t verdict) { $1 = &verdict; }
%typemap(argout) int32_t *overlaps { %append_output(octave_value(*$1 != 0)); }

/* A visitor is a function handle or a name. An error that it raises ends the visit and passes on to the caller. */
%define %hgrid_visitor(TYPE, FORWARD)
%typemap(in) (TYPE *visit, void *context) (HgridVisit visit) {
  visit.function = $input;
  $1 = FORWARD;
  $2 = &visit;
}
%typemap(argout) (TYPE *visit, void *context) {
  if (visit$argnum.error) std::rethrow_exception(visit$argnum.error);
}
%enddef
%hgrid_visitor(hg_pair_visitor, hgrid_visit_pairs_in)
%hgrid_visitor(hg_contact_visitor, hgrid_visit_contacts_in)
