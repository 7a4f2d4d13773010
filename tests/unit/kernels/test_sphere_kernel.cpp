// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The sphere kernels of every instruction set that this machine runs against a plain loop over the particles: ranges of
// any length, nearly touching, coordinates that wrap, and spheres of which nothing is sure.
#include "tests/unit/kernels/kernel_sets.hpp"
#include "tests/unit/kernels/plain_test.hpp"

#include <cmath>
#include <vector>

namespace {

using namespace hgtest;

class Scene {
 public:
  Scene(uint64_t seed, int dimension) : rng_(seed), dimension_(dimension), interaction_(rng_.integer(0, 1)) {
    const double scale = std::pow(2, rng_.uniform(0, 27));
    sphere_ = {point(0x1p31 * rng_.uniform(-1, 1), scale, 0), rng_.chance(0.8)};
    const uint32_t count = 1 + static_cast<uint32_t>(rng_.below(70));
    for (uint32_t k = 0; k < count + hg::kPadding; k++) add(scale);
    begin_ = static_cast<uint32_t>(rng_.below(count));
    end_ = begin_ + static_cast<uint32_t>(rng_.below(count - begin_ + 1));
  }

  void check() {
    const std::vector<uint32_t> expected = plain();
    const hg::PointArrays particles{x_.data(), y_.data(), z_.data(), radius_.data(), nullptr, nullptr};
    for (const hg::KernelSet *set : kernel_sets()) {
      std::vector<uint32_t> hits(end_ - begin_ + hg::kPadding);
      hits.resize(set->find_hits[dimension_ - 2][interaction_](sphere_, particles, begin_, end_, hits.data()));
      require(hits == expected, "%s: %zu hits instead of %zu of %u", set->name, hits.size(), expected.size(),
              end_ - begin_);
    }
  }

 private:
  hg::Point point(double middle, double scale, double radius) {
    const auto any = [&] { return static_cast<int32_t>(static_cast<int64_t>(middle + scale * rng_.uniform(-1, 1))); };
    return {any(), any(), dimension_ == 3 ? any() : 0, static_cast<float>(radius)};
  }

  // Half of them where they touch, or nearly.
  void add(double scale) {
    hg::Point p = point(sphere_.at.x, 2 * scale, rng_.chance(0.1) ? 0 : scale * rng_.uniform());
    if (rng_.chance(0.5)) {
      sphere_.at.radius = static_cast<float>(scale);
      const auto reach = static_cast<double>(plain_reach(interaction_, sphere_.at.radius, p.radius));
      p = {static_cast<int32_t>(static_cast<int64_t>(sphere_.at.x + reach) + rng_.integer(-9, 9)), sphere_.at.y,
           sphere_.at.z, p.radius};
    }
    x_.push_back(p.x);
    y_.push_back(p.y);
    z_.push_back(p.z);
    radius_.push_back(p.radius);
  }

  std::vector<uint32_t> plain() const {
    std::vector<uint32_t> hits;
    for (uint32_t k = begin_; k < end_; k++) {
      const hg::Point offset{hg::near_difference(x_[k], sphere_.at.x), hg::near_difference(y_[k], sphere_.at.y),
                             hg::near_difference(z_[k], sphere_.at.z), radius_[k]};
      const hg::Point origin{0, 0, 0, sphere_.at.radius};
      const Verdict verdict = plain_test(offset, origin, interaction_, hg::kBandConstant);
      require_truthful(offset, origin, interaction_, verdict);
      if (!verdict.possible) continue;
      hits.push_back(verdict.sure && sphere_.may_be_sure ? k : k | hg::kUnsureHit);
    }
    return hits;
  }

  Rng rng_;
  int dimension_;
  int32_t interaction_;
  hg::SpherePoint sphere_{};
  std::vector<int32_t> x_, y_, z_;
  std::vector<float> radius_;
  uint32_t begin_ = 0, end_ = 0;
};

void spheres_among_particles(void **) {
  assert_true(sweep(3000, [](uint64_t seed) { Scene(seed, 2 + static_cast<int>(seed % 2)).check(); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(spheres_among_particles)};
  return cmocka_run_group_tests_name("sphere_kernel", tests, nullptr, nullptr);
}
