/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Elastic spheres between walls: whole steps of a simulation in a plain loop over hg_visit_contacts. */
#include "examples/elastic_steps.h"

#include <math.h>

/* Springs: the force is stiffness times overlap. */
static int32_t add_contacts(void *context, const hg_contact_batch *batch) {
  spheres *s = context;
  size_t k;
  for (k = 0; k < batch->count; k++) {
    const double dx = batch->dx[k], dy = batch->dy[k], dz = batch->dz[k];
    const double distance = sqrt(dx * dx + dy * dy + dz * dz);
    const double pull = s->stiffness * (batch->reach[k] - distance) / distance;
    double *on_a = s->f + 3 * (size_t)batch->a[k], *on_b = s->f + 3 * (size_t)batch->b[k];
    on_a[0] -= pull * dx;
    on_a[1] -= pull * dy;
    on_a[2] -= pull * dz;
    on_b[0] += pull * dx;
    on_b[1] += pull * dy;
    on_b[2] += pull * dz;
  }
  return 0;
}

/* The force of the two walls of an axis on a sphere at x. */
static double wall_force(const spheres *s, int axis, double x, double radius) {
  const double below = radius - (x - s->low[axis]), above = radius - (s->high[axis] - x);
  return s->stiffness * ((below > 0 ? below : 0) - (above > 0 ? above : 0));
}

hg_status one_step(spheres *s) {
  size_t i;
  const hg_status status = hg_visit_contacts(s->grid, add_contacts, s);
  if (status != HG_OK) return status;
  for (i = 0; i < s->count; i++) {
    const double kick = s->step * s->inverse_mass[i];
    int axis;
    for (axis = 0; axis < 3; axis++) {
      double *x = s->x + 3 * i + axis, *v = s->v + 3 * i + axis, *f = s->f + 3 * i + axis;
      *v += kick * (*f + wall_force(s, axis, *x, s->radius[i]));
      *x += s->step * *v;
      *f = 0;
    }
  }
  return hg_move(s->grid, s->count, s->x, NULL);
}
