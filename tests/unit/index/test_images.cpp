// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Periodic images: all that can reach into the box, each once, forward ones first, backward ones where there is a finer
// level; where the box is filled evenly, and where all lie in a small part of it, in chunks; in cells that are tilted
// or shorter than reaches, too.
#include "src/index/build_index.hpp"
#include "src/particles/bounds.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/exact_place.hpp"
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

class Scene {
 public:
  Scene(uint64_t seed, hg::Memory &memory)
      : rng_(seed),
        domain_(any_domain()),
        index_(memory, domain_, interaction_),
        scratch_(memory),
        store_(make_store(memory, domain_)) {}

  struct Kind {
    bool chunked, tilted, short_cell;
  };
  Kind check(bool in_a_part) {
    part_ = in_a_part ? 1.0 / 32 : 1;
    insert();
    const double sizes[4] = {1e-6 * part_, 0.02 * part_, 0.1 * part_, 0.4 * part_};
    const hg::Bounds bounds = hg::bounds_of(store_, domain_, 1);
    index_.map = hg::FixedPoint::over(bounds, domain_, 2 * bounds.max_radius);
    hg::build_index(index_, scratch_, store_, hg::user_levels(sizes, 4, interaction_), 1);
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
    return {index_.chunked, domain_.is_tilted() && begin > 0, domain_.all_images && begin > 0};
  }

 private:
  Domain any_domain() {
    Domain d;
    d.dimension = rng_.integer(2, 3);
    for (int axis = 0; axis < d.dimension; axis++) {
      const double low = rng_.uniform(-1, 1);
      set_box(d, axis, low, low + rng_.uniform(0.9, 3), rng_.chance(0.6));
    }
    if (rng_.chance(0.2)) {
      d.all_images = true;
      set_box(d, rng_.integer(0, d.dimension - 1), 0, rng_.uniform(0.1, 0.4));
    }
    if (rng_.chance(0.6)) tilt_some(rng_, d, [&](double length) { return length * rng_.uniform(-3, 3); });
    return d;
  }

  void insert() {
    std::vector<double> centers, radii;
    double begin[3];  // of the part of the box, across a face now and then
    for (double &x : begin) x = rng_.chance(0.7) ? -0.5 * part_ : rng_.uniform();
    const bool dust = rng_.chance(0.3);
    const int count = rng_.integer(part_ < 1 ? 100 : 1, 300);
    for (int i = 0; i < count; i++) {
      for (int axis = 0; axis < domain_.dimension; axis++) {
        // At a face now and then.
        double x = rng_.chance(0.1) ? 0 : rng_.uniform(-2, 3);
        if (rng_.chance(0.1)) x = std::nextafter(1, 0);
        if (part_ < 1) x = begin[axis] + part_ * rng_.uniform() + (domain_.periodic[axis] ? rng_.integer(-3, 3) : 0);
        centers.push_back(domain_.box_min[axis] + x * domain_.length[axis]);
      }
      const double radius = part_ * (rng_.chance(0.5) ? 0.2 * rng_.uniform() : 0.01 * rng_.uniform());
      radii.push_back(dust && rng_.chance(0.5) ? 1e-5 * radius : radius);
    }
    store_.insert(radii.size(), centers.data(), radii.data());
  }

  void check_images(const IndexLevel &level) {
    for (uint32_t i = level.image_begin; i < level.image_end; i++) {
      const Key key(index_.images.slot[i], index_.images.image[i]);
      require(found_.insert(key).second, "slot %u has image %d twice", key.first, key.second);
      require(!shift_of(key.second).is_none(), "slot %u is its own image", key.first);
      require(is_forward(shift_of(key.second)) == (i < level.image_forward_end), "image %d is on the wrong side",
              key.second);
      at_[key] = i;
    }
  }

  // Where the search has the particle, and how long the box is, in quanta.
  double place(int axis, uint32_t particle) const {
    if (!index_.chunked) return index_.particles.column(axis)[particle];
    double places[3];
    index_.map.find_place(store_.center(index_.particles.slot[particle]), domain_.dimension, places);
    return places[axis];
  }
  double period(int axis) const { return index_.chunked ? index_.map.period_place(axis) : index_.map.period[axis]; }

  // Shifts and what they are in quanta: space/test_shift_table.cpp.
  hg::Shift shift_of(hg::Image image) const { return index_.shifts[image]; }

  // Whether a particle, moved by a shift, comes within `distance` of the box.
  bool reaches(int axis, uint32_t particle, hg::Image image, double distance) const {
    if (axis >= domain_.dimension || !domain_.periodic[axis]) return shift_of(image).n[axis] == 0;
    const double at = place(axis, particle) + index_.shifts.quanta(image, axis);
    return at + distance >= 0 && at - distance <= period(axis);
  }

  void check_complete(const IndexLevel &level, bool some_finer) {
    const double reach = 2 * interaction_.folded_radius(level.largest_radius) * index_.map.scale;
    size_t images = 0;
    for (uint32_t i = level.begin; i < level.end; i++) {
      for (hg::Image image = 0; image < index_.shifts.count(); image++) {
        bool must = !shift_of(image).is_none() && (some_finer || is_forward(shift_of(image))), may = must;
        for (int axis = 0; axis < 3; axis++) {
          must = must && reaches(axis, i, image, reach + 4);
          may = may && reaches(axis, i, image, reach * 1.001 + 4096);
        }
        const auto found = at_.find({index_.particles.slot[i], image});
        require(!must || found != at_.end(), "slot %u: image %d is missing", index_.particles.slot[i], image);
        require(may || found == at_.end(), "slot %u: image %d is far off", index_.particles.slot[i], image);
        if (found == at_.end()) continue;
        images++;
        check_one(i, found->second, image);
      }
    }
    require(images == level.image_end - level.image_begin, "%u images, %zu of them of the level",
            level.image_end - level.image_begin, images);
  }

  void check_one(uint32_t particle, uint32_t at, hg::Image image) {
    for (int axis = 0; axis < domain_.dimension; axis++) {
      const double expected = place(axis, particle) + index_.shifts.quanta(image, axis);
      const auto wrapped = static_cast<int32_t>(static_cast<uint32_t>(static_cast<int64_t>(expected)));
      require(index_.images.column(axis)[at] == wrapped, "image %d: coordinate %d", image, axis);
      require(!index_.chunked || index_.image_place[axis][at] == expected, "image %d: place %d", image, axis);
    }
    require(index_.images.radius[at] == index_.particles.radius[particle], "image %d: radius", image);
  }

  Rng rng_;
  Domain domain_;
  hg::Interaction interaction_;
  Index index_;
  hg::BuildScratch scratch_;
  hg::ParticleStore store_;
  double part_ = 1;  // of the box that particles are in
  std::set<Key> found_;
  std::map<Key, uint32_t> at_;
};

struct Kinds {
  int chunked = 0, tilted = 0, short_cells = 0;
};

void check_scenes(bool in_a_part, Kinds &kinds) {
  assert_true(sweep(300, [&](uint64_t seed) {
    hg::Memory memory(hg::system_allocator());
    const Scene::Kind kind = Scene(seed, memory).check(in_a_part);
    kinds.chunked += kind.chunked ? 1 : 0;
    kinds.tilted += kind.tilted ? 1 : 0;
    kinds.short_cells += kind.short_cell ? 1 : 0;
  }));
}

void evenly_filled(void **) {
  Kinds kinds;
  check_scenes(false, kinds);
  assert_true(kinds.tilted > 50 && kinds.short_cells > 30);
}
void in_chunks(void **) {
  Kinds kinds;
  check_scenes(true, kinds);
  assert_true(kinds.chunked > 150 && kinds.tilted > 50 && kinds.short_cells > 30);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(evenly_filled), cmocka_unit_test(in_chunks)};
  return cmocka_run_group_tests_name("images", tests, nullptr, nullptr);
}
