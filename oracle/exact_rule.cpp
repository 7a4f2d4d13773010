// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether two particles interact, decided in rational numbers.
#include "oracle/cell.hpp"
#include "oracle/images.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>

namespace oracle {
namespace {

mpq_class exact_squared_distance(const hg_grid_def &def, const double *a, const double *b, const Shift &shift) {
  const Cell<mpq_class> cell(def);
  mpq_class sum = 0;
  for (int axis = 0; axis < def.dimension; axis++) {
    mpq_class d = mpq_class(b[axis]) - mpq_class(a[axis]);
    // The shifts are whole doubles; GMP knows no int64_t where long has 32 bits.
    for (int edge = axis; edge < def.dimension; edge++)
      d += mpq_class(static_cast<double>(shift.n[edge])) * cell.edge[axis][edge];
    sum += d * d;
  }
  return sum;
}

mpq_class exact_squared_reach(const hg_grid_def &def, double ra, double rb) {
  mpq_class reach(def.margin);
  if (def.interaction == HG_MAX_RANGE) {
    reach += mpq_class(std::fmax(ra, rb));
  } else {
    reach += mpq_class(ra) + mpq_class(rb);
  }
  return reach * reach;
}

double rounded_reach(const hg_grid_def &def, double ra, double rb) {
  return (def.interaction == HG_MAX_RANGE ? std::fmax(ra, rb) : ra + rb) + def.margin;
}

enum class Verdict { kYes, kNo, kUnclear };

// Doubles decide where the two squares differ by far more than rounding can do. A component of the distance is the sum
// of dx and at most three products n L; it is wrong by at most E = 8 eps (|dx| + sum |n L|): rounding dx, L, n L and
// the sums costs less than 5 eps of that. So the square of the distance is wrong by sum (2 |d| E + E^2) plus a few eps
// of itself; the bound used is larger by orders of magnitude. Squares outside [1e-280, 1e280] are left to the
// rationals, which keeps under- and overflow out of the argument.
Verdict clear_verdict(const hg_grid_def &def, const Sphere &a, const Sphere &b, const Shift &shift) {
  const Cell<double> cell(def);
  double distance2 = 0;
  double slack = 0;
  for (int axis = 0; axis < def.dimension; axis++) {
    double d = b.center[axis] - a.center[axis];
    double size = std::fabs(d);
    for (int edge = axis; edge < def.dimension; edge++) {
      const double term = static_cast<double>(shift.n[edge]) * cell.edge[axis][edge];
      size += std::fabs(term);
      d += term;
    }
    const double error = 16 * 0x1p-53 * size;
    slack += 2 * std::fabs(d) * error + error * error;
    distance2 += d * d;
  }
  const double reach = rounded_reach(def, a.radius, b.radius);
  const double reach2 = reach * reach;
  const auto in_range = [](double x) { return x > 1e-280 && x < 1e280; };
  if (!in_range(distance2) || !in_range(reach2) || !(slack < 1e280)) return Verdict::kUnclear;
  slack = 2 * slack + 1e-12 * (distance2 + reach2);
  if (distance2 + slack < reach2) return Verdict::kYes;
  if (distance2 - slack > reach2) return Verdict::kNo;
  return Verdict::kUnclear;
}

bool image_interacts(const hg_grid_def &def, const Sphere &a, const Sphere &b, const Shift &shift) {
  const Verdict verdict = clear_verdict(def, a, b, shift);
  if (verdict != Verdict::kUnclear) return verdict == Verdict::kYes;
  const mpq_class distance2 = exact_squared_distance(def, a.center, b.center, shift);
  const mpq_class reach2 = exact_squared_reach(def, a.radius, b.radius);
  return def.touching != 0 ? distance2 <= reach2 : distance2 < reach2;
}

}  // namespace

std::vector<Shift> exact_shifts(const hg_grid_def &def, const Sphere &a, const Sphere &b) {
  std::vector<Shift> shifts = images_near(def, a.center, b.center, rounded_reach(def, a.radius, b.radius));
  shifts.erase(std::remove_if(shifts.begin(), shifts.end(),
                              [&](const Shift &shift) { return !image_interacts(def, a, b, shift); }),
               shifts.end());
  if (def.images == HG_NEAREST_IMAGE && shifts.size() > 1) shifts.resize(1);
  return shifts;
}

// One image is enough for HG_NEAREST_IMAGE: of a sphere larger than the cell there are many.
int exact_interact(const hg_grid_def &def, const Sphere &a, const Sphere &b) {
  if (def.images == HG_NEAREST_IMAGE) {
    const Shift middle = middle_image(def, a.center, b.center);
    if (clear_verdict(def, a, b, middle) == Verdict::kYes) return 1;
  }
  return static_cast<int>(exact_shifts(def, a, b).size());
}

// Images are looked for farther and farther away, until enough lie within the distance that was looked at.
double relative_gap(const hg_grid_def &def, const Sphere &a, const Sphere &b, size_t nearer) {
  std::vector<mpq_class> distances;
  for (double within = rounded_reach(def, a.radius, b.radius);; within *= 2) {
    distances.clear();
    for (const Shift &shift : images_near(def, a.center, b.center, within)) {
      distances.push_back(exact_squared_distance(def, a.center, b.center, shift));
    }
    std::sort(distances.begin(), distances.end());
    const mpq_class limit(within);
    if (distances.size() > nearer && distances[nearer] <= limit * limit) break;
  }
  const mpq_class ratio = distances[nearer] / exact_squared_reach(def, a.radius, b.radius);
  return std::sqrt(ratio.get_d()) - 1;
}

}  // namespace oracle
