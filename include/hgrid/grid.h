/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The functions of a grid: a set of particles and the search for pairs among them.
 *
 * Ownership: the library copies what it is given and keeps no pointer of the caller. What queries return belongs to the
 * grid and is borrowed: valid until the next call on that grid that changes it or asks for the same kind of result.
 * Threads: different grids are independent. On one grid, queries from several threads are safe once hg_build has
 * returned; hg_set, hg_insert, hg_move, their forms with arrays, hg_remove, hg_clear, the other hg_set_..., hg_build
 * and hg_destroy need the grid for themselves. Errors: a call that fails has changed nothing. Any call on a NULL grid
 * gives HG_ERR_NULL; any call on a grid from inside one of its own visitors gives HG_ERR_STATE; any call that needs
 * memory may give HG_ERR_MEMORY. N is the number of particles, P that of pairs. Lengths are in the caller's unit. */
#ifndef HGRID_GRID_H
#define HGRID_GRID_H

#include <hgrid/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A grid. Created by hg_create, freed by hg_destroy. */
typedef struct hg_grid hg_grid;

/* Creates an empty grid as `def` says; NULL means the defaults. On failure *grid is NULL.
 * Errors: HG_ERR_NULL (grid); HG_ERR_ARGUMENT: a member of `def` is out of its range (the text names it), `def` was not
 * initialised; HG_ERR_LIMIT: more than HG_MAX_LEVELS levels; HG_ERR_MEMORY. */
HG_API hg_status hg_create(const hg_grid_def *def, hg_grid **grid);

/* Frees the grid and all it lent. NULL is fine. Inside one of the grid's own visitors the call is ignored and leaves a
 * text in hg_last_error. */
HG_API void hg_destroy(hg_grid *grid);

/* Adds `count` particles. The first ever gets the id index_base, each next one the following number.
 * centers: [count][dimension]; radii: [count], >= 0. Both may be NULL if count is 0.
 * Errors: HG_ERR_NULL; HG_ERR_ARGUMENT: NaN, infinity or a negative radius; with HG_NEAREST_IMAGE a periodic cell so
 * short that two particles could meet twice: its shortest lattice vector is shorter than 2 (r1 + r2 + margin), r1 and
 * r2 the two largest radii in the grid (HG_MAX_RANGE: 2 (r1 + margin)); a diameter beyond the last cell of
 * HG_LEVELS_USER; HG_ERR_LIMIT: ids would pass 2^31 - 1, a particle lies more than 2^20 box lengths (2^19 with a tilt)
 * outside a periodic axis, or reaches across more than 2^22 cells; HG_ERR_MEMORY. All or nothing.
 * Complexity: O(count) amortised. */
HG_API hg_status hg_insert(hg_grid *grid, size_t count, const double *centers, const double *radii);

/* Replaces the centres, and the radii unless NULL, of all live particles; row k belongs to the k-th in ascending id.
 * Errors: as hg_insert; HG_ERR_ARGUMENT if count is not the number of live particles. All or nothing.
 * Complexity: O(N); allocates nothing. */
HG_API hg_status hg_move(hg_grid *grid, size_t count, const double *centers, const double *radii);

/* Removes particles. Their ids are not given out again before hg_clear.
 * Errors: HG_ERR_NULL; HG_ERR_NOT_FOUND: an id is unknown, removed already or listed twice. All or nothing.
 * Complexity: O(count log N), and O(N) once in the next build. */
HG_API hg_status hg_remove(hg_grid *grid, size_t count, const int32_t *ids);

/* Removes all particles; ids start anew at index_base. Memory is kept for what comes next. */
HG_API hg_status hg_clear(hg_grid *grid);

/* Makes the grid hold exactly these particles: row k has the id index_base + k, whatever the grid held before. Any
 * count in every step; where count and radii are as before, stored candidates of a skin stay in use, as with hg_move.
 * Arrays and errors as hg_insert. All or nothing. Complexity: O(count); allocates only to grow. */
HG_API hg_status hg_set(hg_grid *grid, size_t count, const double *centers, const double *radii);

/* hg_set, hg_insert and hg_move of numbers that lie elsewhere than in two arrays of doubles. centers: [dimension], one
 * array for each axis; radius: one. Errors name bad numbers as centers[row][axis] and radii[row]. Errors besides:
 * HG_ERR_ARGUMENT: a type or a reserved that is none. */
HG_API hg_status hg_set_arrays(hg_grid *grid, size_t count, const hg_array *centers, const hg_array *radius);
HG_API hg_status hg_insert_arrays(hg_grid *grid, size_t count, const hg_array *centers, const hg_array *radius);
HG_API hg_status hg_move_arrays(hg_grid *grid, size_t count, const hg_array *centers,
                                const hg_array *radius /* NULL: unchanged */);

/* Gives a periodic grid a new box (barostats, shear, deformation); particles stay where they are. Of open axes nothing
 * is read. box_min, box_max: [3], also in 2D; tilt: [3] as in hg_grid_def, NULL: 0, 0, 0. With a skin, stored
 * candidates stay in use while the deformation leaves them valid. Sheared walls that slide (Lees-Edwards) are a tilt
 * that changes. Errors: as hg_create of the box and hg_insert of the particles. All or nothing. Complexity: O(1) and
 * what the next build takes, O(N) if the box is short. */
HG_API hg_status hg_set_box(hg_grid *grid, const double *box_min, const double *box_max, const double *tilt);

/* Says who meets whom: groups[k] of the k-th live particle in ascending id, 0 .. HG_MAX_GROUPS - 1, or -1: absent.
 * Absent particles take part in no query and cost nothing in the search, wherever they are; they still count in
 * hg_move, hg_set_groups and hg_set_bodies, in the check of short periodic boxes, keep empty rows in hg_query_neighbors
 * and stand in hg_query_order. NULL: all are in group 0, `count` is ignored. At first, and when inserted later,
 * particles are in group 0; hg_set leaves groups only if it leaves the number of particles. Groups that were told
 * before change nothing, so that they may be told in each step; others end the use of a skin's stored candidates.
 * Errors: HG_ERR_ARGUMENT: count is not the number of live particles, or a group is none (the text names it). All or
 * nothing. Complexity: O(N). */
HG_API hg_status hg_set_groups(hg_grid *grid, size_t count, const int32_t *groups);

/* Whether particles of two groups, or of one, are pairs at all: interacts is 1 or 0, at first 1 for all. Decided before
 * the search: where it is 0, no pair of theirs is looked for. The table outlives hg_set and hg_clear. Only pairs,
 * neighbours and contacts know groups; hg_query_sphere finds particles of all. Errors: HG_ERR_ARGUMENT. O(1). */
HG_API hg_status hg_set_group_pair(hg_grid *grid, int32_t group_a, int32_t group_b, int32_t interacts);

/* Rigid bodies, clumps, meshes: two particles whose numbers are the same and >= 0 are no pair, nor is one with its own
 * images. bodies[k] of the k-th live particle in ascending id; -1: of no body. NULL: none has one, `count` is ignored.
 * Particles inserted later have none; hg_set and repeated calls: as for groups. Errors: HG_ERR_ARGUMENT: count, or a
 * number below -1. All or nothing. Complexity: O(N). */
HG_API hg_status hg_set_bodies(hg_grid *grid, size_t count, const int32_t *bodies);

/* Makes the grid ready for queries: chooses the levels and sorts the particles into cells. Searches nothing.
 * Queries call it when they must. Complexity: O(N). */
HG_API hg_status hg_build(hg_grid *grid);

/* All pairs, each once, a < b, in the order of def.pair_order. *pairs is NULL only if *count is 0. With HG_ALL_IMAGES
 * equal (a, b) stand side by side, in ascending order of their shifts (x, then y, then z) where HG_ORDER_ID asks for an
 * order; of a particle with itself, a == b, the shift counts whose last component that is not 0 is positive.
 * A second call without a change in between returns the same list.
 * With def.skin, stored candidates are filtered while they hold; the pairs are the same.
 * Complexity: O(N + P) for any sizes when the levels suit them. */
HG_API hg_status hg_query_pairs(hg_grid *grid, const hg_pair **pairs, size_t *count);

/* What leads from a to b in each pair of hg_query_pairs, in its order; either may be NULL. vectors: [pairs][dimension],
 * x_b - x_a and the shift of the image that a meets, rounded once from the exact value: the same bits for any history
 * of the grid, number of threads and machine. shifts: [pairs][dimension], whole edges a, b, c of the periodic cell from
 * the places as given. *vectors and *shifts are NULL only without pairs. Complexity: as hg_query_pairs, and O(P). */
HG_API hg_status hg_query_pair_vectors(hg_grid *grid, const double **vectors, const int32_t **shifts);

/* The pairs of hg_query_pairs into arrays of the caller's, a[capacity] and b[capacity]. *count becomes their number. If
 * they are more than capacity: HG_ERR_CAPACITY, and the arrays are not touched; NULL and 0 ask for the number. */
HG_API hg_status hg_copy_pairs(hg_grid *grid, size_t capacity, int32_t *a, int32_t *b, size_t *count);

/* Hands all pairs with their geometry to `visit`, in batches of at most HG_MAX_BATCH, in the order of def.pair_order,
 * from stored candidates while a skin lets them hold: what a loop over forces wants. The rest as hg_visit_pairs; but
 * with HG_ALL_IMAGES, in a cell where two particles can meet twice, the lists of hg_query_pair_vectors are made first.
 */
HG_API hg_status hg_visit_contacts(hg_grid *grid, hg_contact_visitor *visit, void *context);

/* Hands all pairs to `visit` in batches. With HG_ORDER_GRID and no skin nothing is stored: memory stays bounded
 * whatever P. A visitor that returns nonzero ends the visit; the call still returns HG_OK. The visitor runs on the
 * calling thread.
 */
HG_API hg_status hg_visit_pairs(hg_grid *grid, hg_pair_visitor *visit, void *context);

/* Neighbour lists in compressed rows: the neighbours of the k-th live particle in ascending id are
 * neighbors[offsets[k]] .. neighbors[offsets[k + 1] - 1], ascending ids. offsets has N + 1 entries and starts at 0.
 * With HG_ALL_IMAGES an id stands in a row as often as its pair is found; a pair of a particle with itself once in
 * its row of HG_HALF and twice in that of HG_FULL. list: HG_HALF or HG_FULL. Errors: HG_ERR_NULL, HG_ERR_ARGUMENT
 * (list). Complexity: as hg_query_pairs. */
HG_API hg_status hg_query_neighbors(hg_grid *grid, int32_t list, const int64_t **offsets, const int32_t **neighbors);

/* The lists of hg_query_neighbors into arrays of the caller's, offsets[N + 1] and neighbors[capacity]. *count becomes
 * the number of neighbours. If they are more than capacity: HG_ERR_CAPACITY, offsets is complete all the same, and
 * neighbors is not touched; it may be NULL if capacity is 0. Errors besides: HG_ERR_LIMIT: more than 2^31 - 1
 * neighbours, nothing is written but *count. */
HG_API hg_status hg_copy_neighbors(hg_grid *grid, int32_t list, size_t capacity, int32_t *offsets, int32_t *neighbors,
                                   size_t *count);

/* The particles that a sphere interacts with, by the grid's own rule (interaction, margin, accuracy, periodic axes);
 * ids ascending, each once. center: [dimension]; radius >= 0, finite. Any periodic image counts. The result is
 * borrowed until this thread's next hg_query_sphere on any grid.
 * Errors: HG_ERR_NULL, HG_ERR_ARGUMENT. Complexity: O(cells met + particles met + hits log hits). */
HG_API hg_status hg_query_sphere(hg_grid *grid, const double *center, double radius, const int32_t **ids,
                                 size_t *count);

/* Many spheres at once: two sets of particles, probes, the cells of a fluid solver. Row k, ids[offsets[k]] ..
 * ids[offsets[k + 1] - 1], is what hg_query_sphere gives for sphere k: ids ascending, each once. centers:
 * [count][dimension]; radii: [count], >= 0, finite; offsets has count + 1 entries and starts at 0. On the threads of
 * the grid. All or nothing. The result is borrowed until this thread's next hg_query_spheres on any grid; it comes from
 * malloc, of which a thread keeps 16 MiB at most, or the last result, until it ends.
 * Errors: HG_ERR_NULL, HG_ERR_ARGUMENT (with the index of the sphere), HG_ERR_MEMORY; HG_ERR_LIMIT if one reaches
 * across too many tilted cells, or count is above 2^31 - 1. Complexity: as hg_query_sphere of each, which is faster
 * here, as spheres are taken in an order in which near ones follow each other. */
HG_API hg_status hg_query_spheres(hg_grid *grid, size_t count, const double *centers, const double *radii,
                                  const int64_t **offsets, const int32_t **ids);

/* Particles that axis-aligned boxes meet, in rows as those of hg_query_spheres: the squared distance from the centre to
 * the box is below (radius + margin)^2, or equal to it where touching counts, decided exactly whatever the accuracy and
 * the interaction of the grid; a centre in the closed box counts whatever its radius. low, high: [count][dimension],
 * low <= high, may be infinite. On periodic axes any image counts, each id stands once. On the threads of the grid. All
 * or nothing. Borrowed until this thread's next hg_query_boxes on any grid, kept as the rows of hg_query_spheres.
 * Errors: HG_ERR_NULL; HG_ERR_ARGUMENT (with the index of the box): low > high, NaN, or more than 2^20 box lengths
 * outside a periodic axis that the box does not cover; HG_ERR_STATE if the cell is tilted; HG_ERR_MEMORY; HG_ERR_LIMIT
 * if count is above 2^31 - 1. Complexity: O(cells met + particles met + hits log hits) for each. */
HG_API hg_status hg_query_boxes(hg_grid *grid, size_t count, const double *low, const double *high,
                                const int64_t **offsets, const int32_t **ids);

/* Particles that triangles of a wall mesh meet, in three dimensions, in rows as those of hg_query_spheres: the distance
 * from the centre to the triangle is below radius + margin (or equal where touching counts), whatever the interaction
 * of the grid. Nothing is missed; particles beyond that by less than 2^-40 of the sum of reach and largest coordinate
 * (of corners and centre) may come, too. corners: [count][3 corners][3], finite; any triangle will do, also one that is
 * a segment or a point. On periodic axes any image counts, each id stands once. On the threads of the grid. All or
 * nothing. Borrowed until this thread's next hg_query_triangles on any grid, kept as the rows of hg_query_spheres.
 * Errors: HG_ERR_NULL; HG_ERR_ARGUMENT (with the index of the triangle): a corner that is not finite, or more than 2^20
 * box lengths outside; HG_ERR_STATE in two dimensions or a tilted cell; HG_ERR_MEMORY; HG_ERR_LIMIT if one goes across
 * more than 2^20 periodic cells, or count is above 2^31 - 1. Complexity: as hg_query_boxes, of boxes that follow large
 * triangles. */
HG_API hg_status hg_query_triangles(hg_grid *grid, size_t count, const double *corners, const int64_t **offsets,
                                    const int32_t **ids);

/* Whether two spheres interact that the grid need not hold, by its own rule as in hg_query_sphere: *overlaps is 1 or 0.
 * Errors: HG_ERR_NULL, HG_ERR_ARGUMENT; HG_ERR_LIMIT if they reach across too many tilted cells. */
HG_API hg_status hg_overlap(hg_grid *grid, const double *center_a, double radius_a, const double *center_b,
                            double radius_b, int32_t *overlaps);

/* The ids of all particles in an order in which near ones stand together (a Morton curve). A host that sorts its arrays
 * by it now and then runs faster, and so does the grid. Complexity: O(N log N), nothing if the grid has not changed
 * since. */
HG_API hg_status hg_query_order(hg_grid *grid, const int32_t **ids, size_t *count);

/* The levels of the grid, finest first (the grid is built if it must be). Levels may be empty with HG_LEVELS_USER. */
HG_API hg_status hg_query_levels(hg_grid *grid, const hg_level **levels, size_t *count);

/* The predicted cost of each number of levels that the rule looked at; none for HG_LEVELS_USER (*count = 0). */
HG_API hg_status hg_query_level_costs(hg_grid *grid, const hg_level_cost **costs, size_t *count);

/* Copies the counters into the first struct_size bytes of *stats, struct_size = sizeof(hg_grid_stats) of the caller.
 * Errors: HG_ERR_NULL; HG_ERR_ARGUMENT if struct_size is 0 or larger than this library's. */
HG_API hg_status hg_get_stats(hg_grid *grid, hg_grid_stats *stats, size_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
