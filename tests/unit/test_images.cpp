// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Periodic images: all that can reach into the box, each once, forward steps first.
#include "src/index/images.hpp"
#include "tests/unit/checks.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace hgtest;
using hg::Domain;
using hg::Index;
using hg::IndexLevel;

using Key = std::pair<uint32_t, hg::Image>;  // slot and image

bool is_forward(hg::Image image) {
  for (int k = 2; k >= 0; k--) {
    if (hg::image_step(image, k) != 0) return hg::image_step(image, k) > 0;
  }
  return false;
}

class Scene {
 public:
  Scene(uint64_t seed, hg::Memory &memory)
      : rng_(seed),
        domain_(any_domain()),
        index_(memory),
        scratch_(memory),
        store_(memory, domain_, interaction_, 0, std::numeric_limits<double>::infinity()) {
    index_.domain = domain_;
    index_.interaction = interaction_;
  }

  void check() {
    insert();
    const double sizes[3] = {0.02, 0.1, 0.4};
    hg::build_index(index_, scratch_, store_, hg::bounds_of(store_, domain_, 1),
                    hg::user_levels(sizes, 3, interaction_), 1);
    uint32_t begin = 0;
    for (int h = 0; h < index_.level_count; h++) {
      const IndexLevel &level = index_.levels[h];
      require(
          level.image_begin == begin && level.image_forward_end >= begin && level.image_end >= level.image_forward_end,
          "level %d: images [%u, %u, %u)", h, level.image_begin, level.image_forward_end, level.image_end);
      begin = level.image_end;
      check_images(level);
      check_complete(level);
    }
  }

 private:
  Domain any_domain() {
    Domain d;
    d.dimension = rng_.integer(2, 3);
    for (int k = 0; k < d.dimension; k++) {
      d.periodic[k] = rng_.chance(0.6);
      d.any_periodic = d.any_periodic || d.periodic[k];
      d.box_min[k] = rng_.uniform(-1, 1);
      d.box_max[k] = d.box_min[k] + rng_.uniform(0.9, 3);
      d.length[k] = d.box_max[k] - d.box_min[k];
    }
    return d;
  }

  void insert() {
    std::vector<double> centers, radii;
    const int count = rng_.integer(1, 300);
    for (int i = 0; i < count; i++) {
      for (int k = 0; k < domain_.dimension; k++) {
        // At a face now and then.
        double x = rng_.chance(0.1) ? 0 : rng_.uniform(-2, 3);
        if (rng_.chance(0.1)) x = std::nextafter(1, 0);
        centers.push_back(domain_.box_min[k] + x * domain_.length[k]);
      }
      radii.push_back(rng_.chance(0.5) ? 0.2 * rng_.uniform() : 0.01 * rng_.uniform());
    }
    store_.insert(radii.size(), centers.data(), radii.data());
  }

  const hg::Buffer<int32_t> &axis_of(const hg::PointStore &points, int k) const {
    return k == 0 ? points.x : (k == 1 ? points.y : points.z);
  }

  void check_images(const IndexLevel &level) {
    for (uint32_t i = level.image_begin; i < level.image_end; i++) {
      const Key key(index_.images.slot[i], index_.images.image[i]);
      require(found_.insert(key).second, "slot %u has image %d twice", key.first, key.second);
      require(key.second != hg::kNoImage, "slot %u is its own image", key.first);
      require(is_forward(key.second) == (i < level.image_forward_end), "image %d is on the wrong side", key.second);
      place_[key] = i;
    }
  }

  // Whether a particle at x, moved by `step`, comes within `window` of the box.
  bool reaches(int k, int32_t x, int step, double window) const {
    if (step == 0) return true;
    const double at = x + static_cast<double>(step) * index_.frame.period[k];
    return domain_.periodic[k] && at + window >= 0 && at - window <= index_.frame.period[k];
  }

  void check_complete(const IndexLevel &level) {
    const double reach = 2 * interaction_.folded_radius(level.largest_radius) * index_.frame.scale;
    size_t images = 0;
    for (uint32_t i = level.begin; i < level.end; i++) {
      for (hg::Image image = 0; image < 27; image++) {
        if (image == hg::kNoImage) continue;
        bool must = true, may = true;
        for (int k = 0; k < 3; k++) {
          const int step = hg::image_step(image, k);
          const int32_t x = k < domain_.dimension ? axis_of(index_.particles, k)[i] : 0;
          must = must && reaches(k, x, step, reach + 4);
          may = may && reaches(k, x, step, reach * 1.001 + 4096);
        }
        const auto found = place_.find({index_.particles.slot[i], image});
        require(!must || found != place_.end(), "slot %u: image %d is missing", index_.particles.slot[i], image);
        require(may || found == place_.end(), "slot %u: image %d is far off", index_.particles.slot[i], image);
        if (found == place_.end()) continue;
        images++;
        check_one(i, found->second, image);
      }
    }
    require(images == level.image_end - level.image_begin, "%u images, %zu of them of the level",
            level.image_end - level.image_begin, images);
  }

  void check_one(uint32_t particle, uint32_t at, hg::Image image) {
    for (int k = 0; k < domain_.dimension; k++) {
      const int32_t expected =
          axis_of(index_.particles, k)[particle] + hg::image_step(image, k) * index_.frame.period[k];
      require(axis_of(index_.images, k)[at] == expected, "image %d: coordinate %d", image, k);
    }
    require(index_.images.radius[at] == index_.particles.radius[particle], "image %d: radius", image);
  }

  Rng rng_;
  Domain domain_;
  hg::Interaction interaction_;
  Index index_;
  hg::BuildScratch scratch_;
  hg::ParticleStore store_;
  std::set<Key> found_;
  std::map<Key, uint32_t> place_;
};

void check_scene(uint64_t seed) {
  hg::Memory memory(hg::system_allocator());
  Scene(seed, memory).check();
}

void any_scenes(void **) { assert_true(sweep(200, check_scene)); }

void image_numbers(void **) {
  const bool ok = holds(0, [](uint64_t) {
    require(hg::make_image(0, 0, 0) == hg::kNoImage, "no step");
    for (int z = -1; z <= 1; z++) {
      for (int y = -1; y <= 1; y++) {
        for (int x = -1; x <= 1; x++) {
          const hg::Image image = hg::make_image(x, y, z);
          require(hg::image_step(image, 0) == x && hg::image_step(image, 1) == y && hg::image_step(image, 2) == z,
                  "image %d is not (%d, %d, %d)", image, x, y, z);
        }
      }
    }
  });
  assert_true(ok);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_scenes), cmocka_unit_test(image_numbers)};
  return cmocka_run_group_tests_name("images", tests, nullptr, nullptr);
}
