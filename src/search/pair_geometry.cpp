// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/pair_geometry.hpp"

#include "src/exact/round_in_doubles.hpp"
#include "src/space/search_box.hpp"

#include <algorithm>
#include <cmath>

namespace hg {
namespace {

// Squares below that of it may be rounded by more than a little.
constexpr double kLeastRoot = 1e-140;

bool comes_before(const Shift &s, const Shift &t) { return std::lexicographical_compare(s.n, s.n + 3, t.n, t.n + 3); }

}  // namespace

PairGeometry::PairGeometry(const Domain &domain, const ParticleStore &store, const Overlap &overlap,
                           double largest_reach)
    : domain_(domain),
      store_(store),
      overlap_(overlap),
      many_images_(domain.all_images && !(largest_reach * (1 + 0x1p-20) < overlap.surely_nearest())) {
  const double sure = overlap.surely_nearest();
  if (sure > kLeastRoot) sure2_ = sure * sure;
}

// By whole edges, the last first: near, though not always nearest in a tilted cell.
Shift PairGeometry::nearest(const double *a, const double *b, double &distance2) const {
  Shift shift;
  distance2 = 0;
  for (int axis = domain_.dimension - 1; axis >= 0; axis--) {
    double d = b[axis] - a[axis] + domain_.shifted(axis, shift);
    if (domain_.periodic[axis]) {
      shift.n[axis] = -static_cast<int32_t>(std::floor(d / domain_.length[axis] + 0.5));
      d += shift.n[axis] * domain_.length[axis];
    }
    distance2 += d * d;
  }
  return shift;
}

// The shifts of b that may bring it within reach of a.
template <class Visit>
void PairGeometry::visit_near(size_t a, size_t b, Visit &&visit) const {
  double place_a[3] = {0, 0, 0}, place_b[3] = {0, 0, 0};
  const Shift boxes_a = domain_.take_in(store_.center(a), place_a),
              boxes_b = domain_.take_in(store_.center(b), place_b);
  const PlaceBox near_a = search_box(domain_, place_a, Shift{}, reach(a, b));
  visit_shifts(domain_, PlaceBox::at(place_b, domain_.dimension), near_a,
               [&](const Shift &shift) { visit(shift + boxes_a - boxes_b); });
}

Shift PairGeometry::find_far(size_t a, size_t b, double *components) const {
  const Shift shift = far_shift(a, b);
  vector(a, b, shift, components);
  return shift;
}

Shift PairGeometry::far_shift(size_t a, size_t b) const {
  if (!domain_.any_periodic) return {};
  double distance2 = 0;
  const Shift near = nearest(store_.center(a), store_.center(b), distance2);
  if (distance2 < sure2_) return near;
  Shift found = near;
  int64_t exact = 0;
  visit_near(a, b, [&](const Shift &shift) {
    if (overlap_.is_pair(store_.ball(b), store_.ball(a), shift, exact)) found = shift;
  });
  return found;
}

void PairGeometry::list_shifts(size_t a, size_t b, std::vector<Shift> &shifts) const {
  shifts.clear();
  int64_t exact = 0;
  visit_near(a, b, [&](const Shift &shift) {
    if (a == b && !is_forward(shift)) return;
    if (overlap_.is_pair(store_.ball(b), store_.ball(a), shift, exact)) shifts.push_back(shift);
  });
  std::sort(shifts.begin(), shifts.end(), comes_before);
}

void PairGeometry::vector(size_t a, size_t b, const Shift &shift, double *components) const {
  const double *from = store_.center(a), *to = store_.center(b);
  for (int axis = 0; axis < domain_.dimension; axis++) {
    if (!(domain_.shift_size(axis, shift) > 0)) {
      components[axis] = to[axis] - from[axis];
      continue;
    }
    ExactSum sum;
    sum.add(to[axis], 1);
    sum.add(from[axis], -1);
    add_shift(sum, domain_, axis, shift);
    if (!round_in_doubles(sum, components[axis])) components[axis] = round_exactly(sum);
  }
}

}  // namespace hg
