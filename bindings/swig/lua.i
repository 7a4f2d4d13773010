/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* How arguments and results travel between Lua and C: a table of rows is a list of lists, structs are tables with names,
 * errors are strings raised by error(). */
%{
#include "lua_glue.h"
%}

#define hgrid_raise(status) hgrid_raise_in(L)
/* A call without results pushes none. */
#define %set_output(OBJECT)

/* Tables in; what is left out or nil is an empty one without data. */
%define %hgrid_table_in(TYPE, LETTER)
%typemap(arginit) TYPE { memset(&$1, 0, sizeof $1); }
%typemap(in) TYPE {
  void *data = NULL;
  int failed = !lua_isnil(L, $input) && hgrid_take_table(L, $input, "$1_name", LETTER, &data, &$1.rows, &$1.columns) != 0;
  $1.data = data;
  if (failed) SWIG_fail;
}
%typemap(freearg) TYPE { free($1.data); }
%enddef
%hgrid_table_in(hgrid_reals, 'd')
%hgrid_table_in(hgrid_integers, 'l')

%typemap(arginit) const hgrid_definition *definition { hgrid_definition_begin(&made$argnum); $1 = &made$argnum; }
%typemap(in) const hgrid_definition *definition (hgrid_definition made) {
  if (!lua_isnil(L, $input) && hgrid_take_definition(L, $input, &made) != 0) SWIG_fail;
}
%typemap(freearg) const hgrid_definition *definition { free(made$argnum.cell_sizes.data); }

%typemap(in) double {
  if (lua_type(L, $input) != LUA_TNUMBER) {
    hgrid_complain(L, "$1_name is %s, not a number", luaL_typename(L, $input));
    SWIG_fail;
  }
  $1 = lua_tonumber(L, $input);
}
%typemap(in) int32_t {
  if (hgrid_take_integer(L, $input, "$1_name", &$1) != 0) SWIG_fail;
}

/* New objects, freed by the garbage collector. */
%define %hgrid_new_object(TYPE)
%typemap(in, numinputs=0) TYPE ** (TYPE *made = NULL) { $1 = &made; }
%typemap(argout) TYPE ** { SWIG_NewPointerObj(L, made$argnum, $*1_descriptor, 1); SWIG_arg++; }
%enddef
%hgrid_new_object(hgrid_grid)
%hgrid_new_object(hgrid_history)

/* Tables out. */
%define %hgrid_table_out(TYPE, PUSH)
%typemap(in, numinputs=0) TYPE * (TYPE made) { memset(&made, 0, sizeof made); $1 = &made; }
%typemap(argout) TYPE * { PUSH(L, $1); SWIG_arg++; }
%enddef
%hgrid_table_out(hgrid_rows, hgrid_push_rows)
%hgrid_table_out(hgrid_lists, hgrid_push_lists)
%hgrid_table_out(hgrid_records, hgrid_push_records)
%typemap(freearg) hgrid_rows * { free($1->to_free); }
%typemap(in, numinputs=0) (hgrid_records *counters, hg_grid_stats *room) (hgrid_records made, hg_grid_stats room) {
  $1 = &made;
  $2 = &room;
}
%typemap(argout) (hgrid_records *counters, hg_grid_stats *room) { hgrid_push_records(L, $1); SWIG_arg++; }
%typemap(in, numinputs=0) int32_t *overlaps (int32_t verdict) { $1 = &verdict; }
%typemap(argout) int32_t *overlaps { lua_pushboolean(L, *$1); SWIG_arg++; }

/* A visitor is a function. An error that it raises ends the visit and passes on to the caller. */
%define %hgrid_visitor(TYPE, FORWARD)
%typemap(in) (TYPE *visit, void *context) (hgrid_lua_visit visit) {
  luaL_checktype(L, $input, LUA_TFUNCTION);
  visit.lua = L;
  visit.function = $input;
  visit.failed = 0;
  $1 = FORWARD;
  $2 = &visit;
}
%typemap(argout) (TYPE *visit, void *context) {
  if (visit$argnum.failed) SWIG_fail;
}
%enddef
%hgrid_visitor(hg_pair_visitor, hgrid_visit_pairs_in)
%hgrid_visitor(hg_contact_visitor, hgrid_visit_contacts_in)
