// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/sphere_search.hpp"

#include "src/base/error.hpp"
#include "src/base/ordered_bits.hpp"
#include "src/search/level_ranges.hpp"
#include "src/search/pair_search.hpp"
#include "src/space/search_box.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace hg {
namespace {

// In texts.
struct SphereName {
  std::string center, radius;
};

// `name()` is asked for only if something is wrong.
template <class Name>
void check_sphere(const Domain &domain, const Ball &sphere, Name &&name) {
  for (int axis = 0; axis < domain.dimension; axis++) {
    const double x = sphere.center[axis];
    if (!std::isfinite(x)) fail(HG_ERR_ARGUMENT, "%s[%d] = %g is not finite", name().center.c_str(), axis, x);
  }
  const Domain::Outside outside = domain.outside(sphere.center);
  if (!(outside.boxes <= domain.most_outside())) {
    fail(HG_ERR_ARGUMENT, "%s[%d] = %g: more than 2^%d box lengths outside the periodic box", name().center.c_str(),
         outside.axis, sphere.center[outside.axis], std::ilogb(domain.most_outside()));
  }
  if (!std::isfinite(sphere.radius) || is_negative(sphere.radius)) {
    fail(HG_ERR_ARGUMENT, "%s = %g is not finite and >= 0", name().radius.c_str(), sphere.radius);
  }
}

// How far from a sphere images must be looked for, on one axis: as far as it reaches, but of any particle the nearest
// image is enough. In a box of right angles that is within half a length on each axis, in a tilted one within half the
// diagonal.
double farthest_image(const Domain &domain, int axis, double reach) {
  if (!domain.periodic[axis]) return reach;
  const double longest =
      domain.is_tilted() ? std::hypot(domain.period(0), domain.period(1), domain.period(2)) : domain.length[axis];
  return std::min(reach, 0.5 * longest * (1 + 0x1p-20));
}

// In a very thin cell.
void check_reach(const Domain &domain, double reach) {
  if (!domain.is_tilted() ||
      may_list(domain, std::min(reach, domain.length[0] + domain.length[1] + domain.length[2]))) {
    return;
  }
  fail(HG_ERR_LIMIT, "a reach of %g goes across too many periodic cells", reach);
}

// Of a sphere among particles.
template <class Name>
void check_query(const Index &index, const Ball &sphere, Name &&name) {
  check_sphere(index.domain, sphere, name);
  for (int h = 0; index.domain.is_tilted() && h < index.level_count; h++) {
    const IndexLevel &level = index.levels[h];
    if (!level.is_empty()) check_reach(index.domain, index.interaction.reach(sphere.radius, level.largest_radius));
  }
}

class SphereSearch {
 public:
  explicit SphereSearch(const BuiltGrid &grid)
      : grid_(grid),
        index_(grid.index),
        particles_(index_.particles.arrays(false)),
        find_hits_(active_kernels().find_hits[index_.domain.dimension - 2][index_.interaction.kind]),
        skin_(index_.interaction.margin - grid.overlap.interaction().margin) {}

  // As RowSource::find.
  size_t find(const Ball &sphere, Buffer<int32_t> &ids, size_t count) const {
    Found found{sphere, ids, count, {0, 0, 0}, {}, false};
    found.boxes = index_.domain.take_in(sphere.center, found.place);
    for (int h = 0; h < index_.level_count; h++) {
      if (!index_.levels[h].is_empty()) search_level(h, found);
    }
    return ascend_row(ids, count, found.count, found.may_repeat);
  }

 private:
  struct Found {
    const Ball &sphere;
    Buffer<int32_t> &ids;
    size_t count;
    double place[3];
    Shift boxes;      // that were taken off the centre
    bool may_repeat;  // a sphere wider than half the box can meet a particle through several images
  };

  void search_level(int h, Found &found) const {
    const Domain &domain = index_.domain;
    const double reach = index_.interaction.reach(found.sphere.radius, index_.levels[h].largest_radius);
    PlaceBox to;
    for (int axis = 0; axis < domain.dimension; axis++) {
      // Stored candidates may have left their places by the skin.
      const double around = farthest_image(domain, axis, reach * (1 + 0x1p-40)) + skin_ + place_slack(domain, axis);
      to.low[axis] = -around;
      to.high[axis] = index_.map.extent[axis] / index_.map.scale + around;
    }
    int shifts = 0;
    visit_shifts(domain, PlaceBox::at(found.place, domain.dimension), to, [&](const Shift &shift) {
      found.may_repeat = found.may_repeat || shifts++ > 0;
      search_image(h, reach, shift, found);
    });
  }

  void search_image(int h, double reach, const Shift &shift, Found &found) const {
    SpherePoint point;
    const bool fast = suits_fast_test(h, reach) && find_point(found, shift, point);
    visit_ranges(index_, h, search_box(index_.domain, found.place, shift, reach), [&](uint32_t begin, uint32_t end) {
      if (begin == end) return;
      found.ids.grow(found.count + (end - begin) + kPadding);
      if (fast) {
        test_fast(point, begin, end, shift, found);
      } else {
        test_all(begin, end, shift, found);
      }
    });
  }

  // Chunks that a sphere meets are no farther from it than it reaches and a chunk is long, so that differences of
  // coordinates that wrap are exact. docs/theory/exactness.md, section 12.
  bool suits_fast_test(int h, double reach) const {
    if (index_.chunked && (index_.chunks.level(h).giants || index_.squeezed.in_use())) return false;
    return reach * index_.map.scale <= (index_.chunked ? kLongestInChunks : kLongestInCells) &&
           plain_squares_are_clear(grid_.overlap.accuracy(), index_.map.scale, reach);
  }

  // False if the sphere is so far from all particles that coordinates do not reach there.
  bool find_point(const Found &found, const Shift &shift, SpherePoint &point) const {
    const double lowest = index_.chunked ? -kFarthestPlace : -kFixedPointQuanta;
    const double highest = index_.chunked ? kFarthestPlace : 2 * kFixedPointQuanta - 1;
    int32_t x[3] = {0, 0, 0};
    for (int axis = 0; axis < index_.domain.dimension; axis++) {
      const double quanta = index_.map.quanta(axis, found.place[axis] + index_.domain.shifted(axis, shift));
      if (!(quanta >= lowest && quanta <= highest)) return false;
      const double whole = index_.chunked ? std::nearbyint(quanta) : std::floor(quanta);
      x[axis] = static_cast<int32_t>(static_cast<uint32_t>(static_cast<int64_t>(whole)));
    }
    const double radius = index_.interaction.folded_radius(found.sphere.radius) * index_.map.scale;
    point = {{x[0], x[1], x[2], static_cast<float>(radius)}, skin_ == 0};
    return true;
  }

  void test_fast(const SpherePoint &point, uint32_t begin, uint32_t end, const Shift &shift, Found &found) const {
    int32_t *ids = found.ids.data() + found.count;
    const size_t hits = find_hits_(point, particles_, begin, end, reinterpret_cast<uint32_t *>(ids));
    for (size_t k = 0; k < hits; k++) {
      const auto hit = static_cast<uint32_t>(ids[k]);
      const uint32_t particle = hit & ~kUnsureHit, slot = particles_.slot[particle];
      if (hit != particle && !holds(particle, slot, shift, found)) continue;
      found.ids[found.count++] = grid_.store.id(slot);
    }
  }

  void test_all(uint32_t begin, uint32_t end, const Shift &shift, Found &found) const {
    for (uint32_t j = begin; j < end; j++) {
      const uint32_t slot = particles_.slot[j];
      if (holds(j, slot, shift, found)) found.ids[found.count++] = grid_.store.id(slot);
    }
  }

  bool holds(uint32_t particle, uint32_t slot, const Shift &shift, const Found &found) const {
    int64_t exact = 0;
    const Shift between = shift + grid_.boxes(particle, slot) - found.boxes;
    return grid_.overlap.holds(found.sphere, grid_.store.ball(slot), between, exact);
  }

  // In quanta. Floats hold their squares; coordinates that wrap their differences.
  static constexpr double kLongestInCells = 0x1p60, kLongestInChunks = 0x1p29;
  static constexpr double kFarthestPlace = 0x1p50;

  const BuiltGrid &grid_;
  const Index &index_;
  PointArrays particles_;
  SphereKernel *find_hits_;
  double skin_;
};

class ManySpheres final : public RowSource {
 public:
  ManySpheres(const BuiltGrid &grid, size_t count, const double *centers, const double *radii)
      : search_(grid),
        dimension_(static_cast<size_t>(grid.index.domain.dimension)),
        count_(count),
        centers_(centers),
        radii_(radii) {
    for (size_t k = 0; k < count; k++) {
      check_query(grid.index, ball(k), [k] {
        const std::string row = "[" + std::to_string(k) + "]";
        return SphereName{"centers" + row, "radii" + row};
      });
    }
  }
  size_t count() const override { return count_; }
  void find_center(size_t k, double *center) const override { std::copy_n(ball(k).center, dimension_, center); }
  size_t find(size_t k, Buffer<int32_t> &ids, size_t count) const override { return search_.find(ball(k), ids, count); }

 private:
  Ball ball(size_t k) const { return {centers_ + k * dimension_, radii_[k]}; }

  SphereSearch search_;
  size_t dimension_, count_;
  const double *centers_, *radii_;
};

}  // namespace

bool overlaps(const Domain &domain, const Overlap &overlap, const Ball &a, const Ball &b) {
  check_sphere(domain, a, [] { return SphereName{"center_a", "radius_a"}; });
  check_sphere(domain, b, [] { return SphereName{"center_b", "radius_b"}; });
  double place_a[3] = {0, 0, 0}, place_b[3] = {0, 0, 0};
  const Shift boxes = domain.take_in(b.center, place_b) - domain.take_in(a.center, place_a);
  const double reach = overlap.interaction().reach(a.radius, b.radius) * (1 + 0x1p-40);
  check_reach(domain, reach);
  PlaceBox to;
  for (int axis = 0; axis < domain.dimension; axis++) {
    const double around = farthest_image(domain, axis, reach) + place_slack(domain, axis);
    to.low[axis] = place_b[axis] - around;
    to.high[axis] = place_b[axis] + around;
  }
  bool found = false;
  int64_t exact = 0;
  visit_shifts(domain, PlaceBox::at(place_a, domain.dimension), to,
               [&](const Shift &shift) { found = found || overlap.holds(a, b, shift + boxes, exact); });
  return found;
}

size_t query_sphere(const BuiltGrid &grid, const Ball &sphere, Buffer<int32_t> &ids) {
  check_query(grid.index, sphere, [] { return SphereName{"center", "radius"}; });
  return SphereSearch(grid).find(sphere, ids, 0);
}

void query_spheres(const BuiltGrid &grid, size_t count, const double *centers, const double *radii, QueryRows &rows) {
  rows.find(grid, ManySpheres(grid, count, centers, radii));
}

}  // namespace hg
