/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The objects Grid and History, for languages whose users take the module as it is. Shapes are checked in C
 * (grid_object.h, history_object.h), so that a language needs no layer of its own above: <language>.i says how the types
 * of numbers.h and members.h become its tables or matrices (README.md lists them). */
%{
#include "grid_object.h"
#include "history_object.h"
%}

/* Of the C interface the constants remain. */
%rename("$ignore", regextarget=1) "^hg_";
%include <hgrid/base.h>
%include <hgrid/types.h>

/* The version of the library that is loaded. */
%inline %{
static const char *version(void) {
  static char text[32];
  int major = 0, minor = 0, patch = 0;
  hg_version(&major, &minor, &patch);
  (void)snprintf(text, sizeof text, "%d.%d.%d", major, minor, patch);
  return text;
}
%}

%include <constraints.i>
%apply Pointer NONNULL { struct hgrid_grid *, struct hgrid_history * };

/* Arguments that may be left out; also the radii of move. */
%typemap(default) const hgrid_definition *definition, hgrid_reals tilt, hgrid_integers groups, hgrid_integers bodies ";"
%typemap(default) int32_t list "$1 = HG_HALF;"

%nodefaultctor hgrid_grid;
%rename(GridObject) hgrid_grid;
typedef struct hgrid_grid {
  %extend {
    ~hgrid_grid();
    hg_status close(void);
    hg_status insert(hgrid_reals centers, hgrid_reals radii);
    hg_status set(hgrid_reals centers, hgrid_reals radii);
%typemap(default) hgrid_reals radii ";"
    hg_status move(hgrid_reals centers, hgrid_reals radii);
%typemap(default) hgrid_reals radii;
    hg_status remove(hgrid_integers ids);
    hg_status clear(void);
    hg_status build(void);
    hg_status set_box(hgrid_reals box_min, hgrid_reals box_max, hgrid_reals tilt);
    hg_status set_groups(hgrid_integers groups);
    hg_status set_group_pair(int32_t group_a, int32_t group_b, int32_t interacts);
    hg_status set_bodies(hgrid_integers bodies);
    hg_status query_pairs(hgrid_rows *pairs);
    hg_status query_pair_vectors(hgrid_rows *vectors, hgrid_rows *shifts);
    hg_status query_neighbors(int32_t list, hgrid_lists *neighbors);
    hg_status query_sphere(hgrid_reals center, double radius, hgrid_rows *ids);
    hg_status query_spheres(hgrid_reals centers, hgrid_reals radii, hgrid_lists *ids);
    hg_status query_boxes(hgrid_reals low, hgrid_reals high, hgrid_lists *ids);
    hg_status query_triangles(hgrid_reals corners, hgrid_lists *ids);
    hg_status visit_pairs(hg_pair_visitor *visit, void *context);
    hg_status visit_contacts(hg_contact_visitor *visit, void *context);
    hg_status overlap(hgrid_reals center_a, double radius_a, hgrid_reals center_b, double radius_b, int32_t *overlaps);
    hg_status order(hgrid_rows *ids);
    hg_status levels(hgrid_records *levels);
    hg_status level_costs(hgrid_records *costs);
    hg_status stats(hgrid_records *counters, hg_grid_stats *room);
  }
} hgrid_grid;
%rename(Grid) hgrid_make_grid;
hg_status hgrid_make_grid(const hgrid_definition *definition, hgrid_grid **grid);

%nodefaultctor hgrid_history;
%rename(HistoryObject) hgrid_history;
typedef struct hgrid_history {
  %extend {
    ~hgrid_history();
    hg_status update(hgrid_integers contacts, hgrid_rows *previous);
    hg_status carry(hgrid_reals items, hgrid_rows *carried);
    hg_status ended(hgrid_rows *contacts, hgrid_rows *places);
    hg_status contacts(hgrid_rows *contacts);
    hg_status restore(hgrid_integers contacts);
    hg_status clear(void);
  }
} hgrid_history;
%rename(History) hgrid_make_history;
hg_status hgrid_make_history(hgrid_history **history);
