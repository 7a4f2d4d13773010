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

// The nearest image of a difference: |d| <= length / 2.
void fold(mpz_class &d, const mpz_class &length) {
  mpz_class shifted = 2 * d + length, quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), shifted.get_mpz_t(), mpz_class(2 * length).get_mpz_t());
  d -= quotient * length;
}

// The particles and their rule in whole numbers.
class WholeNumbers {
 public:
  WholeNumbers(const hg_grid_def &def, const particles::ParticleSet &particles)
      : dimension_(static_cast<size_t>(def.dimension)), max_range_(def.interaction == HG_MAX_RANGE) {
    Scale scale;
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
  }

  bool interact(size_t i, size_t j) const {
    mpz_class square = 0;
    for (size_t axis = 0; axis < dimension_; axis++) {
      mpz_class d = centers_[i * dimension_ + axis] - centers_[j * dimension_ + axis];
      if (length_[axis] != 0) fold(d, length_[axis]);
      square += d * d;
    }
    mpz_class reach = max_range_ ? std::max(radii_[i], radii_[j]) : mpz_class(radii_[i] + radii_[j]);
    reach += margin_;
    return square < reach * reach;
  }

 private:
  size_t dimension_;
  bool max_range_;
  std::vector<mpz_class> centers_, radii_;
  mpz_class margin_, length_[3];  // 0: open
};

}  // namespace

std::vector<hg_pair> whole_number_pairs(const hg_grid_def &def, const particles::ParticleSet &particles) {
  const WholeNumbers numbers(def, particles);
  const auto count = static_cast<int32_t>(particles.count());
  std::vector<hg_pair> pairs;
  for (int32_t i = 0; i < count; i++) {
    for (int32_t j = i + 1; j < count; j++) {
      if (numbers.interact(static_cast<size_t>(i), static_cast<size_t>(j))) {
        pairs.push_back({i + def.index_base, j + def.index_base});
      }
    }
  }
  return pairs;
}

}  // namespace hgtest
