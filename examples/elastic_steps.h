/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Elastic spheres between walls: whole steps of a simulation in a plain loop over hg_visit_contacts. */
#ifndef HGRID_EXAMPLES_ELASTIC_STEPS_H
#define HGRID_EXAMPLES_ELASTIC_STEPS_H

#include <hgrid/hgrid.h>

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Near spheres should stand together in the arrays: hg_query_order tells an order. */
typedef struct spheres {
  size_t count;
  double *x, *v, *f; /* [count][3]; velocities lag by half a step, forces are 0 between steps */
  const double *radius, *inverse_mass;
  double low[3], high[3]; /* the walls */
  double stiffness, step;
  hg_grid *grid; /* holds them; with a skin its candidates serve for many steps */
} spheres;

/* One step: forces of the present places, then velocities, then places. */
hg_status one_step(spheres *s);

#ifdef __cplusplus
}
#endif

#endif
