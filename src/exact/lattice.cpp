// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/exact/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hg {
namespace {

// A vector of the lattice: how many of each edge, and what they add up to, in units of the longest edge.
struct Vector {
  double n[3] = {0, 0, 0}, x[3] = {0, 0, 0};

  double dot(const Vector &other) const { return x[0] * other.x[0] + x[1] * other.x[1] + x[2] * other.x[2]; }
  double square() const { return dot(*this); }
  void add(double times, const Vector &other) {
    for (int k = 0; k < 3; k++) {
      n[k] += times * other.n[k];
      x[k] += times * other.x[k];
    }
  }
};

// Vectors that span the same lattice and get shorter, until each is a shortest one that the ones before leave (Semaev
// 2001). At most three.
class Basis {
 public:
  explicit Basis(const Domain &domain) {
    double longest = 0;
    for (int axis = 0; axis < domain.dimension; axis++) longest = std::max(longest, domain.period(axis));
    for (int axis = 0; axis < domain.dimension; axis++) {
      if (!domain.periodic[axis]) continue;
      Vector &edge = vector_[count_++];
      edge.n[axis] = 1;
      edge.x[axis] = domain.length[axis] / longest;
      for (int lower = 0; lower < axis; lower++) edge.x[lower] = domain.tilt[kTiltOf[axis][lower]] / longest;
    }
  }

  void reduce() {
    bool shortened = true;
    while (shortened) {
      sort();
      shortened = false;
      if (count_ > 1) shortened = shorten_by_one(vector_[1], vector_[0]);
      if (count_ > 2 && !shortened) shortened = shorten_by_two(vector_[2], vector_[0], vector_[1]);
    }
  }

  int count() const { return count_; }
  const Vector &operator[](int k) const { return vector_[k]; }

 private:
  // So much shorter that rounding does not keep the search going for ever.
  static constexpr double kShorter = 1 - 0x1p-40;

  void sort() {
    for (int last = count_ - 1; last > 0; last--) {
      for (int k = 0; k < last; k++) {
        if (vector_[k + 1].square() < vector_[k].square()) std::swap(vector_[k], vector_[k + 1]);
      }
    }
  }

  static bool shorten_by_one(Vector &v, const Vector &by) {
    Vector best = v;
    best.add(-std::nearbyint(v.dot(by) / by.square()), by);
    return take_if_shorter(v, best);
  }

  // Around the point nearest to v in the plane of two vectors that are reduced.
  static bool shorten_by_two(Vector &v, const Vector &first, const Vector &second) {
    const double ff = first.square(), ss = second.square(), fs = first.dot(second);
    const double determinant = ff * ss - fs * fs;
    if (!(determinant > 0)) return false;
    const double vf = v.dot(first), vs = v.dot(second);
    const double p = std::nearbyint((vf * ss - vs * fs) / determinant);
    const double q = std::nearbyint((vs * ff - vf * fs) / determinant);
    Vector best = v;
    for (int i = -1; i <= 1; i++) {
      for (int j = -1; j <= 1; j++) {
        Vector other = v;
        other.add(-(p + i), first);
        other.add(-(q + j), second);
        if (other.square() < best.square()) best = other;
      }
    }
    return take_if_shorter(v, best);
  }

  static bool take_if_shorter(Vector &v, const Vector &best) {
    if (!(best.square() < v.square() * kShorter)) return false;
    v = best;
    return true;
  }

  Vector vector_[3];
  int count_ = 0;
};

constexpr double kMostEdges = 1073741824.0;  // 2^30

double length_of(const Domain &domain, const Shift &shift) {
  return std::hypot(domain.shifted(0, shift), domain.shifted(1, shift), domain.shifted(2, shift));
}

void add(ShortVectors &found, const Domain &domain, const Shift &shift) {
  found.shift[found.count++] = shift;
  found.shortest = std::min(found.shortest, length_of(domain, shift));
}

// The sums of the vectors of a reduced basis, each taken -1, 0 or 1 times: a shortest one is among them. Those of more
// edges than a Shift holds are longer than any reach for which shifts may be listed (may_list).
void add_sums(ShortVectors &found, const Domain &domain, const Basis &basis) {
  for (Image image = kImages / 2 + 1; image < kImages; image++) {
    Vector sum;
    bool exists = true;
    for (int k = 0; k < 3; k++) {
      const int times = image_step(image, k);
      exists = exists && (times == 0 || k < basis.count());
      if (k < basis.count()) sum.add(times, basis[k]);
    }
    if (!exists || std::any_of(sum.n, sum.n + 3, [](double n) { return std::fabs(n) > kMostEdges; })) continue;
    add(found, domain,
        {{static_cast<int32_t>(sum.n[0]), static_cast<int32_t>(sum.n[1]), static_cast<int32_t>(sum.n[2])}});
  }
}

}  // namespace

void add_shift(ExactSum &sum, const Domain &domain, int axis, const Shift &shift, int64_t times) {
  if (shift.n[axis] != 0) {
    sum.add(domain.box_max[axis], times * shift.n[axis]);
    sum.add(domain.box_min[axis], -times * shift.n[axis]);
  }
  for (int higher = axis + 1; higher < 3; higher++) {
    const double tilt = domain.tilt[kTiltOf[higher][axis]];
    if (shift.n[higher] != 0 && tilt != 0) sum.add(tilt, times * shift.n[higher]);
  }
}

ShortVectors find_short_vectors(const Domain &domain) {
  ShortVectors found;
  if (domain.is_tilted()) {
    Basis basis(domain);
    basis.reduce();
    add_sums(found, domain, basis);
    return found;
  }
  for (int axis = 0; axis < domain.dimension; axis++) {
    Shift edge;
    edge.n[axis] = 1;
    if (domain.periodic[axis]) add(found, domain, edge);
  }
  return found;
}

bool is_shorter(const Domain &domain, const Shift &shift, const ExactSum &length) {
  ExactSum vector[3];
  for (int axis = 0; axis < domain.dimension; axis++) add_shift(vector[axis], domain, axis, shift);
  return exact_order(vector, domain.dimension, length) < 0;
}

}  // namespace hg
