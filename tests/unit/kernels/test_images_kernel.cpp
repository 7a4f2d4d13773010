// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The image kernels of every instruction set that this machine runs: all wanted images that come near the box, of all
// points of a range, in order, and no others.
#include "tests/unit/checks.hpp"
#include "tests/unit/kernels/block_counts.hpp"
#include "tests/unit/kernels/kernel_sets.hpp"

#include <cmath>
#include <vector>

namespace {

using namespace hgtest;

constexpr hg::PointImage kGuard = {77, 99};

class Scene {
 public:
  Scene(uint64_t seed, size_t count) : rng_(seed), dimension_(rng_.integer(2, 3)) {
    for (int axis = 0; axis < dimension_; axis++) {
      input_.periodic[axis] = rng_.chance(0.7);
      if (input_.periodic[axis]) input_.period[axis] = rng_.chance(0.05) ? 0 : rng_.integer(1 << 12, 1 << 30);
      reach_ = std::min(reach_, input_.period[axis] > 0 ? input_.period[axis] / 2 : reach_);
    }
    reach_ = rng_.chance(0.5) ? reach_ : rng_.integer(0, reach_);
    input_.reach = static_cast<float>(reach_);
    const hg::ImageSet sets[3] = {hg::kForwardImages, hg::kBackwardImages, hg::kForwardImages | hg::kBackwardImages};
    input_.wanted = sets[rng_.below(3)];
    for (int axis = 0; axis < dimension_; axis++) {
      for (size_t i = 0; i < count; i++) x_[axis].push_back(any_place(axis));
      input_.x[axis] = x_[axis].data();
    }
    begin_ = rng_.below(count + 1);
    end_ = begin_ + rng_.below(count - begin_ + 1);
  }

  void check() {
    const std::vector<hg::PointImage> expected = plain_images();
    for (const hg::KernelSet *set : kernel_sets()) {
      std::vector<hg::PointImage> found(expected.size() + 1, kGuard);
      const size_t count = set->find_images[dimension_ - 2](input_, begin_, end_, found.data());
      require(count == expected.size(), "%s: %zu images instead of %zu", set->name, count, expected.size());
      for (size_t k = 0; k < count; k++) {
        require(same(found[k], expected[k]), "%s: image %zu is %d of point %u instead of %d of %u", set->name, k,
                found[k].image, found[k].point, expected[k].image, expected[k].point);
      }
      require(same(found[count], kGuard), "%s: wrote beyond the images", set->name);
    }
  }

 private:
  // Anywhere in the box; in half of the scenes' places where a face comes or goes out of reach.
  int32_t any_place(int axis) {
    const int32_t period = input_.period[axis] > 0 ? input_.period[axis] : 1 << 30;
    if (rng_.chance(0.5)) return rng_.integer(0, period - 1);
    const int32_t near = std::clamp(reach_ + rng_.integer(-200, 200), 0, period - 1);
    return rng_.chance(0.5) ? near : period - 1 - near;
  }

  static bool same(const hg::PointImage &a, const hg::PointImage &b) {
    return a.point == b.point && a.image == b.image;
  }

  bool comes_near(size_t i, int axis, int step) const {
    if (step == 0) return true;
    if (axis >= dimension_ || !input_.periodic[axis]) return false;
    const auto x = static_cast<float>(x_[axis][i]), period = static_cast<float>(input_.period[axis]);
    return step < 0 ? (x - period) + input_.reach >= 0 : (x + period) - input_.reach <= period;
  }

  std::vector<hg::PointImage> plain_images() const {
    std::vector<hg::PointImage> images;
    for (size_t i = begin_; i < end_; i++) {
      for (hg::Image image = 0; image < hg::kImages; image++) {
        bool has = (input_.wanted >> image & 1) != 0;
        for (int axis = 0; axis < 3; axis++) has = has && comes_near(i, axis, hg::image_step(image, axis));
        if (has) images.push_back({static_cast<uint32_t>(i), image});
      }
    }
    return images;
  }

  Rng rng_;
  int dimension_;
  int32_t reach_ = 1 << 29;
  hg::ImageInput input_{};
  std::vector<int32_t> x_[3];
  size_t begin_ = 0, end_ = 0;
};

}  // namespace

int main() { return check_counts<Scene, 500>("images_kernel"); }
