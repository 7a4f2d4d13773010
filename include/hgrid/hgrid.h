/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* libhgrid: every overlapping pair among particles of very different sizes.
 *
 *   base.h    status codes, version, error texts, allocator hooks
 *   types.h   the definition of a grid and what queries return
 *   grid.h    the functions of a grid
 *   history.h contact history: where each pair of a list was in the list before
 */
#ifndef HGRID_HGRID_H
#define HGRID_HGRID_H

#include <hgrid/base.h>
#include <hgrid/grid.h>
#include <hgrid/history.h>
#include <hgrid/types.h>

#endif
