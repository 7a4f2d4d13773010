/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The object Grid of objects.i: a grid, and the checks of shapes that the C interface leaves to its callers. Each
 * function is the method of that name; include/hgrid/grid.h says what it does. */
#pragma once

#include "members.h"

typedef struct hgrid_grid {
  hg_grid *handle; /* NULL once it is closed */
  size_t dimension;
  int visits; /* visitors that are running */
} hgrid_grid;

/* Makes a grid that its object owns. */
static hg_status hgrid_make_grid(const hgrid_definition *definition, hgrid_grid **grid) {
  hgrid_grid *made;
  hg_status status;
  if (definition->of_a_plane != NULL && definition->def.dimension != 2) {
    return hgrid_refuse(HG_ERR_ARGUMENT, "%s must hold 3 numbers, as dimension is not 2", definition->of_a_plane);
  }
  made = (hgrid_grid *)calloc(1, sizeof *made);
  if (made == NULL) return hgrid_refuse(HG_ERR_MEMORY, "no memory for a grid");
  made->dimension = definition->def.dimension == 2 ? 2 : 3;
  status = hg_create(&definition->def, &made->handle);
  if (status == HG_OK) {
    *grid = made;
  } else {
    free(made);
  }
  return status;
}

static void delete_hgrid_grid(hgrid_grid *self) {
  hg_destroy(self->handle);
  free(self);
}

static hg_status hgrid_grid_close(hgrid_grid *self) {
  if (self->visits > 0) return hgrid_refuse(HG_ERR_STATE, "a grid cannot be closed by a visitor of its own");
  hg_destroy(self->handle);
  self->handle = NULL;
  return HG_OK;
}

static hg_status hgrid_check_open(const hgrid_grid *self) {
  return self->handle != NULL ? HG_OK : hgrid_refuse(HG_ERR_STATE, "the grid is closed");
}

/* Places and sizes that belong together: `per_axis` numbers of each axis in a row. */
static hg_status hgrid_check_places(const hgrid_grid *self, hgrid_reals places, const char *name, size_t per_axis) {
  hg_status status = hgrid_check_open(self);
  return status != HG_OK ? status : hgrid_check_rows(places, name, per_axis * self->dimension);
}

static hg_status hgrid_check_particles(const hgrid_grid *self, hgrid_reals centers, hgrid_reals radii) {
  hg_status status = hgrid_check_places(self, centers, "centers", 1);
  return status != HG_OK ? status : hgrid_check_list(radii.rows, radii.columns, "radii", centers.rows);
}

static hg_status hgrid_grid_insert(hgrid_grid *self, hgrid_reals centers, hgrid_reals radii) {
  hg_status status = hgrid_check_particles(self, centers, radii);
  return status != HG_OK ? status : hg_insert(self->handle, centers.rows, centers.data, radii.data);
}

static hg_status hgrid_grid_set(hgrid_grid *self, hgrid_reals centers, hgrid_reals radii) {
  hg_status status = hgrid_check_particles(self, centers, radii);
  return status != HG_OK ? status : hg_set(self->handle, centers.rows, centers.data, radii.data);
}

static hg_status hgrid_grid_move(hgrid_grid *self, hgrid_reals centers, hgrid_reals radii) {
  hg_status status = radii.data == NULL ? hgrid_check_places(self, centers, "centers", 1)
                                        : hgrid_check_particles(self, centers, radii);
  return status != HG_OK ? status : hg_move(self->handle, centers.rows, centers.data, radii.data);
}

/* What takes a list of 32-bit integers; where none is given, NULL. */
typedef hg_status hgrid_list_call(hg_grid *, size_t, const int32_t *);

static hg_status hgrid_give_list(hgrid_grid *self, hgrid_list_call *call, hgrid_integers given, const char *name) {
  int32_t *list = NULL;
  hg_status status = hgrid_check_open(self);
  if (status == HG_OK && given.data != NULL) status = hgrid_narrow(given, name, &list);
  if (status != HG_OK) return status;
  status = call(self->handle, given.rows * given.columns, list);
  free(list);
  return status;
}

static hg_status hgrid_grid_remove(hgrid_grid *self, hgrid_integers ids) {
  return hgrid_give_list(self, hg_remove, ids, "ids");
}

static hg_status hgrid_grid_set_groups(hgrid_grid *self, hgrid_integers groups) {
  return hgrid_give_list(self, hg_set_groups, groups, "groups");
}

static hg_status hgrid_grid_set_bodies(hgrid_grid *self, hgrid_integers bodies) {
  return hgrid_give_list(self, hg_set_bodies, bodies, "bodies");
}

static hg_status hgrid_grid_set_group_pair(hgrid_grid *self, int32_t group_a, int32_t group_b, int32_t interacts) {
  hg_status status = hgrid_check_open(self);
  return status != HG_OK ? status : hg_set_group_pair(self->handle, group_a, group_b, interacts);
}

static hg_status hgrid_grid_clear(hgrid_grid *self) {
  hg_status status = hgrid_check_open(self);
  return status != HG_OK ? status : hg_clear(self->handle);
}

static hg_status hgrid_grid_build(hgrid_grid *self) {
  hg_status status = hgrid_check_open(self);
  return status != HG_OK ? status : hg_build(self->handle);
}

/* Three numbers, of which those of axes that the grid does not have may be left out. */
static hg_status hgrid_take_axes(const hgrid_grid *self, hgrid_reals given, const char *name, double values[3]) {
  size_t count = given.rows * given.columns;
  hg_status status = hgrid_check_list(given.rows, given.columns, name, count == 3 ? 3 : self->dimension);
  memset(values, 0, 3 * sizeof values[0]);
  if (status == HG_OK) memcpy(values, given.data, count * sizeof values[0]);
  return status;
}

static hg_status hgrid_grid_set_box(hgrid_grid *self, hgrid_reals box_min, hgrid_reals box_max, hgrid_reals tilt) {
  double low[3], high[3], lean[3] = {0, 0, 0};
  size_t leaning = tilt.rows * tilt.columns;
  hg_status status = hgrid_check_open(self);
  if (status == HG_OK) status = hgrid_take_axes(self, box_min, "box_min", low);
  if (status == HG_OK) status = hgrid_take_axes(self, box_max, "box_max", high);
  if (status == HG_OK && tilt.data != NULL) {
    status = hgrid_check_list(tilt.rows, tilt.columns, "tilt", self->dimension == 2 && leaning == 1 ? 1 : 3);
    if (status == HG_OK) memcpy(lean, tilt.data, leaning * sizeof lean[0]);
  }
  return status != HG_OK ? status : hg_set_box(self->handle, low, high, lean);
}

static hg_status hgrid_grid_query_pairs(hgrid_grid *self, hgrid_rows *pairs) {
  const hg_pair *found = NULL;
  size_t count = 0;
  hg_status status = hgrid_check_open(self);
  if (status == HG_OK) status = hg_query_pairs(self->handle, &found, &count);
  *pairs = hgrid_rows_of(found, 'i', count, 2);
  return status;
}

static hg_status hgrid_grid_query_pair_vectors(hgrid_grid *self, hgrid_rows *vectors, hgrid_rows *shifts) {
  const hg_pair *pairs = NULL;
  const double *steps = NULL;
  const int32_t *edges = NULL;
  size_t count = 0;
  hg_status status = hgrid_check_open(self);
  if (status == HG_OK) status = hg_query_pairs(self->handle, &pairs, &count);
  if (status == HG_OK) status = hg_query_pair_vectors(self->handle, &steps, &edges);
  *vectors = hgrid_rows_of(steps, 'd', count, self->dimension);
  *shifts = hgrid_rows_of(edges, 'i', count, self->dimension);
  return status;
}

static hg_status hgrid_grid_visit_pairs(hgrid_grid *self, hg_pair_visitor *visit, void *context) {
  hg_status status = hgrid_check_open(self);
  if (status != HG_OK) return status;
  ++self->visits;
  status = hg_visit_pairs(self->handle, visit, context);
  --self->visits;
  return status;
}

static hg_status hgrid_grid_visit_contacts(hgrid_grid *self, hg_contact_visitor *visit, void *context) {
  hg_status status = hgrid_check_open(self);
  if (status != HG_OK) return status;
  ++self->visits;
  status = hg_visit_contacts(self->handle, visit, context);
  --self->visits;
  return status;
}

/* A batch of contacts as tables: pairs, vectors, reaches. */
typedef struct hgrid_contact_tables {
  int32_t pair[2 * HG_MAX_BATCH];
  double vector[3 * HG_MAX_BATCH];
  hgrid_rows rows[3];
} hgrid_contact_tables;

static void hgrid_arrange(const hg_contact_batch *batch, hgrid_contact_tables *tables) {
  size_t axes = batch->dz != NULL ? 3 : 2, k;
  for (k = 0; k < batch->count; ++k) {
    tables->pair[2 * k] = batch->a[k];
    tables->pair[2 * k + 1] = batch->b[k];
    tables->vector[axes * k] = batch->dx[k];
    tables->vector[axes * k + 1] = batch->dy[k];
    if (batch->dz != NULL) tables->vector[axes * k + 2] = batch->dz[k];
  }
  tables->rows[0] = hgrid_rows_of(tables->pair, 'i', batch->count, 2);
  tables->rows[1] = hgrid_rows_of(tables->vector, 'd', batch->count, axes);
  tables->rows[2] = hgrid_list_of(batch->reach, 'd', batch->count);
}

static hg_status hgrid_grid_query_neighbors(hgrid_grid *self, int32_t list, hgrid_lists *neighbors) {
  hg_grid_stats stats;
  hg_status status = hgrid_check_open(self);
  if (status == HG_OK) status = hg_query_neighbors(self->handle, list, &neighbors->offsets, &neighbors->ids);
  if (status == HG_OK) status = hg_get_stats(self->handle, &stats, sizeof stats);
  neighbors->count = status == HG_OK ? (size_t)stats.particle_count : 0;
  return status;
}

static hg_status hgrid_grid_query_sphere(hgrid_grid *self, hgrid_reals center, double radius, hgrid_rows *ids) {
  const int32_t *found = NULL;
  size_t count = 0;
  hg_status status = hgrid_check_open(self);
  if (status == HG_OK) status = hgrid_check_list(center.rows, center.columns, "center", self->dimension);
  if (status == HG_OK) status = hg_query_sphere(self->handle, center.data, radius, &found, &count);
  *ids = hgrid_list_of(found, 'i', count);
  return status;
}

static hg_status hgrid_grid_query_spheres(hgrid_grid *self, hgrid_reals centers, hgrid_reals radii, hgrid_lists *ids) {
  hg_status status = hgrid_check_particles(self, centers, radii);
  ids->count = centers.rows;
  if (status != HG_OK) return status;
  return hg_query_spheres(self->handle, centers.rows, centers.data, radii.data, &ids->offsets, &ids->ids);
}

static hg_status hgrid_grid_query_boxes(hgrid_grid *self, hgrid_reals low, hgrid_reals high, hgrid_lists *ids) {
  hg_status status = hgrid_check_places(self, low, "low", 1);
  if (status == HG_OK) status = hgrid_check_places(self, high, "high", 1);
  if (status == HG_OK && low.rows != high.rows) {
    status = hgrid_refuse(HG_ERR_ARGUMENT, "high must have %zu rows, as low has, not %zu", low.rows, high.rows);
  }
  ids->count = low.rows;
  return status != HG_OK ? status
                         : hg_query_boxes(self->handle, low.rows, low.data, high.data, &ids->offsets, &ids->ids);
}

static hg_status hgrid_grid_query_triangles(hgrid_grid *self, hgrid_reals corners, hgrid_lists *ids) {
  hg_status status = hgrid_check_places(self, corners, "corners", 3);
  ids->count = corners.rows;
  return status != HG_OK ? status
                         : hg_query_triangles(self->handle, corners.rows, corners.data, &ids->offsets, &ids->ids);
}

static hg_status hgrid_grid_overlap(hgrid_grid *self, hgrid_reals center_a, double radius_a, hgrid_reals center_b,
                                    double radius_b, int32_t *overlaps) {
  hg_status status = hgrid_check_open(self);
  if (status == HG_OK) status = hgrid_check_list(center_a.rows, center_a.columns, "center_a", self->dimension);
  if (status == HG_OK) status = hgrid_check_list(center_b.rows, center_b.columns, "center_b", self->dimension);
  if (status != HG_OK) return status;
  return hg_overlap(self->handle, center_a.data, radius_a, center_b.data, radius_b, overlaps);
}

static hg_status hgrid_grid_order(hgrid_grid *self, hgrid_rows *ids) {
  const int32_t *found = NULL;
  size_t count = 0;
  hg_status status = hgrid_check_open(self);
  if (status == HG_OK) status = hg_query_order(self->handle, &found, &count);
  *ids = hgrid_list_of(found, 'i', count);
  return status;
}

static hg_status hgrid_grid_levels(hgrid_grid *self, hgrid_records *levels) {
  const hg_level *found = NULL;
  size_t count = 0;
  hg_status status = hgrid_check_open(self);
  if (status == HG_OK) status = hg_query_levels(self->handle, &found, &count);
  const hgrid_records records = {hgrid_level_members, (const char *)found, sizeof *found, count, 1};
  *levels = records;
  return status;
}

static hg_status hgrid_grid_level_costs(hgrid_grid *self, hgrid_records *costs) {
  const hg_level_cost *found = NULL;
  size_t count = 0;
  hg_status status = hgrid_check_open(self);
  if (status == HG_OK) status = hg_query_level_costs(self->handle, &found, &count);
  const hgrid_records records = {hgrid_level_cost_members, (const char *)found, sizeof *found, count, 1};
  *costs = records;
  return status;
}

/* The counters live in the typemap's `room`, as the library lends none. */
static hg_status hgrid_grid_stats(hgrid_grid *self, hgrid_records *counters, hg_grid_stats *room) {
  hg_status status = hgrid_check_open(self);
  if (status == HG_OK) status = hg_get_stats(self->handle, room, sizeof *room);
  const hgrid_records records = {hgrid_stats_members, (const char *)room, sizeof *room, 1, 0};
  *counters = records;
  return status;
}
