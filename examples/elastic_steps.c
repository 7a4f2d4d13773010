/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Elastic spheres between walls: whole steps of a simulation in a plain loop over hg_visit_contacts. */
#include "examples/elastic_steps.h"

#include <math.h>

/* Springs: the force is stiffness times overlap. Numbers of the context are copied first: for all that the compiler
 * knows, a force that is written could be one of them. */
static int32_t add_contacts(void *context, const hg_contact_batch *batch) {
  const spheres *s = context;
  const double stiffness = s->stiffness;
  double *f = s->f;
  size_t k;
  for (k = 0; k < batch->count; k++) {
    const double dx = batch->dx[k], dy = batch->dy[k], dz = batch->dz[k];
    const double distance = sqrt(dx * dx + dy * dy + dz * dz);
    const double pull = stiffness * (batch->reach[k] - distance) / distance;
    double *on_a = f + 3 * (size_t)batch->a[k], *on_b = f + 3 * (size_t)batch->b[k];
    on_a[0] -= pull * dx;
    on_a[1] -= pull * dy;
    on_a[2] -= pull * dz;
    on_b[0] += pull * dx;
    on_b[1] += pull * dy;
    on_b[2] += pull * dz;
  }
  return 0;
}

/* Forces of the walls, then velocities, then places; the forces start again from 0. */
static void move_all(const spheres *s) {
  const double low[3] = {s->low[0], s->low[1], s->low[2]}, high[3] = {s->high[0], s->high[1], s->high[2]};
  const double stiffness = s->stiffness, step = s->step;
  double *x = s->x, *v = s->v, *f = s->f;
  size_t i;
  for (i = 0; i < s->count; i++) {
    const double radius = s->radius[i], kick = step * s->inverse_mass[i];
    int axis;
    for (axis = 0; axis < 3; axis++, x++, v++, f++) {
      const double below = radius - (*x - low[axis]), above = radius - (high[axis] - *x);
      const double wall = stiffness * ((below > 0 ? below : 0) - (above > 0 ? above : 0));
      *v += kick * (*f + wall);
      *x += step * *v;
      *f = 0;
    }
  }
}

hg_status one_step(spheres *s) {
  const hg_status status = hg_visit_contacts(s->grid, add_contacts, s);
  if (status != HG_OK) return status;
  move_all(s);
  return hg_move(s->grid, s->count, s->x, NULL);
}
