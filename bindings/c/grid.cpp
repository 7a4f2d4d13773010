// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The functions of include/hgrid/grid.h and types.h.
#include "bindings/c/aligned.hpp"
#include "bindings/c/guard.hpp"
#include "src/search/box_search.hpp"
#include "src/search/sphere_search.hpp"
#include "src/search/triangle_search.hpp"

#include <cstring>

using hg::Aligned;
using hg::check_pointer;
using hg::fail;
using hg::Grid;
using hg::guarded;
using hg::on_grid;

namespace hg {
namespace {

// The last result of hg_query_sphere on this thread.
struct SphereResult {
  Memory memory{system_allocator()};
  Buffer<int32_t> ids{memory};
};

SphereResult &sphere_result() {
  thread_local SphereResult result;
  return result;
}

void check_group(int32_t group, const char *name) {
  if (group >= 0 && group < HG_MAX_GROUPS) return;
  fail(HG_ERR_ARGUMENT, "%s = %d is not one of 0 .. %d", name, static_cast<int>(group), HG_MAX_GROUPS - 1);
}

void check_list(int32_t list) {
  if (list == HG_HALF || list == HG_FULL) return;
  fail(HG_ERR_ARGUMENT, "list = %d is neither HG_HALF nor HG_FULL", static_cast<int>(list));
}

}  // namespace
}  // namespace hg

hg_status hg_grid_def_init(hg_grid_def *def, size_t struct_size) {
  return guarded([&] {
    check_pointer(def, "def");
    hg::fill_defaults(def, struct_size);
  });
}

hg_status hg_create(const hg_grid_def *def, hg_grid **grid) {
  if (grid != nullptr) *grid = nullptr;
  return guarded([&] {
    check_pointer(grid, "grid");
    hg_grid_def defaults;
    if (def == nullptr) hg::fill_defaults(&defaults, sizeof defaults);
    const hg::Definition definition = hg::check_definition(def != nullptr ? *def : defaults);
    *grid = hg::make_object<hg_grid>(
        [&](void *memory, const hg_allocator &allocator) { return new (memory) hg_grid{Grid(definition, allocator)}; });
  });
}

void hg_destroy(hg_grid *grid) {
  if (grid == nullptr) return;
  if (grid->grid.is_visited()) {
    hg::remember_error("hg_destroy ignored: the grid is being visited");
    return;
  }
  hg::free_object(grid, grid->grid.allocator());
}

hg_status hg_insert(hg_grid *grid, size_t count, const double *centers, const double *radii) {
  return on_grid(grid, {}, [&](Grid &g) {
    const Aligned<double> x(g, "centers", centers, count, g.dimension()), r(g, "radii", radii, count);
    g.insert(count, x.get(), r.get());
  });
}

hg_status hg_move(hg_grid *grid, size_t count, const double *centers, const double *radii) {
  return on_grid(grid, {}, [&](Grid &g) {
    const Aligned<double> x(g, "centers", centers, count, g.dimension());
    const Aligned<double> r(g, "radii", radii, radii != nullptr ? count : 0);
    g.move(count, x.get(), r.get());
  });
}

hg_status hg_set(hg_grid *grid, size_t count, const double *centers, const double *radii) {
  return on_grid(grid, {}, [&](Grid &g) {
    const Aligned<double> x(g, "centers", centers, count, g.dimension()), r(g, "radii", radii, count);
    g.set(count, x.get(), r.get());
  });
}

hg_status hg_set_arrays(hg_grid *grid, size_t count, const hg_array *centers, const hg_array *radius) {
  return on_grid(grid, {}, [&](Grid &g) {
    if (count > 0) check_pointer(radius, "radius");
    g.set_arrays(count, centers, radius);
  });
}

hg_status hg_insert_arrays(hg_grid *grid, size_t count, const hg_array *centers, const hg_array *radius) {
  return on_grid(grid, {}, [&](Grid &g) {
    if (count > 0) check_pointer(radius, "radius");
    g.insert_arrays(count, centers, radius);
  });
}

hg_status hg_move_arrays(hg_grid *grid, size_t count, const hg_array *centers, const hg_array *radius) {
  return on_grid(grid, {}, [&](Grid &g) { g.move_arrays(count, centers, radius); });
}

hg_status hg_remove(hg_grid *grid, size_t count, const int32_t *ids) {
  return on_grid(grid, {}, [&](Grid &g) { g.remove(count, Aligned<int32_t>(g, "ids", ids, count).get()); });
}

hg_status hg_clear(hg_grid *grid) {
  return on_grid(grid, {}, [](Grid &g) { g.clear(); });
}

hg_status hg_set_box(hg_grid *grid, const double *box_min, const double *box_max, const double *tilt) {
  return on_grid(grid, {{box_min, "box_min"}, {box_max, "box_max"}}, [&](Grid &g) {
    const Aligned<double> low(g, "box_min", box_min, 3), high(g, "box_max", box_max, 3);
    g.set_box(low.get(), high.get(), Aligned<double>(g, "tilt", tilt, tilt != nullptr ? 3 : 0).get());
  });
}

hg_status hg_set_groups(hg_grid *grid, size_t count, const int32_t *groups) {
  return on_grid(grid, {}, [&](Grid &g) {
    g.set_groups(count, Aligned<int32_t>(g, "groups", groups, groups != nullptr ? count : 0).get());
  });
}

hg_status hg_set_group_pair(hg_grid *grid, int32_t group_a, int32_t group_b, int32_t interacts) {
  return on_grid(grid, {}, [&](Grid &g) {
    hg::check_group(group_a, "group_a");
    hg::check_group(group_b, "group_b");
    if (interacts != 0 && interacts != 1) {
      fail(HG_ERR_ARGUMENT, "interacts = %d is neither 0 nor 1", static_cast<int>(interacts));
    }
    g.set_group_pair(group_a, group_b, interacts == 1);
  });
}

hg_status hg_set_bodies(hg_grid *grid, size_t count, const int32_t *bodies) {
  return on_grid(grid, {}, [&](Grid &g) {
    g.set_bodies(count, Aligned<int32_t>(g, "bodies", bodies, bodies != nullptr ? count : 0).get());
  });
}

hg_status hg_build(hg_grid *grid) {
  return on_grid(grid, {}, [](Grid &g) { g.build(); });
}

hg_status hg_query_pairs(hg_grid *grid, const hg_pair **pairs, size_t *count) {
  return on_grid(grid, {{pairs, "pairs"}, {count, "count"}}, [&](Grid &g) { g.query_pairs(pairs, count); });
}

hg_status hg_visit_pairs(hg_grid *grid, hg_pair_visitor *visit, void *context) {
  return on_grid(grid, {{visit, "visit"}}, [&](Grid &g) { g.visit_pairs(visit, context); });
}

hg_status hg_query_pair_vectors(hg_grid *grid, const double **vectors, const int32_t **shifts) {
  return on_grid(grid, {}, [&](Grid &g) { g.query_pair_vectors(vectors, shifts); });
}

hg_status hg_copy_pairs(hg_grid *grid, size_t capacity, int32_t *a, int32_t *b, size_t *count) {
  return on_grid(grid, {{count, "count"}}, [&](Grid &g) { g.copy_pairs(capacity, a, b, count); });
}

hg_status hg_visit_contacts(hg_grid *grid, hg_contact_visitor *visit, void *context) {
  return on_grid(grid, {{visit, "visit"}}, [&](Grid &g) { g.visit_contacts(visit, context); });
}

hg_status hg_query_order(hg_grid *grid, const int32_t **ids, size_t *count) {
  return on_grid(grid, {{ids, "ids"}, {count, "count"}}, [&](Grid &g) { g.query_order(ids, count); });
}

hg_status hg_overlap(hg_grid *grid, const double *center_a, double radius_a, const double *center_b, double radius_b,
                     int32_t *overlaps) {
  return on_grid(grid, {{center_a, "center_a"}, {center_b, "center_b"}, {overlaps, "overlaps"}}, [&](Grid &g) {
    const Aligned<double> a(g, "center_a", center_a, 1, g.dimension()), b(g, "center_b", center_b, 1, g.dimension());
    *overlaps = g.overlaps({a.get(), radius_a}, {b.get(), radius_b}) ? 1 : 0;
  });
}

hg_status hg_query_neighbors(hg_grid *grid, int32_t list, const int64_t **offsets, const int32_t **neighbors) {
  return on_grid(grid, {{offsets, "offsets"}, {neighbors, "neighbors"}}, [&](Grid &g) {
    hg::check_list(list);
    g.query_neighbors(list, offsets, neighbors);
  });
}

hg_status hg_copy_neighbors(hg_grid *grid, int32_t list, size_t capacity, int32_t *offsets, int32_t *neighbors,
                            size_t *count) {
  return on_grid(grid, {{offsets, "offsets"}, {count, "count"}}, [&](Grid &g) {
    hg::check_list(list);
    g.copy_neighbors(list, capacity, offsets, neighbors, count);
  });
}

hg_status hg_query_sphere(hg_grid *grid, const double *center, double radius, const int32_t **ids, size_t *count) {
  return on_grid(grid, {{center, "center"}, {ids, "ids"}, {count, "count"}}, [&](Grid &g) {
    const Aligned<double> x(g, "center", center, 1, g.dimension());
    hg::SphereResult &result = hg::sphere_result();
    const size_t found = hg::query_sphere(g.built(), {x.get(), radius}, result.ids);
    *ids = found == 0 ? nullptr : result.ids.data();
    *count = found;
  });
}

hg_status hg_query_spheres(hg_grid *grid, size_t count, const double *centers, const double *radii,
                           const int64_t **offsets, const int32_t **ids) {
  return on_grid(grid, {{offsets, "offsets"}, {ids, "ids"}}, [&](Grid &g) {
    const Aligned<double> x(g, "centers", centers, count, g.dimension()), r(g, "radii", radii, count);
    thread_local hg::QueryRows rows;
    hg::query_spheres(g.built(), count, x.get(), r.get(), rows);
    *offsets = rows.offsets();
    *ids = rows.ids();
  });
}

hg_status hg_query_boxes(hg_grid *grid, size_t count, const double *low, const double *high, const int64_t **offsets,
                         const int32_t **ids) {
  return on_grid(grid, {{offsets, "offsets"}, {ids, "ids"}}, [&](Grid &g) {
    const Aligned<double> l(g, "low", low, count, g.dimension()), h(g, "high", high, count, g.dimension());
    thread_local hg::QueryRows rows;
    hg::query_boxes(g.built(), count, l.get(), h.get(), rows);
    *offsets = rows.offsets();
    *ids = rows.ids();
  });
}

hg_status hg_query_triangles(hg_grid *grid, size_t count, const double *corners, const int64_t **offsets,
                             const int32_t **ids) {
  return on_grid(grid, {{offsets, "offsets"}, {ids, "ids"}}, [&](Grid &g) {
    const Aligned<double> x(g, "corners", corners, count, 9);
    thread_local hg::QueryRows rows;
    hg::query_triangles(g.built(), count, x.get(), rows);
    *offsets = rows.offsets();
    *ids = rows.ids();
  });
}

hg_status hg_query_levels(hg_grid *grid, const hg_level **levels, size_t *count) {
  return on_grid(grid, {{levels, "levels"}, {count, "count"}}, [&](Grid &g) { g.query_levels(levels, count); });
}

hg_status hg_query_level_costs(hg_grid *grid, const hg_level_cost **costs, size_t *count) {
  return on_grid(grid, {{costs, "costs"}, {count, "count"}}, [&](Grid &g) { g.query_level_costs(costs, count); });
}

hg_status hg_get_stats(hg_grid *grid, hg_grid_stats *stats, size_t struct_size) {
  return on_grid(grid, {{stats, "stats"}}, [&](Grid &g) {
    if (struct_size == 0 || struct_size > sizeof(hg_grid_stats)) {
      fail(HG_ERR_ARGUMENT, "struct_size = %zu: this library knows up to %zu", struct_size, sizeof(hg_grid_stats));
    }
    const hg_grid_stats all = g.stats();
    std::memcpy(stats, &all, struct_size);
  });
}
