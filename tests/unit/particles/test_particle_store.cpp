// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// ParticleStore against a map from ids to particles, its refusals, and refused memory.
#include "src/particles/particle_store.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/refusing_memory.hpp"
#include "tests/unit/stores.hpp"

#include <hgrid/types.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace {

using namespace hgtest;
using hg::Domain;
using hg::Interaction;
using hg::Memory;
using hg::ParticleStore;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Particle {
  std::array<double, 3> center;
  double radius;
};
using Model = std::map<int32_t, Particle>;

Domain periodic_x(double low, double high) {
  Domain domain;
  set_box(domain, 0, low, high);
  return domain;
}

void require_model(const ParticleStore &store, const Model &model, int dimension) {
  require(store.live_count() == model.size(), "%zu particles instead of %zu", store.live_count(), model.size());
  require(store.slots() == model.size(), "%zu slots instead of %zu", store.slots(), model.size());
  size_t slot = 0;
  for (const auto &[id, particle] : model) {
    require(store.id(slot) == id, "slot %zu: id %d instead of %d", slot, store.id(slot), id);
    require(store.find(id) == slot, "id %d: slot %zu instead of %zu", id, store.find(id), slot);
    require(store.radius(slot) == particle.radius, "id %d: radius %g", id, store.radius(slot));
    for (int axis = 0; axis < dimension; axis++) {
      require(store.center(slot)[axis] == particle.center[static_cast<size_t>(axis)], "id %d: center[%d]", id, axis);
    }
    slot++;
  }
  if (store.contiguous()) {
    require(store.slots() == 0 || store.id(0) == store.id_offset(), "contiguous ids begin at the offset");
  }
}

class Script {
 public:
  Script(uint64_t seed, Memory &memory)
      : rng_(seed),
        dimension_(rng_.integer(2, 3)),
        base_(rng_.integer(0, 1)),
        next_(base_),
        store_(make_store(memory, open_space(dimension_), {}, base_)) {}

  void step() {
    switch (rng_.below(6)) {
      case 0:
      case 1:
        insert();
        break;
      case 2:
        move();
        break;
      case 3:
        remove();
        break;
      case 4:
        remove_wrongly();
        break;
      default:
        if (rng_.chance(0.2)) clear();
    }
    if (rng_.chance(0.7)) {
      store_.compact();
      require_model(store_, model_, dimension_);
    }
    require(store_.live_count() == model_.size(), "%zu particles instead of %zu", store_.live_count(), model_.size());
  }

 private:
  Particle any() { return {{rng_.uniform(), rng_.uniform(), rng_.uniform()}, rng_.uniform()}; }
  void append(const Particle &particle) {
    centers_.insert(centers_.end(), particle.center.begin(), particle.center.begin() + dimension_);
    radii_.push_back(particle.radius);
  }
  void start() {
    centers_.clear();
    radii_.clear();
  }

  void insert() {
    start();
    const size_t count = rng_.below(40);
    for (size_t i = 0; i < count; i++) {
      const Particle particle = any();
      append(particle);
      model_[next_++] = particle;
    }
    store_.insert(count, centers_.data(), radii_.data());
  }

  void move() {
    start();
    const bool with_radii = rng_.chance(0.5);
    for (auto &[id, particle] : model_) {
      const double radius = particle.radius;
      particle = any();
      if (!with_radii) particle.radius = radius;
      append(particle);
    }
    store_.move(model_.size(), centers_.data(), with_radii ? radii_.data() : nullptr);
  }

  std::vector<int32_t> some_ids() {
    std::vector<int32_t> ids;
    for (const auto &entry : model_) {
      if (rng_.chance(0.3)) ids.push_back(entry.first);
    }
    for (size_t k = ids.size(); k > 1; k--) std::swap(ids[k - 1], ids[rng_.below(k)]);
    return ids;
  }

  void remove() {
    const std::vector<int32_t> ids = some_ids();
    store_.remove(ids.size(), ids.data());
    for (int32_t id : ids) model_.erase(id);
  }

  // A list with one wrong id removes nothing.
  void remove_wrongly() {
    std::vector<int32_t> ids = some_ids();
    if (ids.empty()) return;
    int32_t wrong = rng_.chance(0.5) ? next_ : ids[0];
    if (rng_.chance(0.2)) wrong = base_ - 1;
    if (rng_.chance(0.2)) wrong = std::numeric_limits<int32_t>::min();
    ids.push_back(wrong);
    char text[64];
    std::snprintf(text, sizeof text, "ids[%zu] = %d", ids.size() - 1, wrong);
    require_refused("remove", HG_ERR_NOT_FOUND, text, [&] { store_.remove(ids.size(), ids.data()); });
  }

  void clear() {
    store_.clear();
    model_.clear();
    next_ = base_;
  }

  Rng rng_;
  int dimension_;
  int32_t base_, next_;
  ParticleStore store_;
  Model model_;
  std::vector<double> centers_, radii_;
};

void check_script(uint64_t seed) {
  Memory memory(hg::system_allocator());
  {
    Script script(seed, memory);
    for (int step = 0; step < 100; step++) script.step();
  }
  require(memory.bytes() == 0, "%lld bytes are left", static_cast<long long>(memory.bytes()));
}

void like_a_map(void **) { assert_true(sweep(200, check_script)); }

// Bad values are named and nothing changes, whichever call brings them.
void check_bad_values(uint64_t) {
  Memory memory(hg::system_allocator());
  ParticleStore store = make_store(memory, open_space(3));
  const double good[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8}, radii[3] = {1, 0, 3};
  store.insert(3, good, radii);
  const struct {
    int center, radius;  // which entry is made bad; -1: none
    double value;
    const char *text;
  } cases[] = {{5, -1, kNaN, "centers[1][2] = nan"},        {8, -1, kInfinity, "centers[2][2] = inf"},
               {0, -1, -kInfinity, "centers[0][0] = -inf"}, {-1, 1, kNaN, "radii[1] = nan"},
               {-1, 2, kInfinity, "radii[2] = inf"},        {-1, 0, -1, "radii[0] = -1"},
               {-1, 0, -5e-324, "radii[0] = -4.9"}};
  for (const auto &c : cases) {
    double x[9], r[3];
    for (int k = 0; k < 9; k++) x[k] = k == c.center ? c.value : 10.0 + k;
    for (int k = 0; k < 3; k++) r[k] = k == c.radius ? c.value : 5;
    require_refused("insert", HG_ERR_ARGUMENT, c.text, [&] { store.insert(3, x, r); });
    require_refused("move", HG_ERR_ARGUMENT, c.text, [&] { store.move(3, x, r); });
    if (c.center >= 0) require_refused("move", HG_ERR_ARGUMENT, c.text, [&] { store.move(3, x, nullptr); });
  }
  require_refused("move", HG_ERR_ARGUMENT, "count is 2", [&] { store.move(2, good, radii); });
  require_model(store, {{0, {{0, 1, 2}, 1}}, {1, {{3, 4, 5}, 0}}, {2, {{6, 7, 8}, 3}}}, 3);
}

void bad_values(void **) { assert_true(holds(0, check_bad_values)); }

void check_periodic_limits(uint64_t) {
  Memory memory(hg::system_allocator());
  ParticleStore store = make_store(memory, periodic_x(1, 3), Interaction{HG_CONTACT, 0.25});
  const double far[3] = {1 + 2 * hg::kMaxWraps + 2.5, 0, 0}, edge[3] = {1 + 2 * hg::kMaxWraps + 0.5, 0, 0};
  const double fits = 0.375, too_large = std::nextafter(0.375, 1);
  require_refused("wraps", HG_ERR_LIMIT, "centers[0][0]", [&] { store.insert(1, far, &fits); });
  store.insert(1, edge, &fits);
  require_refused("box", HG_ERR_ARGUMENT, "particles 1 and 0", [&] { store.insert(1, edge, &too_large); });
  require_refused("wraps", HG_ERR_LIMIT, "centers[0][0]", [&] { store.move(1, far, nullptr); });
  store.insert(1, edge, &fits);
  require(store.live_count() == 2, "a box of twice the reach is long enough");
  const double two[6] = {edge[0], 0, 0, edge[0], 0, 0}, grown[2] = {fits, too_large};
  require_refused("box", HG_ERR_ARGUMENT, "particles 1 and 0", [&] { store.move(2, two, grown); });
}

void periodic_limits(void **) { assert_true(holds(0, check_periodic_limits)); }

// Whether a box is shorter than twice the reach is a question about real numbers, not rounded ones.
void check_box_exactly(uint64_t) {
  Memory memory(hg::system_allocator());
  const double origin[6] = {0, 0, 0, 0, 0, 0};
  // 0.2 + 0.2 + 0.1 rounds to 0.5 but is more.
  ParticleStore sum = make_store(memory, periodic_x(0, 1), Interaction{HG_CONTACT, 0.1});
  const double r[2] = {0.2, 0.2};
  require_refused("sum", HG_ERR_ARGUMENT, "particles 0 and 1", [&] { sum.insert(2, origin, r); });
  // 1 - 2^-55 rounds to 1 but is less.
  ParticleStore length = make_store(memory, periodic_x(0x1p-55, 1));
  const double quarter[2] = {0.25, 0.25}, less[2] = {0.25, std::nextafter(0.25, 0)};
  require_refused("length", HG_ERR_ARGUMENT, "particles 0 and 1", [&] { length.insert(2, origin, quarter); });
  length.insert(2, origin, less);
  ParticleStore range = make_store(memory, periodic_x(0, 1), Interaction{HG_MAX_RANGE, 0.25});
  range.insert(2, origin, quarter);
  require(length.live_count() == 2 && range.live_count() == 2, "boxes that are just long enough");
}

void box_exactly(void **) { assert_true(holds(0, check_box_exactly)); }

void check_largest_cell(uint64_t) {
  Memory memory(hg::system_allocator());
  ParticleStore store = make_store(memory, open_space(3), Interaction{HG_CONTACT, 0.5}, 0, 2.5);
  const double x[6] = {0, 0, 0, 1, 1, 1}, good[2] = {0.5, 1.25}, bad[2] = {0.5, std::nextafter(1.25, 2)};
  require_refused("cell", HG_ERR_ARGUMENT, "radii[1]", [&] { store.insert(2, x, bad); });
  store.insert(2, x, good);
  require_refused("cell", HG_ERR_ARGUMENT, "radii[1]", [&] { store.move(2, x, bad); });
  require(store.radius(1) == 1.25, "the radius changed");
}

void largest_cell(void **) { assert_true(holds(0, check_largest_cell)); }

// Refused memory leaves the store as it was.
void check_refused_memory(uint64_t) {
  Memory memory(refusing_allocator());
  ParticleStore store = make_store(memory, open_space(2), {}, 1);
  const double x[4] = {1, 2, 3, 4}, r[2] = {5, 6};
  store.insert(2, x, r);
  const Model model = {{1, {{1, 2, 0}, 5}}, {2, {{3, 4, 0}, 6}}};
  const std::vector<double> many(2000, 0.5);
  const int32_t id = 1;
  {
    const RefuseMemory all(0);
    require_refused("insert", HG_ERR_MEMORY, "memory", [&] { store.insert(1000, many.data(), many.data()); });
    require_refused("remove", HG_ERR_MEMORY, "memory", [&] { store.remove(1, &id); });
  }
  require_model(store, model, 2);
  store.remove(1, &id);
  store.insert(1, x, r);
  store.compact();
  require_model(store, {{2, {{3, 4, 0}, 6}}, {3, {{1, 2, 0}, 5}}}, 2);
}

void refused_memory(void **) { assert_true(holds(0, check_refused_memory)); }

void too_many(void **) {
  assert_true(holds(0, [](uint64_t) {
    Memory memory(hg::system_allocator());
    ParticleStore store = make_store(memory, open_space(2), {}, 1);
    const double x[2] = {0, 0}, r = 0;
    const size_t most = static_cast<size_t>(std::numeric_limits<int32_t>::max());
    require_refused("ids", HG_ERR_LIMIT, "ids would pass", [&] { store.insert(most + 1, x, &r); });
    store.insert(1, x, &r);
    require_refused("ids", HG_ERR_LIMIT, "ids would pass", [&] { store.insert(most, x, &r); });
    require(store.live_count() == 1, "%zu particles", store.live_count());
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(like_a_map),  cmocka_unit_test(bad_values),   cmocka_unit_test(periodic_limits),
      cmocka_unit_test(box_exactly), cmocka_unit_test(largest_cell), cmocka_unit_test(refused_memory),
      cmocka_unit_test(too_many),
  };
  return cmocka_run_group_tests_name("particle_store", tests, nullptr, nullptr);
}
