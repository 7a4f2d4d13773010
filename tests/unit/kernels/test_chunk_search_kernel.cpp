// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search kernels of chunks against brute force on integers: groups anywhere in a space of up to 2^48 quanta, also
// where coordinates wrap and where rows and chunks meet, of particles up to just below giants.
#include "tests/unit/far_particles.hpp"
#include "tests/unit/kernels/search_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace hgtest;
using hg::KernelSet;

constexpr uint32_t kFirstPoint = 1000;  // slot of the first point that is not a particle of the level

class Scene {
 public:
  Scene(uint64_t seed, hg::Memory &memory)
      : rng_(seed),
        interaction_(rng_.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE),
        check_(interaction_),
        particles_(any_shape()),
        chunks_(memory),
        scratch_(memory) {
    particles_.share = interaction_ == HG_CONTACT ? 0.5 : 1;
    make_group();
    particles_.sort_into(chunks_, scratch_);
    table_ = chunks_.table(0, *std::max_element(particles_.radius.begin(), particles_.radius.end()));
    for (size_t i = 0; i < particles_.count(); i++) {
      const double place[3] = {particles_.place(i, 0), particles_.place(i, 1), particles_.place(i, 2)};
      add(near_, far_, place, particles_.radius[i], static_cast<uint32_t>(i));
    }
    far_.pad();
  }

  // Any of the particles, each with those after it.
  void check_own_level() {
    const auto count = static_cast<uint32_t>(particles_.count());
    const uint32_t begin = rng_.chance(0.5) ? 0 : static_cast<uint32_t>(rng_.below(count));
    const uint32_t end = rng_.chance(0.5) ? count : begin + static_cast<uint32_t>(rng_.below(count - begin + 1));
    const auto run = [&](const KernelSet &set, hg::PairStream *stream) {
      return kernel(set).own_level(far_.arrays(), begin, end, table_, stream);
    };
    check_.search(run);
    for (size_t i = begin; i < end; i++) {
      for (size_t j = i + 1; j < count; j++) check_.check_pair(near_, i, near_, j);
    }
    check_.require_nothing_else();
    check_.check_decisions(run);
  }

  // A few larger points, or images, against the chunks near them and others.
  void check_near_chunks() {
    Points near, far;
    make_points(near, far);
    hg::ChunkGroup group{};
    group.begin = static_cast<uint32_t>(rng_.below(far.count));
    group.end = group.begin + 1 + static_cast<uint32_t>(rng_.below(far.count - group.begin));
    double place[3];
    for (size_t axis = 0; axis < 3; axis++) {
      place[axis] = origin_[axis] + near.x[axis][group.begin];
      group.place[axis] = far.x[axis][group.begin];
    }
    const hg::NearChunks list = list_chunks(near, group, place);
    const auto run = [&](const KernelSet &set, hg::PairStream *stream) {
      return kernel(set).near_chunks(far.arrays(), group, table_, list, far_.arrays(), stream);
    };
    const Sent sent = check_.search(run);
    SearchCheck::require_images(sent, far, kFirstPoint);
    for (size_t i = group.begin; i < group.end; i++) {
      for (size_t j = 0; j < near_.count; j++) check_.check_pair(near, i, near_, j);
    }
    check_.require_nothing_else();
    check_.check_decisions(run);
  }

  void check_stopping() {
    SearchCheck::check_stopping([&](const KernelSet &set, hg::PairStream *stream) {
      return kernel(set).own_level(far_.arrays(), 0, far_.count, table_, stream);
    });
  }

 private:
  const hg::ChunkSearchKernel &kernel(const KernelSet &set) const {
    return set.chunk_search[particles_.dimension - 2][interaction_];
  }

  // Spaces in which cells are as wide as particles ask for, and such in which they are wider.
  FarShape any_shape() {
    FarShape shape;
    shape.dimension = rng_.integer(2, 3);
    const double diameter = rng_.chance(0.2) ? 0x1p26 - 1 : std::floor(std::pow(2, rng_.uniform(0, 26)));
    const double most = rng_.chance(0.2) ? 0x1p46 : std::min(0x1p46, 0x1p28 * std::max(0.5 * diameter, 256.0));
    for (int axis = 0; axis < shape.dimension; axis++) {
      shape.extent[axis] = std::floor(rng_.chance(0.5) ? most : most * std::pow(2, -rng_.uniform(0, 16)));
    }
    shape.diameter = {diameter};
    return shape;
  }

  // Dense enough that many pairs nearly touch, most often where rows meet or coordinates wrap.
  void make_group() {
    const double diameter = particles_.diameter[0], spread = (diameter + 3000) * rng_.uniform(0.5, 4);
    const double width[3] = {4 * diameter + 2048, 2 * diameter + 1024, 2 * diameter + 1024};  // of chunks, about
    for (int axis = 0; axis < 3; axis++) {
      const double extent = particles_.map.extent[axis];
      double at = rng_.chance(0.1) ? extent : extent * rng_.uniform();
      if (rng_.chance(0.3)) at = std::rint(at / 0x1p31) * 0x1p31;
      if (rng_.chance(0.2)) at = width[axis] * rng_.integer(0, 1000);
      origin_[axis] = std::min(std::rint(at), extent);
    }
    const int count = rng_.integer(1, 150);
    for (int i = 0; i < count; i++) {
      double at[3];
      for (int axis = 0; axis < 3; axis++) at[axis] = origin_[axis] + spread * rng_.uniform(-1, 1);
      if (i > 0 && rng_.chance(0.6)) put_near(rng_.below(particles_.count()), at);
      particles_.add(rng_, 0, at);
    }
  }

  // A place about one diameter from particle i, in any direction; along an axis now and then.
  void put_near(size_t i, double *at) {
    double u[3] = {0, 0, 0}, norm = 0;
    const int only = rng_.chance(0.4) ? rng_.integer(0, particles_.dimension - 1) : -1;
    for (int axis = 0; axis < std::min(particles_.dimension, 3); axis++) {
      u[axis] = only < 0 ? rng_.uniform(-1, 1) : (axis == only ? (rng_.chance(0.5) ? 1 : -1) : 0);
      norm += u[axis] * u[axis];
    }
    if (norm == 0) return;
    const double d = particles_.diameter[0] * (1 + rng_.uniform(-1, 1) * 1e-7) + rng_.uniform(-10, 10);
    for (int axis = 0; axis < particles_.dimension; axis++) {
      at[axis] = particles_.center(i, axis) + d * u[axis] / std::sqrt(norm);
    }
  }

  // As the kernels see it, and as seen from the origin of the group, from where nothing wraps.
  void add(Points &near, Points &far, const double *place, float radius, uint32_t slot) const {
    int32_t from_origin[3], wrapped[3];
    for (int axis = 0; axis < 3; axis++) {
      from_origin[axis] = static_cast<int32_t>(place[axis] - origin_[axis]);
      wrapped[axis] = static_cast<int32_t>(static_cast<uint32_t>(static_cast<int64_t>(place[axis])));
    }
    near.add(from_origin, radius, slot);
    far.add(wrapped, radius, slot);
  }

  void make_points(Points &near, Points &far) {
    const double size = std::pow(2, rng_.uniform(0, 12));
    double middle[3];  // points of a group are as near to each other as those of a chunk of theirs
    const double spread = 2 * std::min(particles_.diameter[0] * size, 0x1p26);
    for (int axis = 0; axis < 3; axis++) middle[axis] = origin_[axis] + rng_.uniform(-1, 1) * spread;
    for (int i = 0; i < 30; i++) {
      const size_t partner = rng_.below(near_.count);
      const float radius = static_cast<float>(
          std::min(static_cast<double>(near_.radius[partner]) * size, interaction_ == HG_CONTACT ? 0x1p25 : 0x1p26));
      const double touch = static_cast<double>(plain_reach(interaction_, radius, near_.radius[partner]));
      const int towards = rng_.integer(0, particles_.dimension - 1);
      const double side = rng_.chance(0.5) ? 1 : -1;
      double place[3] = {0, 0, 0};
      for (int axis = 0; axis < particles_.dimension; axis++) {
        const double shift = axis == towards ? side * touch + rng_.uniform(-5, 5) : 0.01 * touch * rng_.uniform(-1, 1);
        place[axis] = origin_[axis] + near_.x[static_cast<size_t>(axis)][partner] + std::rint(shift);
        place[axis] = std::clamp(place[axis], std::rint(middle[axis] - spread), std::rint(middle[axis] + spread));
      }
      add(near, far, place, radius, kFirstPoint + static_cast<uint32_t>(i));
      far.image.push_back(static_cast<hg::Image>(rng_.below(hg::kImages)));
    }
  }

  // All chunks that the box around the points meets, others now and then; nonsense behind them.
  hg::NearChunks list_chunks(const Points &near, const hg::ChunkGroup &group, const double *place) {
    const hg::ChunkLevel &level = chunks_.level(0);
    const double length[3] = {level.chunk_length(), level.row_width, level.row_width};
    hg::NearChunks list{};
    chunks_.visit_box(level, level.space, [&](size_t chunk, const double *corner) {
      bool meets = false;
      for (size_t i = group.begin; i < group.end; i++) {
        const double reach =
            static_cast<double>(plain_reach(interaction_, near.radius[i], table_.largest_radius)) + hg::kSearchSlack;
        bool one_meets = true;
        for (size_t axis = 0; axis < 3; axis++) {
          const double at = origin_[axis] + near.x[axis][i];
          one_meets = one_meets && at + reach >= corner[axis] && at - reach <= corner[axis] + length[axis];
        }
        meets = meets || one_meets;
      }
      if ((!meets && rng_.chance(0.7)) || list.count == hg::NearChunks::kMost) return true;
      const uint32_t at = list.count++;
      list.x[at] = static_cast<float>(corner[0] - place[0]);
      list.y[at] = static_cast<float>(corner[1] - place[1]);
      list.z[at] = static_cast<float>(corner[2] - place[2]);
      list.cell[at] = chunks_.chunk_cell(chunk);
      return true;
    });
    for (uint32_t at = list.count; at < hg::NearChunks::kPadded; at++) {
      list.x[at] = list.y[at] = list.z[at] = rng_.chance(0.5) ? 0 : std::numeric_limits<float>::quiet_NaN();
      list.cell[at] = std::numeric_limits<int32_t>::min();
    }
    return list;
  }

  Rng rng_;
  int32_t interaction_;
  SearchCheck check_;
  FarParticles particles_;
  hg::ChunkRows chunks_;
  hg::ChunkScratch scratch_;
  hg::ChunkTable table_{};
  double origin_[3] = {0, 0, 0};
  Points near_, far_;
};

template <class Check>
bool sweep_scenes(uint64_t rounds, Check &&check) {
  return sweep(rounds, [&](uint64_t seed) {
    hg::Memory memory(hg::system_allocator());
    Scene scene(seed, memory);
    check(scene);
  });
}

void own_level(void **) {
  assert_true(sweep_scenes(800, [](Scene &scene) { scene.check_own_level(); }));
}
void near_chunks(void **) {
  assert_true(sweep_scenes(800, [](Scene &scene) { scene.check_near_chunks(); }));
}
void stopping(void **) {
  assert_true(sweep_scenes(50, [](Scene &scene) { scene.check_stopping(); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(own_level), cmocka_unit_test(near_chunks), cmocka_unit_test(stopping)};
  return cmocka_run_group_tests_name("chunk_search_kernel", tests, nullptr, nullptr);
}
