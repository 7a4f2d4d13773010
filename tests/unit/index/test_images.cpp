// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Periodic images: all that can reach into the box, each once, forward steps first, backward ones where there is a
// finer level.
#include "src/index/build_index.hpp"
#include "src/particles/bounds.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/stores.hpp"

#include <cmath>
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
  for (int axis = 2; axis >= 0; axis--) {
    if (hg::image_step(image, axis) != 0) return hg::image_step(image, axis) > 0;
  }
  return false;
}

class Scene {
 public:
  Scene(uint64_t seed, hg::Memory &memory)
      : rng_(seed),
        domain_(any_domain()),
        index_(memory, domain_, interaction_),
        scratch_(memory),
        store_(make_store(memory, domain_)) {}

  void check() {
    insert();
    const double sizes[3] = {0.02, 0.1, 0.4};
    const hg::Bounds bounds = hg::bounds_of(store_, domain_, 1);
    index_.map = hg::FixedPoint::over(bounds, domain_, 2 * bounds.max_radius);
    hg::build_index(index_, scratch_, store_, hg::user_levels(sizes, 3, interaction_), 1);
    uint32_t begin = 0;
    for (int h = 0; h < index_.level_count; h++) {
      const IndexLevel &level = index_.levels[h];
      require(
          level.image_begin == begin && level.image_forward_end >= begin && level.image_end >= level.image_forward_end,
          "level %d: images [%u, %u, %u)", h, level.image_begin, level.image_forward_end, level.image_end);
      begin = level.image_end;
      check_images(level);
      check_complete(level, level.begin > 0);
    }
  }

 private:
  Domain any_domain() {
    Domain d;
    d.dimension = rng_.integer(2, 3);
    for (int axis = 0; axis < d.dimension; axis++) {
      const double low = rng_.uniform(-1, 1);
      set_box(d, axis, low, low + rng_.uniform(0.9, 3), rng_.chance(0.6));
    }
    return d;
  }

  void insert() {
    std::vector<double> centers, radii;
    const int count = rng_.integer(1, 300);
    for (int i = 0; i < count; i++) {
      for (int axis = 0; axis < domain_.dimension; axis++) {
        // At a face now and then.
        double x = rng_.chance(0.1) ? 0 : rng_.uniform(-2, 3);
        if (rng_.chance(0.1)) x = std::nextafter(1, 0);
        centers.push_back(domain_.box_min[axis] + x * domain_.length[axis]);
      }
      radii.push_back(rng_.chance(0.5) ? 0.2 * rng_.uniform() : 0.01 * rng_.uniform());
    }
    store_.insert(radii.size(), centers.data(), radii.data());
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

  // Whether a particle at x, moved by `step`, comes within `distance` of the box.
  bool reaches(int axis, int32_t x, int step, double distance) const {
    if (step == 0) return true;
    const double at = x + static_cast<double>(step) * index_.map.period[axis];
    return domain_.periodic[axis] && at + distance >= 0 && at - distance <= index_.map.period[axis];
  }

  void check_complete(const IndexLevel &level, bool some_finer) {
    const double reach = 2 * interaction_.folded_radius(level.largest_radius) * index_.map.scale;
    size_t images = 0;
    for (uint32_t i = level.begin; i < level.end; i++) {
      for (hg::Image image = 0; image < 27; image++) {
        bool must = image != hg::kNoImage && (some_finer || is_forward(image)), may = must;
        for (int axis = 0; axis < 3; axis++) {
          const int step = hg::image_step(image, axis);
          const int32_t x = axis < domain_.dimension ? index_.particles.column(axis)[i] : 0;
          must = must && reaches(axis, x, step, reach + 4);
          may = may && reaches(axis, x, step, reach * 1.001 + 4096);
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
    for (int axis = 0; axis < domain_.dimension; axis++) {
      const int32_t expected =
          index_.particles.column(axis)[particle] + hg::image_step(image, axis) * index_.map.period[axis];
      require(index_.images.column(axis)[at] == expected, "image %d: coordinate %d", image, axis);
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

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_scenes)};
  return cmocka_run_group_tests_name("images", tests, nullptr, nullptr);
}
