// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers of two words, which stand in where the compiler has none of 128 bits, against GMP modulo 2^128.
#include "src/base/wide.hpp"
#include "tests/unit/checks.hpp"

#include <gmpxx.h>

namespace {

using namespace hgtest;
using hg::TwoWords;

mpz_class whole(uint64_t word) {
  mpz_class number = static_cast<unsigned long>(word >> 32);
  return (number << 32) + static_cast<unsigned long>(word & 0xffffffffU);
}
mpz_class whole(const TwoWords &number) {
  return (whole(static_cast<uint64_t>(number >> 64)) << 64) + whole(static_cast<uint64_t>(number));
}

// Of few bits, of many, or with long runs of ones, where carries go far.
uint64_t draw(Rng &rng) {
  const uint64_t word = rng.next() >> rng.below(64);
  return rng.chance(0.3) ? ~word : word;
}

void require_same(const char *what, const TwoWords &found, mpz_class expected) {
  const mpz_class modulus = mpz_class(1) << 128;
  mpz_fdiv_r(expected.get_mpz_t(), expected.get_mpz_t(), modulus.get_mpz_t());
  require(whole(found) == expected, "%s: %s instead of %s", what, whole(found).get_str(16).c_str(),
          expected.get_str(16).c_str());
}

void check_numbers(uint64_t seed) {
  Rng rng(seed);
  const uint64_t a = draw(rng), b = draw(rng);
  require_same("product", TwoWords::product(a, b), whole(a) * whole(b));

  const TwoWords x(draw(rng), a), y(rng.chance(0.2) ? static_cast<uint64_t>(x >> 64) : draw(rng), b);
  require_same("sum", x + y, whole(x) + whole(y));
  require_same("negative", -x, -whole(x));
  const int bits = static_cast<int>(rng.below(128));
  require_same("shift up", x << bits, whole(x) << bits);
  require_same("shift down", x >> bits, whole(x) >> bits);
  require((x < y) == (whole(x) < whole(y)), "<");
  require((x > y) == (whole(x) > whole(y)), ">");
  require(!(x < x) && x == x && (x == y) == (whole(x) == whole(y)), "==");
}

void numbers_of_two_words(void **) { assert_true(sweep(20000, check_numbers)); }

// What the library computes with here is the same, whichever it is.
void products(void **) {
  Rng rng(1);
  for (int k = 0; k < 1000; k++) {
    const uint64_t a = draw(rng), b = draw(rng);
    const hg::Wide product = hg::wide_product(a, b);
    const TwoWords found(static_cast<uint64_t>(product >> 64), static_cast<uint64_t>(product));
    assert_true(found == TwoWords::product(a, b));
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(numbers_of_two_words), cmocka_unit_test(products)};
  return cmocka_run_group_tests_name("wide", tests, nullptr, nullptr);
}
