/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* What the typemaps of lua.i call: tables to numbers and back, errors, visitors. Reading raises no error, as Lua leaves
 * by a jump that would lose memory: it pushes the text and returns nonzero. */
#pragma once

#include "grid_object.h"

#include <lauxlib.h>
#include <lua.h>

/* Pushes a text with the place in the script. Always nonzero. */
static int hgrid_complain(lua_State *L, const char *format, ...) {
  va_list arguments;
  luaL_where(L, 1);
  va_start(arguments, format);
  (void)lua_pushvfstring(L, format, arguments);
  va_end(arguments);
  lua_concat(L, 2);
  return -1;
}

static void hgrid_raise_in(lua_State *L) { (void)hgrid_complain(L, "%s", hg_last_error()); }

/* Reads the value on top of the stack as a number of type 'd' or 'l'. NULL, or what is wrong with it. */
static const char *hgrid_take_value(lua_State *L, char type, void *place) {
  int exact = 1;
  if (lua_type(L, -1) == LUA_TBOOLEAN) {
    if (type == 'd') *(double *)place = lua_toboolean(L, -1);
    if (type == 'l') *(int64_t *)place = lua_toboolean(L, -1);
  } else if (lua_type(L, -1) != LUA_TNUMBER) {
    return "no number";
  } else if (type == 'l') {
    *(int64_t *)place = lua_tointegerx(L, -1, &exact);
    if (!exact) return "no integer";
  } else {
    const double value = lua_tonumber(L, -1);
    *(double *)place = value;
    if (lua_isinteger(L, -1) && (value >= 0x1p63 || (lua_Integer)value != lua_tointeger(L, -1))) {
      return "an integer that no double holds";
    }
  }
  return NULL;
}

/* Reads a number, a list of them or a list of lists into memory that the caller frees, also after a failure. */
static int hgrid_take_table(lua_State *L, int index, const char *name, char type, void **data, size_t *rows,
                            size_t *columns) {
  const int is_table = lua_istable(L, index);
  const size_t size = type == 'd' ? sizeof(double) : sizeof(int64_t);
  const char *wrong = NULL;
  size_t row, column;
  int nested;
  index = lua_absindex(L, index);
  if (!lua_checkstack(L, 8)) return hgrid_complain(L, "%s: no room on the stack", name);
  *rows = is_table ? (size_t)lua_rawlen(L, index) : 1;
  *columns = 1;
  nested = is_table && *rows > 0 && lua_rawgeti(L, index, 1) == LUA_TTABLE;
  if (nested) *columns = (size_t)lua_rawlen(L, -1);
  if (is_table && *rows > 0) lua_pop(L, 1);
  if (*rows < SIZE_MAX / size / (*columns + 1)) *data = malloc((*rows * *columns + 1) * size);
  if (*data == NULL) return hgrid_complain(L, "%s: no memory for its numbers", name);
  for (row = 0; row < *rows; ++row) {
    if (is_table) {
      (void)lua_rawgeti(L, index, (lua_Integer)row + 1);
    } else {
      lua_pushvalue(L, index);
    }
    if (!nested) {
      wrong = hgrid_take_value(L, type, (char *)*data + row * size);
      lua_pop(L, 1);
      if (wrong != NULL) return hgrid_complain(L, "%s[%I] is %s", name, (LUAI_UACINT)row + 1, wrong);
      continue;
    }
    if (!lua_istable(L, -1) || lua_rawlen(L, -1) != *columns) {
      lua_pop(L, 1);
      return hgrid_complain(L, "%s[%I] is no list of as many numbers as %s[1]", name, (LUAI_UACINT)row + 1, name);
    }
    for (column = 0; column < *columns; ++column) {
      (void)lua_rawgeti(L, -1, (lua_Integer)column + 1);
      wrong = hgrid_take_value(L, type, (char *)*data + (row * *columns + column) * size);
      lua_pop(L, 1);
      if (wrong == NULL) continue;
      lua_pop(L, 1);
      return hgrid_complain(L, "%s[%I][%I] is %s", name, (LUAI_UACINT)row + 1, (LUAI_UACINT)column + 1, wrong);
    }
    lua_pop(L, 1);
  }
  return 0;
}

static int hgrid_take_integer(lua_State *L, int index, const char *name, int32_t *value) {
  int64_t wide = 0;
  const char *wrong;
  lua_pushvalue(L, index);
  wrong = hgrid_take_value(L, 'l', &wide);
  lua_pop(L, 1);
  *value = (int32_t)wide;
  if (wrong != NULL) return hgrid_complain(L, "%s is %s", name, wrong);
  return *value == wide ? 0 : hgrid_complain(L, "%s = %I does not fit in 32 bits", name, (LUAI_UACINT)wide);
}

/* Reads a table with the names of members of hg_grid_def. */
static int hgrid_take_definition(lua_State *L, int index, hgrid_definition *definition) {
  if (!lua_istable(L, index)) return hgrid_complain(L, "definition is %s, not a table", luaL_typename(L, index));
  index = lua_absindex(L, index);
  lua_pushnil(L);
  while (lua_next(L, index) != 0) {
    hgrid_reals values = {NULL, 0, 0};
    void *data = NULL;
    hg_status status = HG_OK;
    int failed;
    const char *name;
    if (lua_type(L, -2) != LUA_TSTRING) return hgrid_complain(L, "definition: members go by names");
    name = lua_tostring(L, -2);
    failed = hgrid_take_table(L, -1, name, 'd', &data, &values.rows, &values.columns);
    values.data = data;
    if (!failed) status = hgrid_definition_put(definition, name, &values);
    free(values.data);
    if (failed) return -1;
    if (status != HG_OK) return hgrid_complain(L, "%s", hg_last_error());
    lua_pop(L, 1);
  }
  return 0;
}

static void hgrid_push_number(lua_State *L, const hgrid_rows *rows, size_t row, size_t column) {
  if (rows->type == 'd') {
    lua_pushnumber(L, hgrid_real_at(rows, row, column));
  } else {
    lua_pushinteger(L, hgrid_integer_at(rows, row, column));
  }
}

static int hgrid_fits(size_t count) { return count < INT32_MAX ? (int)count : INT32_MAX; }

static void hgrid_push_rows(lua_State *L, const hgrid_rows *rows) {
  size_t row, column;
  lua_createtable(L, hgrid_fits(rows->rows), 0);
  for (row = 0; row < rows->rows; ++row) {
    if (rows->is_list) {
      hgrid_push_number(L, rows, row, 0);
    } else {
      lua_createtable(L, hgrid_fits(rows->columns), 0);
      for (column = 0; column < rows->columns; ++column) {
        hgrid_push_number(L, rows, row, column);
        lua_rawseti(L, -2, (lua_Integer)column + 1);
      }
    }
    lua_rawseti(L, -2, (lua_Integer)row + 1);
  }
}

static void hgrid_push_lists(lua_State *L, const hgrid_lists *lists) {
  size_t row;
  lua_createtable(L, hgrid_fits(lists->count), 0);
  for (row = 0; row < lists->count; ++row) {
    const size_t first = (size_t)lists->offsets[row];
    const hgrid_rows list = hgrid_list_of(lists->ids + first, 'i', (size_t)lists->offsets[row + 1] - first);
    hgrid_push_rows(L, &list);
    lua_rawseti(L, -2, (lua_Integer)row + 1);
  }
}

static void hgrid_push_record(lua_State *L, const hgrid_records *records, size_t index) {
  const hgrid_member *member;
  lua_newtable(L);
  for (member = records->members; member->name != NULL; ++member) {
    const hgrid_rows value = hgrid_member_at(records, index, member);
    hgrid_push_number(L, &value, 0, 0);
    lua_setfield(L, -2, member->name);
  }
}

static void hgrid_push_records(lua_State *L, const hgrid_records *records) {
  size_t index;
  if (!records->is_list) {
    hgrid_push_record(L, records, 0);
    return;
  }
  lua_createtable(L, hgrid_fits(records->count), 0);
  for (index = 0; index < records->count; ++index) {
    hgrid_push_record(L, records, index);
    lua_rawseti(L, -2, (lua_Integer)index + 1);
  }
}

/* A visit on its way: the function stands at `function` on the stack; if it failed, the error is on top. */
typedef struct hgrid_lua_visit {
  lua_State *lua;
  int function, failed;
} hgrid_lua_visit;

/* Runs protected, as an error must not jump over the library: (function, tables, count of tables). */
static int hgrid_call_visitor(lua_State *L) {
  const hgrid_rows *tables = (const hgrid_rows *)lua_touserdata(L, 2);
  const lua_Integer count = lua_tointeger(L, 3);
  lua_Integer k;
  luaL_checkstack(L, 8, NULL);
  lua_pushvalue(L, 1);
  for (k = 0; k < count; ++k) hgrid_push_rows(L, tables + k);
  lua_call(L, (int)count, 1);
  return 1;
}

static int32_t hgrid_hand_over(hgrid_lua_visit *visit, hgrid_rows *tables, int count) {
  lua_State *L = visit->lua;
  int32_t stop;
  visit->failed = 1;
  if (!lua_checkstack(L, 8)) {
    lua_pushliteral(L, "no room on the stack for the visitor"); /* there is room for what Lua itself guarantees */
    return 1;
  }
  lua_pushcfunction(L, hgrid_call_visitor);
  lua_pushvalue(L, visit->function);
  lua_pushlightuserdata(L, tables);
  lua_pushinteger(L, count);
  if (lua_pcall(L, 3, 1, 0) != LUA_OK) return 1;
  visit->failed = 0;
  stop = lua_toboolean(L, -1);
  lua_pop(L, 1);
  return stop;
}

static int32_t hgrid_visit_pairs_in(void *context, const hg_pair *pairs, size_t count) {
  hgrid_rows table = hgrid_rows_of(pairs, 'i', count, 2);
  return hgrid_hand_over((hgrid_lua_visit *)context, &table, 1);
}

static int32_t hgrid_visit_contacts_in(void *context, const hg_contact_batch *batch) {
  hgrid_contact_tables tables;
  hgrid_arrange(batch, &tables);
  return hgrid_hand_over((hgrid_lua_visit *)context, tables.rows, 3);
}
