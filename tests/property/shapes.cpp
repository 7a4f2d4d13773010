// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/property/shapes.hpp"

#include "oracle/shapes.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hgtest {
namespace {

// Every axis by itself: an end where a particle touches it, or both around a centre, or anywhere.
void draw_range(Rng &rng, const Population &among, int axis, double x, double reach, double *low, double *high) {
  const hg_grid_def &def = among.def;
  const double size = reach * std::pow(10, rng.uniform(-2, 2));
  const uint64_t kind = rng.below(6);
  *low = kind == 0 ? x + reach : (kind == 1 ? x - reach - size : (kind == 2 ? x : x + size * rng.uniform(-1, 1)));
  *high = kind == 0 ? *low + size : (kind == 1 ? x - reach : (kind == 2 ? x : *low + size * rng.uniform()));
  if (*high < *low) std::swap(*low, *high);
  if (def.periodic[axis] != 0 && rng.chance(0.3)) {
    const double moved = (def.box_max[axis] - def.box_min[axis]) * rng.integer(-1000, 1000);
    *low += moved;
    *high += moved;
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (rng.chance(0.07)) *low = -kInfinity;
  if (rng.chance(0.07)) *high = kInfinity;
  if (rng.chance(0.01)) *low = *high = rng.chance(0.5) ? kInfinity : -kInfinity;
}

// Corners around a particle at the distance where they touch, or anywhere; some triangles are needles, segments or
// points, some lie in the plane that touches the particle.
void draw_triangle(Rng &rng, const Population &among, double *corners) {
  const size_t i = rng.below(among.particles.count());
  const double *x = among.particles.center(i);
  const double reach = among.particles.radii[i] + among.def.margin;
  const double size =
      (reach > 0 ? reach : largest_reach(among.def, among.particles)) * std::pow(10, rng.uniform(-2, 1.5));
  const uint64_t kind = rng.below(6);
  for (int k = 0; k < 9; k++) corners[k] = x[k % 3] + size * rng.uniform(-1, 1);
  const uint64_t axis = rng.below(3), corner = rng.below(3);
  const double side = rng.chance(0.5) ? reach : -reach;
  for (uint64_t k = 0; k < 3 && kind == 0; k++) corners[3 * k + axis] = x[axis] + side;
  if (kind == 1) {
    std::copy_n(x, 3, corners + 3 * corner);
    corners[3 * corner + axis] += side;
  }
  if (kind == 2) std::copy_n(corners, 3, corners + 3);
  if (kind == 3) std::copy_n(corners, 3, std::copy_n(corners, 3, corners + 3));
  if (kind == 4) {
    const double t = rng.uniform(-0.5, 1.5), off = size * std::pow(2, rng.uniform(-60, -1));
    for (int k = 0; k < 3; k++)
      corners[6 + k] = corners[k] + t * (corners[3 + k] - corners[k]) + off * rng.uniform(-1, 1);
  }
  for (int k = 0; k < 3; k++) {
    if (among.def.periodic[k] == 0 || rng.chance(0.7)) continue;
    const double moved = (among.def.box_max[k] - among.def.box_min[k]) * rng.integer(-1000, 1000);
    for (int c = 0; c < 3; c++) corners[3 * c + k] += moved;
  }
}

// So that the oracle need not look at very many.
bool has_few_images(const Population &among, const double *corners, double reach) {
  double images = 1;
  for (int axis = 0; axis < 3; axis++) {
    if (among.def.periodic[axis] == 0) continue;
    const auto [low, high] = std::minmax({corners[axis], corners[3 + axis], corners[6 + axis]});
    images *= 2 + (high - low + 2 * reach) / (among.def.box_max[axis] - among.def.box_min[axis]);
  }
  return images < 200;
}

void check_triangle_row(const Population &among, const double *corners, const std::vector<int32_t> &ids) {
  require(std::is_sorted(ids.begin(), ids.end()) && std::adjacent_find(ids.begin(), ids.end()) == ids.end(),
          among.name + ": a row of a triangle does not ascend");
  for (size_t n = 0; n < among.particles.count(); n++) {
    const oracle::Sphere particle{among.particles.center(n), among.particles.radii[n]};
    const double reach = particle.radius + among.def.margin;
    double largest = 0;
    for (int k = 0; k < 9; k++) largest = std::max(largest, std::fabs(corners[k]));
    for (int k = 0; k < 3; k++) largest = std::max(largest, std::fabs(particle.center[k]));
    const bool found = std::binary_search(ids.begin(), ids.end(), among.ids[n]);
    const oracle::Meeting truth = triangle_meeting(among.def, corners, particle, 0x1p-40 * (reach + largest));
    const bool missed =
        truth == oracle::Meeting::kMeeting || (truth == oracle::Meeting::kTouching && among.def.touching);
    require(found || !missed, among.name + ": a triangle misses particle " + std::to_string(n));
    require(!found || truth != oracle::Meeting::kNone, among.name + ": a triangle meets particle " + std::to_string(n));
  }
}

}  // namespace

void check_boxes(Rng &rng, const Population &among) {
  const size_t count = 1 + rng.below(20), dimension = static_cast<size_t>(among.particles.dimension);
  std::vector<double> low(count * dimension), high(count * dimension);
  std::vector<std::vector<int32_t>> expected(count);
  for (size_t k = 0; k < count; k++) {
    const size_t i = rng.below(among.particles.count());
    const double reach = among.particles.radii[i] + among.def.margin;
    for (size_t axis = 0; axis < dimension; axis++) {
      const double x = among.particles.center(i)[axis];
      // Touching on one axis is to be decided while the others do not count.
      const bool around = rng.chance(0.4);
      double *ends[2] = {&low[k * dimension + axis], &high[k * dimension + axis]};
      draw_range(rng, among, static_cast<int>(axis), x, reach, ends[0], ends[1]);
      if (around && std::isfinite(*ends[0]) && std::isfinite(*ends[1])) {
        *ends[0] = std::min(*ends[0], x);
        *ends[1] = std::max(*ends[1], x);
      }
    }
    for (size_t n = 0; n < among.particles.count(); n++) {
      const oracle::Sphere particle{among.particles.center(n), among.particles.radii[n]};
      if (oracle::box_meets(among.def, &low[k * dimension], &high[k * dimension], particle)) {
        expected[k].push_back(among.ids[n]);
      }
    }
  }
  require_rows(among.name + ", boxes", among.grid.query_boxes(count, low.data(), high.data()), expected);
}

void check_triangles(Rng &rng, const Population &among) {
  const size_t count = 1 + rng.below(8);
  std::vector<double> corners(9 * count);
  for (size_t k = 0; k < count; k++) draw_triangle(rng, among, &corners[9 * k]);
  if (among.def.dimension == 2) {
    require(status_of([&] { among.grid.query_triangles(count, corners.data()); }) == HG_ERR_STATE,
            "triangles in a plane");
    return;
  }
  const hgrid::Rows rows = among.grid.query_triangles(count, corners.data());
  require(rows.size() == count, among.name + ": the number of rows of triangles");
  for (size_t k = 0; k < count; k++) {
    if (!has_few_images(among, &corners[9 * k], largest_reach(among.def, among.particles))) continue;
    check_triangle_row(among, &corners[9 * k], list_of(rows[k]));
  }
}

}  // namespace hgtest
