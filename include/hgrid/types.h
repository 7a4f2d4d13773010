/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The definition of a grid and what its queries return. No type here depends on the compiler: no bool, long or enum
 * members, padding spelled out. Structs grow only at their end. */
#ifndef HGRID_TYPES_H
#define HGRID_TYPES_H

#include <hgrid/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* hg_grid_def.interaction: when two particles interact. The comparison is strict, touching is not overlapping, unless
 * hg_grid_def.touching says otherwise. */
enum {
  HG_CONTACT = 0,  /* |xi - xj| < ri + rj + margin: contacts of spheres (DEM) */
  HG_MAX_RANGE = 1 /* |xi - xj| < max(ri, rj) + margin: radii are ranges, either particle may see the other (SPH) */
};

/* hg_grid_def.accuracy: how an interaction is decided. */
enum {
  HG_EXACT = 0,  /* as real arithmetic on the stored doubles would */
  HG_DOUBLE = 1, /* as dx*dx + dy*dy + dz*dz < s*s in doubles, added in this order, without contraction */
  HG_FLOAT = 2   /* never misses; extra pairs are nearer to touching than stated in docs/theory/exactness.md */
};

/* hg_grid_def.pair_order: the order of hg_query_pairs and hg_visit_pairs. Both are reproducible. */
enum {
  HG_ORDER_GRID = 0, /* as found, near pairs together in memory: the fastest */
  HG_ORDER_ID = 1    /* ascending (a, b), whatever the levels; hg_visit_pairs then stores the list first */
};

/* hg_grid_def.level_rule: how the levels' cell sizes are chosen. */
enum {
  HG_LEVELS_AUTO = 0,  /* the paper's levels, as many as cost this library least */
  HG_LEVELS_PAPER = 1, /* Ogarko & Luding 2012, Appendix A and Eq. 7 with K = 0.3 */
  HG_LEVELS_USER = 2   /* cell_sizes */
};

/* hg_grid_def.images: which periodic images of two particles are pairs. */
enum {
  HG_NEAREST_IMAGE = 0, /* the nearest: two particles are a pair once at most; boxes that are too short are refused */
  HG_ALL_IMAGES = 1     /* each in reach, by its shift; also those of a particle with itself; boxes of any length */
};

/* The list asked of hg_query_neighbors. */
enum {
  HG_HALF = 0, /* row a holds the b > a: every pair once */
  HG_FULL = 1  /* every pair in both rows */
};

enum { HG_MAX_LEVELS = 64 }; /* the most levels a grid can have */
enum { HG_MAX_GROUPS = 64 }; /* the most groups that its particles can be in */

/* hg_array.type: the numbers of an array. */
enum {
  HG_REAL64 = 0, /* double */
  HG_REAL32 = 1  /* float, widened to double exactly */
};

/* One number of each particle, wherever the caller keeps it: a column of its own, or a member of its structs. */
typedef struct hg_array {
  const void *data; /* that of the first particle; of any alignment */
  int64_t stride;   /* bytes from a particle to the next; may be negative, or 0 if all share one number */
  int32_t type;     /* HG_REAL64 or HG_REAL32 */
  int32_t reserved; /* 0 */
} hg_array;

/* Two particles that interact, by their ids; a < b. With HG_ALL_IMAGES a == b is a particle and an image of itself. */
typedef struct hg_pair {
  int32_t a, b;
} hg_pair;

/* How a grid works, fixed when it is created. Fill it with hg_default_grid_def(), then change what you need. */
typedef struct hg_grid_def {
  uint32_t struct_size; /* sizeof(hg_grid_def) of the caller; set by hg_grid_def_init */
  int32_t dimension;    /* 2 or 3 (3) */
  int32_t thread_count; /* 0 = all that the machine offers, 1 = serial; up to 1024 (0) */
  int32_t index_base;   /* id of the first particle, 0 or 1 (0) */
  int32_t interaction;  /* HG_CONTACT or HG_MAX_RANGE (HG_CONTACT) */
  int32_t accuracy;     /* HG_EXACT, HG_DOUBLE or HG_FLOAT (HG_EXACT) */
  int32_t pair_order;   /* HG_ORDER_GRID or HG_ORDER_ID (HG_ORDER_GRID) */
  int32_t level_rule;   /* HG_LEVELS_AUTO, HG_LEVELS_PAPER or HG_LEVELS_USER (HG_LEVELS_AUTO) */
  int32_t level_count;  /* AUTO, PAPER: at most that many levels, 0 = the cheapest; USER: length of cell_sizes (0) */
  int32_t reserved0;    /* 0 */
  const double *cell_sizes; /* USER: [level_count] ascending cell edges > 0, the last >= the largest diameter (largest
                               range for HG_MAX_RANGE), and wider by itself if a margin needs that; copied by hg_create
                               (NULL) */
  double margin;            /* added to every reach, >= 0, caller's length unit (0) */
  double skin;          /* >= 0, length: pairs this much farther apart are stored as candidates, which serve until one
                           particle has moved plus grown by skin / 2; then all are searched anew. 0 = search always.
                           It changes the time, never the pairs; docs/evidence/performance.md says which to take
                           (0) */
  int32_t periodic[3];  /* per axis: 0 open, 1 periodic (0, 0, 0) */
  int32_t reserved1;    /* 0 */
  double box_min[3];    /* periodic axes: the box, needed. Open axes: particles may lie anywhere; a box with */
  double box_max[3];    /* box_max > box_min only states the volume that the choice of levels assumes (0) */
  double cell_overhead; /* K of Eq. 7: cost of visiting a cell over cost of testing a particle, >= 0 and finite;
                           negative = 0.3 for PAPER; AUTO: takes the two prices below instead (-1) */
  /* AUTO: what work costs, in units of testing one candidate; finite, negative = fitted on several machines, by the
     number of particles; `hgrid calibrate` measures them. They change the levels and with them the time, never the
     pairs. */
  double level_price; /* one more level, per particle (-1) */
  double row_price;   /* looking at a row of a finer level (-1) */
  /* Periodic cells need not be right-angled: their edges are a = (lx, 0, 0), b = (xy, ly, 0) and c = (xz, yz, lz) with
     l = box_max - box_min (LAMMPS's convention). */
  double tilt[3];   /* xy, xz, yz; only xy in 2D. One that is not 0 needs both of its axes periodic, and is at most 2^19
                       lengths of the box along the first (0, 0, 0) */
  int32_t touching; /* 1: particles that touch exactly are a pair, too: <= in place of < (0) */
  int32_t images;   /* HG_NEAREST_IMAGE or HG_ALL_IMAGES (HG_NEAREST_IMAGE) */
} hg_grid_def;

/* One level of the hierarchical grid as it stands, finest first. */
typedef struct hg_level {
  double cell_size;       /* s_h, length */
  double largest_radius;  /* of the particles on the level; 0 if it is empty */
  double occupancy;       /* m_h = N_h s_h^d / V, particles per cell of edge s_h */
  int64_t particle_count; /* N_h */
} hg_level;

/* What the level rule expects of L levels, one entry for each L looked at, L = 1, 2, ... The cost is L (m + K) (Eq. 7)
 * for PAPER, and for AUTO with cell_overhead >= 0. Else it is level_price * L + row_price * rows
 * + tests, counts per particle that are expected from the sizes and a sample of the places: docs/theory/algorithm.md.
 */
typedef struct hg_level_cost {
  int32_t level_count; /* L */
  int32_t reachable;   /* 0 if the sizes cannot be split into L levels (then m and cost are 0), else 1 */
  double occupancy;    /* m = max over levels of m_h */
  double cost;         /* per particle, in units of one test */
} hg_level_cost;

/* Counters of a grid. They describe the grid as built and the last search of all pairs, or, with a skin, the last time
 * that stored candidates were filtered instead; before the first, they are 0. */
typedef struct hg_grid_stats {
  int64_t particle_count;  /* live particles */
  int64_t level_count;     /* levels of the built grid */
  int64_t row_count;       /* rows of cells stored, all levels */
  int64_t cell_count;      /* cells stored, all levels */
  int64_t candidate_count; /* pairs tested in the last search, or stored candidates filtered */
  int64_t undecided_count; /* of these, pairs too near to touching for the fast test */
  int64_t exact_count;     /* of these, pairs too near to touching even for double arithmetic */
  int64_t pair_count;      /* pairs found */
  int64_t build_count;     /* times the grid was built since hg_create */
  int64_t search_count;    /* times all pairs were searched since hg_create */
  int64_t byte_count;      /* memory held by the grid now, results included */
  int64_t filter_count;    /* times stored candidates were filtered instead of a search since hg_create */
  int64_t stored_count;    /* candidates stored now; 0 without a skin, and while they are out of date */
} hg_grid_stats;

/* Receives pairs in batches. `pairs` is valid during the call only. Return 0 to go on, anything else to stop. */
typedef int32_t hg_pair_visitor(void *context, const hg_pair *pairs, size_t count);

/* The most contacts in a batch. */
enum { HG_MAX_BATCH = 1024 };

/* Contacts with their geometry: `count` entries in each array, 1 to HG_MAX_BATCH. (dx, dy, dz) leads from a to the
 * image of b that it meets, each component rounded once from the exact value; dz is NULL in 2D. reach: r_a + r_b +
 * margin, or the larger radius + margin. */
typedef struct hg_contact_batch {
  size_t count;
  const int32_t *a, *b;
  const double *dx, *dy, *dz, *reach;
} hg_contact_batch;

/* Receives contacts in batches. `batch` is valid during the call only. Return 0 to go on, anything else to stop. */
typedef int32_t hg_contact_visitor(void *context, const hg_contact_batch *batch);

/* Fills `def` with the defaults (in brackets above). `struct_size` is sizeof(hg_grid_def) as the caller compiled it.
 * Errors: HG_ERR_NULL; HG_ERR_ARGUMENT if struct_size is smaller than that of version 0.1 or larger than this
 * library's (the header is newer than the library). */
HG_API hg_status hg_grid_def_init(hg_grid_def *def, size_t struct_size);

#ifndef SWIG
/* The defaults by value. Inline, so that a struct that grows never overruns an older caller. */
static inline hg_grid_def hg_default_grid_def(void) {
  hg_grid_def def;
  (void)hg_grid_def_init(&def, sizeof def);
  return def;
}
#endif

#ifdef __cplusplus
}
#endif

#endif
