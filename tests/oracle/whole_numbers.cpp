// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Integers of GMP.
#include "tests/oracle/whole_numbers.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hgtest {
namespace {

// value = odd number * 2^exponent; 0 has none.
int exponent_of(double value) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(value, &exponent), 53);
  exponent -= 53;
  for (auto whole = static_cast<int64_t>(mantissa); whole % 2 == 0; whole /= 2) exponent++;
  return exponent;
}

// Turns doubles into multiples of 2^least.
class Scale {
 public:
  void include(double value) {
    if (value != 0) least_ = std::min(least_, exponent_of(value));
  }
  mpz_class whole(double value) const {
    if (value == 0) return 0;
    const int exponent = exponent_of(value);
    mpz_class result(std::ldexp(value, -exponent));
    mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<unsigned long>(exponent - least_));
    return result;
  }

 private:
  int least_ = 2000;
};

// All n with |d + n length| <= reach, the first and the last; only 0, or none, if the length is 0.
struct Interval {
  Interval(const mpz_class &d, const mpz_class &length, const mpz_class &reach) {
    if (length == 0) {
      last = abs(d) <= reach ? 0 : -1;
      return;
    }
    const mpz_class low = -reach - d, high = reach - d;
    mpz_cdiv_q(first.get_mpz_t(), low.get_mpz_t(), length.get_mpz_t());
    mpz_fdiv_q(last.get_mpz_t(), high.get_mpz_t(), length.get_mpz_t());
  }
  mpz_class first = 0, last = 0;
};

// The particles and their rule in whole numbers.
class WholeNumbers {
 public:
  WholeNumbers(const hg_grid_def &def, const particles::ParticleSet &particles)
      : dimension_(static_cast<size_t>(def.dimension)),
        max_range_(def.interaction == HG_MAX_RANGE),
        touching_(def.touching != 0),
        all_images_(def.images == HG_ALL_IMAGES) {
    Scale scale;
    for (const double tilt : def.tilt) scale.include(tilt);
    scale.include(def.margin);
    for (const double x : particles.centers) scale.include(x);
    for (const double r : particles.radii) scale.include(r);
    for (size_t axis = 0; axis < dimension_; axis++) {
      scale.include(def.box_min[axis]);
      scale.include(def.box_max[axis]);
    }
    margin_ = scale.whole(def.margin);
    for (const double x : particles.centers) centers_.push_back(scale.whole(x));
    for (const double r : particles.radii) radii_.push_back(scale.whole(r));
    for (size_t axis = 0; axis < dimension_; axis++) {
      if (def.periodic[axis] != 0) length_[axis] = scale.whole(def.box_max[axis]) - scale.whole(def.box_min[axis]);
    }
    xy_ = scale.whole(def.tilt[0]);
    xz_ = scale.whole(def.tilt[1]);
    yz_ = scale.whole(def.tilt[2]);
  }

  // How often i and j are a pair, i <= j.
  int64_t count(size_t i, size_t j) const {
    mpz_class d[3] = {0, 0, 0};
    for (size_t axis = 0; axis < dimension_; axis++) {
      d[axis] = centers_[j * dimension_ + axis] - centers_[i * dimension_ + axis];
    }
    mpz_class reach = max_range_ ? std::max(radii_[i], radii_[j]) : mpz_class(radii_[i] + radii_[j]);
    reach += margin_;
    const int64_t images = images_within(d, reach);
    if (!all_images_) return std::min<int64_t>(images, i != j ? 1 : 0);
    return i != j ? images : images / 2;  // an image and its opposite; not the particle itself
  }

 private:
  int64_t images_within(const mpz_class *d, const mpz_class &reach) const {
    int64_t count = 0;
    const Interval c(d[2], length_[2], reach);
    for (mpz_class nc = c.first; nc <= c.last; nc++) {
      const mpz_class z = d[2] + nc * length_[2], y_of_c = d[1] + nc * yz_;
      const Interval b(y_of_c, length_[1], reach);
      for (mpz_class nb = b.first; nb <= b.last; nb++) {
        const mpz_class y = y_of_c + nb * length_[1], x_of_b = d[0] + nc * xz_ + nb * xy_;
        const Interval a(x_of_b, length_[0], reach);
        for (mpz_class na = a.first; na <= a.last; na++) {
          const mpz_class x = x_of_b + na * length_[0], square = x * x + y * y + z * z;
          if (touching_ ? square <= reach * reach : square < reach * reach) count++;
        }
      }
    }
    return count;
  }

  size_t dimension_;
  bool max_range_, touching_, all_images_;
  std::vector<mpz_class> centers_, radii_;
  mpz_class margin_, length_[3], xy_, xz_, yz_;  // length 0: open
};

}  // namespace

std::vector<hg_pair> whole_number_pairs(const hg_grid_def &def, const particles::ParticleSet &particles) {
  const WholeNumbers numbers(def, particles);
  const auto count = static_cast<int32_t>(particles.count());
  std::vector<hg_pair> pairs;
  for (int32_t i = 0; i < count; i++) {
    for (int32_t j = i; j < count; j++) {
      const int64_t times = numbers.count(static_cast<size_t>(i), static_cast<size_t>(j));
      pairs.insert(pairs.end(), static_cast<size_t>(times), {i + def.index_base, j + def.index_base});
    }
  }
  return pairs;
}

}  // namespace hgtest
