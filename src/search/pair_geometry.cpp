// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/pair_geometry.hpp"

#include "src/space/search_box.hpp"

#include <algorithm>
#include <cmath>

namespace hg {
namespace {

bool comes_before(const Shift &s, const Shift &t) { return std::lexicographical_compare(s.n, s.n + 3, t.n, t.n + 3); }

// A sum of doubles that keeps what each addition rounds off (Knuth 1969), and what it cannot keep.
class CarefulSum {
 public:
  void add(double term) {
    const double sum = sum_ + term, added = sum - sum_;
    rest_ += (sum_ - (sum - added)) + (term - added);
    sum_ = sum;
    size_ += std::fabs(term);
  }

  // The rounded sum. False if it is too near to the middle between two doubles to be sure of it.
  bool round(double &rounded) const {
    rounded = sum_ + rest_;
    const double added = rounded - sum_;
    const double rest = (sum_ - (rounded - added)) + (rest_ - added), error = 0x1p-98 * size_;
    return rounded + (rest + error) == rounded && rounded + (rest - error) == rounded;
  }

 private:
  double sum_ = 0, rest_ = 0, size_ = 0;
};

// Factors have at most 23 bits, so that products with either half of a double (Dekker 1971) are exact.
bool round_in_doubles(const ExactSum &sum, double &rounded) {
  CarefulSum total;
  for (int k = 0; k < sum.count; k++) {
    const double value = sum.terms[k].value, scaled = value * 0x1.0000002p27;
    const double high = scaled - (scaled - value), factor = static_cast<double>(sum.terms[k].factor);
    total.add(high * factor);
    total.add((value - high) * factor);
  }
  return total.round(rounded);
}

}  // namespace

PairGeometry::PairGeometry(const Domain &domain, const ParticleStore &store, const Overlap &overlap,
                           double largest_reach)
    : domain_(domain),
      store_(store),
      overlap_(overlap),
      sure_(overlap.surely_nearest()),
      many_images_(domain.all_images && !(largest_reach * (1 + 0x1p-20) < sure_)) {}

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
  double place_a[3], place_b[3];
  const Shift boxes_a = domain_.take_in(store_.center(a), place_a),
              boxes_b = domain_.take_in(store_.center(b), place_b);
  PlaceBox from, to;
  for (int axis = 0; axis < domain_.dimension; axis++) {
    const double around = reach(a, b) * (1 + 0x1p-40) + place_slack(domain_, axis);
    from.low[axis] = from.high[axis] = place_b[axis];
    to.low[axis] = place_a[axis] - around;
    to.high[axis] = place_a[axis] + around;
  }
  visit_shifts(domain_, from, to, [&](const Shift &shift) { visit(shift + boxes_a - boxes_b); });
}

Shift PairGeometry::shift(size_t a, size_t b) const {
  if (!domain_.any_periodic) return {};
  double distance2 = 0;
  const Shift near = nearest(store_.center(a), store_.center(b), distance2);
  if (sure_ > 0 && distance2 < sure_ * sure_) return near;
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
