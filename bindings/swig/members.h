/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The members of the C structs by their names: of those that come back, and of the definition of a grid, which is given
 * as a table of the language's own. */
#pragma once

#include "numbers.h"

#include <math.h>

/* `type` as in hgrid_rows; `count` numbers. */
typedef struct hgrid_member {
  const char *name;
  char type;
  size_t count, offset;
} hgrid_member;

#define HGRID_MEMBER(STRUCT, NAME, TYPE, COUNT) \
  { #NAME, TYPE, COUNT, offsetof(STRUCT, NAME) }

static const hgrid_member hgrid_level_members[] = {HGRID_MEMBER(hg_level, cell_size, 'd', 1),
                                                   HGRID_MEMBER(hg_level, largest_radius, 'd', 1),
                                                   HGRID_MEMBER(hg_level, occupancy, 'd', 1),
                                                   HGRID_MEMBER(hg_level, particle_count, 'l', 1),
                                                   {NULL, 0, 0, 0}};

static const hgrid_member hgrid_level_cost_members[] = {HGRID_MEMBER(hg_level_cost, level_count, 'i', 1),
                                                        HGRID_MEMBER(hg_level_cost, reachable, 'i', 1),
                                                        HGRID_MEMBER(hg_level_cost, occupancy, 'd', 1),
                                                        HGRID_MEMBER(hg_level_cost, cost, 'd', 1),
                                                        {NULL, 0, 0, 0}};

static const hgrid_member hgrid_stats_members[] = {
    HGRID_MEMBER(hg_grid_stats, particle_count, 'l', 1),  HGRID_MEMBER(hg_grid_stats, level_count, 'l', 1),
    HGRID_MEMBER(hg_grid_stats, row_count, 'l', 1),       HGRID_MEMBER(hg_grid_stats, cell_count, 'l', 1),
    HGRID_MEMBER(hg_grid_stats, candidate_count, 'l', 1), HGRID_MEMBER(hg_grid_stats, undecided_count, 'l', 1),
    HGRID_MEMBER(hg_grid_stats, exact_count, 'l', 1),     HGRID_MEMBER(hg_grid_stats, pair_count, 'l', 1),
    HGRID_MEMBER(hg_grid_stats, build_count, 'l', 1),     HGRID_MEMBER(hg_grid_stats, search_count, 'l', 1),
    HGRID_MEMBER(hg_grid_stats, byte_count, 'l', 1),      HGRID_MEMBER(hg_grid_stats, filter_count, 'l', 1),
    HGRID_MEMBER(hg_grid_stats, stored_count, 'l', 1),    {NULL, 0, 0, 0}};

static const hgrid_member hgrid_definition_members[] = {
    HGRID_MEMBER(hg_grid_def, dimension, 'i', 1),   HGRID_MEMBER(hg_grid_def, thread_count, 'i', 1),
    HGRID_MEMBER(hg_grid_def, index_base, 'i', 1),  HGRID_MEMBER(hg_grid_def, interaction, 'i', 1),
    HGRID_MEMBER(hg_grid_def, accuracy, 'i', 1),    HGRID_MEMBER(hg_grid_def, pair_order, 'i', 1),
    HGRID_MEMBER(hg_grid_def, level_rule, 'i', 1),  HGRID_MEMBER(hg_grid_def, level_count, 'i', 1),
    HGRID_MEMBER(hg_grid_def, margin, 'd', 1),      HGRID_MEMBER(hg_grid_def, skin, 'd', 1),
    HGRID_MEMBER(hg_grid_def, periodic, 'i', 3),    HGRID_MEMBER(hg_grid_def, box_min, 'd', 3),
    HGRID_MEMBER(hg_grid_def, box_max, 'd', 3),     HGRID_MEMBER(hg_grid_def, cell_overhead, 'd', 1),
    HGRID_MEMBER(hg_grid_def, level_price, 'd', 1), HGRID_MEMBER(hg_grid_def, row_price, 'd', 1),
    HGRID_MEMBER(hg_grid_def, tilt, 'd', 3),        HGRID_MEMBER(hg_grid_def, touching, 'i', 1),
    HGRID_MEMBER(hg_grid_def, images, 'i', 1),      {NULL, 0, 0, 0}};

/* Structs for the caller, who gets a table with the members' names of each; a single one unless `is_list`. */
typedef struct hgrid_records {
  const hgrid_member *members;
  const char *data;
  size_t size, count;
  int is_list;
} hgrid_records;

static hgrid_rows hgrid_member_at(const hgrid_records *records, size_t index, const hgrid_member *member) {
  return hgrid_list_of(records->data + index * records->size + member->offset, member->type, member->count);
}

/* A definition while it is filled. */
typedef struct hgrid_definition {
  hg_grid_def def;
  hgrid_reals cell_sizes;
  const char *of_a_plane; /* a member that got the numbers of two axes, or NULL */
} hgrid_definition;

/* The defaults of the library, but for ids, which count from 1 where places in lists do. */
static void hgrid_definition_begin(hgrid_definition *definition) {
  memset(definition, 0, sizeof *definition);
  (void)hg_grid_def_init(&definition->def, sizeof definition->def);
  definition->def.index_base = 1;
}

static hg_status hgrid_definition_put_number(hg_grid_def *def, const hgrid_member *member, size_t k, double value) {
  char *place = (char *)def + member->offset;
  if (member->type == 'd') {
    ((double *)place)[k] = value;
  } else if (!(value >= INT32_MIN && value <= INT32_MAX && floor(value) == value)) {
    return hgrid_refuse(HG_ERR_ARGUMENT, "%s is %g, not an integer of 32 bits", member->name, value);
  } else {
    ((int32_t *)place)[k] = (int32_t)value;
  }
  return HG_OK;
}

/* Sets a member to the numbers of a list. Takes over those of cell_sizes, which choose the rule for the levels, too;
 * the caller frees all others. In two dimensions what goes by axes may have two numbers, and tilt one. */
static hg_status hgrid_definition_put(hgrid_definition *definition, const char *name, hgrid_reals *values) {
  const hgrid_member *member;
  size_t given = values->rows * values->columns, k;
  hg_status status = hgrid_check_list(values->rows, values->columns, name, given);
  if (status != HG_OK) return status;
  if (strcmp(name, "cell_sizes") == 0) {
    definition->def.level_rule = HG_LEVELS_USER;
    definition->def.level_count = given < INT32_MAX ? (int32_t)given : INT32_MAX;
    definition->def.cell_sizes = values->data;
    definition->cell_sizes = *values;
    values->data = NULL;
    return HG_OK;
  }
  for (member = hgrid_definition_members; member->name != NULL && strcmp(member->name, name) != 0; ++member) {
  }
  if (member->name == NULL) {
    return hgrid_refuse(HG_ERR_ARGUMENT, "a definition has no member '%s' (include/hgrid/types.h, hg_grid_def)", name);
  }
  if (given != member->count) {
    if (member->count != 3 || given != (member->offset == offsetof(hg_grid_def, tilt) ? 1 : 2)) {
      return hgrid_check_list(1, given, name, member->count);
    }
    definition->of_a_plane = member->name;
  }
  for (k = 0; k < given && status == HG_OK; ++k) {
    status = hgrid_definition_put_number(&definition->def, member, k, values->data[k]);
  }
  return status;
}
